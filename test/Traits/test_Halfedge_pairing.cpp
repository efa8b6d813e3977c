// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every halfedge finds its partner, and what has no partner is told.

#include "Traits/to_indexed_triangles.h"
#include "support/shapes.h"
#include <CSCD/Surface/Halfedge_pairing.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

namespace {

using CSCD::Halfedge_pairing;
using CSCD::Index;
using CSCD::no_index;
using Faces = std::vector<std::array<Index, 3>>;

Index source(const Faces& faces, Index h)
{
  return faces[h / 3][h % 3];
}

Index target(const Faces& faces, Index h)
{
  return faces[h / 3][(h + 1) % 3];
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
  // Below and above the size from which on a bucket is sorted.
  for (std::size_t valence : {3u, 15u, 16u, 17u, 5000u}) {
    const auto triangles = CSCD::test::to_indexed_triangles(CSCD::test::double_cone(valence));
    // The apices become the smallest numbers, so that their buckets hold all incident edges.
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

} // namespace
