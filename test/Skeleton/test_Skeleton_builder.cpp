// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What changes a builder keeps its cycles: splitting, bypassing, contracting, merging, making simple.

#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeleton/place_junctions.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Skeleton_builder;
using CSCD::Vector_3;
using Edges = std::vector<std::pair<Index, Index>>;

Edges edges(const Skeleton_builder& builder)
{
  Edges result;
  builder.for_each_edge([&](Index a, Index b) { result.emplace_back(a, b); });
  std::sort(result.begin(), result.end());
  return result;
}

/// Nodes minus edges.
int euler_number(const Skeleton_builder& builder)
{
  int nodes = 0;
  for (Index node = 0; node < builder.size(); ++node) {
    nodes += builder[node].is_removed ? 0 : 1;
  }
  return nodes - int(edges(builder).size());
}

/// Whether neighbors know each other equally often, and nobody knows a removed node.
bool is_consistent(const Skeleton_builder& builder)
{
  for (Index a = 0; a < builder.size(); ++a) {
    for (Index b : builder[a].neighbors) {
      const auto& back = builder[b].neighbors;
      const auto& forth = builder[a].neighbors;
      if (builder[b].is_removed ||
          std::count(back.begin(), back.end(), a) != std::count(forth.begin(), forth.end(), b)) {
        return false;
      }
    }
  }
  return true;
}

/// Nodes on a line, one unit apart, and these edges.
Skeleton_builder make_builder(Index number_of_nodes, const Edges& wanted, double radius = 1)
{
  Skeleton_builder builder;
  for (Index node = 0; node < number_of_nodes; ++node) {
    builder.add_node({double(node), 0, 0}, radius);
    builder[node].separators = {node};
  }
  for (const auto& [a, b] : wanted) {
    builder.add_edge(a, b);
  }
  return builder;
}

TEST(Skeleton_builder, lists_each_edge_once)
{
  const Edges wanted{{0, 0}, {0, 1}, {0, 1}, {1, 2}, {2, 2}, {2, 2}};
  const Skeleton_builder builder = make_builder(3, wanted);
  EXPECT_EQ(edges(builder), wanted);
  EXPECT_EQ(builder.degree(0), 4u) << "a loop has two ends";
  EXPECT_TRUE(builder.is_junction(0));
  EXPECT_EQ(builder.edge_length(0, 2), 2);
}

TEST(Skeleton_builder, splits_and_bypasses)
{
  Skeleton_builder builder = make_builder(2, {{0, 1}, {0, 1}});
  const Index node = builder.split_edge(0, 1, {0, 5, 0}, 3);
  EXPECT_EQ(edges(builder), (Edges{{0, 1}, {0, node}, {1, node}}));
  EXPECT_EQ(builder[node].radius, 3);
  EXPECT_TRUE(builder.is_regular(node));
  builder.bypass(node);
  EXPECT_EQ(edges(builder), (Edges{{0, 1}, {0, 1}}));
  EXPECT_TRUE(is_consistent(builder));
  EXPECT_TRUE(builder[node].is_removed);
}

TEST(Skeleton_builder, bypass_on_a_double_edge_leaves_a_loop)
{
  Skeleton_builder builder = make_builder(2, {{0, 1}, {0, 1}});
  builder.bypass(1);
  EXPECT_EQ(edges(builder), (Edges{{0, 0}}));
  EXPECT_EQ(builder[0].separators, (std::vector<Index>{0, 1})) << "the heir stands for what the other one stood for";
}

TEST(Skeleton_builder, contracts)
{
  Skeleton_builder builder = make_builder(5, {{0, 1}, {1, 2}, {1, 3}, {3, 4}, {0, 4}});
  const int euler = euler_number(builder);
  builder.contract(1, 0);
  EXPECT_EQ(edges(builder), (Edges{{0, 2}, {0, 3}, {0, 4}, {3, 4}}));
  EXPECT_EQ(euler_number(builder), euler);
  EXPECT_TRUE(is_consistent(builder));
  builder.contract(0, 4);
  EXPECT_EQ(edges(builder), (Edges{{2, 4}, {3, 4}, {3, 4}}));
  EXPECT_EQ(euler_number(builder), euler) << "the triangle has become a double edge";
  std::vector<Index> separators = builder[4].separators;
  std::sort(separators.begin(), separators.end());
  EXPECT_EQ(separators, (std::vector<Index>{0, 1, 4}));
}

TEST(Skeleton_builder, keeps_its_euler_number_under_random_changes)
{
  std::mt19937 random(1);
  Skeleton_builder builder = make_builder(6, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {2, 4}, {4, 5}});
  const int euler = euler_number(builder);
  for (int step = 0; step < 2000; ++step) {
    const Edges all = edges(builder);
    const auto [a, b] = all[random() % all.size()];
    const auto links = std::count(all.begin(), all.end(), std::make_pair(a, b));
    if (random() % 2 == 0 || all.size() < 6) {
      builder.split_edge(a, b, Vector_3::Zero(), 1);
    } else if (builder.is_regular(a) && builder[a].neighbors[0] != a) {
      builder.bypass(a);
    } else if (a != b && links == 1 && std::count(all.begin(), all.end(), std::make_pair(a, a)) == 0) {
      builder.contract(a, b);
    }
    ASSERT_EQ(euler_number(builder), euler);
    ASSERT_TRUE(is_consistent(builder));
    if (step % 100 == 0) {
      builder.compact();
      ASSERT_EQ(euler_number(builder), euler);
      ASSERT_TRUE(is_consistent(builder));
    }
  }
}

TEST(Skeleton_builder, compacts_in_order)
{
  Skeleton_builder builder = make_builder(4, {{0, 1}, {1, 2}, {2, 3}});
  builder.bypass(1);
  builder.compact();
  ASSERT_EQ(builder.size(), 3u);
  EXPECT_EQ(edges(builder), (Edges{{0, 1}, {1, 2}}));
  EXPECT_EQ(builder[1].position.x(), 2);
}

TEST(make_simple, leaves_neither_loops_nor_parallels_and_keeps_the_cycles)
{
  Skeleton_builder builder = make_builder(4, {{0, 0}, {0, 0}, {0, 1}, {0, 1}, {0, 1}, {1, 2}, {3, 3}});
  const int euler = euler_number(builder);
  CSCD::make_simple(builder);
  EXPECT_EQ(euler_number(builder), euler);
  EXPECT_TRUE(is_consistent(builder));
  const Edges all = edges(builder);
  EXPECT_EQ(std::set(all.begin(), all.end()).size(), all.size());
  for (const auto& [a, b] : all) {
    EXPECT_NE(a, b);
    EXPECT_GT(builder.edge_length(a, b), 0);
  }
}

TEST(make_simple, leaves_a_simple_draft_alone)
{
  Skeleton_builder builder = make_builder(4, {{0, 1}, {1, 2}, {0, 2}, {2, 3}});
  const Edges before = edges(builder);
  CSCD::make_simple(builder);
  EXPECT_EQ(edges(builder), before);
}

/// Two junctions with two tips each, joined by a path over a node of this radius.
Skeleton_builder two_junctions(double radius)
{
  return make_builder(7, {{0, 1}, {1, 2}, {0, 3}, {0, 4}, {2, 5}, {2, 6}}, radius);
}

TEST(merge_junctions, merges_two_in_one_body)
{
  Skeleton_builder builder = two_junctions(5);
  CSCD::internal::merge_junctions(builder);
  EXPECT_EQ(euler_number(builder), 1);
  EXPECT_TRUE(is_consistent(builder));
  std::vector<std::size_t> degrees;
  for (Index node = 0; node < builder.size(); ++node) {
    if (!builder[node].is_removed) {
      degrees.push_back(builder.degree(node));
    }
  }
  std::sort(degrees.begin(), degrees.end());
  EXPECT_EQ(degrees, (std::vector<std::size_t>{1, 1, 1, 1, 4}));
}

TEST(merge_junctions, leaves_those_apart_that_are_far_apart)
{
  Skeleton_builder builder = two_junctions(0.5);
  const Edges before = edges(builder);
  CSCD::internal::merge_junctions(builder);
  EXPECT_EQ(edges(builder), before);
}

TEST(merge_junctions, keeps_cycles)
{
  // A ring of four junctions with a tip each, and nodes between them, all in one thick body.
  Skeleton_builder ring = make_builder(
      12, {{0, 4}, {4, 1}, {1, 5}, {5, 2}, {2, 6}, {6, 3}, {3, 7}, {7, 0}, {0, 8}, {1, 9}, {2, 10}, {3, 11}}, 100);
  CSCD::internal::merge_junctions(ring);
  EXPECT_EQ(euler_number(ring), 0);
  EXPECT_TRUE(is_consistent(ring));
  const Edges all = edges(ring);
  EXPECT_EQ(std::set(all.begin(), all.end()).size(), all.size()) << "no parallel edges";
  EXPECT_TRUE(std::none_of(all.begin(), all.end(), [](const auto& edge) { return edge.first == edge.second; }));
  // Two junctions joined by three paths.
  Skeleton_builder theta = make_builder(5, {{0, 2}, {2, 1}, {0, 3}, {3, 1}, {0, 4}, {4, 1}}, 100);
  CSCD::internal::merge_junctions(theta);
  EXPECT_EQ(euler_number(theta), -1);
}

} // namespace
