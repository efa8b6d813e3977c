// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The branches of a skeleton.

#ifndef CSCD_MEASURE_SPLIT_INTO_BRANCHES_H
#define CSCD_MEASURE_SPLIT_INTO_BRANCHES_H

#include <CSCD/Vector_3.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range_core.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD {

namespace internal {

/// Walks along the branches of a skeleton; see `split_into_branches()`.
class Branch_splitter
{
public:
  using Branch = std::vector<Index>;

  explicit Branch_splitter(const std::vector<std::vector<Index>>& neighbors)
      : m_neighbors(neighbors), m_is_walked(neighbors.size(), 0)
  {
    for (Index v = 0; v < neighbors.size(); ++v) {
      if (!is_inner(v)) {
        walk_all_from(v);
      }
    }
    for (Index v = 0; v < neighbors.size(); ++v) {
      if (is_inner(v) && m_is_walked[v] == 0) {
        walk_cycle(v);
      }
    }
  }

  std::vector<Branch> release() { return std::move(m_branches); }

private:
  bool is_inner(Index v) const { return m_neighbors[v].size() == 2; }

  void walk_all_from(Index end)
  {
    if (m_neighbors[end].empty()) {
      m_branches.push_back({end});
    }
    std::size_t number_of_loop_ends = 0; // an edge from a node to itself is listed twice among its edges
    for (const Index next : m_neighbors[end]) {
      if (is_inner(next)) {
        if (m_is_walked[next] == 0) {
          walk(end, next);
        }
      } else if (end < next || (end == next && number_of_loop_ends++ % 2 == 0)) {
        m_branches.push_back({end, next});
      }
    }
  }

  void walk(Index previous, Index current)
  {
    Branch branch{previous};
    while (is_inner(current) && m_is_walked[current] == 0) {
      m_is_walked[current] = 1;
      branch.push_back(current);
      const Index next = m_neighbors[current][m_neighbors[current][0] == previous ? 1 : 0];
      previous = current;
      current = next;
    }
    branch.push_back(current);
    m_branches.push_back(std::move(branch));
  }

  void walk_cycle(Index first)
  {
    m_is_walked[first] = 1;
    walk(first, m_neighbors[first][0]);
  }

  const std::vector<std::vector<Index>>& m_neighbors;
  std::vector<char> m_is_walked;
  std::vector<Branch> m_branches;
};

/// The branches of the skeleton whose nodes have these neighbors, in the order of their edges; see the function for
/// graphs. Linear.
inline std::vector<std::vector<Index>> split_into_branches(const std::vector<std::vector<Index>>& neighbors)
{
  return Branch_splitter(neighbors).release();
}

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
