// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vertices for many limbs of few faces.

#include "Surface/to_indexed_triangles.h"
#include "support/shapes.h"
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Surface/refine_large_faces.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <utility>

namespace {

using CSCD::Halfedge_pairing;
using CSCD::Indexed_triangles;
using CSCD::internal::Surface_components;
using CSCD::test::Shape;

struct Sampled
{
  explicit Sampled(const Shape& shape) : triangles(CSCD::test::to_indexed_triangles(shape))
  {
    Halfedge_pairing pairing(triangles.faces, triangles.points.size());
    Surface_components components(triangles);
    const Surface_components::Measure before = components.measures.front();
    number_of_inserted_vertices = CSCD::internal::sample_limbs(triangles, pairing, components);
    EXPECT_EQ(triangles.points.size(), shape.points.size() + number_of_inserted_vertices);
    EXPECT_EQ(triangles.first_hole_filling_face, triangles.faces.size());
    const Surface_components after(triangles);
    EXPECT_EQ(after.component, components.component);
    EXPECT_NEAR(after.measures.front().area, before.area, 1e-9 * before.area);
    EXPECT_NEAR(after.measures.front().volume, before.volume, 1e-9 * std::abs(before.volume));
    EXPECT_FALSE(CSCD::Triangulated_surface(Indexed_triangles(triangles)).defect());
  }

  Indexed_triangles triangles;
  std::size_t number_of_inserted_vertices = 0;
};

TEST(sample_limbs, gives_each_tooth_of_a_comb_a_few_rings)
{
  for (const std::size_t teeth : {30U, 100U, 1000U}) {
    for (const bool has_bar : {false, true}) {
      const Sampled sampled(CSCD::test::comb(teeth, has_bar));
      EXPECT_GE(sampled.number_of_inserted_vertices, 24 * teeth);
      EXPECT_LE(sampled.number_of_inserted_vertices, 64 * teeth) << "slivers take no more";
    }
  }
}

TEST(sample_limbs, leaves_what_is_sampled_alone)
{
  for (const Shape& shape :
       {CSCD::test::comb(5, true), CSCD::test::cube(), CSCD::test::beam(), CSCD::test::subdivided_cube(5),
        CSCD::test::torus(3, 1, 48), CSCD::test::anisotropic_tube(40, 1, 8, 2),
        CSCD::test::midpoint_subdivided(CSCD::test::comb(30, true), 3)}) {
    EXPECT_EQ(Sampled(shape).number_of_inserted_vertices, 0u) << shape.name;
  }
}

TEST(sample_limbs, takes_noise_for_no_limbs)
{
  const Shape tube = CSCD::test::noisy(CSCD::test::anisotropic_tube(40, 1, 48, 160), 1, 1);
  EXPECT_EQ(Sampled(tube).number_of_inserted_vertices, 0u);
}

TEST(sample_limbs, refines_the_same_whatever_the_numbers_are)
{
  const Shape comb = CSCD::test::comb(40, true);
  EXPECT_EQ(Sampled(comb).number_of_inserted_vertices,
            Sampled(CSCD::test::renumbered(comb, 1).shape).number_of_inserted_vertices);
}

} // namespace
