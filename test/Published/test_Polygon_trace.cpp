// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polygons are traced over a surface, or refused.

#include "Separator/is_closed_curve.h"
#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Published/Curve_trace.h>
#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using CSCD::Edge_crossing;
using CSCD::Triangulated_surface;
using CSCD::Vector_3;
using CSCD::internal::Closest_point_projection;
using CSCD::internal::Polygon_trace;
using CSCD::internal::Projected_point;
using CSCD::internal::Solid_queries;
using CSCD::test::pi;

TEST(Polygon_trace, follows_a_circle_around_a_tube)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat));
  const Solid_queries queries(surface);
  const Closest_point_projection project(surface, queries);
  std::vector<Projected_point> points;
  for (int i = 0; i < 20; ++i) {
    const double angle = 2 * pi * i / 20;
    points.push_back(project({5.1, std::cos(angle), std::sin(angle)}, CSCD::no_index));
  }
  std::vector<Edge_crossing> crossings;
  ASSERT_TRUE(Polygon_trace(surface)(points, crossings));
  EXPECT_TRUE(CSCD::test::is_closed_curve(surface, crossings));
  EXPECT_GE(crossings.size(), 24u);
}

/// The plane through the points goes round and round the first ball.
TEST(Polygon_trace, ends_where_a_point_cannot_be_reached)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::merged(
      "two balls", {CSCD::test::sphere(3), CSCD::test::translated(CSCD::test::sphere(3), {100, 0, 0})}));
  const Solid_queries queries(surface);
  const Closest_point_projection project(surface, queries);
  std::vector<Projected_point> points;
  for (const double x : {0.1, 0.3, 100.1}) {
    points.push_back(project({x, 0.2, 1}, CSCD::no_index));
  }
  std::vector<Edge_crossing> crossings;
  EXPECT_FALSE(Polygon_trace(surface)(points, crossings));
}

} // namespace
