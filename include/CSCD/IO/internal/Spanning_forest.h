// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A skeleton as a forest, for file formats that know no cycles.

#ifndef CSCD_IO_INTERNAL_SPANNING_FOREST_H
#define CSCD_IO_INTERNAL_SPANNING_FOREST_H

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range_core.hpp>

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
      : m_parent(num_vertices(skeleton)), m_is_reached(num_vertices(skeleton), false)
  {
    m_order.reserve(num_vertices(skeleton));
    for (vertex_descriptor root : boost::make_iterator_range(vertices(skeleton))) {
      if (!m_is_reached[root]) {
        m_parent[root] = root;
        reach_from(root, skeleton);
      }
    }
    collect_loops(skeleton);
  }

  /// All nodes, each after its parent and each branch in one piece.
  const std::vector<vertex_descriptor>& order() const { return m_order; }
  /// The parent of `v`; a root is its own.
  vertex_descriptor parent(vertex_descriptor v) const { return m_parent[v]; }
  /// The edges that are not in the forest; each of them closes a cycle.
  const std::vector<std::pair<vertex_descriptor, vertex_descriptor>>& loops() const { return m_loops; }

private:
  /// Goes deep first, so that branches stay in one piece.
  void reach_from(vertex_descriptor root, const Skeleton& skeleton)
  {
    std::vector<vertex_descriptor> open{root};
    while (!open.empty()) {
      const vertex_descriptor v = open.back();
      open.pop_back();
      if (m_is_reached[v]) {
        continue;
      }
      m_is_reached[v] = true;
      m_order.push_back(v);
      for (auto e : boost::make_iterator_range(out_edges(v, skeleton))) {
        const vertex_descriptor neighbor = target(e, skeleton);
        if (!m_is_reached[neighbor]) {
          m_parent[neighbor] = v; // the parent given last stays, as what was put on the stack last is taken first
          open.push_back(neighbor);
        }
      }
    }
  }

  /// One edge to the parent of each node is in the forest; all others are not.
  void collect_loops(const Skeleton& skeleton)
  {
    std::vector<bool> has_edge_to_parent(num_vertices(skeleton), false);
    for (auto e : boost::make_iterator_range(edges(skeleton))) {
      const vertex_descriptor u = source(e, skeleton);
      const vertex_descriptor v = target(e, skeleton);
      const vertex_descriptor child = m_parent[u] == v ? u : v;
      const bool is_in_forest = u != v && (m_parent[u] == v || m_parent[v] == u) && !has_edge_to_parent[child];
      if (is_in_forest) {
        has_edge_to_parent[child] = true;
      } else {
        m_loops.emplace_back(u, v);
      }
    }
  }

  std::vector<vertex_descriptor> m_parent;
  std::vector<bool> m_is_reached;
  std::vector<vertex_descriptor> m_order;
  std::vector<std::pair<vertex_descriptor, vertex_descriptor>> m_loops;
};

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_SPANNING_FOREST_H
