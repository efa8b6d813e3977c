// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A skeleton as a forest, for file formats that know no cycles.

#ifndef CSCD_IO_INTERNAL_SPANNING_FOREST_H
#define CSCD_IO_INTERNAL_SPANNING_FOREST_H

#include <boost/graph/graph_traits.hpp>
#include <boost/pending/disjoint_sets.hpp>
#include <boost/range/adaptor/reversed.hpp>
#include <boost/range/iterator_range_core.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// A spanning forest of a skeleton, each tree rooted at its first node, and the edges that it leaves out.
template <class Skeleton>
class Spanning_forest
{
public:
  using vertex_descriptor = typename boost::graph_traits<Skeleton>::vertex_descriptor;

  explicit Spanning_forest(const Skeleton& skeleton)
      : m_neighbors(num_vertices(skeleton)), m_parent(num_vertices(skeleton))
  {
    separate_loops(skeleton);
    std::vector<bool> is_reached(num_vertices(skeleton), false);
    for (vertex_descriptor root : boost::make_iterator_range(vertices(skeleton))) {
      if (!is_reached[root]) {
        m_parent[root] = root;
        reach_from(root, is_reached);
      }
    }
  }

  /// All nodes, each after its parent and each branch in one piece.
  const std::vector<vertex_descriptor>& order() const { return m_order; }
  /// The parent of `v`; a root is its own.
  vertex_descriptor parent(vertex_descriptor v) const { return m_parent[v]; }
  /// The edges that are not in the forest; each of them closes a cycle.
  const std::vector<std::pair<vertex_descriptor, vertex_descriptor>>& loops() const { return m_loops; }

private:
  void separate_loops(const Skeleton& skeleton)
  {
    boost::disjoint_sets_with_storage<> trees(num_vertices(skeleton));
    for (auto e : boost::make_iterator_range(edges(skeleton))) {
      const vertex_descriptor u = source(e, skeleton);
      const vertex_descriptor v = target(e, skeleton);
      if (trees.find_set(u) == trees.find_set(v)) {
        m_loops.emplace_back(u, v);
        continue;
      }
      trees.union_set(u, v);
      m_neighbors[u].push_back(v);
      m_neighbors[v].push_back(u);
    }
  }

  void reach_from(vertex_descriptor root, std::vector<bool>& is_reached)
  {
    std::vector<vertex_descriptor> open{root};
    while (!open.empty()) {
      const vertex_descriptor v = open.back();
      open.pop_back();
      is_reached[v] = true;
      m_order.push_back(v);
      for (vertex_descriptor neighbor : boost::adaptors::reverse(m_neighbors[v])) {
        if (!is_reached[neighbor]) {
          m_parent[neighbor] = v;
          open.push_back(neighbor);
        }
      }
    }
  }

  std::vector<std::vector<vertex_descriptor>> m_neighbors;
  std::vector<vertex_descriptor> m_parent;
  std::vector<vertex_descriptor> m_order;
  std::vector<std::pair<vertex_descriptor, vertex_descriptor>> m_loops;
};

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_SPANNING_FOREST_H
