// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of the comparison of two skeletons.

#include "support/convert_shape.h"
#include "support/swept_shapes.h"
#include <CSCD/Measure/compare_skeletons.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/exceptions.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Skeleton = CSCD::Skeleton_graph<Point, std::size_t>;
using CSCD::compare_skeletons, CSCD::Skeleton_comparison, CSCD::test::to_graph, CSCD::test::Triple;
using Edges = std::vector<std::pair<std::size_t, std::size_t>>;

/// A line of length 10 along x with three twigs of length 2 along y, moved by (x, y).
Skeleton comb(double x = 0, double y = 0)
{
  std::vector<Triple> points;
  Edges edges;
  for (std::size_t i = 0; i <= 10; ++i) {
    points.push_back({double(i) + x, y, 0});
    if (i > 0) {
      edges.emplace_back(i - 1, i);
    }
  }
  for (const std::size_t i : {2, 5, 8}) {
    points.push_back({double(i) + x, y + 2, 0});
    edges.emplace_back(i, points.size() - 1);
  }
  return to_graph<Skeleton>(points, edges);
}

TEST(Compare_skeletons, a_skeleton_is_equal_to_itself)
{
  const Skeleton_comparison c = compare_skeletons(comb(), comb());
  EXPECT_NEAR(std::sqrt(104.), c.diagonal, 1e-12);
  EXPECT_NEAR(0, c.hausdorff_distance(), 1e-12);
  EXPECT_NEAR(0, c.mean_distance(), 1e-12);
  EXPECT_EQ(1, c.from_first_to_second.fraction_matched);
  EXPECT_EQ(5u, c.tips.number_matched);
  EXPECT_EQ(3u, c.junctions.number_matched);
}

TEST(Compare_skeletons, nodes_along_a_branch_do_not_matter)
{
  const Skeleton one = to_graph<Skeleton>({{0, 0, 0}, {9, 0, 0}}, {{0, 1}});
  const Skeleton many =
      to_graph<Skeleton>({{0, 0, 0}, {1, 0, 0}, {5, 0, 0}, {5.5, 0, 0}, {9, 0, 0}}, {{2, 1}, {0, 1}, {2, 3}, {3, 4}});
  const Skeleton_comparison c = compare_skeletons(one, many);
  EXPECT_NEAR(0, c.hausdorff_distance(), 1e-12);
}

TEST(Compare_skeletons, distances_of_parallel_lines_are_known)
{
  const Skeleton a = to_graph<Skeleton>({{0, 0, 0}, {4, 0, 0}}, {{0, 1}});
  const Skeleton b = to_graph<Skeleton>({{0, 3, 0}, {4, 3, 0}}, {{0, 1}});
  const Skeleton_comparison c = compare_skeletons(a, b);
  EXPECT_DOUBLE_EQ(5, c.diagonal);
  EXPECT_NEAR(0.6, c.mean_distance(), 1e-12);
  EXPECT_NEAR(0.6, c.hausdorff_distance(), 1e-12);
  EXPECT_EQ(0, c.from_first_to_second.fraction_matched);
  EXPECT_EQ(0u, c.tips.number_matched);
  EXPECT_EQ(2u, compare_skeletons(a, b, CSCD::parameters::match_distance(0.61)).tips.number_matched);
}

TEST(Compare_skeletons, is_one_sided_where_a_part_is_missing)
{
  const Skeleton whole = to_graph<Skeleton>({{0, 0, 0}, {8, 0, 0}, {8, 6, 0}}, {{0, 1}, {1, 2}});
  const Skeleton part = to_graph<Skeleton>({{0, 0, 0}, {8, 0, 0}}, {{0, 1}});
  const Skeleton_comparison c = compare_skeletons(whole, part);
  EXPECT_NEAR(0.6, c.from_first_to_second.maximum, 1e-12);
  EXPECT_NEAR(6. / 14 * 0.3, c.from_first_to_second.mean, 1e-3);
  EXPECT_NEAR(8.2 / 14, c.from_first_to_second.fraction_matched, 0.01);
  EXPECT_NEAR(0, c.from_second_to_first.maximum, 1e-12);
  EXPECT_EQ(1, c.from_second_to_first.fraction_matched);
  EXPECT_NEAR(0.6, c.hausdorff_distance(), 1e-12);
  EXPECT_EQ(1u, c.tips.number_matched); // of two: one is elsewhere
}

TEST(Compare_skeletons, counts_what_is_at_another_place_or_missing)
{
  Skeleton changed = comb();
  remove_edge(8, 13, changed); // the last twig: its tip is left alone, the junction is gone
  changed[11].point = Point(2, 3.5, 0);
  const Skeleton_comparison c = compare_skeletons(comb(), changed);
  EXPECT_EQ(5u, c.tips.number_in_first);
  EXPECT_EQ(4u, c.tips.number_in_second);
  EXPECT_EQ(3u, c.tips.number_matched);
  EXPECT_EQ(3u, c.junctions.number_in_first);
  EXPECT_EQ(2u, c.junctions.number_matched);
}

TEST(Compare_skeletons, matches_each_feature_once)
{
  // Two tips near one: only one of them is matched, the nearer one.
  const Skeleton one = to_graph<Skeleton>({{0, 0, 0}, {10, 0, 0}}, {{0, 1}});
  const Skeleton two =
      to_graph<Skeleton>({{0, 0, 0}, {9, 0, 0}, {10, 0.1, 0}, {10, -0.05, 0}}, {{0, 1}, {1, 2}, {1, 3}});
  const Skeleton_comparison c = compare_skeletons(one, two);
  EXPECT_EQ(2u, c.tips.number_in_first);
  EXPECT_EQ(3u, c.tips.number_in_second);
  EXPECT_EQ(2u, c.tips.number_matched);
  EXPECT_EQ(0u, c.junctions.number_matched);
}

TEST(Compare_skeletons, closed_cycles_have_neither_tips_nor_junctions)
{
  const auto ring = [](std::size_t n) {
    std::vector<Triple> points;
    Edges edges;
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = 2 * CSCD::test::pi * double(i) / double(n);
      points.push_back({std::cos(angle), std::sin(angle), 0});
      edges.emplace_back(i, (i + 1) % n);
    }
    return to_graph<Skeleton>(points, edges);
  };
  const Skeleton_comparison c = compare_skeletons(ring(40), ring(60));
  EXPECT_EQ(0u, c.junctions.number_in_first);
  EXPECT_EQ(1, c.tips.fraction()); // there are none
}

TEST(Compare_skeletons, single_nodes_can_be_compared)
{
  const Skeleton a = to_graph<Skeleton>({{1, 1, 1}}, {});
  const Skeleton_comparison same = compare_skeletons(a, a);
  EXPECT_EQ(0, same.hausdorff_distance());
  const Skeleton_comparison apart = compare_skeletons(a, to_graph<Skeleton>({{1, 1, 4}}, {}));
  EXPECT_EQ(3, apart.diagonal);
  EXPECT_EQ(1, apart.hausdorff_distance());
}

/// Straight branches from the origin to random tips in a ball.
Skeleton star(std::size_t number_of_arms, unsigned seed)
{
  std::mt19937 generator(seed);
  std::normal_distribution<double> coordinate;
  std::vector<Triple> points{{0, 0, 0}};
  Edges edges;
  for (std::size_t i = 1; i <= number_of_arms; ++i) {
    const double x = coordinate(generator);
    const double y = coordinate(generator);
    points.push_back({x, y, coordinate(generator)});
    edges.emplace_back(0, i);
  }
  return to_graph<Skeleton>(points, edges);
}

/// The number of pairs up to `match_distance`, the nearest first, from all distances.
template <class Distance>
std::size_t number_matched(std::size_t m, std::size_t n, const Distance& distance, double match_distance)
{
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      if (distance(i, j) <= match_distance) {
        pairs.emplace_back(distance(i, j), i, j);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::set<std::size_t> first, second;
  for (const auto& [d, i, j] : pairs) {
    if (first.count(i) + second.count(j) == 0) {
      first.insert(i);
      second.insert(j);
    }
  }
  return first.size();
}

TEST(Compare_skeletons, matches_the_nearest_pairs_of_all)
{
  const Skeleton a = star(150, 1);
  const Skeleton b = star(120, 2);
  const auto tip = [](const Skeleton& skeleton, std::size_t i) { return skeleton[i + 1].point - CGAL::ORIGIN; };
  for (const double match_distance : {0.02, 0.05, 0.2}) {
    const Skeleton_comparison c = compare_skeletons(a, b, CSCD::parameters::match_distance(match_distance));
    const double bound = match_distance * c.diagonal;
    const auto tips = number_matched(
        150, 120, [&](std::size_t i, std::size_t j) { return std::sqrt((tip(a, i) - tip(b, j)).squared_length()); },
        bound);
    EXPECT_GT(tips, 0u);
    EXPECT_EQ(c.tips.number_matched, tips);
  }
}

TEST(Compare_skeletons, refuses_what_cannot_be_compared)
{
  const Skeleton bad = to_graph<Skeleton>({{0, 0, std::numeric_limits<double>::infinity()}}, {});
  const Skeleton huge = to_graph<Skeleton>({{-1.7e308, 0, 0}, {1.7e308, 0, 0}}, {{0, 1}});
  EXPECT_THROW(compare_skeletons(Skeleton(), comb()), CSCD::Input_error);
  EXPECT_THROW(compare_skeletons(comb(), Skeleton()), CSCD::Input_error);
  EXPECT_THROW(compare_skeletons(comb(), bad), CSCD::Input_error);
  EXPECT_THROW(compare_skeletons(comb(), huge), CSCD::Input_error);
  EXPECT_THROW(compare_skeletons(comb(), comb(), CSCD::parameters::match_distance(-1)), CSCD::Input_error);
}

} // namespace
