// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons as SWC.

#ifndef CSCD_IO_WRITE_SWC_H
#define CSCD_IO_WRITE_SWC_H

#include <CSCD/IO/internal/Skeleton_content.h>
#include <CSCD/Vector_3.h>

#include <array>
#include <cstddef>
#include <ostream>
#include <vector>

namespace CSCD {
namespace internal {

/// A spanning forest of a skeleton, found depth first, each tree rooted at its first node, and the edges that it leaves
/// out. Boost's depth-first search would need a copy of the skeleton whose incident edges are in reverse order.
class Spanning_forest
{
public:
  /// \param neighbors of every node
  Spanning_forest(const std::vector<std::vector<Index>>& neighbors, const std::vector<std::array<Index, 2>>& edges)
      : m_parent(neighbors.size()), m_is_reached(neighbors.size(), 0)
  {
    m_order.reserve(neighbors.size());
    for (Index root = 0; root < neighbors.size(); ++root) {
      if (m_is_reached[root] == 0) {
        m_parent[root] = root;
        reach_from(root, neighbors);
      }
    }
    collect_loops(edges);
  }

  /// All nodes, each after its parent and each branch in one piece.
  const std::vector<Index>& order() const { return m_order; }
  /// The parent of `v`; a root is its own.
  Index parent(Index v) const { return m_parent[v]; }
  /// The edges that are not in the forest; each of them closes a cycle.
  const std::vector<std::array<Index, 2>>& loops() const { return m_loops; }

private:
  void reach_from(Index root, const std::vector<std::vector<Index>>& neighbors)
  {
    std::vector<Index> open{root};
    while (!open.empty()) {
      const Index v = open.back();
      open.pop_back();
      if (m_is_reached[v] != 0) {
        continue;
      }
      m_is_reached[v] = 1;
      m_order.push_back(v);
      for (const Index neighbor : neighbors[v]) {
        if (m_is_reached[neighbor] == 0) {
          m_parent[neighbor] = v; // the parent given last stays, as what was put on the stack last is taken first
          open.push_back(neighbor);
        }
      }
    }
  }

  /// One edge to the parent of each node is in the forest; all others are not.
  void collect_loops(const std::vector<std::array<Index, 2>>& edges)
  {
    std::vector<char> has_edge_to_parent(m_parent.size(), 0);
    for (const auto& [u, v] : edges) {
      const Index child = m_parent[u] == v ? u : v;
      const bool is_in_forest = u != v && (m_parent[u] == v || m_parent[v] == u) && has_edge_to_parent[child] == 0;
      if (is_in_forest) {
        has_edge_to_parent[child] = 1;
      } else {
        m_loops.push_back({u, v});
      }
    }
  }

  std::vector<Index> m_parent;
  std::vector<char> m_is_reached;
  std::vector<Index> m_order;
  std::vector<std::array<Index, 2>> m_loops;
};

/// The structure identifier of a node in SWC: 5 a fork, 6 an end, 0 anything else.
inline int swc_type(std::size_t degree)
{
  constexpr int undefined = 0;
  constexpr int fork_point = 5;
  constexpr int end_point = 6;
  return degree > 2 ? fork_point : degree == 1 ? end_point : undefined;
}

inline void write_swc(std::ostream& out, const Skeleton_content& skeleton)
{
  const std::vector<std::vector<Index>> neighbors = node_neighbors(skeleton);
  const Spanning_forest forest(neighbors, skeleton.edges);
  std::vector<std::size_t> id(skeleton.number_of_nodes());
  for (std::size_t i = 0; i < forest.order().size(); ++i) {
    id[forest.order()[i]] = i + 1;
  }
  Exact_format format(out);
  out << "# id type x y z radius parent\n";
  for (const auto& [u, v] : forest.loops()) {
    out << "# loop " << id[u] << ' ' << id[v] << '\n';
  }
  for (const Index v : forest.order()) {
    out << id[v] << ' ' << swc_type(neighbors[v].size()) << ' ';
    write_coordinates(out, skeleton.points[v]);
    out << ' ' << (skeleton.has_radius ? skeleton.radii[v] : 0) << ' ';
    if (forest.parent(v) == v) {
      out << "-1\n";
    } else {
      out << id[forest.parent(v)] << '\n';
    }
  }
  format.finish();
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
  internal::write_swc(out, internal::skeleton_content(skeleton));
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_SWC_H
