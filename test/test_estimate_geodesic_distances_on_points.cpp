// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances on samples of surfaces with known ones; kinds of ranges and sources.

#include "support/Shape.h"
#include "support/message_of.h"
#include "support/sampling.h"
#include "support/shapes.h"
#include <CSCD/estimate_geodesic_distances_on_points.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Points = std::vector<Point>;
using Estimator = CSCD::Point_set_distance_estimator<Points>;
using CSCD::test::Triple;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Random points on the unit sphere.
std::vector<Triple> points_on_sphere(std::size_t number, unsigned seed)
{
  std::mt19937_64 random(seed);
  std::vector<Triple> result;
  while (result.size() < number) {
    const Triple p{CSCD::test::random_signed_unit(random), CSCD::test::random_signed_unit(random),
                   CSCD::test::random_signed_unit(random)};
    const double length = CSCD::test::norm(p);
    if (length > 0.1 && length < 1) {
      result.push_back(CSCD::test::unit(p));
    }
  }
  return result;
}

/// A map to the elements of a vector, which refers to them.
auto map_to(std::vector<double>& values)
{
  return CGAL::make_property_map(values);
}

std::vector<double> distances_from(const Points& points, std::size_t source)
{
  std::vector<double> result(points.size(), -1);
  CSCD::estimate_geodesic_distances(points, source, map_to(result));
  return result;
}

/// The mean difference between distances and angles on the unit sphere, relative to the spacing of the points.
double mean_error_on_sphere(const std::vector<Triple>& points)
{
  const std::vector<double> distances = distances_from(CSCD::test::to_points<Point>(points), 0);
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum += std::fabs(distances[i] - std::acos(std::clamp(CSCD::test::dot(points[0], points[i]), -1., 1.)));
  }
  constexpr double area = 4 * CSCD::test::pi;
  return sum / double(points.size()) / std::sqrt(area / double(points.size()));
}

TEST(estimate_geodesic_distances_on_points, is_exact_to_a_part_of_the_spacing_on_a_sphere)
{
  EXPECT_LT(mean_error_on_sphere(CSCD::test::sphere(4).points), 0.25) << "even";
  for (const unsigned seed : {1u, 2u, 3u}) {
    EXPECT_LT(mean_error_on_sphere(points_on_sphere(3000, seed)), 0.5) << "random";
  }
}

TEST(estimate_geodesic_distances_on_points, is_infinite_elsewhere_and_zero_at_duplicates)
{
  std::vector<Triple> triples = CSCD::test::chain_of_rings(2, 16).points;
  const std::size_t number = triples.size() / 2; // of each ring
  // Outliers: a pair, and one so far away that the shape is a point compared with that.
  triples.insert(triples.end(), {{0, 0, 30}, {0, 0, 30.1}, {1e6, 0, 0}, triples[3]});
  const Points points = CSCD::test::to_points<Point>(triples);
  const std::vector<double> distances = distances_from(points, 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_TRUE(i < number ? std::isfinite(distances[i]) : distances[i] == (points[i] == points[3] ? 0 : infinity));
  }
  const std::vector<double> from_outlier = distances_from(points, points.size() - 2);
  EXPECT_EQ(std::ptrdiff_t(points.size()) - 1, std::count(from_outlier.begin(), from_outlier.end(), infinity));
}

TEST(Point_set_distance_estimator, estimates_from_each_of_many_sets_as_from_one)
{
  const Points points = CSCD::test::to_points<Point>(CSCD::test::torus(3, 1, 16).points);
  const Estimator estimator(points);
  std::vector<std::vector<std::size_t>> sets;
  for (std::size_t i = 0; i < 11; ++i) {
    sets.push_back({i * 7, points.size() - 1 - i});
  }
  std::vector<std::vector<double>> distances(sets.size(), std::vector<double>(points.size(), -1));
  std::vector<decltype(map_to(distances[0]))> maps;
  for (auto& values : distances) {
    maps.push_back(map_to(values));
  }
  estimator.estimate_each(sets, maps);
  for (std::size_t i = 0; i < sets.size(); ++i) {
    std::vector<double> alone(points.size(), -1);
    estimator.estimate(sets[i], map_to(alone));
    EXPECT_EQ(0, alone[sets[i][0]]);
    for (std::size_t k = 0; k < points.size(); ++k) {
      EXPECT_NEAR(alone[k], distances[i][k], 1e-12);
    }
  }
}

TEST(Point_set_distance_estimator, takes_point_sets_with_and_without_normals)
{
  const std::vector<Triple> triples = points_on_sphere(500, 1);
  const Points points = CSCD::test::to_points<Point>(triples);
  CGAL::Point_set_3<Point> set;
  for (const Point& point : points) {
    set.insert(point);
  }
  const std::vector<double> expected = distances_from(points, 9);
  for (const bool has_normals : {false, true}) {
    if (has_normals) {
      set.add_normal_map();
      for (const auto& index : set) {
        set.normal(index) = set.point(index) - CGAL::ORIGIN;
      }
    }
    auto distance = set.add_property_map<double>("distance", -1).first;
    CSCD::estimate_geodesic_distances(set, *(set.begin() + 9), distance);
    for (const auto& index : set) {
      EXPECT_NEAR(expected[std::size_t(index)], distance[index], has_normals ? 0.05 : 1e-12);
    }
  }
}

TEST(Point_set_distance_estimator, refuses_points_that_are_no_surface)
{
  const auto message = [](const Points& points) { return CSCD::test::message_of([&] { distances_from(points, 0); }); };
  EXPECT_TRUE(CSCD::test::names(message({}), "the point set is empty"));
  EXPECT_TRUE(CSCD::test::names(message({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}), "all points are on one line"));
  EXPECT_TRUE(CSCD::test::names(message({{0, 0, 0}, {infinity, 0, 0}}), "point 1 has a coordinate"));
}

} // namespace
