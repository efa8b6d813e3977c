// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is no oriented manifold is refused, and the message names the place.

#include "Traits/message_of.h"
#include "Traits/to_indexed_triangles.h"
#include "support/shapes.h"
#include <CSCD/Surface/Halfedge_pairing.h>

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Indexed_triangles;
using CSCD::test::message_of;
using CSCD::test::names;

/// Only the faces count.
Indexed_triangles combinatorial(std::vector<std::array<Index, 3>> faces, std::size_t number_of_points)
{
  Indexed_triangles result;
  result.points.resize(number_of_points, CSCD::Vector_3::Zero());
  result.faces = std::move(faces);
  result.first_hole_filling_face = result.faces.size();
  return result;
}

std::string message(const Indexed_triangles& triangles)
{
  return message_of([&] { CSCD::check_manifold(triangles, [](Index vertex) { return vertex + 100; }); });
}

TEST(check_manifold, accepts_closed_and_open_surfaces)
{
  for (const auto& shape : {CSCD::test::sphere(1), CSCD::test::flat_disc(2, 7), CSCD::test::torus(3, 1, 8),
                            CSCD::test::slit_tube(10, 1, 24), CSCD::test::hollow_sphere(1)}) {
    EXPECT_EQ(message(CSCD::test::to_indexed_triangles(shape)), "") << shape.name;
  }
}

TEST(check_manifold, refuses_an_edge_with_three_faces)
{
  const std::string text = message(combinatorial({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, 5));
  EXPECT_TRUE(names(text, "the edge between vertices 100 and 101 has 3 faces")) << text;
}

TEST(check_manifold, refuses_opposite_orientations)
{
  const std::string text = message(combinatorial({{2, 0, 1}, {0, 1, 3}}, 4));
  EXPECT_TRUE(names(text, "the edge between vertices 100 and 101 has two faces of opposite orientation")) << text;
}

TEST(check_manifold, refuses_a_moebius_strip)
{
  // A strip of an odd number of triangles whose ends are joined with a twist.
  const std::string text = message(combinatorial({{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 0, 4}, {4, 0, 1}}, 5));
  EXPECT_NE(text.find("opposite orientation"), std::string::npos) << text;
  EXPECT_NE(text.find("one-sided"), std::string::npos) << text;
}

TEST(check_manifold, refuses_a_vertex_where_two_bodies_touch)
{
  Indexed_triangles triangles =
      combinatorial({{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}, {6, 4, 5}, {6, 0, 4}, {6, 5, 0}, {4, 0, 5}}, 7);
  const std::string text = message(triangles);
  EXPECT_TRUE(names(text, "vertex 100 is pinched")) << text;
}

TEST(check_manifold, refuses_a_vertex_where_two_borders_touch)
{
  const std::string text = message(combinatorial({{0, 1, 2}, {2, 3, 4}}, 5));
  EXPECT_TRUE(names(text, "vertex 102 is pinched")) << text;
}

TEST(check_manifold, refuses_a_vertex_on_the_border_of_one_fan_and_inside_another)
{
  Indexed_triangles triangles = combinatorial({{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}, {0, 4, 5}}, 6);
  const std::string text = message(triangles);
  EXPECT_TRUE(names(text, "vertex 100 is pinched")) << text;
}

} // namespace
