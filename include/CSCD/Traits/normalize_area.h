// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Gives a surface unit area around its centroid.

#ifndef CSCD_TRAITS_NORMALIZE_AREA_H
#define CSCD_TRAITS_NORMALIZE_AREA_H

#include <CSCD/Traits/Indexed_triangles.h>
#include <CSCD/Traits/Normalization.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/Vector_3.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CSCD::internal {

/// Least area of a surface, relative to the square of its extent: below it lies what rounding leaves of collinear
/// points.
inline constexpr double smallest_relative_area = 1e-12;

/// Moves the area-weighted centroid of `triangles` to the origin and scales the area, bridging faces not counted, to 1.
/// Linear.
/// \pre the extent of the points is about 1
/// \throw Input_error if the area vanishes
inline Normalization normalize_area(Indexed_triangles& triangles)
{
  double area = 0;
  Vector_3 moment = Vector_3::Zero();
  for (std::size_t f = 0; f < triangles.first_bridging_face; ++f) {
    const std::array<Index, 3>& face = triangles.faces[f];
    const Vector_3& a = triangles.points[face[0]];
    const Vector_3& b = triangles.points[face[1]];
    const Vector_3& c = triangles.points[face[2]];
    const double face_area = (b - a).cross(c - a).norm() / 2;
    area += face_area;
    moment += face_area / 3 * (a + b + c);
  }
  if (!(area > smallest_relative_area)) {
    throw Input_error("all faces have zero area: the vertices are collinear; check how the input was written");
  }
  Normalization result{moment / area, std::sqrt(area)};
  for (Vector_3& point : triangles.points) {
    point = result.from_input(point);
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_TRAITS_NORMALIZE_AREA_H
