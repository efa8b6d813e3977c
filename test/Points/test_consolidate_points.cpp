// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Dense clouds are thinned, noise is averaged away, outliers are left out, and every point of the input stays near the
// point that stands for it.

#include "support/Shape.h"
#include "support/sampling.h"
#include "support/shapes.h"
#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Points/consolidate_points.h>
#include <CSCD/Points/recognize_tree_scan.h>
#include <CSCD/Vector3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace {

using CSCD::Index, CSCD::Point_cloud, CSCD::Vector3, CSCD::internal::consolidate_points;

constexpr double torus_radius = 3;
constexpr double tube_radius = 1;

std::vector<Vector3> torus_points(std::size_t number, double noise)
{
  const auto torus = CSCD::test::torus(torus_radius, tube_radius, 64);
  return CSCD::test::to_points<Vector3>(CSCD::test::shaken(CSCD::test::sampled(torus, number, 1), noise, 2));
}

double distance_from_torus(const Vector3& p)
{
  return std::abs(std::hypot(std::hypot(p.x(), p.y()) - torus_radius, p.z()) - tube_radius);
}

Point_cloud consolidated(std::vector<Vector3> points)
{
  return consolidate_points(CSCD::make_point_cloud(std::move(points), {}));
}

/// The mean distance of the points of a cloud, in coordinates of the input, from the torus.
double mean_distance(const Point_cloud& cloud)
{
  double sum = 0;
  for (const Vector3& point : cloud.points) {
    sum += distance_from_torus(cloud.normalization.to_input(point));
  }
  return sum / double(cloud.points.size());
}

TEST(consolidate_points, leaves_a_cloud_as_it_is_that_is_not_dense)
{
  const std::vector<Vector3> points = torus_points(3000, 0);
  const Point_cloud cloud = CSCD::make_point_cloud(std::vector<Vector3>(points), {});
  const Point_cloud result = consolidated(points);
  EXPECT_TRUE(cloud.points == result.points);
  EXPECT_TRUE(cloud.input_point == result.input_point);
  EXPECT_EQ(0u, result.number_of_thinned_points);
  EXPECT_EQ(0u, result.number_of_outliers);
}

TEST(consolidate_points, thins_a_dense_cloud_and_keeps_every_point_near_that_which_stands_for_it)
{
  const std::vector<Vector3> points = torus_points(60000, 0);
  const Point_cloud cloud = consolidated(points);
  EXPECT_GT(15000u, cloud.points.size());
  EXPECT_LT(4000u, cloud.points.size());
  EXPECT_FALSE(cloud.is_averaged);
  EXPECT_EQ(0u, cloud.number_of_outliers);
  EXPECT_EQ(points.size() - cloud.points.size(), cloud.number_of_thinned_points);
  // Half of the area for each point is a disc of this radius; a covering needs less than three times that.
  const double area = 4 * M_PI * M_PI * torus_radius * tube_radius;
  const double greatest = 3 * std::sqrt(area / double(cloud.points.size()) / M_PI);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3 kept = cloud.normalization.to_input(cloud.points[cloud.input_point[i]]);
    ASSERT_GE(greatest, (kept - points[i]).norm()) << "point " << i;
  }
}

TEST(consolidate_points, keeps_some_twenty_thousand_points_of_a_long_chain_at_most)
{
  // Its rings are so thin, compared with the chain, that they stay bent between points.
  const auto points = CSCD::test::sampled(CSCD::test::chain_of_rings(100, 12), 200000, 1);
  EXPECT_GT(40000u, consolidated(CSCD::test::to_points<Vector3>(points)).points.size());
}

TEST(consolidate_points, averages_noise_away)
{
  constexpr double noise = 0.05;
  const std::vector<Vector3> points = torus_points(60000, noise);
  const Point_cloud cloud = CSCD::make_point_cloud(std::vector<Vector3>(points), {});
  const Point_cloud result = consolidated(points);
  EXPECT_TRUE(result.is_averaged);
  EXPECT_LT(mean_distance(result), 0.5 * mean_distance(cloud));
}

TEST(consolidate_points, leaves_out_points_that_are_spread_in_space)
{
  for (const auto& [number, number_of_strays] :
       {std::pair(20000, 4000), std::pair(20000, 200), std::pair(80000, 400)}) {
    SCOPED_TRACE(number_of_strays);
    std::vector<Vector3> points = torus_points(std::size_t(number), 0);
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> wide(-4, 4);
    std::uniform_real_distribution<double> high(-1, 1);
    for (int i = 0; i < number_of_strays; ++i) {
      points.emplace_back(wide(random), wide(random), high(random));
    }
    // Points near the torus cannot be distinguished from it.
    const Point_cloud cloud = consolidated(points);
    for (const Vector3& point : cloud.points) {
      EXPECT_GT(0.25, distance_from_torus(cloud.normalization.to_input(point)));
    }
    EXPECT_LT(number_of_strays / 2, int(cloud.number_of_outliers));
    EXPECT_GT(number_of_strays, int(cloud.number_of_outliers));
  }
}

TEST(consolidate_points, keeps_the_sparse_part_of_a_surface)
{
  std::vector<Vector3> points = torus_points(40000, 0);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].x() > 0 || i % 16 == 0) {
      points[kept++] = points[i];
    }
  }
  points.resize(kept);
  EXPECT_EQ(0U, consolidated(points).number_of_outliers);
}

TEST(is_scan_of_trees, tells_rods_from_a_torus)
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> along(-1, 1);
  std::normal_distribution<double> across(0, 0.002);
  std::uniform_int_distribution<int> which(0, 39);
  std::vector<Vector3> directions;
  for (int i = 0; i < 40; ++i) {
    directions.push_back(Vector3(along(random), along(random), along(random)));
  }
  std::vector<Vector3> rods;
  for (int i = 0; i < 30000; ++i) {
    rods.push_back(along(random) * directions[std::size_t(which(random))] +
                   Vector3(across(random), across(random), across(random)));
  }
  const auto forms_of = [](std::vector<Vector3> points) {
    return CSCD::internal::forms_of(CSCD::make_point_cloud(std::move(points), {}).points);
  };
  EXPECT_LT(0.1, forms_of(rods).along_curves);
  EXPECT_EQ(0, forms_of(torus_points(30000, 0)).along_curves);
  EXPECT_FALSE(CSCD::internal::is_scan_of_trees(forms_of(torus_points(30000, 0.05))));
}

/// Circles around the z axis, on a ball of radius 1, `ratio` times as far apart as their points are.
std::vector<Vector3> sliced_ball(std::size_t number, double ratio)
{
  const double spacing = std::sqrt(4 * CSCD::test::pi / (double(number) * ratio));
  std::vector<Vector3> points;
  for (double latitude = -1.5; latitude < 1.5; latitude += ratio * spacing) {
    const double step = spacing / std::cos(latitude);
    for (double angle = 0; angle < 2 * CSCD::test::pi; angle += step) {
      points.emplace_back(std::cos(latitude) * std::cos(angle), std::cos(latitude) * std::sin(angle),
                          std::sin(latitude));
    }
  }
  return points;
}

TEST(is_scan_of_trees, does_not_take_slices_for_twigs)
{
  for (const double ratio : {3., 10., 20.}) {
    const CSCD::Point_cloud cloud = CSCD::make_point_cloud(sliced_ball(20000, ratio), {});
    EXPECT_FALSE(CSCD::internal::is_scan_of_trees(CSCD::internal::forms_of(cloud.points))) << ratio;
  }
  // Lines that look like twigs, laid flat.
  CSCD::internal::Cloud_forms forms;
  forms.along_curves = forms.in_space = 0.3;
  forms.steepness = 0.3;
  EXPECT_TRUE(CSCD::internal::is_scan_of_trees(forms));
  forms.steepness = 0;
  EXPECT_FALSE(CSCD::internal::is_scan_of_trees(forms));
}

} // namespace
