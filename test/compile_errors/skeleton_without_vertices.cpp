// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A graph whose nodes cannot hold what identifies the vertices of the input is refused as a skeleton.
// expected error: CSCD: CurveSkeletonGraph requires g[v].vertices, a range of input descriptors

#include <CSCD/concepts.h>

#include <boost/graph/adjacency_list.hpp>

#include <array>

struct Node
{
  std::array<double, 3> point;
};

int main()
{
  CSCD::check_curve_skeleton_graph<boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Node>>();
}
