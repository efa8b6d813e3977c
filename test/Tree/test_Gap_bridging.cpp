// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which pieces of poles, standing and floating, are one object.

#include "Tree/Neighbor_graph.h"
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::no_index;
using CSCD::Vector_3;
using CSCD::internal::Gap_bridging;
using CSCD::internal::Neighbor_graph;
using CSCD::internal::Root_distances;

constexpr double thin = 0.05; // of poles, and what is between their points

/// The points of an upright pole.
void add_pole(std::vector<Vector_3>& points, double x, double bottom, double top)
{
  constexpr int around = 6;
  for (int level = 0; bottom + thin * level <= top; ++level) {
    for (int i = 0; i < around; ++i) {
      const double angle = (i + 0.5 * (level % 2)) * 2 * 3.14159265358979 / around;
      points.emplace_back(x + thin * std::cos(angle), thin * std::sin(angle), bottom + thin * level);
    }
  }
}

TEST(Gap_bridging, joins_what_floats)
{
  std::vector<Vector_3> points;
  add_pole(points, 0, 0, 3);
  add_pole(points, 0, 3.8, 6);
  const Neighbor_graph graph(points);
  const Gap_bridging bridging(points, graph);
  EXPECT_EQ(1u, bridging.number_of_objects());
  EXPECT_FALSE(bridging.bridges().empty());
}

TEST(Gap_bridging, leaves_apart_what_stands_or_is_too_far)
{
  std::vector<Vector_3> points;
  add_pole(points, 0, 0, 5);
  add_pole(points, 1, 0.1, 4);
  add_pole(points, 9, 3, 6);
  const Neighbor_graph graph(points);
  const Gap_bridging bridging(points, graph);
  EXPECT_EQ(3u, bridging.number_of_objects());
  EXPECT_TRUE(bridging.bridges().empty());
  EXPECT_EQ(0u, bridging.object(0)); // the one of most points
}

TEST(Gap_bridging, calls_few_points_debris)
{
  std::vector<Vector_3> points;
  add_pole(points, 0, 0, 5);
  add_pole(points, 9, 3, 3 + 1.5 * thin);
  const Neighbor_graph graph(points);
  const Gap_bridging bridging(points, graph);
  EXPECT_EQ(1u, bridging.number_of_objects());
  EXPECT_EQ(no_index, bridging.object(Index(points.size() - 1)));
}

/// Pieces one after the other: a bridge into each but the first.
TEST(Gap_bridging, enters_each_piece_once)
{
  std::vector<Vector_3> points;
  constexpr int number_of_pieces = 5;
  for (int i = 0; i < number_of_pieces; ++i) {
    add_pole(points, 0.1 * (i % 2), 2 * i, 2 * i + 1.4);
  }
  Neighbor_graph graph(points);
  const Gap_bridging bridging(points, graph);
  ASSERT_EQ(1u, bridging.number_of_objects());
  EXPECT_LE(std::size_t(number_of_pieces) - 1, bridging.bridges().size());
  std::vector<Neighbor_graph::Edge> edges;
  for (const auto& gap : bridging.bridges()) {
    edges.emplace_back(gap.a, gap.b);
  }
  graph.set_bridges(edges);
  Root_distances distances(points, graph);
  distances.measure_from({0});
  const auto entries = bridging.entries(distances);
  ASSERT_EQ(std::size_t(number_of_pieces) - 1, entries.size());
  for (const auto& gap : entries) {
    EXPECT_NEAR(0.6, gap.length, 0.1);
  }
}

TEST(Gap_bridging, refuses_lines_whose_triangulation_would_fill_the_memory)
{
  constexpr int number = 4000; // on each of two skew lines, which have so many tetrahedra squared
  std::vector<Vector_3> points;
  for (int i = 0; i < number; ++i) {
    points.emplace_back(0.001 * i, 0, 0);
    points.emplace_back(0, 0.001 * i, 1);
  }
  const Neighbor_graph graph(points);
  EXPECT_THROW(Gap_bridging(points, graph), CSCD::Input_error);
}

} // namespace
