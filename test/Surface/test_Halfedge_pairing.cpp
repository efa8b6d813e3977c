// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pairing of halfedges, and what it tells of manifolds.

#include "Surface/to_indexed_triangles.h"
#include "Traits/message_of.h"
#include "support/Allow_threads.h"
#include "support/shapes.h"
#include <CSCD/Surface/Triangles.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace {

using CSCD::Halfedge_pairing;
using CSCD::Index;
using CSCD::Indexed_triangles;
using CSCD::no_index;
using CSCD::test::message_of;
using CSCD::test::names;

using Faces = std::vector<std::array<Index, 3>>;

Index source(const Faces& faces, Index h)
{
  return faces[h / 3][h % 3];
}

Index target(const Faces& faces, Index h)
{
  return faces[h / 3][(h + 1) % 3];
}

/// The rows of `outgoing()` hold each halfedge once, and go counterclockwise from the border or the smallest one on.
void expect_ordered_rows(const Faces& faces, const Halfedge_pairing& pairing)
{
  std::size_t number = 0;
  for (Index vertex = 0; vertex < pairing.outgoing().number_of_rows(); ++vertex) {
    const auto row = pairing.outgoing()[vertex];
    number += row.size();
    for (const Index* h = row.begin(); h != row.end(); ++h) {
      ASSERT_EQ(source(faces, *h), vertex);
      const bool is_last = h + 1 == row.end();
      const Index expected = is_last ? (pairing.twin(*row.begin()) == no_index ? no_index : *row.begin()) : *(h + 1);
      ASSERT_EQ(pairing.twin(Halfedge_pairing::previous(*h)), expected);
    }
    if (!row.empty() && pairing.twin(*row.begin()) != no_index) {
      ASSERT_EQ(*row.begin(), *std::min_element(row.begin(), row.end()));
    }
  }
  EXPECT_EQ(number, 3 * faces.size());
}

void expect_consistent(const Faces& faces, const Halfedge_pairing& pairing, std::size_t expected_border)
{
  std::size_t border = 0;
  for (Index h = 0; h < pairing.number_of_halfedges(); ++h) {
    const Index twin = pairing.twin(h);
    if (twin == no_index) {
      ++border;
      continue;
    }
    ASSERT_EQ(pairing.twin(twin), h);
    ASSERT_EQ(source(faces, twin), target(faces, h));
    ASSERT_EQ(target(faces, twin), source(faces, h));
  }
  EXPECT_EQ(border, expected_border);
  EXPECT_EQ(pairing.has_border(), expected_border > 0);
  EXPECT_EQ(pairing.conflict(), no_index);
  EXPECT_EQ(pairing.pinched_vertex(), no_index);
  expect_ordered_rows(faces, pairing);
}

TEST(Halfedge_pairing, pairs_a_closed_surface)
{
  const auto triangles = CSCD::test::to_indexed_triangles(CSCD::test::sphere(2));
  expect_consistent(triangles.faces, Halfedge_pairing(triangles.faces, triangles.points.size()), 0);
}

TEST(Halfedge_pairing, leaves_the_border_without_partner)
{
  const auto triangles = CSCD::test::to_indexed_triangles(CSCD::test::flat_disc(3, 24));
  expect_consistent(triangles.faces, Halfedge_pairing(triangles.faces, triangles.points.size()), 24);
}

TEST(Halfedge_pairing, pairs_vertices_of_any_degree)
{
  // Below and above the sizes from which on fans are ordered in another way.
  for (std::size_t valence : {3u, 8u, 9u, 16u, 17u, 5000u}) {
    const auto triangles = CSCD::test::to_indexed_triangles(CSCD::test::double_cone(valence));
    // The apices become the smallest numbers.
    Faces faces = triangles.faces;
    const Index n = Index(triangles.points.size());
    for (auto& face : faces) {
      for (Index& corner : face) {
        corner = n - 1 - corner;
      }
    }
    expect_consistent(faces, Halfedge_pairing(faces, n), 0);
  }
}

TEST(Halfedge_pairing, pairs_a_pillow)
{
  const Faces faces{{0, 1, 2}, {0, 2, 1}};
  expect_consistent(faces, Halfedge_pairing(faces, 3), 0);
}

TEST(Halfedge_pairing, reports_two_faces_of_opposite_orientation)
{
  const Faces faces{{0, 1, 2}, {0, 1, 3}};
  const Halfedge_pairing pairing(faces, 4);
  ASSERT_NE(pairing.conflict(), no_index);
  EXPECT_EQ(pairing.conflict() % 3, 0u);
}

TEST(Halfedge_pairing, reports_three_faces_at_an_edge)
{
  for (const std::array<Index, 3>& third : {std::array<Index, 3>{0, 1, 4}, std::array<Index, 3>{1, 0, 4}}) {
    const Faces faces{{0, 1, 2}, {1, 0, 3}, third};
    EXPECT_NE(Halfedge_pairing(faces, 5).conflict(), no_index);
  }
}

TEST(Halfedge_pairing, of_nothing_is_empty)
{
  EXPECT_EQ(Halfedge_pairing(Faces{}, 0).number_of_halfedges(), 0u);
}

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

TEST(Halfedge_pairing, is_the_same_for_any_number_of_threads)
{
  // Tetrahedra of which some contradict each other, and some touch in a vertex, far behind the first ones.
  constexpr Index number = 10000;
  Faces faces;
  for (Index v = 0; v < 4 * number; v += 4) {
    const bool is_reversed = v % 16000 == 12000;
    faces.push_back({v, is_reversed ? v + 1 : v + 2, is_reversed ? v + 2 : v + 1});
    faces.push_back({v, v + 1, v + 3});
    faces.push_back({v + 1, v + 2, v + 3});
    faces.push_back({v + 2, v, v % 20000 == 16000 ? v + 7 : v + 3});
  }
  const CSCD::test::Allow_threads allow(3);
  const Halfedge_pairing expected(faces, 4 * number);
  EXPECT_EQ(target(faces, expected.conflict()), 12001u);
  for (const unsigned number_of_threads : {2u, 3u}) {
    const Halfedge_pairing pairing(faces, 4 * number, number_of_threads);
    EXPECT_EQ(pairing.conflict(), expected.conflict());
    EXPECT_EQ(pairing.pinched_vertex(), expected.pinched_vertex());
    EXPECT_EQ(pairing.has_border(), expected.has_border());
    EXPECT_EQ(pairing.outgoing().values(), expected.outgoing().values());
    for (Index h = 0; h < pairing.number_of_halfedges(); ++h) {
      ASSERT_EQ(pairing.twin(h), expected.twin(h));
    }
  }
}

} // namespace
