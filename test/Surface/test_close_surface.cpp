// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// After bridging, every surface is a closed oriented manifold, and its own faces are as before. The components that
// bound cavities, and the rest without them.

#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Surface/close_surface.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace {

using CSCD::Halfedge_pairing, CSCD::Index, CSCD::Indexed_triangles, CSCD::internal::Surface_components,
    CSCD::test::reversed, CSCD::test::scaled, CSCD::test::Shape, CSCD::test::sphere, CSCD::test::translated,
    CSCD::Triangulated_surface;

/// Bridges and compares; returns the surface.
Triangulated_surface expect_closed(const Indexed_triangles& input, std::size_t number_of_borders, long euler_number,
                                   std::size_t inserted = 0)
{
  const Halfedge_pairing pairing(input.faces, input.points.size());
  EXPECT_EQ(pairing.conflict(), CSCD::no_index);
  EXPECT_EQ(pairing.pinched_vertex(), CSCD::no_index);
  Indexed_triangles bridged = input;
  EXPECT_EQ(CSCD::internal::bridge_borders(bridged, pairing), number_of_borders);
  EXPECT_EQ(bridged.points.size(), input.points.size() + inserted);
  EXPECT_EQ(bridged.first_hole_filling_face, input.faces.size());
  EXPECT_TRUE(std::equal(input.faces.begin(), input.faces.end(), bridged.faces.begin()));
  Triangulated_surface surface(std::move(bridged));
  EXPECT_FALSE(surface.has_defect());
  EXPECT_EQ(long(surface.number_of_vertices()) - long(surface.number_of_faces() / 2), euler_number);
  return surface;
}

TEST(bridge_borders, closes_all_open_shapes)
{
  for (const auto& maker : CSCD::test::open_shapes()) {
    const Shape shape = maker.make();
    SCOPED_TRACE(shape.name);
    const long euler_number = 2 * long(shape.number_of_components) - 2 * long(shape.genus);
    expect_closed(CSCD::test::to_indexed_triangles(shape), shape.number_of_border_cycles, euler_number);
  }
}

TEST(bridge_borders, inserts_a_vertex_where_every_diagonal_exists)
{
  // Moebius' torus joins each two of its seven vertices; the faces around the last one are missing.
  Indexed_triangles input;
  for (Index i = 0; i < 7; ++i) {
    for (const std::array<Index, 3>& face :
         {std::array<Index, 3>{i, (i + 1) % 7, (i + 3) % 7}, std::array<Index, 3>{i, (i + 3) % 7, (i + 2) % 7}}) {
      if (std::count(face.begin(), face.end(), 6u) == 0) {
        input.faces.push_back(face);
      }
    }
  }
  for (Index i = 0; i < 6; ++i) {
    input.points.emplace_back(i, i * i % 5, i * i * i % 7);
  }
  input.first_hole_filling_face = input.faces.size();
  const Triangulated_surface surface = expect_closed(input, 1, 0, 1);
  EXPECT_EQ(surface.degree(6), 6u);
}

/// One character for each component of `parts`, which are joined in this order: 1 for a cavity.
std::string cavities_of(const std::vector<Shape>& parts)
{
  const Indexed_triangles triangles = CSCD::test::to_indexed_triangles(CSCD::test::merged("parts", parts));
  const Surface_components components(triangles);
  std::string result;
  for (const char is_cavity : CSCD::internal::Cavity_search(triangles, components)()) {
    result += is_cavity != 0 ? '1' : '0';
  }
  return result;
}

TEST(Cavity_search, finds_what_faces_inwards_within_a_body)
{
  const Shape body = scaled(sphere(3), 10);
  EXPECT_EQ(cavities_of({body, reversed(scaled(sphere(3), 9.9))}), "01") << "a thin wall";
  EXPECT_EQ(cavities_of({reversed(sphere(2)), body, reversed(translated(sphere(2), {5, 0, 0}))}), "101") << "bubbles";
  EXPECT_EQ(cavities_of({reversed(translated(sphere(3), {9.5, 0, 0})), body}), "00") << "through the surface";
  EXPECT_EQ(cavities_of({body, reversed(translated(sphere(2), {20, 0, 0}))}), "00") << "beside";
  EXPECT_EQ(cavities_of({body, sphere(2)}), "00") << "a body of its own";
  EXPECT_EQ(cavities_of({reversed(body)}), "0");
  EXPECT_EQ(cavities_of({reversed(body), reversed(sphere(2))}), "00");
}

TEST(Cavity_search, finds_the_void_around_another_body)
{
  const Shape body = scaled(sphere(3), 10);
  const Shape bubble = reversed(translated(sphere(2), {8.5, 0, 0}));
  EXPECT_EQ(cavities_of({body, reversed(scaled(sphere(3), 6)), sphere(2), bubble}), "0101");
}

TEST(fill_cavities, leaves_the_body_as_it_is)
{
  const Shape body = scaled(sphere(3), 10);
  const Shape bubble = reversed(sphere(2));
  Indexed_triangles triangles = CSCD::test::to_indexed_triangles(CSCD::test::merged("body", {bubble, body}));
  const Indexed_triangles before = triangles;
  Halfedge_pairing pairing(triangles.faces, triangles.points.size());
  Surface_components components(triangles);
  const CSCD::internal::Filled_cavities filled =
      CSCD::internal::fill_cavities(triangles, pairing, components, triangles.points.size());
  EXPECT_EQ(filled.number, 1U);
  EXPECT_EQ(components.number(), 1U);
  EXPECT_EQ(triangles.faces.size(), body.triangles.size());
  EXPECT_EQ(triangles.first_hole_filling_face, triangles.faces.size());
  EXPECT_EQ(filled.vertices, CSCD::internal::all_indices(bubble.points.size()));
  ASSERT_EQ(filled.old_number.size(), triangles.points.size());
  for (std::size_t i = 0; i < triangles.points.size(); ++i) {
    EXPECT_EQ(triangles.points[i], before.points[filled.old_number[i]]);
  }
  EXPECT_FALSE(Triangulated_surface(std::move(triangles), std::move(pairing)).has_defect());
}

} // namespace
