// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Separators of point clouds: how long they are, where they come to rest, and that they separate.

#include "Points/to_point_complex.h"
#include "Separator/halfedges_along.h"
#include "Surface/edge_ways.h"
#include "support/sampling.h"
#include "support/shapes.h"
#include <CSCD/Points/Point_complex.h>
#include <CSCD/Published/Curve_trace.h>
#include <CSCD/Published/Edge_flip_shortening.h>
#include <CSCD/Published/Field_separator_finder.h>
#include <CSCD/Published/Variational_shortening.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

namespace {

using CSCD::Edge_crossing;
using CSCD::Index;
using CSCD::Point_complex;
using CSCD::Separator;
using CSCD::Shortening_outcome;
using CSCD::Vector_3;
using CSCD::Vertex_loop;
using CSCD::internal::Complex_trace;
using CSCD::internal::Moving_least_squares_projection;
using CSCD::internal::Point_neighborhoods;
using CSCD::test::pi;
using CSCD::test::Shape;

/// A sampled shape with what is needed to shorten loops on it.
struct Fixture
{
  Fixture(const Shape& shape, std::size_t number_of_points, double noise = 0)
      : complex(CSCD::test::to_point_complex(
            CSCD::test::shaken(CSCD::test::sampled(shape, number_of_points, 1),
                               noise * CSCD::test::mean_spacing(shape, number_of_points), 2))),
        neighborhoods(complex), shortening(complex, Moving_least_squares_projection(complex, neighborhoods))
  {
  }
  Fixture(const Fixture&) = delete;
  Fixture& operator=(const Fixture&) = delete;

  /// Shortens `loop` in the ball around its first vertex.
  Shortening_outcome shorten(const Vertex_loop& loop, Separator& separator)
  {
    return shortening(CSCD::test::halfedges_along(complex, loop), loop.front(), separator);
  }

  Point_complex complex;
  Point_neighborhoods neighborhoods;
  CSCD::internal::Separator_variational_shortening<Moving_least_squares_projection, Complex_trace> shortening;
};

/// Places on a circle around the x axis, or a curve that sways about it.
std::vector<Vector_3> places_around_axis(double x, double radius, double sway)
{
  std::vector<Vector_3> places;
  for (int i = 0; i < 6; ++i) {
    const double angle = 2 * pi * i / 6;
    places.emplace_back(x + sway * std::sin(2 * angle), radius * std::cos(angle), radius * std::sin(angle));
  }
  return places;
}

/// Places around the tube of the torus around the z axis with radii 3 and 1.
std::vector<Vector_3> places_around_tube(double longitude, double sway)
{
  std::vector<Vector_3> places;
  for (int i = 0; i < 6; ++i) {
    const double angle = 2 * pi * i / 6;
    const double turned = longitude + sway * std::sin(2 * angle);
    const double radius = 3 + std::cos(angle);
    places.emplace_back(radius * std::cos(turned), radius * std::sin(turned), std::sin(angle));
  }
  return places;
}

TEST(Point_separator_shortening, finds_the_meridians_of_a_torus)
{
  const Shape shape = CSCD::test::torus(3, 1, 96);
  struct Case
  {
    std::size_t number_of_points;
    double noise;     // relative to the mean distance of the nearest points
    double max_error; // of the length, relative
  };
  for (const Case& c : {Case{1000, 0, 0.01}, Case{4000, 0, 0.004}, Case{4000, 0.3, 0.03}, Case{4000, 0.8, 0.06}}) {
    SCOPED_TRACE(c.number_of_points);
    SCOPED_TRACE(c.noise);
    Fixture fixture(shape, c.number_of_points, c.noise);
    for (double longitude = 0; longitude < 6.2; longitude += 0.31) {
      SCOPED_TRACE(longitude);
      const Vertex_loop loop = CSCD::test::loop_through(fixture.complex, places_around_tube(longitude, 0.1));
      Separator separator;
      ASSERT_NE(fixture.shorten(loop, separator), Shortening_outcome::collapsed);
      EXPECT_NEAR(separator.length, 2 * pi, c.max_error * 2 * pi);
      // All meridians are as short: where the curve comes to rest is a matter of noise. It is a circle around the core.
      EXPECT_NEAR(std::hypot(separator.center.x(), separator.center.y()), 3, 0.05);
      EXPECT_NEAR(separator.center.z(), 0, 0.05);
      EXPECT_NEAR(separator.area, pi, 2.5 * c.max_error * pi);
      EXPECT_LT(separator.planarity, c.noise > 0 ? 0.01 : 0.002);
      EXPECT_NEAR(std::abs(separator.normal.z()), 0, 0.1);
      EXPECT_NEAR(CSCD::internal::measure_polygon(*separator.points).length, separator.length, 1e-12);
      EXPECT_TRUE(CSCD::test::separates(fixture.complex, separator.crossings, [&](Index vertex) {
        return fixture.complex.point(vertex).dot(separator.center) > 0; // not around the torus
      }));
    }
  }
}

TEST(Point_separator_shortening, cuts_the_ends_of_a_tube_apart)
{
  for (const double noise : {0., 0.5}) {
    Fixture fixture(CSCD::test::capsule(8, 1, 64), 3000, noise);
    const Point_complex& complex = fixture.complex;
    const Index left_tip = CSCD::test::nearest_vertex(complex, {9, 0, 0});
    const Index right_tip = CSCD::test::nearest_vertex(complex, {-1, 0, 0});
    for (double x = 1; x <= 7; x += 0.5) {
      SCOPED_TRACE(x);
      Separator separator;
      const Vertex_loop loop = CSCD::test::loop_through(complex, places_around_axis(x, 1, 0.2));
      ASSERT_NE(fixture.shorten(loop, separator), Shortening_outcome::collapsed);
      EXPECT_GT(separator.normal.x(), 0.98);
      EXPECT_EQ(CSCD::test::flooded(complex, separator.crossings, {left_tip}, CSCD::test::anywhere).count(right_tip),
                0u);
      for (const Edge_crossing& crossing : separator.crossings) {
        const Vector_3& origin = complex.point(complex.origin(crossing.halfedge));
        const Vector_3& target = complex.point(complex.target(crossing.halfedge));
        EXPECT_LE((origin - target).dot(separator.normal), 0.2 * complex.mean_edge_length()) << "the left is ahead";
        EXPECT_NEAR(CSCD::internal::crossing_point(complex, crossing).x(), x, 0.5);
      }
    }
  }
}

/// Whether the vertices that the crossings are nearest to are connected among themselves.
bool is_connected_ring(const Point_complex& complex, const std::vector<Edge_crossing>& crossings)
{
  std::set<Index> ring;
  for (const Edge_crossing& crossing : crossings) {
    ring.insert(crossing.position < 0.5 ? complex.origin(crossing.halfedge) : complex.target(crossing.halfedge));
  }
  return CSCD::test::flooded(complex, {}, {*ring.begin()}, [&](Index vertex) { return ring.count(vertex) != 0; }) ==
         ring;
}

TEST(Point_separator_shortening, mirrors_the_sides_of_the_opposite_loop)
{
  Fixture fixture(CSCD::test::capsule(8, 1, 64), 3000);
  for (double x = 2; x <= 6; x += 0.8) {
    Vertex_loop loop = CSCD::test::loop_through(fixture.complex, places_around_axis(x, 1, 0.2));
    Separator there;
    ASSERT_NE(fixture.shorten(loop, there), Shortening_outcome::collapsed);
    EXPECT_TRUE(is_connected_ring(fixture.complex, there.crossings));
    std::reverse(loop.begin(), loop.end());
    Separator back;
    ASSERT_NE(fixture.shorten(loop, back), Shortening_outcome::collapsed);
    EXPECT_NEAR(back.length, there.length, 0.01 * there.length);
    EXPECT_LT(back.normal.dot(there.normal), -0.99);
    EXPECT_LT((back.center - there.center).norm(), 0.1);
  }
}

TEST(Point_separator_shortening, holds_curves_in_the_ball)
{
  // On a cone curves slide to the thin end, until they leave the ball.
  Fixture fixture(CSCD::test::tapered_tube(8, 0.3, 1.5, 64), 3000);
  const Vertex_loop loop = CSCD::test::loop_through(fixture.complex, places_around_axis(5, 1.05, 0));
  const Vector_3 source = fixture.complex.point(loop.front());
  double radius = 0;
  for (const Index vertex : loop) {
    radius = std::max(radius, (fixture.complex.point(vertex) - source).norm());
  }
  Separator separator;
  EXPECT_EQ(fixture.shorten(loop, separator), Shortening_outcome::held);
  for (const Vector_3& point : *separator.points) {
    EXPECT_LT((point - source).norm(), 1.03 * radius);
  }
  EXPECT_GT(separator.center.x(), 3.5);
  EXPECT_LT(separator.length, 2 * pi * 1.05);
}

TEST(Point_separator_shortening, notices_what_collapses)
{
  Fixture fixture(CSCD::test::sphere(5), 3000);
  std::vector<Vector_3> places;
  for (int i = 0; i < 6; ++i) {
    places.emplace_back(0.5 * std::cos(pi * i / 3), 0.5 * std::sin(pi * i / 3), std::sqrt(0.75));
  }
  Separator separator;
  const Vertex_loop loop = CSCD::test::loop_through(fixture.complex, places);
  EXPECT_EQ(fixture.shorten(loop, separator), Shortening_outcome::collapsed);
  EXPECT_TRUE(separator.crossings.empty()) << "it stays as it was";
  EXPECT_EQ(fixture.shorten({loop[0], loop[1]}, separator), Shortening_outcome::collapsed);
}

TEST(Point_separator_shortening, gives_the_same_answer_again)
{
  Fixture fixture(CSCD::test::torus(3, 1, 64), 2000, 0.5);
  const Vertex_loop loop = CSCD::test::loop_through(fixture.complex, places_around_tube(1, 0.1));
  Separator first;
  fixture.shorten(loop, first);
  Separator other;
  fixture.shorten(CSCD::test::loop_through(fixture.complex, places_around_tube(4, 0.1)), other);
  Separator again;
  fixture.shorten(loop, again);
  EXPECT_EQ(again.points, first.points);
  ASSERT_EQ(again.crossings.size(), first.crossings.size());
  for (std::size_t i = 0; i < first.crossings.size(); ++i) {
    EXPECT_EQ(again.crossings[i].halfedge, first.crossings[i].halfedge);
    EXPECT_EQ(again.crossings[i].position, first.crossings[i].position);
  }
}

} // namespace
