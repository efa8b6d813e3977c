// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Walks over faces: straight in the plane, along geodesics elsewhere, never off the surface.

#include "Published/to_surface_with_borders.h"
#include "support/shapes.h"
#include <CSCD/Published/Surface_walk.h>
#include <CSCD/Published/Tangent_frames.h>
#include <CSCD/Surface/Triangulated_surface.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>

namespace {

using CSCD::Index;
using CSCD::Triangulated_surface;
using CSCD::Vector_3;
using CSCD::internal::Face_point;
using CSCD::internal::Surface_walk;
using CSCD::internal::Tangent_frames;

void expect_on_face(const Face_point& at)
{
  double sum = 0;
  for (double weight : at.weights) {
    EXPECT_GE(weight, 0);
    sum += weight;
  }
  EXPECT_NEAR(sum, 1, 1e-12);
}

TEST(Surface_walk, is_straight_in_the_plane_and_ends_at_the_border)
{
  const Triangulated_surface surface = CSCD::test::to_surface_with_borders(CSCD::test::flat_grid(10, 10, 1));
  const Tangent_frames<Triangulated_surface> frames(surface);
  const Surface_walk walk(frames);
  std::mt19937_64 random(5);
  for (Index v = 0; v < surface.number_of_vertices(); ++v) {
    Vector_3 step(4 * CSCD::test::random_signed_unit(random), 4 * CSCD::test::random_signed_unit(random), 0);
    const Face_point middle = walk(walk.at_vertex(v), step);
    const Face_point end = walk(middle, step);
    expect_on_face(end);
    const Vector_3 goal = surface.point(v) + 2 * step;
    const bool stays = goal.x() >= 0 && goal.x() <= 10 && goal.y() >= 0 && goal.y() <= 10;
    if (stays) {
      EXPECT_LT((walk.position(end) - goal).norm(), 1e-9);
    } else {
      EXPECT_LT((walk.position(end) - surface.point(v)).norm(), 2 * step.norm() + 1e-9);
    }
  }
}

TEST(Surface_walk, returns_around_a_tube)
{
  const std::size_t around = 24;
  const Triangulated_surface surface =
      CSCD::test::to_surface_with_borders(CSCD::test::tube(6, 1, around, CSCD::test::Tube_end::open));
  const Tangent_frames<Triangulated_surface> frames(surface);
  const Surface_walk walk(frames);
  const double girth = 2 * double(around) * std::sin(CSCD::test::pi / double(around));
  const Face_point start{0, {0.3, 0.3, 0.4}};
  const Vector_3 at = walk.position(start);
  const Face_point end = walk(start, girth * Vector_3(0, -at.z(), at.y()).normalized());
  EXPECT_LT((walk.position(end) - at).norm(), 0.05 * girth) << "the step is along the face only nearly";
  expect_on_face(end);
}

TEST(Surface_walk, keeps_to_the_face_without_a_step)
{
  const Triangulated_surface surface = CSCD::test::to_surface_with_borders(CSCD::test::tetrahedron());
  const Tangent_frames<Triangulated_surface> frames(surface);
  const Surface_walk walk(frames);
  for (Index v = 0; v < 4; ++v) {
    const Face_point at = walk(walk.at_vertex(v), Vector_3::Zero());
    EXPECT_LT((walk.position(at) - surface.point(v)).norm(), 1e-12);
  }
}

} // namespace
