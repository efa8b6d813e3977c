// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A test shape with borders, compiled with them bridged but without any other change.

#ifndef CSCD_TEST_SURFACE_TO_BRIDGED_SURFACE_H
#define CSCD_TEST_SURFACE_TO_BRIDGED_SURFACE_H

#include "Surface/to_indexed_triangles.h"
#include "support/Shape.h"
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Surface/close_surface.h>

#include <utility>

namespace CSCD::test {

inline CSCD::Triangulated_surface to_bridged_surface(const Shape& shape)
{
  CSCD::Indexed_triangles triangles = to_indexed_triangles(shape);
  CSCD::internal::bridge_borders(triangles, CSCD::Halfedge_pairing(triangles.faces, triangles.points.size()));
  return CSCD::Triangulated_surface(std::move(triangles));
}

} // namespace CSCD::test

#endif // CSCD_TEST_SURFACE_TO_BRIDGED_SURFACE_H
