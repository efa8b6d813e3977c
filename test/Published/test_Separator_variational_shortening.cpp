// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Separators made by the variational flow, beside those made by edge flips.

#include "Separator/halfedges_along.h"
#include "Separator/is_closed_curve.h"
#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Local/Geodesic_polar_coordinates.h>
#include <CSCD/Published/Curve_trace.h>
#include <CSCD/Published/Edge_flip_shortening.h>
#include <CSCD/Published/Field_separator_finder.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace {

using CSCD::Edge_crossing;
using CSCD::Index;
using CSCD::Separator;
using CSCD::Shortening_outcome;
using CSCD::Triangulated_surface;
using CSCD::Vector_3;
using CSCD::Vertex_loop;
using CSCD::internal::Closest_point_projection;
using CSCD::internal::Polygon_trace;
using CSCD::internal::Projected_point;
using CSCD::internal::Solid_queries;
using CSCD::test::pi;

double length_of_crossings(const Triangulated_surface& surface, const std::vector<Edge_crossing>& crossings)
{
  std::vector<Vector_3> points;
  CSCD::internal::crossing_points(surface, crossings, points);
  return CSCD::internal::measure_polygon(points).length;
}

TEST(Polygon_trace, joins_points_over_the_surface)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::noisy(CSCD::test::torus(3, 1, 32), 0.1, 1));
  const Solid_queries queries(surface);
  const CSCD::internal::Polygon_trace trace(surface);
  for (const std::size_t number_of_points : {16u, 40u, 200u, 1000u}) {
    SCOPED_TRACE(number_of_points);
    std::vector<Projected_point> points;
    for (std::size_t i = 0; i < number_of_points; ++i) {
      const double angle = 2 * pi * double(i) / double(number_of_points);
      points.push_back(Closest_point_projection(surface, queries)(
          {3 + std::cos(angle), 0.2 * std::sin(2 * angle), std::sin(angle)}, CSCD::no_index));
    }
    std::vector<Edge_crossing> crossings;
    ASSERT_TRUE(trace(points, crossings));
    EXPECT_TRUE(CSCD::test::is_closed_curve(surface, crossings));
    EXPECT_NEAR(length_of_crossings(surface, crossings), 6.6, 0.3);
  }
}

TEST(Polygon_trace, refuses_what_crosses_nothing)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::cube());
  const CSCD::internal::Polygon_trace trace(surface);
  std::vector<Edge_crossing> crossings;
  const Vector_3 a = surface.point(surface.origin(0));
  const Vector_3 b = surface.point(surface.origin(1));
  const Vector_3 c = surface.point(surface.origin(2));
  const Vector_3 up(0, 0, 1);
  EXPECT_FALSE(
      trace({{(2 * a + b + c) / 4, up, 0}, {(a + 2 * b + c) / 4, up, 0}, {(a + b + 2 * c) / 4, up, 0}}, crossings));
  EXPECT_FALSE(trace({}, crossings));
}

/// Shortens the loop of every `stride`-th vertex by both methods. \return the number of loops that neither collapsed
std::size_t compare_with_flips(const Triangulated_surface& surface, Index stride, double& sum, double& flip_sum)
{
  const Solid_queries queries(surface);
  const CSCD::Vertex_fan_table corners(surface);
  CSCD::internal::Geodesic_polar_coordinates front(corners, surface.number_of_vertices());
  CSCD::internal::Separator_variational_shortening<Closest_point_projection, Polygon_trace> shortening(
      surface, Closest_point_projection(surface, queries));
  CSCD::internal::Separator_flip_shortening flip_shortening(surface, surface);
  std::size_t number = 0;
  for (Index source = 0; source < surface.number_of_vertices(); source += stride) {
    CSCD::internal::Nearest_meeting meeting(surface, front, source);
    front.grow(source, std::numeric_limits<std::size_t>::max(), meeting);
    Vertex_loop loop;
    if (meeting.has_found()) {
      CSCD::internal::trace_loop(front, meeting.first(), meeting.second(), loop);
    }
    Separator separator;
    Separator flipped;
    const std::vector<Index> halfedges = CSCD::test::halfedges_along(surface, loop);
    if (loop.size() < 3 || shortening(halfedges, source, separator) == Shortening_outcome::collapsed ||
        flip_shortening(halfedges, source, flipped) == Shortening_outcome::collapsed) {
      continue;
    }
    EXPECT_TRUE(CSCD::test::is_closed_curve(surface, separator.crossings)) << "source " << source;
    EXPECT_NEAR(length_of_crossings(surface, separator.crossings), separator.length, 0.1 * separator.length);
    ++number;
    sum += separator.length;
    flip_sum += flipped.length;
  }
  return number;
}

TEST(Separator_variational_shortening, comes_to_the_lengths_that_edge_flips_come_to)
{
  for (const CSCD::test::Shape& shape :
       {CSCD::test::torus(3, 1, 24), CSCD::test::noisy(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat), 0.2, 1),
        CSCD::test::y_tube(0.15)}) {
    SCOPED_TRACE(shape.name);
    const Triangulated_surface surface = CSCD::test::to_surface(shape);
    double sum = 0;
    double flip_sum = 0;
    EXPECT_GT(compare_with_flips(surface, 41, sum, flip_sum), 15u);
    EXPECT_NEAR(sum, flip_sum, 0.05 * flip_sum);
  }
}

} // namespace
