// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops around handles that no source has found.

#ifndef CSCD_SELECTION_HANDLE_LOOPS_H
#define CSCD_SELECTION_HANDLE_LOOPS_H

#include <CSCD/Selection/Cut_graph.h>
#include <CSCD/Selection/Separator_arrangement.h>
#include <CSCD/Separator/Vertex_loop.h>
#include <CSCD/Traits/Corner_table.h>
#include <CSCD/Traits/Surface_levels.h>
#include <CSCD/Traits/Triangulated_surface.h>
#include <CSCD/internal/Disjoint_sets.h>
#include <CSCD/internal/Distance_front.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CSCD::internal {

/// Finds loops in a piece of the cut surface that do not separate it: a basis of its homology, with the disc-like parts
/// beyond its separators filled in. From a tree of shortest paths in the piece and a cotree of the faces that leaves
/// the edges of the shortest loops to the last (Erickson and Whittlesey, "Greedy optimal homotopy and homology
/// generators", 2005), each edge that is in neither closes one loop. O(n log n) for n vertices of the surface.
class Handle_loops
{
public:
  Handle_loops(const Surface_level& finest, const Cut_graph& cut_graph, const Separator_arrangement& arrangement)
      : m_surface(finest.surface), m_corners(finest.corners), m_cut_graph(cut_graph), m_arrangement(arrangement),
        m_is_crossed(m_surface.number_of_halfedges(), 0), m_front(m_surface.number_of_vertices()),
        m_parent(m_surface.number_of_vertices())
  {
    for (const Separator_arrangement::Edge_point& point : arrangement.points()) {
      m_is_crossed[point.edge] = 1;
    }
  }

  /// The loops of `piece`, twice its genus of them, each simple, through `root` or with its stem from there left out.
  std::vector<Vertex_loop> operator()(Index piece, Index root)
  {
    grow_tree(piece, root);
    join_faces_along_separators();
    collect_cotree_edges(piece);
    std::vector<Vertex_loop> loops;
    // The longest loops first: their edges go to the cotree, and those of the shortest remain.
    for (auto edge = m_edges.rbegin(); edge != m_edges.rend(); ++edge) {
      if (!m_faces.join(Triangulated_surface::face(edge->halfedge),
                        Triangulated_surface::face(m_surface.twin(edge->halfedge)))) {
        loops.push_back(close_loop(edge->halfedge));
      }
    }
    std::reverse(loops.begin(), loops.end());
    return loops;
  }

private:
  struct Cotree_edge
  {
    Index halfedge;
    float loop_length;
  };

  bool is_crossed(Index halfedge) const { return m_is_crossed[m_surface.edge(halfedge)] != 0; }

  void grow_tree(Index piece, Index root)
  {
    m_front.clear();
    m_front.reach(root, 0);
    m_parent[root] = no_index;
    m_front.spread([&](Index vertex, float distance) {
      const Corner* corner = m_corners.fan(vertex).begin();
      for (Index halfedge : m_surface.outgoing(vertex)) {
        if (!is_crossed(halfedge) && m_cut_graph.piece_of_vertex(corner->neighbor) == piece &&
            m_front.reach(corner->neighbor, distance + corner->length)) {
          m_parent[corner->neighbor] = vertex;
        }
        ++corner;
      }
    });
  }

  /// What lies beyond a separator counts as a disc: the faces along it are one.
  void join_faces_along_separators()
  {
    m_faces = Disjoint_sets(m_surface.number_of_faces());
    for (const Separator_arrangement::Edge_point& point : m_arrangement.points()) {
      m_faces.join(Triangulated_surface::face(point.edge), Triangulated_surface::face(m_surface.twin(point.edge)));
    }
  }

  /// Collects the edges of the piece that are not in the tree, by increasing length of the loops that they close.
  void collect_cotree_edges(Index piece)
  {
    m_edges.clear();
    for (Index h = 0; h < m_surface.number_of_halfedges(); ++h) {
      const Index a = m_surface.origin(h);
      const Index b = m_surface.target(h);
      if (m_surface.edge(h) == h && !is_crossed(h) && m_cut_graph.piece_of_vertex(a) == piece &&
          m_front.is_reached(a) && m_front.is_reached(b) && m_parent[a] != b && m_parent[b] != a) {
        m_edges.push_back({h, m_front.distance(a) + m_front.distance(b) + float(m_surface.length(h))});
      }
    }
    std::stable_sort(m_edges.begin(), m_edges.end(),
                     [](const Cotree_edge& a, const Cotree_edge& b) { return a.loop_length < b.loop_length; });
  }

  /// The two tree paths to the ends of `halfedge` without what they share.
  Vertex_loop close_loop(Index halfedge) const
  {
    Vertex_loop first = path_from(m_surface.origin(halfedge));
    Vertex_loop second = path_from(m_surface.target(halfedge));
    Index meeting = first.back();
    while (!first.empty() && !second.empty() && first.back() == second.back()) {
      meeting = first.back();
      first.pop_back();
      second.pop_back();
    }
    std::reverse(second.begin(), second.end());
    first.push_back(meeting);
    first.insert(first.end(), second.begin(), second.end());
    return first;
  }

  Vertex_loop path_from(Index vertex) const
  {
    Vertex_loop path;
    for (; vertex != no_index; vertex = m_parent[vertex]) {
      path.push_back(vertex);
    }
    return path;
  }

  const Triangulated_surface& m_surface;
  const Corner_table& m_corners;
  const Cut_graph& m_cut_graph;
  const Separator_arrangement& m_arrangement;
  std::vector<std::uint8_t> m_is_crossed;
  Distance_front m_front;
  std::vector<Index> m_parent;
  Disjoint_sets m_faces;
  std::vector<Cotree_edge> m_edges;
};

} // namespace CSCD::internal

#endif // CSCD_SELECTION_HANDLE_LOOPS_H
