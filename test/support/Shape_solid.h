// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A test shape as the body that the pipeline runs on.

#ifndef CSCD_TEST_SUPPORT_SHAPE_SOLID_H
#define CSCD_TEST_SUPPORT_SHAPE_SOLID_H

#include "Shape.h"
#include "Surface/to_surface.h"
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector3.h>

#include <utility>

namespace CSCD::test {

/// The solid of the triangles of `shape`, whose vertices each have a face.
class Shape_solid
{
public:
  explicit Shape_solid(const Shape& shape) : Shape_solid(to_indexed_triangles(shape)) {}

  const Triangulated_solid& operator*() const { return m_solid; }
  const Triangulated_solid* operator->() const { return &m_solid; }
  const Triangulated_surface& surface() const { return m_solid.triangulation(); }

  /// The point of the solid that is (x, y, z) on the shape.
  Vector3 at(double x, double y, double z) const { return m_solid.normalization().from_input({x, y, z}); }
  /// The point of the shape that is `point` on the solid.
  Vector3 to_shape(const Vector3& point) const { return m_solid.normalization().to_input(point); }
  /// The length 1 of the solid in the unit of the shape.
  double unit() const { return m_solid.normalization().unit; }

private:
  explicit Shape_solid(Indexed_triangles&& triangles) : Shape_solid(std::move(triangles), pairing(triangles)) {}
  Shape_solid(Indexed_triangles&& triangles, Halfedge_pairing&& halfedges)
      : m_solid(std::move(triangles), std::move(halfedges))
  {
  }

  static Halfedge_pairing pairing(const Indexed_triangles& triangles)
  {
    return Halfedge_pairing(triangles.faces, triangles.points.size());
  }

  Triangulated_solid m_solid;
};

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_SHAPE_SOLID_H
