// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What changes a draft keeps its cycles: splitting, bypassing, contracting, merging, making simple, dropping
// overshoots, smoothing.

#include <CSCD/Skeleton/Skeleton_draft.h>
#include <CSCD/Skeleton/drop_overshoots.h>
#include <CSCD/Skeleton/make_simple.h>
#include <CSCD/Skeleton/merge_junctions.h>
#include <CSCD/Skeleton/smooth_branches.h>
#include <CSCD/internal/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace {

using CSCD::internal::Index;
using CSCD::internal::Skeleton_draft;
using CSCD::internal::Vector_3;
using Edges = std::vector<std::pair<Index, Index>>;

Edges edges(const Skeleton_draft& draft)
{
  Edges result;
  draft.for_each_edge([&](Index a, Index b) { result.emplace_back(a, b); });
  std::sort(result.begin(), result.end());
  return result;
}

/// Nodes minus edges.
int euler_number(const Skeleton_draft& draft)
{
  int nodes = 0;
  for (Index node = 0; node < draft.size(); ++node) {
    nodes += draft[node].is_removed ? 0 : 1;
  }
  return nodes - int(edges(draft).size());
}

/// Whether neighbors know each other equally often, and nobody knows a removed node.
bool is_consistent(const Skeleton_draft& draft)
{
  for (Index a = 0; a < draft.size(); ++a) {
    for (Index b : draft[a].neighbors) {
      const auto& back = draft[b].neighbors;
      const auto& forth = draft[a].neighbors;
      if (draft[b].is_removed || std::count(back.begin(), back.end(), a) != std::count(forth.begin(), forth.end(), b)) {
        return false;
      }
    }
  }
  return true;
}

/// Nodes on a line, one unit apart, and these edges.
Skeleton_draft make_draft(Index number_of_nodes, const Edges& wanted, double radius = 1)
{
  Skeleton_draft draft;
  for (Index node = 0; node < number_of_nodes; ++node) {
    draft.add_node({double(node), 0, 0}, radius);
    draft[node].separators = {node};
  }
  for (const auto& [a, b] : wanted) {
    draft.add_edge(a, b);
  }
  return draft;
}

TEST(Skeleton_draft, lists_each_edge_once)
{
  const Edges wanted{{0, 0}, {0, 1}, {0, 1}, {1, 2}, {2, 2}, {2, 2}};
  const Skeleton_draft draft = make_draft(3, wanted);
  EXPECT_EQ(edges(draft), wanted);
  EXPECT_EQ(draft.degree(0), 4u) << "a loop has two ends";
  EXPECT_TRUE(draft.is_junction(0));
  EXPECT_EQ(draft.edge_length(0, 2), 2);
}

TEST(Skeleton_draft, splits_and_bypasses)
{
  Skeleton_draft draft = make_draft(2, {{0, 1}, {0, 1}});
  const Index node = draft.split_edge(0, 1, {0, 5, 0}, 3);
  EXPECT_EQ(edges(draft), (Edges{{0, 1}, {0, node}, {1, node}}));
  EXPECT_EQ(draft[node].radius, 3);
  EXPECT_TRUE(draft.is_regular(node));
  draft.bypass(node);
  EXPECT_EQ(edges(draft), (Edges{{0, 1}, {0, 1}}));
  EXPECT_TRUE(is_consistent(draft));
  EXPECT_TRUE(draft[node].is_removed);
}

TEST(Skeleton_draft, bypass_on_a_double_edge_leaves_a_loop)
{
  Skeleton_draft draft = make_draft(2, {{0, 1}, {0, 1}});
  draft.bypass(1);
  EXPECT_EQ(edges(draft), (Edges{{0, 0}}));
  EXPECT_EQ(draft[0].separators, (std::vector<Index>{0, 1})) << "the heir stands for what the other one stood for";
}

TEST(Skeleton_draft, contracts)
{
  Skeleton_draft draft = make_draft(5, {{0, 1}, {1, 2}, {1, 3}, {3, 4}, {0, 4}});
  const int euler = euler_number(draft);
  draft.contract(1, 0);
  EXPECT_EQ(edges(draft), (Edges{{0, 2}, {0, 3}, {0, 4}, {3, 4}}));
  EXPECT_EQ(euler_number(draft), euler);
  EXPECT_TRUE(is_consistent(draft));
  draft.contract(0, 4);
  EXPECT_EQ(edges(draft), (Edges{{2, 4}, {3, 4}, {3, 4}}));
  EXPECT_EQ(euler_number(draft), euler) << "the triangle has become a double edge";
  std::vector<Index> separators = draft[4].separators;
  std::sort(separators.begin(), separators.end());
  EXPECT_EQ(separators, (std::vector<Index>{0, 1, 4}));
}

TEST(Skeleton_draft, keeps_its_euler_number_under_random_changes)
{
  std::mt19937 random(1);
  Skeleton_draft draft = make_draft(6, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {2, 4}, {4, 5}});
  const int euler = euler_number(draft);
  for (int step = 0; step < 2000; ++step) {
    const Edges all = edges(draft);
    const auto [a, b] = all[random() % all.size()];
    const auto links = std::count(all.begin(), all.end(), std::make_pair(a, b));
    if (random() % 2 == 0 || all.size() < 6) {
      draft.split_edge(a, b, Vector_3::Zero(), 1);
    } else if (draft.is_regular(a) && draft[a].neighbors[0] != a) {
      draft.bypass(a);
    } else if (a != b && links == 1 && std::count(all.begin(), all.end(), std::make_pair(a, a)) == 0) {
      draft.contract(a, b);
    }
    ASSERT_EQ(euler_number(draft), euler);
    ASSERT_TRUE(is_consistent(draft));
    if (step % 100 == 0) {
      draft.compact();
      ASSERT_EQ(euler_number(draft), euler);
      ASSERT_TRUE(is_consistent(draft));
    }
  }
}

TEST(Skeleton_draft, compacts_in_order)
{
  Skeleton_draft draft = make_draft(4, {{0, 1}, {1, 2}, {2, 3}});
  draft.bypass(1);
  draft.compact();
  ASSERT_EQ(draft.size(), 3u);
  EXPECT_EQ(edges(draft), (Edges{{0, 1}, {1, 2}}));
  EXPECT_EQ(draft[1].position.x(), 2);
}

TEST(make_simple, leaves_neither_loops_nor_parallels_and_keeps_the_cycles)
{
  Skeleton_draft draft = make_draft(4, {{0, 0}, {0, 0}, {0, 1}, {0, 1}, {0, 1}, {1, 2}, {3, 3}});
  const int euler = euler_number(draft);
  CSCD::internal::make_simple(draft);
  EXPECT_EQ(euler_number(draft), euler);
  EXPECT_TRUE(is_consistent(draft));
  const Edges all = edges(draft);
  EXPECT_EQ(std::set(all.begin(), all.end()).size(), all.size());
  for (const auto& [a, b] : all) {
    EXPECT_NE(a, b);
    EXPECT_GT(draft.edge_length(a, b), 0);
  }
}

TEST(make_simple, leaves_a_simple_draft_alone)
{
  Skeleton_draft draft = make_draft(4, {{0, 1}, {1, 2}, {0, 2}, {2, 3}});
  const Edges before = edges(draft);
  CSCD::internal::make_simple(draft);
  EXPECT_EQ(edges(draft), before);
}

/// Two junctions with two tips each, joined by a path over a node of this radius.
Skeleton_draft two_junctions(double radius)
{
  return make_draft(7, {{0, 1}, {1, 2}, {0, 3}, {0, 4}, {2, 5}, {2, 6}}, radius);
}

TEST(merge_junctions, merges_two_in_one_body)
{
  Skeleton_draft draft = two_junctions(5);
  CSCD::internal::merge_junctions(draft);
  EXPECT_EQ(euler_number(draft), 1);
  EXPECT_TRUE(is_consistent(draft));
  std::vector<std::size_t> degrees;
  for (Index node = 0; node < draft.size(); ++node) {
    if (!draft[node].is_removed) {
      degrees.push_back(draft.degree(node));
    }
  }
  std::sort(degrees.begin(), degrees.end());
  EXPECT_EQ(degrees, (std::vector<std::size_t>{1, 1, 1, 1, 4}));
}

TEST(merge_junctions, leaves_those_apart_that_are_far_apart)
{
  Skeleton_draft draft = two_junctions(0.5);
  const Edges before = edges(draft);
  CSCD::internal::merge_junctions(draft);
  EXPECT_EQ(edges(draft), before);
}

TEST(merge_junctions, keeps_cycles)
{
  // A ring of four junctions with a tip each, and nodes between them, all in one thick body.
  Skeleton_draft ring = make_draft(
      12, {{0, 4}, {4, 1}, {1, 5}, {5, 2}, {2, 6}, {6, 3}, {3, 7}, {7, 0}, {0, 8}, {1, 9}, {2, 10}, {3, 11}}, 100);
  CSCD::internal::merge_junctions(ring);
  EXPECT_EQ(euler_number(ring), 0);
  EXPECT_TRUE(is_consistent(ring));
  const Edges all = edges(ring);
  EXPECT_EQ(std::set(all.begin(), all.end()).size(), all.size()) << "no parallel edges";
  EXPECT_TRUE(std::none_of(all.begin(), all.end(), [](const auto& edge) { return edge.first == edge.second; }));
  // Two junctions joined by three paths.
  Skeleton_draft theta = make_draft(5, {{0, 2}, {2, 1}, {0, 3}, {3, 1}, {0, 4}, {4, 1}}, 100);
  CSCD::internal::merge_junctions(theta);
  EXPECT_EQ(euler_number(theta), -1);
}

/// A junction at the origin, of this radius, with two tips to its left and a branch over nodes at these places on the
/// line; the last one is a tip. Nodes are numbered in this order.
Skeleton_draft junction_with_branch(const std::vector<double>& places, double radius)
{
  Skeleton_draft draft = make_draft(3, {{0, 1}, {0, 2}}, radius);
  draft[1].position = {-9, 1, 0};
  draft[2].position = {-9, -1, 0};
  Index last = 0;
  for (double x : places) {
    const Index node = draft.add_node({x, 0, 0}, radius);
    draft.add_edge(last, node);
    last = node;
  }
  return draft;
}

TEST(drop_overshoots, drops_nodes_that_the_branch_would_turn_back_from)
{
  Skeleton_draft draft = junction_with_branch({-1, 3, 6}, 2);
  CSCD::internal::drop_overshoots(draft);
  EXPECT_TRUE(draft[3].is_removed);
  EXPECT_EQ(edges(draft), (Edges{{0, 1}, {0, 2}, {0, 4}, {4, 5}}));
  EXPECT_TRUE(is_consistent(draft));
}

TEST(drop_overshoots, drops_several_in_a_row)
{
  Skeleton_draft draft = junction_with_branch({1.5, 1, 0.5, 3, 6}, 2);
  CSCD::internal::drop_overshoots(draft);
  EXPECT_EQ(edges(draft), (Edges{{0, 1}, {0, 2}, {0, 5}, {5, 6}, {6, 7}}))
      << "back from 1.5, back from 1, but on from 0.5";
  EXPECT_TRUE(is_consistent(draft));
}

TEST(drop_overshoots, leaves_branches_alone_that_go_on)
{
  for (Skeleton_draft draft : {junction_with_branch({1, 3, 6}, 2), junction_with_branch({-3, 3, 6}, 2)}) {
    const Edges before = edges(draft);
    CSCD::internal::drop_overshoots(draft);
    EXPECT_EQ(edges(draft), before) << "nor those that turn back outside of the junction's ball";
  }
}

TEST(drop_overshoots, leaves_tips_where_they_are)
{
  Skeleton_draft draft = junction_with_branch({-1, 3}, 2);
  const Edges before = edges(draft);
  CSCD::internal::drop_overshoots(draft);
  EXPECT_EQ(edges(draft), before);
}

TEST(drop_overshoots, keeps_cycles_and_makes_no_parallel_edges)
{
  // A triangle at the junction, whose nodes both turn back.
  Skeleton_draft draft = junction_with_branch({-1, -0.5}, 2);
  draft.add_edge(4, 0);
  ASSERT_EQ(euler_number(draft), 0);
  const Edges before = edges(draft);
  CSCD::internal::drop_overshoots(draft);
  EXPECT_EQ(edges(draft), before);
}

TEST(smooth_branches, moves_nodes_within_branches_only)
{
  Skeleton_draft draft = make_draft(4, {{0, 1}, {1, 2}, {2, 3}});
  draft[1].position.y() = 1;
  CSCD::internal::smooth_branches(draft);
  EXPECT_EQ(draft[0].position, Vector_3(0, 0, 0));
  EXPECT_EQ(draft[3].position, Vector_3(3, 0, 0));
  EXPECT_EQ(draft[1].position, Vector_3(1, 0.5, 0));
  EXPECT_EQ(draft[2].position, Vector_3(2, 0.25, 0)) << "all at once, from the old positions";
}

} // namespace
