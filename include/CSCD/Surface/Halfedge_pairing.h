// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which halfedges of a list of triangles are twins, and where the triangles are no manifold.

#ifndef CSCD_SURFACE_HALFEDGE_PAIRING_H
#define CSCD_SURFACE_HALFEDGE_PAIRING_H

#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Compressed_rows.h>
#include <CSCD/internal/config.h>

#include <CGAL/Iterator_range.h>

#include <array>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CSCD {

/// The sides of a set of triangles as halfedges.
class Halfedge_pairing : public Triangle_halfedges
{
public:
  Halfedge_pairing() = default;

  /// Pairs the halfedges of `faces`, of which there are less than 2^29, by the numbers of their ends; near linear,
  /// whatever the degrees.
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
  /// The first vertex around which the faces form several fans, or `no_index`. \pre there is no conflict
  Index pinched_vertex() const { return m_findings.pinched_vertex; }
  /// Whether any halfedge has no twin.
  bool has_border() const { return m_findings.has_border; }

private:
  /// Most degrees are at most this, and nearly all the second one. Fans of more faces are ordered by sorting, so that
  /// they do not cost their degree squared.
  static constexpr std::size_t small_degree = 8;
  static constexpr std::size_t medium_degree = 16;
  /// Vertices ahead for which memory is asked for.
  static constexpr Index prefetch_distance = 8;

  /// What is no manifold around some vertices, the first of each kind.
  struct Findings
  {
    Index conflict = no_index;
    Index pinched_vertex = no_index;
    bool has_border = false;
  };

  /// Pairs and orders the halfedges that leave the vertices from `begin` to `end` - 1, and no others.
  Findings pair_range(const std::vector<std::array<Index, 3>>& faces, Index begin, Index end);
  /// Pairs and orders those that leave `vertex`.
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
/// \param name gives the number by which a message calls a vertex
/// \param number_of_threads 0 for as many as TBB allows
/// \throw Input_error naming the first edge or vertex that violates this
Halfedge_pairing check_manifold(const Indexed_triangles& triangles, const std::function<Index(Index)>& name,
                                unsigned number_of_threads = 1);

/// Triangles of which the halfedges are paired, and the vertices of the input that they use.
struct Checked_triangles
{
  Indexed_triangles triangles;
  Halfedge_pairing pairing;
  std::vector<Index> input_number; ///< for each point, its number in the input
  std::size_t number_of_isolated_vertices = 0;
};

/// Leaves out the points without a face, and pairs the halfedges of the rest. Linear.
/// \param number_of_threads 0 for as many as TBB allows
/// \pre each face has three different corners, which are less than the number of points
/// \throw Input_error naming the element, by its number in the input, if there are no faces, or an edge has more than two
///        faces or faces of opposite orientation, a vertex is pinched, or a coordinate is not finite
Checked_triangles check_triangles(std::vector<Vector_3>&& points, std::vector<std::array<Index, 3>>&& faces,
                                  unsigned number_of_threads = 1);

/// The same for triangles of which the halfedges are paired already.
/// \pre `pairing` is that of the faces, and has no conflict and no pinched vertex
/// \throw Input_error if a coordinate is not finite
Checked_triangles check_triangles(Indexed_triangles&& triangles, Halfedge_pairing&& pairing,
                                  unsigned number_of_threads = 1);

/// Gives every fan of faces around a vertex a vertex of its own: the first keeps it, the others get copies, which are
/// appended. Linear. \return for every copy, in order, the vertex of which it is one
/// \pre `pairing`, that of the faces, has no conflict; it is kept so
std::vector<Index> split_pinched_vertices(Indexed_triangles& triangles, Halfedge_pairing& pairing);

} // namespace CSCD

#ifndef CSCD_COMPILED
#include <CSCD/Surface/Halfedge_pairing_impl.h>
#endif

#endif // CSCD_SURFACE_HALFEDGE_PAIRING_H
