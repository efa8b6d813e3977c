// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a loop cuts off: flat discs, hemispheres, limbs.

#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/limb_tests.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using CSCD::Index;
using CSCD::Triangulated_surface;
using CSCD::Vector_3;
using CSCD::Vertex_loop;
using CSCD::internal::Enclosed_area_test;
using CSCD::test::pi;

constexpr double no_limit = 1e9;

/// The ring number `ring` of a swept shape.
Vertex_loop ring_loop(Index ring, Index around)
{
  Vertex_loop loop;
  for (Index k = 0; k < around; ++k) {
    loop.push_back(ring * around + k);
  }
  return loop;
}

TEST(Enclosed_area_test, of_a_flat_disc)
{
  constexpr Index around = 64;
  const Triangulated_surface surface =
      CSCD::test::to_surface(CSCD::test::tube(10, 1, around, CSCD::test::Tube_end::flat));
  Enclosed_area_test bump_test(surface);
  EXPECT_NEAR(bump_test.area_ratio(ring_loop(0, around), no_limit), 1 / (4 * pi), 1e-3);
}

TEST(Enclosed_area_test, of_a_hemisphere_and_of_limbs)
{
  constexpr Index around = 64;
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::capsule(10, 1, around));
  Enclosed_area_test bump_test(surface);
  for (Index ring = 0; ring < 50; ring += 10) {
    const Vertex_loop loop = ring_loop(ring, around);
    const double length = surface.point(loop.front()).x();
    EXPECT_NEAR(bump_test.area_ratio(loop, no_limit), (length + 1) / (2 * pi), 2e-3) << "limb of length " << length;
  }
}

TEST(Enclosed_area_test, of_a_loop_without_length_is_zero)
{
  CSCD::test::Shape shape = CSCD::test::sphere(2);
  const CSCD::test::Triangle triangle = shape.triangles.front();
  shape.points[triangle[1]] = shape.points[triangle[0]];
  shape.points[triangle[2]] = shape.points[triangle[0]];
  const Triangulated_surface surface = CSCD::test::to_surface(shape);
  Enclosed_area_test bump_test(surface);
  const Vertex_loop loop{Index(triangle[0]), Index(triangle[1]), Index(triangle[2])};
  EXPECT_EQ(bump_test.area_ratio(loop, no_limit), 0);
}

TEST(Enclosed_area_test, does_not_depend_on_direction_nor_side_and_can_be_used_again)
{
  constexpr Index around = 24;
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::capsule(10, 1, around));
  Enclosed_area_test bump_test(surface);
  Vertex_loop loop = ring_loop(5, around);
  const double ratio = bump_test.area_ratio(loop, no_limit);
  std::reverse(loop.begin(), loop.end());
  EXPECT_NEAR(bump_test.area_ratio(loop, no_limit), ratio, 1e-9);
  bump_test.area_ratio(ring_loop(9, around), 0.01);
  EXPECT_NEAR(bump_test.area_ratio(loop, no_limit), ratio, 1e-9);
}

TEST(Enclosed_area_test, tells_only_that_the_limit_is_exceeded)
{
  constexpr Index around = 24;
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::capsule(10, 1, around));
  Enclosed_area_test bump_test(surface);
  const Vertex_loop loop = ring_loop(20, around);
  EXPECT_GT(bump_test.area_ratio(loop, no_limit), 0.5);
  EXPECT_GE(bump_test.area_ratio(loop, 0.1), 0.1);
}

TEST(Enclosed_area_test, of_a_loop_that_separates_nothing_is_the_whole_surface)
{
  constexpr Index around = 24;
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::torus(3, 1, around));
  Enclosed_area_test bump_test(surface);
  const double length = 2 * around * std::sin(pi / around);
  EXPECT_NEAR(bump_test.area_ratio(ring_loop(4, around), no_limit), surface.total_area() / (length * length), 1e-4);
}

TEST(Enclosed_area_test, of_what_is_no_loop_is_nothing)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::sphere(2));
  Enclosed_area_test bump_test(surface);
  EXPECT_EQ(bump_test.area_ratio({0, 1, 2}, no_limit), 0);
}

} // namespace
