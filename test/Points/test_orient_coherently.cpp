// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Turned faces are turned back, and surfaces with one side are cut open.

#include "Surface/to_indexed_triangles.h"
#include "support/shapes.h"
#include <CSCD/Points/reconstruct_surface_impl.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace {

using CSCD::Halfedge_pairing;
using CSCD::Index;
using Faces = std::vector<std::array<Index, 3>>;

TEST(orient_coherently, turns_faces_like_the_first_one)
{
  const Faces expected = to_indexed_triangles(CSCD::test::double_torus(0.2)).faces;
  Faces faces = expected;
  std::mt19937 random(1);
  for (std::size_t face = 1; face < faces.size(); ++face) {
    if (random() % 2 == 0) {
      std::swap(faces[face][1], faces[face][2]);
    }
  }
  CSCD::internal::orient_coherently(faces);
  EXPECT_TRUE(expected == faces);
}

TEST(orient_coherently, keeps_components_apart)
{
  // Two triangles that meet in a point, and one that meets the second in an edge.
  Faces faces = {{0, 1, 2}, {2, 3, 4}, {3, 4, 5}};
  CSCD::internal::orient_coherently(faces);
  EXPECT_TRUE((Faces{{0, 1, 2}, {2, 3, 4}, {3, 5, 4}}) == faces);
}

TEST(orient_coherently, opens_a_moebius_strip)
{
  constexpr Index length = 7; // odd: the strip of triangles `i, i + 1, i + 2` is twisted
  Faces faces;
  for (Index i = 0; i < length; ++i) {
    faces.push_back({i, (i + 1) % length, (i + 2) % length});
  }
  CSCD::internal::orient_coherently(faces);
  EXPECT_EQ(std::size_t(length - 1), faces.size());
  EXPECT_EQ(CSCD::no_index, Halfedge_pairing(faces, length).conflict());
}

} // namespace
