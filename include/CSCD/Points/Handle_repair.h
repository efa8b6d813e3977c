// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Removes handles that are too small for the spacing of the points to prove them.

#ifndef CSCD_POINTS_HANDLE_REPAIR_H
#define CSCD_POINTS_HANDLE_REPAIR_H

#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Dijkstra_search.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
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

/// Cuts `triangles` open along `loops`: the faces to the right of a loop get copies of its vertices, which are
/// appended. Linear in the degrees of the vertices. \return for every copy, in order, the vertex that it copies
/// \pre `surface` is made of `triangles`, with the same numbers; the loops have no vertex in common, and consecutive
///      vertices are neighbors
inline std::vector<Index> cut_along_loops(Indexed_triangles& triangles, const Triangulated_surface& surface,
                                          const std::vector<Vertex_loop>& loops)
{
  std::vector<Index> originals;
  for (const Vertex_loop& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index copy = Index(triangles.points.size());
      triangles.points.push_back(Vector_3(triangles.points[loop[i]]));
      originals.push_back(loop[i]);
      const Index forward = surface.find_halfedge(loop[i], loop[(i + 1) % loop.size()]);
      const Index before = loop[(i + loop.size() - 1) % loop.size()];
      // Clockwise from the outgoing to the incoming edge lie the faces to the right.
      Index h = forward;
      do {
        h = surface.previous_around_origin(h);
        triangles.faces[h / 3][h % 3] = copy;
      } while (surface.target(h) != before);
    }
  }
  return originals;
}

/// Finds disjoint loops that are a few edges long, or somewhat longer and along a fold of the surface, and that, taken
/// together, do not separate it: to cut along one and to close both sides removes a bridge between two sheets or where
/// two limbs touch, or closes a hole through a thin limb.
class Handle_repair
{
public:
  explicit Handle_repair(const Triangulated_surface& surface)
      : m_surface(surface), m_corners(surface), m_search(surface, m_corners), m_flood(surface)
  {
  }

  /// The loops, the shortest first.
  std::vector<Vertex_loop> operator()()
  {
    collect_candidates();
    std::sort(m_candidates.begin(), m_candidates.end(), [](const Candidate& a, const Candidate& b) {
      return std::tie(a.length, a.loop) < std::tie(b.length, b.loop);
    });
    std::vector<Vertex_loop> cuts;
    std::vector<std::uint8_t> is_cut(m_surface.number_of_vertices(), 0);
    std::vector<std::uint8_t> is_tested(m_surface.number_of_vertices(), 0);
    for (const Candidate& candidate : m_candidates) {
      const Vertex_loop& loop = candidate.loop;
      const auto is_marked = [](const std::vector<std::uint8_t>& marks) {
        return [&marks](Index vertex) { return marks[vertex] != 0; };
      };
      if (std::any_of(loop.begin(), loop.end(), is_marked(is_cut)) ||
          std::all_of(loop.begin(), loop.end(), is_marked(is_tested))) {
        continue;
      }
      const bool is_handle = !m_flood.separates(loop);
      if (is_handle) {
        m_flood.add_barrier(loop);
        cuts.push_back(loop);
      }
      for (Index vertex : loop) {
        (is_handle ? is_cut : is_tested)[vertex] = 1;
      }
    }
    return cuts;
  }

private:
  /// The longest loop that is cut, in mean lengths of the edges at its vertex. With 5, true handles are lost; with 3,
  /// false ones remain.
  static constexpr double longest_loop = 4.0;
  /// The longest loop along a fold that is cut, likewise: bodies that touch each other, as knees do, are one there.
  static constexpr double longest_loop_in_fold = 16.0;
  /// A loop is along a fold if the surface faces itself at this part of its vertices ...
  static constexpr double min_part_in_fold = 0.8;
  /// ... by two faces whose normals have at most this cosine.
  static constexpr double max_cosine_in_fold = -0.5;
  /// Lengths below this part of the mean length of all edges count as this.
  static constexpr double min_edge_part = 0.5;

  struct Candidate
  {
    float length;
    Vertex_loop loop;
  };

  struct Oriented_face
  {
    Vector_3 center, normal;
  };

  void collect_candidates()
  {
    find_folds();
    for (Index vertex = 0; vertex < m_surface.number_of_vertices(); ++vertex) {
      search_around(vertex);
    }
  }

  double edge_length_at(Index vertex) const
  {
    double sum = 0;
    for (const Corner& corner : m_corners.neighbors(vertex)) {
      sum += double(corner.length);
    }
    return std::max(sum / m_surface.degree(vertex), min_edge_part * m_corners.mean_length());
  }

  void search_around(Index vertex)
  {
    const double edge_length = edge_length_at(vertex);
    const auto max_length = float(longest_loop * edge_length);
    const auto longest = float((m_is_in_fold[vertex] != 0 ? longest_loop_in_fold : longest_loop) * edge_length);
    // The loops through a vertex reach half their length from it, and an edge may be as long as its loop allows.
    if (m_search.grow(vertex, longest / 2)) {
      return;
    }
    m_search.for_each_loop(longest, [&](const Vertex_loop& loop, float length) {
      if (length <= max_length || is_in_fold(loop)) {
        m_candidates.push_back({length, loop});
      }
    });
  }

  bool is_in_fold(const Vertex_loop& loop) const
  {
    const auto number =
        std::count_if(loop.begin(), loop.end(), [this](Index vertex) { return m_is_in_fold[vertex] != 0; });
    return double(number) >= min_part_in_fold * double(loop.size());
  }

  /// Marks the vertices at which the surface faces itself: around which two faces look at each other.
  void find_folds()
  {
    m_is_in_fold.resize(m_surface.number_of_vertices());
    for (Index vertex = 0; vertex < m_surface.number_of_vertices(); ++vertex) {
      m_is_in_fold[vertex] = faces_itself(vertex) ? 1 : 0;
    }
  }

  bool faces_itself(Index vertex)
  {
    m_faces.clear();
    for (const Corner& corner : m_corners.neighbors(vertex)) {
      for (const Index h : m_surface.outgoing(corner.neighbor)) {
        const Index face = Triangulated_surface::face(h);
        const Vector_3 center = (m_surface.point(m_surface.origin(h)) + m_surface.point(m_surface.target(h)) +
                                 m_surface.point(m_surface.opposite_vertex(h))) /
                                3;
        m_faces.push_back({center, m_surface.face_vector(face).normalized()});
      }
    }
    for (std::size_t i = 0; i < m_faces.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const Vector_3 way = m_faces[k].center - m_faces[i].center;
        if (m_faces[i].normal.dot(m_faces[k].normal) < max_cosine_in_fold && way.dot(m_faces[i].normal) > 0 &&
            way.dot(m_faces[k].normal) < 0) {
          return true;
        }
      }
    }
    return false;
  }

  const Triangulated_surface& m_surface;
  Vertex_fan_table m_corners;
  Local_handle_search m_search;
  Loop_flood m_flood;
  std::vector<std::uint8_t> m_is_in_fold; ///< for every vertex
  std::vector<Oriented_face> m_faces;     ///< working memory
  std::vector<Candidate> m_candidates;
};

} // namespace CSCD::internal

#endif // CSCD_POINTS_HANDLE_REPAIR_H
