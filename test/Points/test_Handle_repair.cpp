// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Only handles of a few edges are cut.

#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Points/Handle_repair.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Surface/close_surface.h>
#include <CSCD/Vector3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using CSCD::Halfedge_pairing, CSCD::Index, CSCD::Indexed_triangles, CSCD::Triangulated_surface, CSCD::Vertex_loop,
    CSCD::test::Shape;

/// Twice the number of components less twice the genus.
std::ptrdiff_t euler_number(const Indexed_triangles& triangles)
{
  return std::ptrdiff_t(triangles.points.size()) - std::ptrdiff_t(triangles.faces.size() / 2);
}

/// Cuts what `Handle_repair` finds, once. \return the number of loops
std::size_t repair(Indexed_triangles& triangles)
{
  const Triangulated_surface surface{Indexed_triangles(triangles)};
  const std::vector<Vertex_loop> loops = CSCD::internal::Handle_repair(surface)();
  CSCD::internal::cut_along_loops(triangles, surface, loops);
  const Halfedge_pairing pairing(triangles.faces, triangles.points.size());
  EXPECT_EQ(CSCD::no_index, pairing.conflict());
  EXPECT_EQ(2 * loops.size(), CSCD::internal::bridge_borders(triangles, pairing));
  EXPECT_FALSE(Triangulated_surface{Indexed_triangles(triangles)}.has_defect());
  return loops.size();
}

TEST(Handle_repair, keeps_handles_that_are_sampled)
{
  for (const Shape& shape : {CSCD::test::torus(3, 1, 24), CSCD::test::torus(3, 1, 8), CSCD::test::double_torus(0.2),
                             CSCD::test::trefoil_knot(0.4, 16), CSCD::test::sphere(3)}) {
    SCOPED_TRACE(shape.name);
    Indexed_triangles triangles = to_indexed_triangles(shape);
    EXPECT_EQ(0u, repair(triangles));
  }
}

TEST(Handle_repair, cuts_handles_of_a_few_edges)
{
  for (const std::size_t around : {3u, 4u}) {
    SCOPED_TRACE(around);
    // Rings of this many vertices, about as far from each other as these.
    Indexed_triangles triangles = to_indexed_triangles(CSCD::test::torus(6, 1, around));
    EXPECT_EQ(0, euler_number(triangles));
    EXPECT_EQ(1u, repair(triangles));
    EXPECT_EQ(2, euler_number(triangles));
    EXPECT_EQ(0u, repair(triangles));
  }
}

/// A ring around the z-axis that is thin in one place: a neck or, if the rings next to it are moved there, the two ends
/// of a limb that touch each other.
Indexed_triangles ring_with_thin_place(std::size_t around, double thickness, bool is_fold)
{
  constexpr double radius = 6;
  Indexed_triangles triangles = to_indexed_triangles(CSCD::test::torus(radius, 1, around));
  const double step = 2 * CSCD::test::pi * double(around) / double(triangles.points.size()); // from ring to ring
  for (CSCD::Vector3& point : triangles.points) {
    const double angle = std::atan2(point.y(), point.x());
    const CSCD::Vector3 center = radius * CSCD::Vector3(std::cos(angle), std::sin(angle), 0);
    if (std::abs(angle) < step / 2) {
      point = center + thickness * (point - center);
    } else if (is_fold && std::abs(angle) < 3 * step / 2) {
      constexpr double share = 0.2; // of the way that is left
      const double back = (share - 1) * angle;
      const CSCD::Vector3 old = point;
      point.x() = std::cos(back) * old.x() - std::sin(back) * old.y();
      point.y() = std::sin(back) * old.x() + std::cos(back) * old.y();
    }
  }
  return triangles;
}

TEST(Handle_repair, cuts_where_limbs_touch_and_keeps_necks)
{
  for (const double thickness : {0.5, 0.7}) {
    SCOPED_TRACE(thickness);
    constexpr std::size_t around = 16;
    Indexed_triangles neck = ring_with_thin_place(around, thickness, false);
    EXPECT_EQ(0u, repair(neck));
    Indexed_triangles touching = ring_with_thin_place(around, thickness, true);
    EXPECT_EQ(0, euler_number(touching));
    EXPECT_EQ(1u, repair(touching));
    EXPECT_EQ(2, euler_number(touching));
    EXPECT_EQ(0u, repair(touching));
  }
}

} // namespace
