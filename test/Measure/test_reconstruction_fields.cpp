// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of the fields that surfaces are reconstructed by, of their triangulation, and of estimated radii.

#include "Measure/reconstruction.h"
#include <CSCD/Measure/evaluate_skeleton.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Surface/Triangulated_surface.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace {

using namespace CSCD;
using namespace CSCD::internal;
constexpr double pi = boost::math::double_constants::pi;

Skeleton segment(const Vector3& source, const Vector3& target, double source_radius, double target_radius)
{
  return {{source, target}, {source_radius, target_radius}, {{0, 1}}};
}

/// F of one edge by quadrature.
double quadrature(const Skeleton& s, const Vector3& point)
{
  const Vector3 along = s.points[1] - s.points[0];
  const auto integrand = [&](double t) {
    const double radius = (1 - t) * s.radii[0] + t * s.radii[1];
    const double square = (s.points[0] + t * along - point).squaredNorm();
    return radius * radius * radius / (square * square);
  };
  constexpr unsigned depth = 12;
  constexpr double tolerance = 1e-12;
  return 2 / pi * along.norm() *
         boost::math::quadrature::gauss_kronrod<double, 31>::integrate(integrand, 0., 1., depth, tolerance);
}

TEST(Convolution_field, agrees_with_quadrature)
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto point = [&] { return Vector3(coordinate(random), coordinate(random), coordinate(random)); };
  for (int i = 0; i < 200; ++i) {
    const Skeleton s =
        segment(point() / 4, point() / 4, 0.1 + std::abs(coordinate(random)), 0.1 + std::abs(coordinate(random)));
    const Vector3 near = s.points[0] + 0.1 * point();
    for (const Vector3& p : {near, point(), Vector3(3 * point())}) {
      const double expected = quadrature(s, p);
      EXPECT_NEAR(1, Convolution_field(s).convolution(p) / expected, 1e-4) << i << ": " << testing::PrintToString(p);
    }
  }
}

TEST(Convolution_field, a_long_line_gives_the_cylinder_of_its_radius)
{
  for (const double radius : {0.01, 1., 7.}) {
    const Convolution_field field(segment({0, 0, -100 * radius}, {0, 0, 100 * radius}, radius, radius));
    for (const double angle : {0., 0.4, 2.}) {
      const Vector3 direction(std::cos(angle), std::sin(angle), 0);
      EXPECT_NEAR(0, field(radius * direction), 1e-5);
      EXPECT_NEAR(-0.5, field(radius / 2 * direction), 1e-5); // even across the surface
      EXPECT_NEAR(1, field(2 * radius * direction), 1e-4);
    }
    // The end of a half line: half the line, so that the radius is smaller by the cubic root of 2.
    EXPECT_NEAR(0, field({radius / std::cbrt(2), 0, 100 * radius}), 1e-5);
  }
}

TEST(Round_cone_field, is_the_distance_from_the_hull_of_two_balls)
{
  const Skeleton s = segment({0, 0, 0}, {2, 0, 0}, 0.5, 0.2);
  const Round_cone_field field(s);
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> coordinate(-1.5, 1.5);
  for (int i = 0; i < 200; ++i) {
    const Vector3 p(1 + coordinate(random), coordinate(random), coordinate(random));
    // The hull is the union of all balls between the two.
    double least = 1e9;
    constexpr int steps = 20000;
    for (int k = 0; k <= steps; ++k) {
      const double t = double(k) / steps;
      least = std::min(least, (p - Vector3(2 * t, 0, 0)).norm() - (0.5 - 0.3 * t));
    }
    EXPECT_NEAR(least, field(p), 1e-6) << testing::PrintToString(p);
  }
}

/// The surface of round cones, which must be a closed oriented manifold, and its facts.
struct Surface_facts
{
  explicit Surface_facts(const Skeleton& s, double cell_size)
  {
    const Round_cone_field field(s);
    Field_surface result = triangulate_field(field, s, cell_size);
    unresolved_fraction = result.unresolved_fraction;
    number_of_faces = result.triangles.faces.size();
    for (const Vector3& p : result.triangles.points) {
      max_error = std::max(max_error, std::abs(field(p)));
    }
    const Triangulated_surface surface(std::move(result.triangles));
    is_manifold = !surface.has_defect();
    if (is_manifold) {
      euler_number = int(surface.number_of_vertices()) - int(surface.number_of_faces() / 2);
      for (Index f = 0; f < surface.number_of_faces(); ++f) {
        volume += surface.point(surface.origin(3 * f)).dot(surface.face_vector(f)) / 6;
      }
    }
  }

  bool is_manifold = false;
  std::size_t number_of_faces = 0;
  int euler_number = 0;
  double volume = 0; ///< positive if the faces look outwards
  double max_error = 0;
  double unresolved_fraction = 0;
};

TEST(Triangulate_field, a_capsule_is_closed_and_has_the_right_volume)
{
  const Surface_facts facts(segment({0, 0, 0}, {1, 0.2, 0.1}, 0.2, 0.2), 0.02);
  EXPECT_TRUE(facts.is_manifold);
  EXPECT_EQ(2, facts.euler_number);
  const double length = std::sqrt(1.05);
  const double expected = pi * 0.04 * length + 4 * pi / 3 * 0.008;
  EXPECT_NEAR(expected, facts.volume, 0.01 * expected);
  EXPECT_LT(facts.max_error, 0.02 * 0.02 / 0.2); // of second order in the size of the cells
  EXPECT_EQ(0, facts.unresolved_fraction);
}

TEST(Triangulate_field, says_what_is_too_thin)
{
  Skeleton s = segment({0.013, 0.013, 0.013}, {1.013, 0.013, 0.013}, 0.2, 0.2);
  s.points.emplace_back(0.013, 5.013, 0.013);
  s.points.emplace_back(1.013, 5.013, 0.013);
  s.radii.insert(s.radii.end(), {1e-4, 1e-4});
  s.edges.push_back({2, 3});
  EXPECT_NEAR(0.5, Surface_facts(s, 0.05).unresolved_fraction, 0.05);
}

TEST(Estimate_radii, are_exact_on_a_cone)
{
  // Points in planes across the axis, whose distances from it grow linearly.
  const Skeleton s{{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {4, 0, 0}}, {}, {{0, 1}, {1, 2}, {2, 3}}};
  std::vector<Vector3> points;
  for (int i = 0; i <= 400; ++i) {
    const double x = 0.01 * i;
    points.emplace_back(x, (1 + x) * std::cos(i), (1 + x) * std::sin(i));
  }
  const std::vector<double> radii = estimate_radii(points, s);
  ASSERT_EQ(4u, radii.size());
  // The weight of a node is a hat over its edges, whose mean distance is that of the hat's centroid.
  EXPECT_NEAR(1 + 1. / 3, radii[0], 0.01);
  EXPECT_NEAR(1 + 4. / 3, radii[1], 0.01);
  EXPECT_NEAR(1 + 8. / 3, radii[2], 0.01);
  EXPECT_NEAR(1 + 11. / 3, radii[3], 0.01);
}

TEST(Estimate_radii, interpolates_where_no_point_is_near)
{
  // Points around the ends only: the nodes between get radii that are linear in length.
  Skeleton s{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {5, 0, 0}, {6, 0, 0}, {0, 90, 0}}, {}, {}};
  s.edges = {{0, 1}, {1, 2}, {2, 3}, {3, 4}};
  const std::vector<double> radii = estimate_radii({{0, 1, 0}, {0, 0, -1}, {6, 7, 0}}, s);
  EXPECT_NEAR(1, radii[0], 1e-12);
  EXPECT_NEAR(2, radii[1], 1e-12);
  EXPECT_NEAR(3, radii[2], 1e-12);
  EXPECT_NEAR(6, radii[3], 1e-12);
  EXPECT_NEAR(7, radii[4], 1e-12);
  EXPECT_NEAR(3, radii[5], 1e-12); // nothing is known of its component: the mean of all distances
}

} // namespace
