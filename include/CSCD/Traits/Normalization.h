// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The similarity between the coordinates of the input and those in which everything is computed.

#ifndef CSCD_TRAITS_NORMALIZATION_H
#define CSCD_TRAITS_NORMALIZATION_H

#include <CSCD/internal/Vector_3.h>

#include <type_traits>
#include <utility>

namespace CSCD::internal {

/// Normalized coordinates: the point `x` of the input is `(x - origin) / unit`.
struct Normalization
{
  Vector_3 origin = Vector_3::Zero(); ///< in the coordinates of the input
  double unit = 1;                    ///< in the unit of the input, positive

  Vector_3 to_input(const Vector_3& point) const { return origin + unit * point; }
  Vector_3 from_input(const Vector_3& point) const { return (point - origin) / unit; }

  /// The normalization that first applies this one and then `second`.
  Normalization then(const Normalization& second) const { return {to_input(second.origin), unit * second.unit}; }
};

/// The point of any type, constructible from three coordinates, that `point` is in the input.
template <class Point>
Point to_input_point(const Normalization& normalization, const Vector_3& point)
{
  using Coordinate = std::decay_t<decltype(std::declval<const Point&>().x())>;
  const Vector_3 result = normalization.to_input(point);
  return Point(Coordinate(result.x()), Coordinate(result.y()), Coordinate(result.z()));
}

} // namespace CSCD::internal

#endif // CSCD_TRAITS_NORMALIZATION_H
