// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points in flat arrays: duplicates, order, normals; and what is measured on them: neighbors, quadrics.

#include "support/sampling.h"
#include "support/shapes.h"
#include <CSCD/Points/Cloud_sampling.h>
#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Traits/Input_points.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using CSCD::Index;
using CSCD::Vector_3;

TEST(collect_points, merges_equal_points_and_restores_their_coordinates)
{
  const std::vector<Point> points{{1, 2, 3}, {5, 2, 3}, {1, 2, 3}, {1, 4, 3}, {1, 2, 7}, {5, 2, 3}};
  const auto cloud =
      CSCD::internal::collect_points(points, CGAL::Identity_property_map<const Point>(), CSCD::internal::No_normals());
  EXPECT_EQ(4u, cloud.points.size());
  EXPECT_EQ(2u, cloud.number_of_duplicates());
  EXPECT_TRUE(cloud.normals.empty());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector_3 p = cloud.normalization.to_input(cloud.points[cloud.input_point[i]]);
    EXPECT_EQ(points[i], Point(p.x(), p.y(), p.z()));
  }
}

TEST(collect_points, gives_normals_unit_length)
{
  using Pair = std::pair<Point, Vector>;
  const std::vector<Pair> points{
      {{0, 0, 0}, {0, 0, 5}}, {{1, 0, 0}, {0, 0, 0}}, {{0, 1, 0}, {1e-200, 0, 0}}, {{0, 0, 1}, {0, -1, 0}}};
  const auto cloud = CSCD::internal::collect_points(points, CGAL::First_of_pair_property_map<Pair>(),
                                                    CGAL::Second_of_pair_property_map<Pair>());
  const auto normal = [&cloud](Index i) { return cloud.normals[cloud.input_point[i]]; };
  EXPECT_EQ(Vector_3(0, 0, 1), normal(0));
  EXPECT_EQ(Vector_3(0, 0, 0), normal(1));
  EXPECT_EQ(Vector_3(1, 0, 0), normal(2));
  EXPECT_EQ(Vector_3(0, -1, 0), normal(3));
}

std::vector<Vector_3> random_points(std::size_t number)
{
  std::vector<Vector_3> result;
  for (const CSCD::test::Triple& p : CSCD::test::sampled(CSCD::test::sphere(4), number, 1)) {
    result.emplace_back(p[0], p[1], p[2]);
  }
  return result;
}

TEST(Neighbor_table, holds_the_nearest_points)
{
  const Index number = 7;
  std::vector<Vector_3> points = random_points(300);
  points.insert(points.end(), 10, points.front()); // more equal ones than neighbors
  const CSCD::internal::Neighbor_table table(points, number);
  for (Index i = 0; i < points.size(); ++i) {
    std::vector<double> expected;
    for (Index j = 0; j < points.size(); ++j) {
      if (j != i) {
        expected.push_back((points[i] - points[j]).norm());
      }
    }
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(number, table.number());
    std::size_t at = 0;
    for (Index j : table.neighbors(i)) {
      EXPECT_NE(i, j);
      EXPECT_DOUBLE_EQ(expected[at], (points[i] - points[j]).norm());
      EXPECT_DOUBLE_EQ(expected[at], *(table.distances(i).begin() + std::ptrdiff_t(at)));
      ++at;
    }
    EXPECT_DOUBLE_EQ(expected[number - 1], table.reach(i));
  }
}

TEST(Neighbor_table, has_as_many_as_there_are)
{
  EXPECT_EQ(0u, CSCD::internal::Neighbor_table({}, 5).number());
  EXPECT_EQ(0u, CSCD::internal::Neighbor_table({Vector_3(1, 2, 3)}, 5).number());
  EXPECT_EQ(1u, CSCD::internal::Neighbor_table({Vector_3(1, 2, 3), Vector_3(1, 2, 4)}, 5).number());
}

TEST(fit_quadrics, finds_a_quadric_exactly)
{
  std::vector<Vector_3> points;
  for (const Vector_3& p : random_points(500)) {
    points.emplace_back(p.x(), p.y(), 0.3 * p.x() * p.x() - 0.2 * p.x() * p.y());
  }
  // Another frame than that of the axes changes the surface's height field, but little where it is nearly flat.
  const CSCD::internal::Neighbor_table table(points, 16);
  for (const CSCD::internal::Quadric_fit& fit : fit_quadrics(points, table)) {
    EXPECT_NEAR(1, fit.normal.norm(), 1e-12);
    EXPECT_LT(fit.deviation, 0.01);
  }
}

TEST(fit_quadrics, measures_noise_and_lessens_it)
{
  constexpr double deviation = 0.02;
  const CSCD::test::Shape ball = CSCD::test::sphere(5);
  std::vector<Vector_3> points;
  for (const CSCD::test::Triple& p : CSCD::test::shaken(CSCD::test::sampled(ball, 5000, 1), deviation, 2)) {
    points.emplace_back(p[0], p[1], p[2]);
  }
  const CSCD::internal::Neighbor_table table(points, 16);
  double squared_before = 0;
  double squared_after = 0;
  double squared_estimate = 0;
  const std::vector<CSCD::internal::Quadric_fit> fits = fit_quadrics(points, table);
  for (Index i = 0; i < points.size(); ++i) {
    squared_before += std::pow(points[i].norm() - 1, 2);
    squared_after += std::pow(fits[i].projection.norm() - 1, 2);
    squared_estimate += fits[i].deviation * fits[i].deviation;
  }
  const double size = double(points.size());
  EXPECT_NEAR(deviation, std::sqrt(squared_estimate / size), 0.1 * deviation);
  EXPECT_LT(squared_after, 0.6 * squared_before);
}

} // namespace
