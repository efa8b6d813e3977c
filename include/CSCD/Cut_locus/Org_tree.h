// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tree over all vertices whose long branches follow the ridges of a distance field.

#ifndef CSCD_CUT_LOCUS_ORG_TREE_H
#define CSCD_CUT_LOCUS_ORG_TREE_H

#include <CSCD/Vector_3.h>

#include <boost/graph/compressed_sparse_row_graph.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The ORG tree of the supplement (appendix G.1), which does not define it: the full, unfiltered spanning tree of the
/// vertices that have a distance, one for each component. Its root is the farthest vertex, a point of the cut locus
/// beyond doubt; it grows as Prim's tree does, from the attached vertex whose Laplacian is least, which takes all its
/// neighbors that are free. So it runs along the ridges first, and the cut locus becomes long chains from the root,
/// while everything else hangs on them as short twigs. Vertices on loops of the cut locus, if these are known, come
/// before all others: so the tree runs along the loops.
class Org_tree
{
public:
  /// Edges run from parents to children; vertices are those that are measured.
  using Graph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                                   boost::no_property, Index, Index>;

  /// Grows the tree; O(n log n) for n vertices.
  /// \param measures those of a triangulation, `Cut_locus_indicators`, or of a point complex, `Point_cut_locus_indicators`
  /// \param is_on_loop for every vertex
  template <class Measures>
  Org_tree(const Measures& measures, const std::vector<char>& is_on_loop)
      : m_laplacian(measures.distances().size(), 0), m_parent(measures.distances().size(), no_index),
        m_halfedge(measures.distances().size(), no_index)
  {
    std::vector<Index> by_distance;
    for (Index vertex = 0; vertex < m_parent.size(); ++vertex) {
      if (measures.is_reached(vertex)) {
        m_laplacian[vertex] =
            is_on_loop[vertex] ? -std::numeric_limits<double>::infinity() : measures.laplacian(vertex);
        by_distance.push_back(vertex);
      }
    }
    grow_from_farthest(measures, by_distance);
    make_graph();
  }

  const Graph& graph() const { return m_graph; }
  /// The farthest vertices of the components.
  const std::vector<Index>& roots() const { return m_roots; }
  /// All vertices of the tree, parents before children.
  const std::vector<Index>& order() const { return m_order; }
  /// `no_index` for roots, and for vertices that are not in the tree.
  Index parent(Index vertex) const { return m_parent[vertex]; }
  /// A halfedge between `vertex` and its parent, in either direction.
  Index halfedge_to_parent(Index vertex) const { return m_halfedge[vertex]; }
  /// The scale-free Laplacian; minus infinity on a loop.
  double laplacian(Index vertex) const { return m_laplacian[vertex]; }
  bool is_on_loop(Index vertex) const { return std::isinf(m_laplacian[vertex]); }

private:
  template <class Measures>
  void grow_from_farthest(const Measures& measures, std::vector<Index>& by_distance)
  {
    // The farthest vertex of each component is the first of it to come.
    const auto is_nearer = [&](Index a, Index b) {
      return std::pair(measures.distance(a), b) < std::pair(measures.distance(b), a);
    };
    std::vector<char> is_attached(m_parent.size(), 0);
    std::make_heap(by_distance.begin(), by_distance.end(), is_nearer);
    for (auto end = by_distance.end(); end != by_distance.begin(); --end) {
      const Index vertex = by_distance.front();
      if (!is_attached[vertex]) {
        m_roots.push_back(vertex);
        grow(measures, vertex, is_attached);
      }
      if (m_order.size() == by_distance.size()) {
        break;
      }
      std::pop_heap(by_distance.begin(), end, is_nearer);
    }
  }

  template <class Measures>
  void grow(const Measures& measures, Index root, std::vector<char>& is_attached)
  {
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const auto attach = [&](Index vertex) {
      is_attached[vertex] = 1;
      m_order.push_back(vertex);
      queue.emplace(m_laplacian[vertex], vertex);
    };
    attach(root);
    while (!queue.empty()) {
      const Index vertex = queue.top().second;
      queue.pop();
      measures.frames().for_each_neighbor(vertex, [&](Index neighbor, Index halfedge) {
        if (!is_attached[neighbor] && measures.is_reached(neighbor)) {
          m_parent[neighbor] = vertex;
          m_halfedge[neighbor] = halfedge;
          attach(neighbor);
        }
      });
    }
  }

  void make_graph()
  {
    std::vector<Index> sources;
    std::vector<Index> targets;
    for (Index vertex : m_order) {
      if (m_parent[vertex] != no_index) {
        sources.push_back(m_parent[vertex]);
        targets.push_back(vertex);
      }
    }
    m_graph = Graph(boost::construct_inplace_from_sources_and_targets, sources, targets, Index(m_parent.size()));
  }

  std::vector<double> m_laplacian;
  std::vector<Index> m_parent;
  std::vector<Index> m_halfedge;
  std::vector<Index> m_order;
  std::vector<Index> m_roots;
  Graph m_graph;
};

} // namespace CSCD::internal

#endif // CSCD_CUT_LOCUS_ORG_TREE_H
