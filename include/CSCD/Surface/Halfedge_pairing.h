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

#include <array>
#include <cstddef>
#include <functional>
#include <tuple>
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
  /// \pre the corners of `faces` are less than `number_of_points`, and each face has three different ones
  Halfedge_pairing(const std::vector<std::array<Index, 3>>& faces, std::size_t number_of_points);

  /// The number of halfedges, three a face.
  Index number_of_halfedges() const { return Index(m_twin.size()); }
  /// The oppositely directed halfedge of the same edge; `no_index` on a border.
  Index twin(Index halfedge) const { return m_twin[halfedge]; }
  /// The twins of all halfedges.
  std::vector<Index> twins() && { return std::move(m_twin); }
  /// A halfedge that has the ends and the direction of another one, or `no_index`: two faces are then oriented
  /// inconsistently, or more than two meet in one edge.
  Index conflict() const { return m_conflict; }
  /// Whether any halfedge has no twin.
  bool has_border() const { return m_has_border; }

private:
  /// An ascending halfedge, from its smaller to its larger end, in the bucket of the smaller one.
  struct Entry
  {
    Index larger_end;
    Index halfedge;

    bool operator<(const Entry& other) const
    {
      return std::tie(larger_end, halfedge) < std::tie(other.larger_end, other.halfedge);
    }
  };

  /// Buckets of more entries than this are sorted, so that vertices of high degree do not cost their degree squared.
  static constexpr Index small_bucket = 16;

  void fill_buckets(const std::vector<std::array<Index, 3>>& faces, std::size_t number_of_points);
  bool is_sorted(Index vertex) const { return m_entries.size(vertex) > small_bucket; }
  /// Seeks two entries for the same edge; sorts the bucket if it is large.
  void check_bucket(Index vertex);
  /// Pairs the halfedge `h` from `larger_end` to `smaller_end` with the ascending one of its edge, if there is one.
  void pair_descending(Index h, Index larger_end, Index smaller_end);

  std::vector<Index> m_twin;
  internal::Compressed_rows<Entry> m_entries; // by bucket, while halfedges are paired
  Index m_conflict = no_index;
  bool m_has_border = false;
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

/// A vertex around which the faces form several fans, or `no_index`; linear.
/// \param pairing of the faces, without conflict
Index find_pinched_vertex(const Indexed_triangles& triangles, const Halfedge_pairing& pairing);

/// Pairs the halfedges of `triangles`, after making sure that every edge has at most two faces, oriented consistently,
/// and that the faces around every vertex form one fan. Linear.
/// \param name gives the number by which a message calls a vertex
/// \throw Input_error naming the first edge or vertex that violates this
Halfedge_pairing check_manifold(const Indexed_triangles& triangles, const std::function<Index(Index)>& name);

/// Gives every fan of faces around a vertex a vertex of its own: the first keeps it, the others get copies, which are
/// appended. The pairing remains valid. Linear. \return for every copy, in order, the vertex of which it is one
/// \pre `pairing`, that of the faces, has no conflict
std::vector<Index> split_pinched_vertices(Indexed_triangles& triangles, const Halfedge_pairing& pairing);

} // namespace CSCD

#ifndef CSCD_COMPILED
#include <CSCD/Surface/Halfedge_pairing_impl.h>
#endif

#endif // CSCD_SURFACE_HALFEDGE_PAIRING_H
