// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles as indices of points: their order, the pairing of their halfedges, and checks of a manifold.

#ifndef CSCD_SURFACE_TRIANGLES_H
#define CSCD_SURFACE_TRIANGLES_H

#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CSCD {

/// Halfedge `h` runs along side `h % 3` of face `h / 3`, counterclockwise: so going around a face needs no memory.
/// Triangulations are derived from this.
struct Triangle_halfedges
{
  /// The halfedge after `halfedge` in its face.
  static Index next(Index halfedge) { return halfedge % 3 == 2 ? halfedge - 2 : halfedge + 1; }
  /// The halfedge before `halfedge` in its face.
  static Index previous(Index halfedge) { return halfedge % 3 == 0 ? halfedge + 2 : halfedge - 1; }
  /// The face of `halfedge`.
  static Index face(Index halfedge) { return halfedge / 3; }
};

/// The genus of a closed surface, all components together: their Euler numbers V - E + F = V - F/2, each 2 - 2 g, add
/// up.
constexpr std::size_t genus_of_closed_surface(std::size_t number_of_components, std::size_t number_of_vertices,
                                              std::size_t number_of_faces)
{
  return (2 * number_of_components + number_of_faces / 2 - number_of_vertices) / 2;
}

/// Points and triangles, counterclockwise seen from outside.
struct Indexed_triangles
{
  /// The positions of the vertices.
  std::vector<Vector3> points;
  /// The vertices of each face, counterclockwise seen from outside.
  std::vector<std::array<Index, 3>> faces;
  /// The faces from this one on only bridge borders: they close the surface but carry no area.
  std::size_t first_hole_filling_face = 0;
};

namespace internal {

/// The sets of vertices that faces join. Near linear.
inline Disjoint_sets sets_of_vertices(const std::vector<std::array<Index, 3>>& faces, std::size_t number_of_vertices)
{
  Disjoint_sets sets(number_of_vertices);
  for (const auto& [a, b, c] : faces) {
    sets.join(a, b);
    sets.join(a, c);
  }
  return sets;
}

/// The areas of the faces.
inline std::vector<double> face_areas(const Indexed_triangles& triangles)
{
  std::vector<double> areas;
  areas.reserve(triangles.faces.size());
  for (const auto& [a, b, c] : triangles.faces) {
    areas.push_back(triangle_area(triangles.points[a], triangles.points[b], triangles.points[c]));
  }
  return areas;
}

} // namespace internal

/// Removes the numbers that no face uses from the numbering, and returns the old numbers of the rest, in order.
inline std::vector<Index> compact_numbers(std::vector<std::array<Index, 3>>& faces, std::size_t number_of_vertices)
{
  std::vector<Index> new_number(number_of_vertices, no_index);
  for (const std::array<Index, 3>& face : faces) {
    for (Index corner : face) {
      new_number[corner] = 0;
    }
  }
  std::vector<Index> old_number;
  old_number.reserve(number_of_vertices);
  for (Index vertex = 0; vertex < number_of_vertices; ++vertex) {
    if (new_number[vertex] != no_index) {
      new_number[vertex] = Index(old_number.size());
      old_number.push_back(vertex);
    }
  }
  if (old_number.size() < number_of_vertices) {
    for (std::array<Index, 3>& face : faces) {
      for (Index& corner : face) {
        corner = new_number[corner];
      }
    }
  }
  return old_number;
}

/// Sorts faces lexicographically, hole-filling faces after all others; linear where degrees are bounded.
/// \pre the smallest corner of every face comes first
inline void sort_faces(Indexed_triangles& triangles)
{
  // One bucket for each smallest corner; the buckets of the hole-filling faces come last.
  const std::size_t n = triangles.points.size();
  const auto bucket = [&triangles, n](std::size_t f) {
    return triangles.faces[f].front() + (f < triangles.first_hole_filling_face ? 0 : n);
  };
  internal::Compressed_rows<std::array<Index, 3>> buckets(2 * n, [&](const auto& add) {
    for (std::size_t f = 0; f < triangles.faces.size(); ++f) {
      add(bucket(f), triangles.faces[f]);
    }
  });
  for (Index b = 0; b < 2 * n; ++b) {
    std::sort(buckets[b].begin(), buckets[b].end());
  }
  triangles.faces = std::move(buckets).values();
}

/// Gives the vertex `order[i]` of `triangles` the number `i`, and sorts the faces accordingly, each from its smallest
/// corner on. Linear where degrees are bounded.
/// \pre `order` is a permutation
inline void renumber(Indexed_triangles& triangles, const std::vector<Index>& order)
{
  std::vector<Index> number(order.size());
  std::vector<Vector3> points(order.size());
  for (Index i = 0; i < order.size(); ++i) {
    number[order[i]] = i;
    points[i] = triangles.points[order[i]];
  }
  triangles.points = std::move(points);
  for (std::array<Index, 3>& face : triangles.faces) {
    for (Index& corner : face) {
      corner = number[corner];
    }
    if (face[1] < face[0] && face[1] < face[2]) {
      face = {face[1], face[2], face[0]};
    } else if (face[2] < face[0]) {
      face = {face[2], face[0], face[1]};
    }
  }
  sort_faces(triangles);
}

/// The sides of a set of triangles as halfedges.
class Halfedge_pairing : public Triangle_halfedges
{
public:
  Halfedge_pairing() = default;

  /// Pairs the halfedges of `faces`, less than 2^29 faces, by the numbers of their ends; near linear for any degrees.
  /// \param number_of_threads 0 for as many as TBB allows; the result is the same for any number
  /// \pre the corners of `faces` are less than `number_of_points`, and each face has three different ones
  Halfedge_pairing(const std::vector<std::array<Index, 3>>& faces, std::size_t number_of_points,
                   unsigned number_of_threads = 1);

  /// The number of halfedges, three a face.
  Index number_of_halfedges() const { return Index(m_twin.size()); }
  /// The oppositely directed halfedge of the same edge; `no_index` on a border.
  Index twin(Index halfedge) const { return m_twin[halfedge]; }
  /// The halfedges that leave each point, counterclockwise: at a border the first one of the fan comes first, elsewhere
  /// the smallest. Without order where there is a conflict or a pinched vertex.
  const internal::Compressed_rows<Index>& outgoing() const { return m_outgoing; }
  /// Hands over the twins of all halfedges and the rows of `outgoing()`.
  void move_to(std::vector<Index>& twins, internal::Compressed_rows<Index>& outgoing_rows) &&
  {
    twins = std::move(m_twin);
    outgoing_rows = std::move(m_outgoing);
  }
  /// A halfedge that has the ends and the direction of another one, or `no_index`: two faces are then oriented
  /// inconsistently, or more than two meet in one edge.
  Index conflict() const { return m_findings.conflict; }
  /// The first vertex whose faces form several fans, or `no_index`. \pre no halfedge is in conflict
  Index pinched_vertex() const { return m_findings.pinched_vertex; }
  /// Whether any halfedge has no twin.
  bool has_border() const { return m_findings.has_border; }

private:
  /// Most degrees are at most this, and nearly all the second one. Fans of more faces are ordered by sorting, so that
  /// they do not cost their degree squared.
  static constexpr std::size_t small_degree = 8;
  static constexpr std::size_t medium_degree = 16;
  /// Prefetch distance, in vertices.
  static constexpr Index prefetch_distance = 8;

  /// Violations of a manifold around some vertices, the first of each kind.
  struct Findings
  {
    Index conflict = no_index;
    Index pinched_vertex = no_index;
    bool has_border = false;
  };

  /// Pairs and orders the halfedges that leave the vertices from `begin` to `end` - 1, and no others.
  Findings pair_range(const std::vector<std::array<Index, 3>>& faces, Index begin, Index end);
  /// Pairs and orders the halfedges that leave `vertex`.
  void pair_around(const std::vector<std::array<Index, 3>>& faces, Index vertex, Findings& findings);
  /// Orders `row` counterclockwise from its first halfedge on, by searching one after the other; false if the faces do
  /// not go once around.
  template <std::size_t max_degree>
  static bool order_by_search(const std::vector<std::array<Index, 3>>& faces, CGAL::Iterator_range<Index*> row);
  /// Pairs and orders by sorting, for faces of any kind; finds borders, conflicts and pinched vertices.
  void order_by_sorting(const std::vector<std::array<Index, 3>>& faces, Index vertex, Findings& findings);

  std::vector<Index> m_twin;
  internal::Compressed_rows<Index> m_outgoing;
  Findings m_findings;
};

/// Calls `use(h)` for each halfedge `h` that leaves the origin of `halfedge` inside the same fan of faces.
template <class Use>
void for_each_in_fan(const Halfedge_pairing& pairing, Index halfedge, const Use& use)
{
  Index at = halfedge;
  do {
    use(at);
    at = pairing.twin(Halfedge_pairing::previous(at));
  } while (at != no_index && at != halfedge);
  if (at == no_index) {
    for (at = pairing.twin(halfedge); at != no_index; at = pairing.twin(at)) {
      at = Halfedge_pairing::next(at);
      use(at);
    }
  }
}

/// Pairs the halfedges of `triangles`, after making sure that every edge has at most two faces, oriented consistently,
/// and that the faces around every vertex form one fan. Linear.
/// \param name returns the number of a vertex in messages
/// \param number_of_threads 0 for as many as TBB allows
/// \throw Input_error naming the first edge or vertex that violates this
Halfedge_pairing check_manifold(const Indexed_triangles& triangles, const std::function<Index(Index)>& name,
                                unsigned number_of_threads = 1);

/// Triangles with paired halfedges, and the vertices of the input that they use.
struct Checked_triangles
{
  Indexed_triangles triangles;                 ///< the triangles of the input, with points that have a face
  Halfedge_pairing pairing;                    ///< of their halfedges
  std::vector<Index> input_number;             ///< for each point, its number in the input
  std::size_t number_of_isolated_vertices = 0; ///< points of the input without a face
};

/// Leaves out the points without a face, and pairs the halfedges of the rest. Linear.
/// \param number_of_threads 0 for as many as TBB allows
/// \pre each face has three different corners, which are less than the number of points
/// \throw Input_error naming the element, by its number in the input, if `faces` is empty, an edge has more than two
///        faces or faces of opposite orientation, a vertex is pinched, or a coordinate is not finite
Checked_triangles check_triangles(std::vector<Vector3>&& points, std::vector<std::array<Index, 3>>&& faces,
                                  unsigned number_of_threads = 1);

/// The same for triangles with paired halfedges.
/// \pre `pairing` is that of the faces, and has no conflict and no pinched vertex
/// \throw Input_error if a coordinate is not finite
Checked_triangles check_triangles(Indexed_triangles&& triangles, Halfedge_pairing&& pairing,
                                  unsigned number_of_threads = 1);

/// Gives every fan of faces around a vertex a vertex of its own: the first keeps it, the others get copies, which are
/// appended. Linear. \return for every copy, in order, its original
/// \pre `pairing`, that of the faces, has no conflict; it is kept so
std::vector<Index> split_pinched_vertices(Indexed_triangles& triangles, Halfedge_pairing& pairing);

} // namespace CSCD

#ifndef CSCD_COMPILED
#include <CSCD/Surface/Triangles_impl.h>
#endif

#endif // CSCD_SURFACE_TRIANGLES_H
