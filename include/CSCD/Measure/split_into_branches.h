// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The branches of a skeleton.

#ifndef CSCD_MEASURE_SPLIT_INTO_BRANCHES_H
#define CSCD_MEASURE_SPLIT_INTO_BRANCHES_H

#include <CSCD/Vector3.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range_core.hpp>

#include <vector>

namespace CSCD {

namespace internal {

/// The branches of the skeleton whose nodes have these neighbors, in the order of their edges; see the function for
/// graphs. Linear.
std::vector<std::vector<Index>> split_into_branches(const std::vector<std::vector<Index>>& neighbors);

} // namespace internal

/// splits a skeleton into its branches: the paths between nodes of degree other than 2, and the closed cycles.
/// Every edge belongs to exactly one branch. A branch lists its nodes from end to end; one that returns to its first
/// node, such as a closed cycle, lists that node at both ends; an isolated node is a branch of its own.
/// Branches stand in the order of their first node and its edges, cycles without any other node after all others, so
/// that equal graphs give equal branches. Linear in the size of `skeleton`.
/// \tparam Skeleton a `Skeleton_graph`, or another `boost::adjacency_list` whose vertex descriptors are the indices
///         0 to n - 1 and whose edges are undirected
template <class Skeleton>
std::vector<std::vector<typename boost::graph_traits<Skeleton>::vertex_descriptor>>
split_into_branches(const Skeleton& skeleton)
{
  using vertex_descriptor = typename boost::graph_traits<Skeleton>::vertex_descriptor;
  std::vector<std::vector<Index>> neighbors;
  neighbors.reserve(num_vertices(skeleton));
  for (const vertex_descriptor v : boost::make_iterator_range(vertices(skeleton))) {
    std::vector<Index>& around = neighbors.emplace_back();
    for (const auto edge : boost::make_iterator_range(out_edges(v, skeleton))) {
      around.push_back(static_cast<Index>(target(edge, skeleton)));
    }
  }
  std::vector<std::vector<vertex_descriptor>> result;
  for (const std::vector<Index>& branch : internal::split_into_branches(neighbors)) {
    result.emplace_back(branch.begin(), branch.end());
  }
  return result;
}

} // namespace CSCD

#endif // CSCD_MEASURE_SPLIT_INTO_BRANCHES_H
