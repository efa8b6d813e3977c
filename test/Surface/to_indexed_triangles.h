// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A test shape in the form that the library checks and completes.

#ifndef CSCD_TEST_SURFACE_TO_INDEXED_TRIANGLES_H
#define CSCD_TEST_SURFACE_TO_INDEXED_TRIANGLES_H

#include "support/Shape.h"
#include <CSCD/Surface/Triangles.h>

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

} // namespace CSCD::test

#endif // CSCD_TEST_SURFACE_TO_INDEXED_TRIANGLES_H
