// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The loops of a closed surface that do not separate it: a tree of its edges, a tree of its faces, and the rest.

#ifndef CSCD_SURFACE_TREE_COTREE_H
#define CSCD_SURFACE_TREE_COTREE_H

#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CSCD::internal {

/// A tree of edges and a tree of faces that crosses none of these, in each component of a closed surface. They leave
/// 2 g edges over on a surface of genus g. Each of these closes a loop along edges with the first tree, and a dual loop
/// across edges with the second; these two meet in that edge alone, and no other loop meets it (Erickson and
/// Whittlesey, "Greedy optimal homotopy and homology generators", 2005). So how often a closed curve crosses the dual
/// loops tells its class in the homology over Z2.
class Tree_cotree
{
public:
  /// Linear. `surface` is referred to.
  explicit Tree_cotree(const Triangulated_surface& surface) : m_surface(surface)
  {
    m_parent = grow_trees(surface.number_of_vertices(), [&](Index vertex, const auto& reach) {
      for (const Index h : surface.outgoing(vertex)) {
        reach(surface.target(h), surface.twin(h));
      }
    });
    m_dual_parent = grow_trees(surface.number_of_faces(), [&](Index face, const auto& reach) {
      for (const Index h : Triangulated_surface::face_halfedges(face)) {
        if (!is_in_tree(h)) {
          reach(Triangulated_surface::face(surface.twin(h)), surface.twin(h));
        }
      }
    });
    for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
      if (surface.edge(h) == h && !is_in_tree(h) && !is_in_dual_tree(h)) {
        m_left_over.push_back(h);
      }
    }
  }

  /// A halfedge of each edge in neither tree.
  const std::vector<Index>& left_over() const { return m_left_over; }

  /// The vertex of the component of `vertex` that stands for it.
  Index root(Index vertex) const
  {
    while (m_parent[vertex] != no_index) {
      vertex = m_surface.target(m_parent[vertex]);
    }
    return vertex;
  }

  /// The halfedges along the loop that `edge` closes, in order; the first is `edge`. \pre it is left over
  std::vector<Index> loop(Index edge) const
  {
    return closed_path(edge, m_surface.origin(edge), m_surface.target(edge), m_parent,
                       [this](Index side) { return m_surface.target(side); });
  }

  /// The halfedges where the dual loop of `edge` leaves faces, in order; the first is `edge`. \pre it is left over
  std::vector<Index> dual_loop(Index edge) const
  {
    const auto face_behind = [this](Index side) { return Triangulated_surface::face(m_surface.twin(side)); };
    return closed_path(edge, Triangulated_surface::face(edge), face_behind(edge), m_dual_parent, face_behind);
  }

private:
  /// Grows a tree breadth first in each connected part of a graph of `size` nodes. \return the way back of each node
  /// except the roots \param for_each_neighbor `for_each_neighbor(node, reach)` calls `reach(neighbor, way back)`
  template <class ForEachNeighbor>
  static std::vector<Index> grow_trees(std::size_t size, const ForEachNeighbor& for_each_neighbor)
  {
    std::vector<Index> parent(size, no_index);
    std::vector<char> is_reached(size, 0);
    std::vector<Index> queue;
    queue.reserve(size);
    for (Index root = 0; root < size; ++root) {
      std::size_t next = queue.size();
      if (is_reached[root] == 0) {
        is_reached[root] = 1;
        queue.push_back(root);
      }
      for (; next < queue.size(); ++next) {
        for_each_neighbor(queue[next], [&](Index neighbor, Index way_back) {
          if (is_reached[neighbor] == 0) {
            is_reached[neighbor] = 1;
            parent[neighbor] = way_back;
            queue.push_back(neighbor);
          }
        });
      }
    }
    return parent;
  }

  bool is_in_tree(Index h) const
  {
    return m_parent[m_surface.origin(h)] == h || m_parent[m_surface.target(h)] == m_surface.twin(h);
  }
  bool is_in_dual_tree(Index h) const
  {
    const Index t = m_surface.twin(h);
    return m_dual_parent[Triangulated_surface::face(h)] == h || m_dual_parent[Triangulated_surface::face(t)] == t;
  }

  /// The closed path over the side `edge` from node to node of a tree and back along the tree, as the sides that it
  /// passes; `edge` comes first. \param next `next(side)` is the node that a way back leads to
  template <class Next>
  std::vector<Index> closed_path(Index edge, Index from, Index to, const std::vector<Index>& parent,
                                 const Next& next) const
  {
    const auto path_to_root = [&](Index node) {
      std::vector<Index> path;
      for (Index h = parent[node]; h != no_index; h = parent[next(h)]) {
        path.push_back(h);
      }
      return path;
    };
    std::vector<Index> first = path_to_root(from);
    std::vector<Index> second = path_to_root(to);
    while (!first.empty() && !second.empty() && first.back() == second.back()) { // their common part
      first.pop_back();
      second.pop_back();
    }
    std::vector<Index> result{edge};
    result.insert(result.end(), second.begin(), second.end());
    std::transform(first.rbegin(), first.rend(), std::back_inserter(result),
                   [this](Index h) { return m_surface.twin(h); });
    return result;
  }

  const Triangulated_surface& m_surface;
  std::vector<Index> m_parent;      // halfedge from each vertex to its parent in the tree
  std::vector<Index> m_dual_parent; // halfedge where each face is left for its parent
  std::vector<Index> m_left_over;   // a halfedge of each edge in neither tree
};

} // namespace CSCD::internal

#endif // CSCD_SURFACE_TREE_COTREE_H
