// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Components are told apart and measured, and look outwards in the end.

#include "Surface/to_indexed_triangles.h"
#include "support/shapes.h"
#include <CSCD/Surface/Surface_components.h>

#include <gtest/gtest.h>

namespace {

using CSCD::Halfedge_pairing;
using CSCD::Index;
using CSCD::Indexed_triangles;
using CSCD::Vector_3;
using CSCD::internal::Surface_components;

TEST(Surface_components, measures_each_component)
{
  const Indexed_triangles triangles = CSCD::test::to_indexed_triangles(CSCD::test::merged(
      "cubes",
      {CSCD::test::cube(), CSCD::test::reversed(CSCD::test::translated(CSCD::test::box("b", {1, 2, 3}), {5, 0, 0}))}));
  const Surface_components components(triangles);
  ASSERT_EQ(components.number(), 2u);
  for (Index f = 0; f < 24; ++f) {
    EXPECT_EQ(components.component[f], f / 12);
  }
  EXPECT_NEAR(components.measures[0].area, 6, 1e-14);
  EXPECT_NEAR(components.measures[1].area, 22, 1e-13);
  EXPECT_NEAR(components.measures[0].volume, 1, 1e-14);
  EXPECT_NEAR(components.measures[1].volume, -6, 1e-13);
  EXPECT_TRUE(components.measures[0].centroid.isApprox(Vector_3(0.5, 0.5, 0.5), 1e-14));
  EXPECT_TRUE(components.measures[1].centroid.isApprox(Vector_3(5.5, 1, 1.5), 1e-14));
}

TEST(orient_outwards, turns_what_looks_inwards)
{
  Indexed_triangles triangles = CSCD::test::to_indexed_triangles(CSCD::test::hollow_sphere(1));
  Halfedge_pairing pairing(triangles.faces, triangles.points.size());
  Surface_components components(triangles);
  EXPECT_LT(components.measures[1].volume, 0);
  EXPECT_EQ(CSCD::internal::orient_outwards(triangles, pairing, components), 1u);
  for (const auto& measure : Surface_components(triangles).measures) {
    EXPECT_GT(measure.volume, 0);
  }
  EXPECT_GT(components.measures[1].volume, 0);
  for (Index h = 0; h < pairing.number_of_halfedges(); ++h) {
    const Index twin = pairing.twin(h);
    ASSERT_EQ(triangles.faces[h / 3][h % 3], triangles.faces[twin / 3][(twin + 1) % 3]) << "the pairing was updated";
  }
}

TEST(orient_outwards, leaves_a_flat_body_alone)
{
  Indexed_triangles triangles{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}, 1};
  Halfedge_pairing pairing(triangles.faces, triangles.points.size());
  Surface_components components(triangles);
  EXPECT_EQ(CSCD::internal::orient_outwards(triangles, pairing, components), 0u);
}

} // namespace
