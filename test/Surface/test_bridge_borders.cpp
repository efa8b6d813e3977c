// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// After bridging, every surface is a closed oriented manifold, and its own faces are as before.

#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Surface/close_surface.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace {

using CSCD::Index, CSCD::Indexed_triangles, CSCD::Triangulated_surface, CSCD::Vector3, CSCD::test::Shape;

struct Bridged
{
  explicit Bridged(Indexed_triangles input) : triangles(std::move(input))
  {
    const CSCD::Halfedge_pairing pairing(triangles.faces, triangles.points.size());
    EXPECT_EQ(pairing.conflict(), CSCD::no_index);
    EXPECT_EQ(pairing.pinched_vertex(), CSCD::no_index);
    number_of_borders = CSCD::internal::bridge_borders(triangles, pairing);
  }

  Indexed_triangles triangles;
  std::size_t number_of_borders = 0;
};

/// Bridges and compares; returns the surface.
Triangulated_surface expect_closed(const Indexed_triangles& input, std::size_t number_of_borders, long euler_number,
                                   std::size_t inserted = 0)
{
  Bridged bridged(input);
  EXPECT_EQ(bridged.number_of_borders, number_of_borders);
  EXPECT_EQ(bridged.triangles.points.size(), input.points.size() + inserted);
  EXPECT_EQ(bridged.triangles.first_hole_filling_face, input.faces.size());
  EXPECT_TRUE(std::equal(input.faces.begin(), input.faces.end(), bridged.triangles.faces.begin()));
  Triangulated_surface surface(std::move(bridged.triangles));
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

} // namespace
