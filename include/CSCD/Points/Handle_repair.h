// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Removes handles that are too small for the spacing of the points to prove them.

#ifndef CSCD_POINTS_HANDLE_REPAIR_H
#define CSCD_POINTS_HANDLE_REPAIR_H

#include <CSCD/Points/Local_handle_search.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Epoch_marks.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace CSCD::internal {

/// Cuts `triangles` open along `loops`: the faces to the right of a loop get copies of its vertices, which are
/// appended. Linear in the degrees of the vertices. \return for every copy, in order, the vertex of which it is one
/// \pre `surface` is that of `triangles`, with the same numbers; the loops have no vertex in common, and consecutive
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
  /// ... by two faces of which the normals have at most this cosine.
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
