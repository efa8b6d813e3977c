// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tangent planes of a point complex: vectors in them and in space, and what is carried from one to the next.

#include "Points/to_point_complex.h"
#include "Published/to_surface_with_borders.h"
#include "support/shapes.h"
#include <CSCD/Points/Point_complex.h>
#include <CSCD/Published/Tangent_frames.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <set>
#include <utility>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Point_complex;
using CSCD::Vector_3;
using CSCD::internal::Point_frames;
using Complex = std::complex<double>;

TEST(Point_frames, hold_the_directions_of_edges)
{
  const Point_complex complex = CSCD::test::to_point_complex(CSCD::test::sphere(3));
  const Point_frames frames(complex);
  for (Index v = 0; v < complex.number_of_vertices(); ++v) {
    std::set<Index> neighbors;
    double last = -1;
    frames.for_each_neighbor(v, [&](Index neighbor, Index h) {
      EXPECT_EQ(complex.origin(h), v);
      EXPECT_EQ(complex.target(h), neighbor);
      EXPECT_TRUE(neighbors.insert(neighbor).second);
      const Vector_3 along = complex.point(neighbor) - complex.point(v);
      const Vector_3 direction = frames.in_space(v, std::polar(1., frames.direction_at_origin(h)));
      EXPECT_NEAR(direction.dot(complex.normal(v)), 0, 1e-12);
      EXPECT_NEAR(along.cross(direction).dot(complex.normal(v)), 0, 1e-12);
      EXPECT_GT(along.dot(direction), 0);
      EXPECT_EQ(frames.direction_at_target(complex.twin(h)), frames.direction_at_origin(h));
      const double turn = std::remainder(frames.direction_at_origin(h), 2 * CSCD::test::pi);
      const double angle = turn < -1e-12 ? turn + 2 * CSCD::test::pi : turn;
      EXPECT_GT(angle, last) << "counterclockwise, from the real axis on";
      last = angle;
    });
    const Complex vector(0.3, -0.7);
    EXPECT_LT(std::abs(frames.in_frame(v, frames.in_space(v, vector)) - vector), 1e-12);
  }
}

TEST(Point_frames, carry_vectors_as_the_plane_does)
{
  const Point_complex complex = CSCD::test::to_point_complex(CSCD::test::flat_grid(4, 3, 1));
  const Point_frames frames(complex);
  const Vector_3 vector(0.6, -0.8, 0);
  for (Index h = 0; h < complex.number_of_halfedges(); ++h) {
    const Complex there = frames.in_frame(complex.target(h), vector);
    EXPECT_LT(std::abs(frames.transport_to_origin(h) * there - frames.in_frame(complex.origin(h), vector)), 1e-12);
  }
}

TEST(Point_frames, carry_along_great_circles)
{
  const Point_complex complex = CSCD::test::to_point_complex(CSCD::test::sphere(3));
  const Point_frames frames(complex);
  for (Index h = 0; h < complex.number_of_halfedges(); ++h) {
    EXPECT_NEAR(std::abs(frames.transport_to_origin(h)), 1, 1e-12);
    EXPECT_LT(std::abs(frames.transport_to_origin(h) * frames.transport_to_origin(complex.twin(h)) - 1.), 1e-9);
    // An edge runs straight on, up to the normals of triangles, which are not quite those of the sphere.
    const Complex arriving = std::polar(-1., frames.direction_at_target(h));
    EXPECT_LT(std::abs(frames.transport_to_origin(h) * arriving - std::polar(1., frames.direction_at_origin(h))), 0.02);
  }
}

TEST(Point_frames, of_opposite_normals_and_of_edges_along_them)
{
  std::vector<Vector_3> points{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  std::vector<Vector_3> normals{{0, 0, 1}, {0, 0, -1}, {0, 0, 1}};
  const Point_complex complex(std::move(points), std::move(normals), {{0, 1, 2}});
  const Point_frames frames(complex);
  for (Index h = 0; h < complex.number_of_halfedges(); ++h) {
    EXPECT_NEAR(std::abs(frames.transport_to_origin(h)), 1, 1e-12);
    EXPECT_TRUE(std::isfinite(frames.direction_at_origin(h)));
  }
}

} // namespace
