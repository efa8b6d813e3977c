// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of a surface around a curve, copied face by face when it is first touched, in order to flip its edges.

#ifndef CSCD_INTRINSIC_INTRINSIC_PATCH_H
#define CSCD_INTRINSIC_INTRINSIC_PATCH_H

#include <CSCD/Intrinsic/Flat_diamond.h>
#include <CSCD/Intrinsic/Intrinsic_halfedges.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// An intrinsic triangulation that holds only the faces that were asked for, in the order in which they were, and is
/// emptied in constant time: what is done in it costs nothing of the size of the surface. The input is only read, so
/// that any number of patches, of several threads, may share one; each keeps one index for every halfedge of it.
/// Halfedges have numbers of their own. Vertices keep those of the input.
/// \tparam Triangulation see `Intrinsic_halfedges`; without borders
template <class Triangulation>
class Intrinsic_patch : public Intrinsic_halfedges<Triangulation>
{
  using Base = Intrinsic_halfedges<Triangulation>;

public:
  using Base::next;
  using Base::previous;

  /// \param added_length is added to the lengths of all edges, see `mollifying_length()`
  explicit Intrinsic_patch(const Triangulation& input, double added_length)
      : Base(input, added_length), m_halfedge_along(input.number_of_halfedges(), 0)
  {
  }

  /// Forgets all faces and flips.
  void clear()
  {
    this->m_halfedges.clear();
    m_angle.clear();
  }

  /// The halfedge that runs along `input_halfedge`, the face of which is added if it is new.
  /// \pre the edge has not been flipped
  Index halfedge_along(Index input_halfedge)
  {
    if (!has_along(input_halfedge)) {
      add_face(Triangulation::face(input_halfedge));
    }
    CGAL_postcondition(has_along(input_halfedge));
    return m_halfedge_along[input_halfedge];
  }

  /// The twin of `halfedge`, the face of which is added if it is new.
  Index twin(Index halfedge)
  {
    if (this->m_halfedges[halfedge].twin == no_index) {
      add_face(Triangulation::face(this->input().twin(this->input_halfedge(halfedge))));
    }
    return this->m_halfedges[halfedge].twin;
  }

  /// Whether both halfedges are those of one edge.
  bool are_twins(Index a, Index b) const { return this->m_halfedges[a].twin == b; }

  /// The next halfedge of the same origin, counterclockwise.
  Index next_around_origin(Index halfedge) { return twin(previous(halfedge)); }

  /// The angle of the face of `halfedge` at its origin, which is computed once.
  double angle(Index halfedge)
  {
    double& angle = m_angle[halfedge];
    if (angle == unknown_angle) {
      angle = corner_angle(*this, halfedge);
    }
    return angle;
  }

  /// Flips the edge if its two faces form a strictly convex quadrilateral, as `Intrinsic_triangulation::flip()` does.
  /// \return whether it did
  bool flip_if_convex(Index halfedge)
  {
    const Index t = twin(halfedge);
    if (this->face(t) == this->face(halfedge)) {
      return false;
    }
    const Flat_diamond diamond(flat_triangle(*this, halfedge), flat_triangle(*this, t));
    if (!diamond.is_convex(least_part)) {
      return false;
    }
    this->replace_diagonal(halfedge, diamond.other_diagonal());
    for (const Index moved : {halfedge, t}) {
      if (this->is_input_edge(moved)) {
        m_halfedge_along[this->input_halfedge(moved)] = moved;
      }
    }
    for (const Index h : {halfedge, t}) {
      m_angle[h] = m_angle[next(h)] = m_angle[previous(h)] = unknown_angle;
    }
    return true;
  }

private:
  /// The least part of the area of a quadrilateral that a diagonal has to leave on either side.
  static constexpr double least_part = 1e-9;
  static constexpr double unknown_angle = -1;

  /// Whether there is a halfedge that runs along `input_halfedge`. Numbers that are left over from a patch before, or
  /// from before a flip, tell on themselves, so that they need not be cleared.
  bool has_along(Index input_halfedge) const
  {
    const Index h = m_halfedge_along[input_halfedge];
    return h < this->number_of_halfedges() && this->is_input_edge(h) && this->input_halfedge(h) == input_halfedge;
  }

  /// Adds a face and links it to its neighbors. Between an old face and a new one nothing was ever flipped.
  void add_face(Index input_face)
  {
    const Index first = this->number_of_halfedges();
    this->append_face(input_face);
    m_angle.insert(m_angle.end(), 3, unknown_angle);
    for (Index k = 0; k < 3; ++k) {
      m_halfedge_along[3 * input_face + k] = first + k;
    }
    for (Index k = 0; k < 3; ++k) {
      const Index input_twin = this->input().twin(3 * input_face + k);
      if (has_along(input_twin)) {
        this->link(first + k, m_halfedge_along[input_twin]);
      }
    }
  }

  std::vector<Index> m_halfedge_along;
  std::vector<double> m_angle;
};

} // namespace CSCD::internal

#endif // CSCD_INTRINSIC_INTRINSIC_PATCH_H
