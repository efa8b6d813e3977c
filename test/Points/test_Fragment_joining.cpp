// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which fragments are joined, and that the result is an oriented manifold.

#include "Surface/to_indexed_triangles.h"
#include "support/shapes.h"
#include <CSCD/Points/Fragment_joining.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Surface/close_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace {

using CSCD::Halfedge_pairing;
using CSCD::Index;
using CSCD::Indexed_triangles;
using CSCD::Triangulated_surface;
using CSCD::Vector_3;
using CSCD::internal::Fragment_joining;
using CSCD::test::Shape;
using CSCD::test::Tube_end;

/// Reverses the faces from number `first` on.
void reverse(Indexed_triangles& triangles, std::size_t first)
{
  for (std::size_t f = first; f < triangles.faces.size(); ++f) {
    std::swap(triangles.faces[f][1], triangles.faces[f][2]);
  }
}

/// Joins the fragments and closes what is left. \return the Euler number of the closed surface
std::ptrdiff_t join(Indexed_triangles& triangles, std::size_t expected_gaps)
{
  const Halfedge_pairing pairing(triangles.faces, triangles.points.size());
  Fragment_joining joining(triangles, pairing);
  EXPECT_EQ(expected_gaps, joining().size());
  const Halfedge_pairing joined(triangles.faces, triangles.points.size());
  EXPECT_EQ(CSCD::no_index, joined.conflict());
  CSCD::internal::bridge_borders(triangles, joined);
  const Triangulated_surface surface{Indexed_triangles(triangles)};
  EXPECT_FALSE(surface.defect());
  return std::ptrdiff_t(triangles.points.size()) - std::ptrdiff_t(triangles.faces.size() / 2);
}

double volume(const Indexed_triangles& triangles)
{
  double sum = 0;
  for (const std::array<Index, 3>& f : triangles.faces) {
    sum += triangles.points[f[0]].dot(triangles.points[f[1]].cross(triangles.points[f[2]])) / 6;
  }
  return sum;
}

TEST(Fragment_joining, joins_two_stumps_whatever_their_orientation)
{
  for (const bool is_reversed : {false, true}) {
    // Tubes with an open end each, one after the other, with a gap of two edges between them.
    const Shape half = CSCD::test::tube(10, 1, 24, Tube_end::open);
    const Shape other = CSCD::test::translated(half, {10.5, 0, 0});
    Indexed_triangles triangles = to_indexed_triangles(CSCD::test::merged("", {half, other}));
    if (is_reversed) {
      reverse(triangles, half.triangles.size());
    }
    EXPECT_EQ(2, join(triangles, 1)) << "a sphere";
    EXPECT_GT(volume(triangles), 0.9 * 20 * CSCD::test::pi);
  }
}

TEST(Fragment_joining, keeps_bodies_apart)
{
  const Shape ball = CSCD::test::sphere(3);
  Indexed_triangles triangles =
      to_indexed_triangles(CSCD::test::merged("", {ball, CSCD::test::translated(ball, {2.1, 0, 0})}));
  EXPECT_EQ(4, join(triangles, 0)) << "two spheres";
}

TEST(Fragment_joining, joins_small_debris_that_looks_whole)
{
  const Shape ball = CSCD::test::sphere(4);
  Shape crumb = CSCD::test::scaled(CSCD::test::sphere(1), 0.1);
  for (const bool is_reversed : {false, true}) {
    Indexed_triangles triangles =
        to_indexed_triangles(CSCD::test::merged("", {ball, CSCD::test::translated(crumb, {1.15, 0, 0})}));
    if (is_reversed) {
      reverse(triangles, ball.triangles.size());
    }
    EXPECT_EQ(2, join(triangles, 1)) << "a sphere";
  }
}

TEST(Fragment_joining, turns_fragments_outwards)
{
  Indexed_triangles triangles = to_indexed_triangles(CSCD::test::sphere(2));
  reverse(triangles, 0);
  EXPECT_EQ(2, join(triangles, 0));
  EXPECT_GT(volume(triangles), 0);
}

} // namespace
