// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of the branches of a skeleton.

#include <CSCD/Measure/split_into_branches.h>

#include <boost/graph/adjacency_list.hpp>
#include <gtest/gtest.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace {

using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;
using Branches = std::vector<std::vector<std::size_t>>;

Branches branches(std::size_t number_of_nodes, const std::vector<std::pair<std::size_t, std::size_t>>& edges)
{
  return CSCD::split_into_branches(Graph(edges.begin(), edges.end(), number_of_nodes));
}

TEST(Split_into_branches, of_known_graphs)
{
  EXPECT_EQ((Branches{{0}, {1}}), branches(2, {})) << "isolated nodes";
  EXPECT_EQ((Branches{{0, 2, 1, 3}}), branches(4, {{1, 3}, {2, 1}, {0, 2}})) << "a path, from its lesser end";
  EXPECT_EQ((Branches{{0, 1, 2, 0}}), branches(3, {{0, 1}, {1, 2}, {2, 0}})) << "a cycle";
  EXPECT_EQ((Branches{{3, 4}, {0, 1, 2, 0}}), branches(5, {{0, 1}, {1, 2}, {2, 0}, {3, 4}})) << "cycles come last";
  EXPECT_EQ((Branches{{0, 1}, {1, 2, 3, 1}}), branches(4, {{0, 1}, {1, 2}, {2, 3}, {3, 1}})) << "a loop at a junction";
  EXPECT_EQ((Branches{{0, 2, 1}, {0, 1}, {0, 3, 4, 1}}), branches(5, {{0, 2}, {2, 1}, {0, 1}, {0, 3}, {3, 4}, {4, 1}}));
  EXPECT_EQ((Branches{{0, 1}, {0, 1}, {0, 1}}), branches(2, {{0, 1}, {1, 0}, {0, 1}})) << "parallel edges";
  EXPECT_EQ((Branches{{0, 1, 0}}), branches(2, {{0, 1}, {1, 0}})) << "a cycle: both have degree 2";
  EXPECT_EQ((Branches{{0, 1}, {1, 2, 1}}), branches(3, {{0, 1}, {1, 2}, {2, 1}}));
}

} // namespace
