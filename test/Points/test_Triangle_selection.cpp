// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Delaunay neighbors of the origin, beside those of CGAL's triangulation.

#include "support/shape_operations.h"
#include <CSCD/Points/Triangle_selection.h>
#include <CSCD/Vector_3.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::internal::Delaunay_star;

/// The neighbors of the origin, counterclockwise; from behind the border on, if there is one.
std::vector<Index> neighbors_by_cgal(const std::vector<Eigen::Vector2d>& points)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Base = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
  CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Base>> triangulation;
  const auto origin = triangulation.insert({0, 0});
  for (Index i = 0; i < points.size(); ++i) {
    triangulation.insert({points[i].x(), points[i].y()})->info() = i;
  }
  std::vector<Index> result;
  auto neighbor = triangulation.incident_vertices(origin);
  const auto first = neighbor;
  auto border = result.size();
  do {
    if (triangulation.is_infinite(neighbor)) {
      border = result.size();
    } else {
      result.push_back(neighbor->info());
    }
  } while (++neighbor != first);
  std::rotate(result.begin(), result.begin() + std::ptrdiff_t(border), result.end());
  return result;
}

std::vector<Index> rotated_to_least(std::vector<Index> ring)
{
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
}

std::vector<Eigen::Vector2d> random_points(std::size_t number, double min_x, std::mt19937_64& random)
{
  std::vector<Eigen::Vector2d> result;
  while (result.size() < number) {
    const double x = CSCD::test::random_signed_unit(random);
    const double y = CSCD::test::random_signed_unit(random);
    if (x > min_x) {
      result.emplace_back(x, y);
    }
  }
  return result;
}

TEST(Delaunay_star, has_the_neighbors_of_the_triangulation)
{
  std::mt19937_64 random(1);
  Delaunay_star star;
  for (int i = 0; i < 200; ++i) {
    const std::vector<Eigen::Vector2d> points = random_points(3 + std::size_t(i) % 20, i % 2 == 0 ? -1 : 0, random);
    star.clear();
    for (Index k = 0; k < points.size(); ++k) {
      star.add(points[k], k);
    }
    star();
    const std::vector<Index> expected = neighbors_by_cgal(points);
    if (star.is_closed()) {
      EXPECT_EQ(rotated_to_least(expected), rotated_to_least(star.neighbors()));
    } else {
      EXPECT_EQ(expected, star.neighbors());
    }
    EXPECT_TRUE(i % 2 == 0 || !star.is_closed()) << "all points are on one side";
  }
}

TEST(Delaunay_star, takes_the_nearest_of_points_in_one_direction)
{
  Delaunay_star star;
  star.add({2, 0}, 0);
  star.add({1, 0}, 1);
  star.add({0, 3}, 2);
  star();
  EXPECT_EQ((std::vector<Index>{1, 2}), star.neighbors());
  EXPECT_FALSE(star.is_closed());
}

TEST(Delaunay_star, of_few_points_is_open)
{
  Delaunay_star star;
  star();
  EXPECT_TRUE(star.neighbors().empty());
  star.clear();
  star.add({1, 1}, 7);
  star.add({0, 0}, 8);
  star();
  EXPECT_EQ((std::vector<Index>{7}), star.neighbors());
  EXPECT_FALSE(star.is_closed());
}

} // namespace
