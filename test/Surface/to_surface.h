// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A test shape as the triangles that the library checks and completes, and compiled, without any change of numbers or
// coordinates.

#ifndef CSCD_TEST_SURFACE_TO_SURFACE_H
#define CSCD_TEST_SURFACE_TO_SURFACE_H

#include "support/Shape.h"
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>

namespace CSCD::test {

inline CSCD::Indexed_triangles to_indexed_triangles(const Shape& shape)
{
  CSCD::Indexed_triangles result;
  for (const Triple& p : shape.points) {
    result.points.emplace_back(p[0], p[1], p[2]);
  }
  for (const Triangle& t : shape.triangles) {
    result.faces.push_back({CSCD::Index(t[0]), CSCD::Index(t[1]), CSCD::Index(t[2])});
  }
  result.first_hole_filling_face = result.faces.size();
  return result;
}

inline CSCD::Triangulated_surface to_surface(const Shape& shape)
{
  return CSCD::Triangulated_surface(to_indexed_triangles(shape));
}

/// The vertex of `surface` that is nearest to `point`.
inline CSCD::Index nearest_vertex(const CSCD::Triangulated_surface& surface, const CSCD::Vector3& point)
{
  CSCD::Index nearest = 0;
  for (CSCD::Index vertex = 1; vertex < surface.number_of_vertices(); ++vertex) {
    if ((surface.point(vertex) - point).norm() < (surface.point(nearest) - point).norm()) {
      nearest = vertex;
    }
  }
  return nearest;
}

} // namespace CSCD::test

#endif // CSCD_TEST_SURFACE_TO_SURFACE_H
