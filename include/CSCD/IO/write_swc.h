// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes a skeleton as SWC.

#ifndef CSCD_IO_WRITE_SWC_H
#define CSCD_IO_WRITE_SWC_H

#include <CSCD/IO/internal/Exact_format.h>
#include <CSCD/IO/internal/skeleton_access.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range_core.hpp>

#include <cstddef>
#include <ostream>
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

namespace CSCD {

namespace internal {

/// The structure identifier of a node in SWC: 5 a fork, 6 an end, 0 anything else.
inline int swc_type(std::size_t degree)
{
  constexpr int undefined = 0;
  constexpr int fork_point = 5;
  constexpr int end_point = 6;
  return degree > 2 ? fork_point : degree == 1 ? end_point : undefined;
}

} // namespace internal

/// writes `skeleton` in SWC format: a line `id type x y z radius parent` for each node, identifiers counted from 1,
/// parents before children, -1 as the parent of the first node of each component; radius 0 if the nodes have none.
/// SWC holds forests only: of each cycle one edge is left out and stands in a comment line `# loop i j` instead, with
/// the identifiers of its ends. Linear.
/// \throw File_error if `out` fails
template <class Skeleton>
void write_swc(std::ostream& out, const Skeleton& skeleton)
{
  const internal::Spanning_forest<Skeleton> forest(skeleton);
  std::vector<std::size_t> id(num_vertices(skeleton));
  for (std::size_t i = 0; i < forest.order().size(); ++i) {
    id[forest.order()[i]] = i + 1;
  }
  internal::Exact_format format(out);
  out << "# id type x y z radius parent\n";
  for (const auto& [u, v] : forest.loops()) {
    out << "# loop " << id[u] << ' ' << id[v] << '\n';
  }
  for (auto v : forest.order()) {
    out << id[v] << ' ' << internal::swc_type(out_degree(v, skeleton)) << ' ';
    internal::write_coordinates(out, skeleton, v);
    out << ' ' << internal::radius(skeleton, v) << ' ';
    if (forest.parent(v) == v) {
      out << "-1\n";
    } else {
      out << id[forest.parent(v)] << '\n';
    }
  }
  format.finish();
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_SWC_H
