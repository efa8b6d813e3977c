// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The map between the coordinates of the input and those of the surface.

#ifndef CSCD_SURFACE_NORMALIZATION_H
#define CSCD_SURFACE_NORMALIZATION_H

#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/Box_tree.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CSCD {

/// Normalized coordinates: the point `x` of the input is `(x - origin) / unit`.
struct Normalization
{
  Vector3 origin = Vector3::Zero(); ///< in the coordinates of the input
  double unit = 1;                  ///< in the unit of the input, positive

  /// The point of the input that `point` is.
  Vector3 to_input(const Vector3& point) const { return origin + unit * point; }
  /// The normalized point that `point` of the input is.
  Vector3 from_input(const Vector3& point) const { return (point - origin) / unit; }

  /// The normalization that first applies this one and then `second`.
  Normalization then(const Normalization& second) const { return {to_input(second.origin), unit * second.unit}; }
};

namespace internal {

/// Replaces `points` by the normalized ones.
inline void normalize(std::vector<Vector3>& points, const Normalization& normalization)
{
  for (Vector3& point : points) {
    point = normalization.from_input(point);
  }
}

} // namespace internal

/// Minimal area of a surface, relative to the square of its extent: rounding leaves smaller areas of collinear points.
inline constexpr double min_relative_area = 1e-12;

/// Moves the area-weighted centroid of `triangles` to the origin and scales the area, hole-filling faces not counted,
/// to 1. Linear. \pre the extent of the points is about 1 \throw Input_error if the area vanishes
inline Normalization normalize_area(Indexed_triangles& triangles)
{
  double area = 0;
  Vector3 moment = Vector3::Zero();
  for (std::size_t f = 0; f < triangles.first_hole_filling_face; ++f) {
    const std::array<Index, 3>& face = triangles.faces[f];
    const Vector3& a = triangles.points[face[0]];
    const Vector3& b = triangles.points[face[1]];
    const Vector3& c = triangles.points[face[2]];
    const double face_area = internal::triangle_area(a, b, c);
    area += face_area;
    moment += face_area / 3 * (a + b + c);
  }
  if (!(area > min_relative_area)) {
    throw Input_error("all faces have zero area: the vertices are collinear; check how the input was written");
  }
  Normalization result{moment / area, std::sqrt(area)};
  internal::normalize(triangles.points, result);
  return result;
}

/// The minimal extent, in the unit of the input. Extents outside the bounds lose digits when they are halved or divided
/// by.
inline constexpr double min_extent = 1e-290;
/// The maximal extent, likewise.
inline constexpr double max_extent = 1e290;

/// Moves the center of the bounding box of `points` to the origin and scales its longest side to 2.
/// The result depends on the set of points alone, not on their order. Linear.
/// \pre `points` is not empty and all coordinates are finite
/// \throw Input_error if all points are equal, or their extent is out of the range that can be computed with
inline Normalization normalize_extent(std::vector<Vector3>& points)
{
  const internal::Bounding_box box(points);
  // Halving before subtracting: the difference itself may overflow.
  const double half_extent = (box.max() / 2 - box.min() / 2).maxCoeff();
  if (box.max() == box.min()) {
    throw Input_error("all vertices are at the same point: the surface has no extent; check how the input was written");
  }
  if (half_extent < min_extent || half_extent > max_extent) {
    throw Input_error("the extent of the surface is outside [1e-290, 1e290]: scale the coordinates");
  }
  Normalization result{box.min() / 2 + box.max() / 2, half_extent};
  internal::normalize(points, result);
  return result;
}

} // namespace CSCD

#endif // CSCD_SURFACE_NORMALIZATION_H
