// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves that are shortened to known lengths, are held by a ball, or collapse.

#include "Surface/to_surface.h"
#include "support/Similarity.h"
#include "support/shapes.h"
#include <CSCD/Published/Edge_flip_shortening.h>
#include <CSCD/Published/Variational_shortening.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <boost/math/special_functions/ellint_2.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace {

using CSCD::Shortening_outcome;
using CSCD::Triangulated_surface;
using CSCD::Vector_3;
using CSCD::internal::Closest_point_projection;
using CSCD::internal::Projected_point;
using CSCD::internal::Solid_queries;
using CSCD::internal::Variational_report;
using CSCD::internal::Variational_shortening;
using CSCD::test::pi;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t number_of_samples = 64;

double length(const std::vector<Vector_3>& points)
{
  return CSCD::internal::measure_polygon(points).length;
}

/// A surface with what is needed to shorten curves on it.
struct Fixture
{
  explicit Fixture(const CSCD::test::Shape& shape)
      : surface(CSCD::test::to_surface(shape)), queries(surface), shorten(Closest_point_projection(surface, queries))
  {
  }
  Fixture(const Fixture&) = delete;
  Fixture& operator=(const Fixture&) = delete;

  Triangulated_surface surface;
  Solid_queries queries;
  Variational_shortening<Closest_point_projection> shorten;
};

/// The point at `angle` around the x axis, at the height `x`.
Vector_3 on_circle(double x, double radius, double angle)
{
  return {x, radius * std::cos(angle), radius * std::sin(angle)};
}

/// A closed curve around the x axis that sways along it.
std::vector<Vector_3> swaying_circle(double x, double radius, double sway)
{
  std::vector<Vector_3> points;
  for (int i = 0; i < 200; ++i) {
    const double angle = 2 * pi * i / 200;
    points.push_back(on_circle(x + sway * std::sin(3 * angle) + sway * std::cos(angle), radius, angle));
  }
  return points;
}

TEST(Variational_shortening, makes_a_circle_of_a_swaying_curve_around_a_cylinder)
{
  Fixture fixture(CSCD::test::tube(10, 1, 48, CSCD::test::Tube_end::flat));
  std::vector<Vector_3> points = swaying_circle(5, 1, 0.3);
  const double before = length(points);
  const Variational_report report = fixture.shorten(points, number_of_samples, {5, 0, 1}, infinity);
  EXPECT_EQ(report.outcome, Shortening_outcome::straight);
  EXPECT_NEAR(report.length_before, before, 0.01 * before);
  EXPECT_EQ(points.size(), number_of_samples);
  EXPECT_NEAR(report.length, length(points), 1e-9);
  EXPECT_NEAR(report.length, 2 * pi, 0.005 * 2 * pi);
  EXPECT_LT(CSCD::internal::measure_polygon(points).planarity, 0.002);
  // Its sides have become equal.
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR((points[(i + 1) % points.size()] - points[i]).norm(), report.length / number_of_samples,
                0.02 * report.length / number_of_samples);
  }
}

TEST(Variational_shortening, finds_the_meridian_of_a_torus)
{
  Fixture fixture(CSCD::test::torus(3, 1, 48));
  std::vector<Vector_3> points;
  for (int i = 0; i < 100; ++i) {
    const double angle = 2 * pi * i / 100;
    const double around = 0.15 * std::sin(2 * angle);
    const double radius = 3 + std::cos(angle);
    points.emplace_back(radius * std::cos(around), radius * std::sin(around), std::sin(angle));
  }
  const Variational_report report = fixture.shorten(points, number_of_samples, {2, 0, 0}, infinity);
  EXPECT_EQ(report.outcome, Shortening_outcome::straight);
  EXPECT_NEAR(report.length, 2 * pi, 0.005 * 2 * pi);
  EXPECT_LT(CSCD::internal::measure_polygon(points).planarity, 0.005);
}

TEST(Variational_shortening, slides_to_the_waist)
{
  // A tube that is thinnest in its middle.
  const CSCD::test::Shape shape =
      CSCD::test::moved(CSCD::test::tube(6, 1, 48, CSCD::test::Tube_end::flat), [](const CSCD::test::Triple& p) {
        const double radius = 0.7 + 0.3 * (p[0] - 3) * (p[0] - 3);
        return CSCD::test::Triple{p[0], radius * p[1], radius * p[2]};
      });
  Fixture fixture(shape);
  std::vector<Vector_3> points = swaying_circle(3.7, 0.85, 0.2);
  const Variational_report report = fixture.shorten(points, number_of_samples, {3.7, 0, 0.85}, infinity);
  EXPECT_EQ(report.outcome, Shortening_outcome::straight);
  EXPECT_NEAR(report.length, 2 * pi * 0.7, 0.01 * 2 * pi * 0.7);
  EXPECT_NEAR(CSCD::internal::measure_polygon(points).center.x(), 3, 0.1);
}

TEST(Variational_shortening, finds_the_shortest_section_of_an_ellipsoid)
{
  // The longest axis is x; the ellipse across it is a closed geodesic, from which curves slide down only slowly.
  Fixture fixture(CSCD::test::ellipsoid({3, 1.2, 0.8}, 5));
  std::vector<Vector_3> points;
  for (int i = 0; i < 100; ++i) {
    const double angle = 2 * pi * i / 100;
    points.emplace_back(0.1 * std::sin(3 * angle), 1.2 * std::cos(angle), 0.8 * std::sin(angle));
  }
  const Variational_report report = fixture.shorten(points, number_of_samples, {0, 0, 0.8}, infinity);
  const double eccentricity = std::sqrt(1 - 0.8 * 0.8 / (1.2 * 1.2));
  EXPECT_NEAR(report.length, 4 * 1.2 * boost::math::ellint_2(eccentricity), 0.01 * report.length);
}

TEST(Variational_shortening, stays_in_the_ball)
{
  // On a cone the curve slides towards the thin end, until points leave the ball.
  Fixture fixture(CSCD::test::tapered_tube(8, 0.3, 1.5, 48));
  const double radius_there = 0.3 + 1.2 * 5 / 8;
  const Vector_3 source = on_circle(5, radius_there, 0);
  for (const double factor : {1.05, 1.2}) {
    const double radius = factor * 2 * radius_there;
    std::vector<Vector_3> points = swaying_circle(5, radius_there, 0.1);
    const Variational_report report = fixture.shorten(points, number_of_samples, source, radius);
    EXPECT_EQ(report.outcome, Shortening_outcome::held);
    double farthest = 0;
    for (const Vector_3& point : points) {
      farthest = std::max(farthest, (point - source).norm());
    }
    EXPECT_LT(farthest, 1.02 * radius);
    EXPECT_GT(farthest, 0.9 * radius);
    EXPECT_LT(report.length, 0.99 * 2 * pi * radius_there);
  }
  std::vector<Vector_3> points = swaying_circle(5, radius_there, 0.1);
  const Variational_report free = fixture.shorten(points, number_of_samples, source, infinity);
  EXPECT_LT(free.length, 0.75 * 2 * pi * radius_there) << "nothing holds it";
}

TEST(Variational_shortening, notices_what_collapses)
{
  Fixture fixture(CSCD::test::sphere(4));
  std::vector<Vector_3> points;
  for (int i = 0; i < 100; ++i) {
    const double angle = 2 * pi * i / 100;
    points.emplace_back(0.8 * std::cos(angle), 0.8 * std::sin(angle), 0.6);
  }
  const Variational_report report = fixture.shorten(points, number_of_samples, {0.8, 0, 0.6}, 1.6);
  EXPECT_EQ(report.outcome, Shortening_outcome::collapsed);
  EXPECT_GT(report.length, 0.3 * report.length_before) << "it is left as it was when that was noticed";
  std::vector<Vector_3> point(5, Vector_3(0, 0, 1));
  EXPECT_EQ(fixture.shorten(point, number_of_samples, {0, 0, 1}, 1).outcome, Shortening_outcome::collapsed);
}

TEST(Variational_shortening, does_the_same_at_any_scale_and_anywhere)
{
  const CSCD::test::Shape shape = CSCD::test::tapered_tube(8, 0.3, 1.5, 24);
  const std::vector<Vector_3> start = swaying_circle(5, 1, 0.2);
  const auto shortened = [&](const CSCD::test::Similarity& move) {
    const auto moved = [&](const Vector_3& p) {
      const CSCD::test::Triple q = move({p.x(), p.y(), p.z()});
      return Vector_3(q[0], q[1], q[2]);
    };
    Fixture fixture(CSCD::test::moved(shape, move));
    std::vector<Vector_3> points;
    for (const Vector_3& point : start) {
      points.push_back(moved(point));
    }
    fixture.shorten(points, number_of_samples, moved({5, 0, 1}), 2.2 * move.scale);
    return points;
  };
  const std::vector<Vector_3> reference = shortened({});
  const std::vector<Vector_3> scaled = shortened({0x1p-20, {0, 0, 1}, 0, {0, 0, 0}});
  for (std::size_t i = 0; i < reference.size(); ++i) {
    ASSERT_EQ(scaled[i], 0x1p-20 * reference[i]);
  }
  // Rounding decides on which side of an edge a point goes on; then the same minimum is found from another side.
  for (const double scale : {1e-3, 1., 1e3}) {
    const std::vector<Vector_3> turned =
        shortened({scale, CSCD::test::unit({1, 2, 3}), 1, {10 * scale, 20 * scale, 0}});
    EXPECT_NEAR(length(turned) / scale, length(reference), 2e-3 * length(reference));
  }
}

/// To a unit sphere without triangles.
struct Projection_to_sphere
{
  static constexpr bool needs_site = false;

  Projected_point operator()(const Vector_3& point, CSCD::Index) const
  {
    return {point.normalized(), point.normalized(), 0};
  }
};

TEST(Variational_shortening, needs_nothing_but_a_projection)
{
  Variational_shortening<Projection_to_sphere> shorten{Projection_to_sphere()};
  std::vector<Vector_3> points;
  for (int i = 0; i < 100; ++i) {
    const double angle = 2 * pi * i / 100;
    points.push_back(Vector_3(std::cos(angle), std::sin(angle), 0.1 * std::sin(2 * angle)).normalized());
  }
  const Variational_report report = shorten(points, number_of_samples, {0, 0, 0}, infinity);
  EXPECT_NEAR(report.length, 2 * pi, 0.005 * 2 * pi) << "a great circle";
}

TEST(resample_polygon, puts_points_at_equal_distances)
{
  std::vector<Vector_3> samples;
  CSCD::internal::resample_polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}, {0, 1, 0}}, 8, samples);
  ASSERT_EQ(samples.size(), 8u);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_NEAR((samples[(i + 1) % 8] - samples[i]).norm(), 0.5, 1e-12);
  }
  CSCD::internal::resample_polygon({{1, 2, 3}}, 3, samples);
  EXPECT_EQ(samples, std::vector<Vector_3>(3, Vector_3(1, 2, 3)));
}

} // namespace
