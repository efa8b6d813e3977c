// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds short loops around small handles.

#ifndef CSCD_POINTS_LOCAL_HANDLE_SEARCH_H
#define CSCD_POINTS_LOCAL_HANDLE_SEARCH_H

#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Dijkstra_search.h>
#include <CSCD/internal/Disjoint_sets.h>
#include <CSCD/internal/Epoch_marks.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CSCD::internal {

/// Floods the faces on both sides of a loop in lock step, so that the work is about that for the smaller side where the
/// loop separates, and until the floods meet where it does not. Loops can be made barriers that no flood crosses.
/// Nothing of the size of the surface is touched for a loop; reuse one object.
class Loop_flood
{
public:
  explicit Loop_flood(const Triangulated_surface& surface)
      : m_surface(surface), m_is_barrier(surface.number_of_halfedges(), 0),
        m_on_loop(surface.number_of_halfedges()), m_side{Epoch_marks(surface.number_of_faces()),
                                                         Epoch_marks(surface.number_of_faces())}
  {
  }

  /// Whether `loop` separates its component of the surface, cut along all barriers.
  /// \pre consecutive vertices are neighbors
  bool separates(const Vertex_loop& loop)
  {
    start(loop);
    for (std::size_t next = 0;; ++next) {
      for (std::size_t side = 0; side < 2; ++side) {
        if (next >= m_front[side].size()) {
          return true;
        }
        if (!expand(m_front[side][next], side)) {
          return false;
        }
      }
    }
  }

  /// Keeps all later floods from crossing `loop`.
  void add_barrier(const Vertex_loop& loop)
  {
    for_each_halfedge(loop, [this](Index h) {
      m_is_barrier[h] = 1;
      m_is_barrier[m_surface.twin(h)] = 1;
    });
  }

private:
  template <class Use>
  void for_each_halfedge(const Vertex_loop& loop, const Use& use) const
  {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      use(m_surface.find_halfedge(loop[i], loop[(i + 1) % loop.size()]));
    }
  }

  void start(const Vertex_loop& loop)
  {
    m_on_loop.clear();
    for (std::size_t side = 0; side < 2; ++side) {
      m_front[side].clear();
      m_side[side].clear();
    }
    for_each_halfedge(loop, [this](Index h) {
      m_on_loop.mark(h);
      m_on_loop.mark(m_surface.twin(h));
    });
    for_each_halfedge(loop, [this](Index h) {
      add(Triangulated_surface::face(h), 0);
      add(Triangulated_surface::face(m_surface.twin(h)), 1);
    });
  }

  void add(Index face, std::size_t side)
  {
    if (m_side[side].mark(face)) {
      m_front[side].push_back(face);
    }
  }

  /// Floods the neighbors of `face`. \return whether the other side has not been met
  bool expand(Index face, std::size_t side)
  {
    if (m_side[1 - side].is_marked(face)) {
      return false;
    }
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      if (m_on_loop.is_marked(h) || m_is_barrier[h] != 0) {
        continue;
      }
      const Index neighbor = Triangulated_surface::face(m_surface.twin(h));
      if (m_side[1 - side].is_marked(neighbor)) {
        return false;
      }
      add(neighbor, side);
    }
    return true;
  }

  const Triangulated_surface& m_surface;
  std::vector<std::uint8_t> m_is_barrier;
  Epoch_marks m_on_loop;
  Epoch_marks m_side[2];
  std::vector<Index> m_front[2];
};

/// Finds the short loops through a vertex that are not filled by the faces around it: a basis of the homology of a
/// geodesic ball. Most balls are discs, which is seen by counting. From the tree of shortest paths and a cotree of
/// faces and the outside that leaves the edges of the shortest loops to the last, each edge that is in neither closes
/// one loop (Erickson and Whittlesey, "Greedy optimal homotopy and homology generators", 2005). Nothing of the size of
/// the surface is touched for a vertex; reuse one object.
class Local_handle_search
{
public:
  Local_handle_search(const Triangulated_surface& surface, const Vertex_fan_table& corners)
      : m_surface(surface), m_corners(corners), m_front(surface.number_of_vertices()),
        m_parent(surface.number_of_vertices()), m_first_hop(surface.number_of_vertices()),
        m_face_seen(surface.number_of_faces()), m_face_number(surface.number_of_faces())
  {
  }

  /// Grows the ball of `radius` around `center`. \return whether it is a disc, so that all loops in it are filled
  bool grow(Index center, float radius)
  {
    m_ball.clear();
    m_front.clear();
    m_front.reach(center, 0);
    m_parent[center] = m_first_hop[center] = no_index;
    m_front.spread([&](Index vertex, float distance) {
      m_ball.push_back(vertex);
      for (const Corner& corner : m_corners.neighbors(vertex)) {
        const float longer = distance + corner.length;
        if (longer <= radius && m_front.reach(corner.neighbor, longer)) {
          m_parent[corner.neighbor] = vertex;
          m_first_hop[corner.neighbor] = vertex == center ? corner.neighbor : m_first_hop[vertex];
        }
      }
    });
    return count_euler_number() == 1;
  }

  /// Calls `use(loop, length)` for the loops through the center that are not filled and at most `longest` long.
  template <class Use>
  void for_each_loop(float longest, const Use& use)
  {
    collect_edges();
    // One set for each face of the ball, and the last for the outside.
    m_faces = Disjoint_sets(m_number_of_faces + 1);
    for (auto edge = m_edges.rbegin(); edge != m_edges.rend(); ++edge) {
      if (m_faces.join(set_of(edge->halfedge), set_of(m_surface.twin(edge->halfedge)))) {
        continue;
      }
      const Index a = m_surface.origin(edge->halfedge);
      const Index b = m_surface.target(edge->halfedge);
      if (edge->loop_length <= longest && m_first_hop[a] != m_first_hop[b]) {
        close_loop(a, b);
        use(m_loop, edge->loop_length);
      }
    }
  }

private:
  struct Cotree_edge
  {
    Index halfedge;
    float loop_length;
  };

  /// Vertices less edges and plus faces of the ball; numbers its faces.
  std::ptrdiff_t count_euler_number()
  {
    m_face_seen.clear();
    m_number_of_faces = 0;
    std::ptrdiff_t number_of_halfedges = 0;
    for (Index vertex : m_ball) {
      for (Index h : m_surface.outgoing(vertex)) {
        number_of_halfedges += m_front.is_reached(m_surface.target(h)) ? 1 : 0;
        const Index face = Triangulated_surface::face(h);
        if (m_front.is_reached(m_surface.target(h)) && m_front.is_reached(m_surface.opposite_vertex(h)) &&
            m_face_seen.mark(face)) {
          m_face_number[face] = m_number_of_faces++;
        }
      }
    }
    return std::ptrdiff_t(m_ball.size()) - number_of_halfedges / 2 + std::ptrdiff_t(m_number_of_faces);
  }

  Index set_of(Index halfedge) const
  {
    const Index face = Triangulated_surface::face(halfedge);
    return m_face_seen.is_marked(face) ? m_face_number[face] : m_number_of_faces;
  }

  /// Collects the edges of the ball that are not in the tree, by increasing length of the loops that they close.
  void collect_edges()
  {
    m_edges.clear();
    for (Index a : m_ball) {
      for (Index h : m_surface.outgoing(a)) {
        const Index b = m_surface.target(h);
        if (m_surface.edge(h) == h && m_front.is_reached(b) && m_parent[a] != b && m_parent[b] != a) {
          m_edges.push_back({h, m_front.distance(a) + m_front.distance(b) + float(m_surface.length(h))});
        }
      }
    }
    std::sort(m_edges.begin(), m_edges.end(), [](const Cotree_edge& a, const Cotree_edge& b) {
      return a.loop_length != b.loop_length ? a.loop_length < b.loop_length : a.halfedge < b.halfedge;
    });
  }

  /// The tree paths to `a` and `b`, which have but the center in common.
  void close_loop(Index a, Index b)
  {
    m_loop.clear();
    for (Index vertex = a; vertex != no_index; vertex = m_parent[vertex]) {
      m_loop.push_back(vertex);
    }
    std::reverse(m_loop.begin(), m_loop.end());
    for (Index vertex = b; m_parent[vertex] != no_index; vertex = m_parent[vertex]) {
      m_loop.push_back(vertex);
    }
  }

  const Triangulated_surface& m_surface;
  const Vertex_fan_table& m_corners;
  Dijkstra_search m_front;
  std::vector<Index> m_parent;
  std::vector<Index> m_first_hop;
  Epoch_marks m_face_seen;
  std::vector<Index> m_face_number;
  Index m_number_of_faces = 0;
  std::vector<Index> m_ball;
  std::vector<Cotree_edge> m_edges;
  Disjoint_sets m_faces;
  Vertex_loop m_loop;
};

} // namespace CSCD::internal

#endif // CSCD_POINTS_LOCAL_HANDLE_SEARCH_H
