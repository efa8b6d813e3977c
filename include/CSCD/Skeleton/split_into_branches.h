// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The branches of a skeleton.

#ifndef CSCD_SKELETON_SPLIT_INTO_BRANCHES_H
#define CSCD_SKELETON_SPLIT_INTO_BRANCHES_H

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range_core.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD {

namespace internal {

/// Walks along the branches of a skeleton; see `split_into_branches()`.
template <class Skeleton>
class Branch_splitter
{
public:
  using vertex_descriptor = typename boost::graph_traits<Skeleton>::vertex_descriptor;
  using Branch = std::vector<vertex_descriptor>;

  explicit Branch_splitter(const Skeleton& skeleton) : m_skeleton(skeleton), m_is_walked(num_vertices(skeleton), false)
  {
    for (vertex_descriptor v : boost::make_iterator_range(vertices(skeleton))) {
      if (out_degree(v, skeleton) != 2) {
        walk_all_from(v);
      }
    }
    for (vertex_descriptor v : boost::make_iterator_range(vertices(skeleton))) {
      if (out_degree(v, skeleton) == 2 && !is_walked(v)) {
        walk_cycle(v);
      }
    }
  }

  std::vector<Branch> release() { return std::move(m_branches); }

private:
  bool is_inner(vertex_descriptor v) const { return out_degree(v, m_skeleton) == 2; }
  bool is_walked(vertex_descriptor v) const { return m_is_walked[static_cast<std::size_t>(v)]; }
  void mark(vertex_descriptor v) { m_is_walked[static_cast<std::size_t>(v)] = true; }

  void walk_all_from(vertex_descriptor end)
  {
    if (out_degree(end, m_skeleton) == 0) {
      m_branches.push_back({end});
    }
    std::size_t number_of_loop_ends = 0; // an edge from a node to itself is listed twice among its edges
    for (auto e : boost::make_iterator_range(out_edges(end, m_skeleton))) {
      const vertex_descriptor next = target(e, m_skeleton);
      if (is_inner(next)) {
        if (!is_walked(next)) {
          walk(end, next);
        }
      } else if (end < next || (end == next && number_of_loop_ends++ % 2 == 0)) {
        m_branches.push_back({end, next});
      }
    }
  }

  void walk(vertex_descriptor previous, vertex_descriptor current)
  {
    Branch branch{previous};
    while (is_inner(current) && !is_walked(current)) {
      mark(current);
      branch.push_back(current);
      const vertex_descriptor next = other_neighbor(current, previous);
      previous = current;
      current = next;
    }
    branch.push_back(current);
    m_branches.push_back(std::move(branch));
  }

  void walk_cycle(vertex_descriptor first)
  {
    mark(first);
    walk(first, target(*out_edges(first, m_skeleton).first, m_skeleton));
  }

  vertex_descriptor other_neighbor(vertex_descriptor v, vertex_descriptor neighbor) const
  {
    auto e = out_edges(v, m_skeleton).first;
    const vertex_descriptor first = target(*e, m_skeleton);
    return first == neighbor ? target(*++e, m_skeleton) : first;
  }

  const Skeleton& m_skeleton;
  std::vector<bool> m_is_walked;
  std::vector<Branch> m_branches;
};

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
  return internal::Branch_splitter<Skeleton>(skeleton).release();
}

} // namespace CSCD

#endif // CSCD_SKELETON_SPLIT_INTO_BRANCHES_H
