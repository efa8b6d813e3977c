// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Brings points of any magnitude into the cube [-1, 1]^3, so that no later product overflows or vanishes.

#ifndef CSCD_TRAITS_NORMALIZE_EXTENT_H
#define CSCD_TRAITS_NORMALIZE_EXTENT_H

#include <CSCD/Traits/Normalization.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/Vector_3.h>

#include <vector>

namespace CSCD::internal {

/// Extents outside these bounds lose digits when they are halved or divided by; in the unit of the input.
inline constexpr double smallest_extent = 1e-290;
inline constexpr double largest_extent = 1e290;

/// Moves the centre of the bounding box of `points` to the origin and scales its longest side to 2.
/// The result depends on the set of points alone, not on their order. Linear.
/// \pre `points` is not empty and all coordinates are finite
/// \throw Input_error if all points are equal, or their extent is beyond what can be computed with
inline Normalization normalize_extent(std::vector<Vector_3>& points)
{
  Vector_3 least = points.front();
  Vector_3 greatest = points.front();
  for (const Vector_3& point : points) {
    least = least.cwiseMin(point);
    greatest = greatest.cwiseMax(point);
  }
  // Halving before subtracting: the difference itself may overflow.
  const double half_extent = (greatest / 2 - least / 2).maxCoeff();
  if (greatest == least) {
    throw Input_error("all vertices are at the same point: the surface has no extent; check how the input was written");
  }
  if (half_extent < smallest_extent || half_extent > largest_extent) {
    throw Input_error("the extent of the surface is outside [1e-290, 1e290]: scale the coordinates");
  }
  Normalization result{least / 2 + greatest / 2, half_extent};
  for (Vector_3& point : points) {
    point = result.from_input(point);
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_TRAITS_NORMALIZE_EXTENT_H
