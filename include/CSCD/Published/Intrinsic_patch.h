// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of a surface around a curve, copied face by face when it is first touched, in order to flip its edges.

#ifndef CSCD_PUBLISHED_INTRINSIC_PATCH_H
#define CSCD_PUBLISHED_INTRINSIC_PATCH_H

#include <CSCD/Published/Edge_trace.h>
#include <CSCD/Published/Intrinsic_halfedges.h>
#include <CSCD/Published/Intrinsic_triangulation.h>
#include <CSCD/Vector_3.h>

#include <CGAL/assertions.h>

#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The surface over which the edges of `triangulation` run: itself, if it is not intrinsic.
template <class Triangulation>
const Triangulation& input_of(const Triangulation& triangulation)
{
  return triangulation;
}

template <class Triangulation>
const Triangulation& input_of(const Intrinsic_triangulation<Triangulation>& triangulation)
{
  return triangulation.input();
}

template <class Triangulation>
using Input_of = std::decay_t<decltype(input_of(std::declval<const Triangulation&>()))>;

/// A triangulation of which only those faces are held that were requested, in this order, so that
/// edges can be flipped without touching it. It is emptied in constant time: what is done here costs nothing of the
/// size of the surface. The source is only read, so that any number of patches, of several threads, may share one; each
/// keeps one index for every halfedge of it. Halfedges have numbers of their own, vertices keep theirs.
/// \tparam Source a triangulation without borders: a surface, or an `Intrinsic_triangulation`, whose edges are known to
///         be lines over its input
template <class Source>
class Intrinsic_patch : public Intrinsic_halfedges<Input_of<Source>>
{
  using Base = Intrinsic_halfedges<Input_of<Source>>;

public:
  using Base::next;
  using Base::previous;

  /// \param added_length what is added to the lengths of the input, see `mollifying_length()`; an intrinsic
  ///        triangulation has added it already
  Intrinsic_patch(const Source& source, double added_length)
      : Base(input_of(source), added_length), m_source(&source), m_halfedge_along(source.number_of_halfedges(), 0)
  {
  }

  /// Removes all faces.
  void clear()
  {
    this->m_halfedges.clear();
    m_source_halfedge.clear();
    m_angle.clear();
  }

  /// The halfedge that runs along `source_halfedge`, the face of which is added if it is new.
  /// \pre the edge has not been flipped
  Index halfedge_along(Index source_halfedge)
  {
    if (!has_along(source_halfedge)) {
      add_face(Source::face(source_halfedge));
    }
    CGAL_postcondition(has_along(source_halfedge));
    return m_halfedge_along[source_halfedge];
  }

  /// The twin of `halfedge`, the face of which is added if it is new.
  Index twin(Index halfedge)
  {
    if (this->m_halfedges[halfedge].twin == no_index) {
      add_face(Source::face(m_source->twin(m_source_halfedge[halfedge])));
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
    if (!diamond.is_convex(min_part)) {
      return false;
    }
    this->replace_diagonal(halfedge, diamond.other_diagonal());
    move_source(previous(halfedge), t);
    move_source(previous(t), halfedge);
    for (const Index h : {halfedge, t}) {
      m_angle[h] = m_angle[next(h)] = m_angle[previous(h)] = unknown_angle;
    }
    return true;
  }

  /// Writes to `trace` the edges of the input that `halfedge` crosses, see `Intrinsic_triangulation::trace()`.
  void trace(Index halfedge, Edge_trace& trace)
  {
    this->trace_over_input(halfedge, trace, [this](Index h) { return twin(h); });
  }

private:
  /// The least part of the area of a quadrilateral that a diagonal has to leave on either side.
  static constexpr double min_part = 1e-9;
  static constexpr double unknown_angle = -1;

  /// Whether there is a halfedge that runs along `source_halfedge`. Numbers that are left over from a patch before, or
  /// from before a flip, are recognized, so that they need not be cleared.
  bool has_along(Index source_halfedge) const
  {
    const Index h = m_halfedge_along[source_halfedge];
    return h < this->number_of_halfedges() && m_source_halfedge[h] == source_halfedge;
  }

  /// Records that a halfedge has moved and that a new one has taken its place.
  void move_source(Index from, Index to)
  {
    const Index source_halfedge = std::exchange(m_source_halfedge[from], no_index);
    m_source_halfedge[to] = source_halfedge;
    if (source_halfedge != no_index) {
      m_halfedge_along[source_halfedge] = to;
    }
  }

  /// Adds a face and links it to its neighbors. Between an old face and a new one nothing was ever flipped.
  void add_face(Index source_face)
  {
    const Index first = this->number_of_halfedges();
    append(*m_source, source_face);
    m_angle.insert(m_angle.end(), 3, unknown_angle);
    for (Index k = 0; k < 3; ++k) {
      m_source_halfedge.push_back(3 * source_face + k);
      m_halfedge_along[3 * source_face + k] = first + k;
    }
    for (Index k = 0; k < 3; ++k) {
      const Index source_twin = m_source->twin(3 * source_face + k);
      if (has_along(source_twin)) {
        this->link(first + k, m_halfedge_along[source_twin]);
      }
    }
  }

  void append(const Input_of<Source>&, Index input_face) { this->append_face(input_face); }

  void append(const Intrinsic_triangulation<Input_of<Source>>& source, Index source_face)
  {
    for (Index h = 3 * source_face; h < 3 * source_face + 3; ++h) {
      this->m_halfedges.push_back(
          {source.origin(h), no_index, source.input_halfedge(h), source.normal_coordinate(h), source.length(h)});
    }
  }

  const Source* m_source;
  std::vector<Index> m_halfedge_along;  // of each halfedge of the source
  std::vector<Index> m_source_halfedge; // that a halfedge runs along, if any
  std::vector<double> m_angle;
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_INTRINSIC_PATCH_H
