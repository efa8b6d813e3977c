// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A skeleton with all difficult cases for writers, with and without radius.

#ifndef CSCD_TEST_IO_SAMPLE_SKELETON_H
#define CSCD_TEST_IO_SAMPLE_SKELETON_H

#include <CSCD/Skeleton_graph.h>

#include <CGAL/Simple_cartesian.h>

#include <boost/graph/adjacency_list.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace test_support {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Skeleton = CSCD::Skeleton_graph<Point, std::size_t>;

/// A node as in skeletons of other makers: no radius.
struct Node_without_radius
{
  Point point;
  std::vector<std::size_t> vertices;
};
using Skeleton_without_radius =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Node_without_radius>;

/// Edges of the sample: a path 0 - 1 - 2 that ends in a cycle 2 - 3 - 4, at whose node 4 hangs the tip 5; an isolated
/// node 6; a closed cycle 7 - 8 - 9; two nodes 10, 11 joined by two edges, one of them by way of 12.
inline std::vector<std::pair<std::size_t, std::size_t>> sample_edges()
{
  return {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 2}, {4, 5}, {7, 8}, {8, 9}, {9, 7}, {10, 11}, {11, 12}, {12, 10}};
}

/// A skeleton whose coordinates are mostly not exact in decimal notation.
template <class SampleSkeleton>
SampleSkeleton sample_skeleton()
{
  constexpr std::size_t number_of_nodes = 13;
  SampleSkeleton skeleton(number_of_nodes);
  for (std::size_t i = 0; i < number_of_nodes; ++i) {
    const auto x = static_cast<double>(i);
    skeleton[i].point = Point(x / 3, -1234567.0 - 0.1 * x, x == 5 ? 1e-300 : 1e20 * (x + 0.7));
    skeleton[i].vertices.assign(i, i);
    if constexpr (CSCD::has_radius_v<SampleSkeleton>) {
      skeleton[i].radius = 1 / (x + 7);
    }
  }
  for (const auto& [u, v] : sample_edges()) {
    add_edge(u, v, skeleton);
  }
  return skeleton;
}

} // namespace test_support

#endif // CSCD_TEST_IO_SAMPLE_SKELETON_H
