// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangulations of a surface by intrinsic edges, the intrinsic Delaunay triangulation among them.

#ifndef CSCD_PUBLISHED_INTRINSIC_TRIANGULATION_H
#define CSCD_PUBLISHED_INTRINSIC_TRIANGULATION_H

#include <CSCD/Published/Edge_trace.h>
#include <CSCD/Published/Flat_triangle.h>
#include <CSCD/Published/Intrinsic_halfedges.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <CGAL/assertions.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// An intrinsic triangulation of a whole surface: it has the vertices and the faces of the input, to begin with, and
/// the edges of which can be flipped. It is a model of the same interface as `Triangulated_surface`, but for `twin()`
/// being `no_index` on borders, and for edges that have equal ends or both ends in common: go by halfedges, never by
/// pairs of vertices. Only lengths count; there are no points.
///
/// Degenerate faces are mollified: a constant is added to the lengths of all edges, see `mollifying_length()`.
/// The input is referred to and must outlive the object.
/// \tparam Triangulation see `Intrinsic_halfedges`
template <class Triangulation>
class Intrinsic_triangulation : public Intrinsic_halfedges<Triangulation>
{
  using Base = Intrinsic_halfedges<Triangulation>;

public:
  using Base::face;
  using Base::length;
  using Base::next;
  using Base::previous;

  /// Takes over all faces of `input`. Linear.
  explicit Intrinsic_triangulation(const Triangulation& input) : Intrinsic_triangulation(input, input.number_of_faces())
  {
  }

  /// Takes over the first `number_of_faces` faces of `input`; what is next to others becomes border. So the faces that
  /// bridge borders can be left out, from `first_hole_filling_face()` on; they are otherwise faces like all. Linear.
  Intrinsic_triangulation(const Triangulation& input, Index number_of_faces)
      : Base(input, mollifying_length(input, number_of_faces))
  {
    this->m_halfedges.reserve(3 * std::size_t(number_of_faces));
    for (Index f = 0; f < number_of_faces; ++f) {
      this->append_face(f);
    }
    for (Index h = 0; h < this->number_of_halfedges(); ++h) {
      const Index twin = input.twin(h);
      this->m_halfedges[h].twin = twin < this->number_of_halfedges() ? twin : no_index;
    }
  }

  /// \name Combinatorics
  /// @{
  Index number_of_vertices() const { return this->input().number_of_vertices(); }
  /// `no_index` on a border.
  Index twin(Index halfedge) const { return this->m_halfedges[halfedge].twin; }
  bool is_border(Index halfedge) const { return twin(halfedge) == no_index; }
  /// The halfedge that stands for the edge: the smaller one of the two.
  Index edge(Index halfedge) const { return std::min(halfedge, twin(halfedge)); }
  /// @}

  /// \name Geometry
  /// @{
  double mean_edge_length() const
  {
    double sum = 0;
    std::size_t number = 0;
    for (Index h = 0; h < this->number_of_halfedges(); ++h) {
      if (edge(h) == h) {
        sum += length(h);
        ++number;
      }
    }
    return number == 0 ? 0. : sum / double(number);
  }
  /// @}

  /// \name Flips
  /// @{
  /// Whether the edge has two faces that form a strictly convex quadrilateral.
  bool is_flippable(Index halfedge) const
  {
    return !is_border(halfedge) && face(halfedge) != face(twin(halfedge)) &&
           flat_diamond(*this, halfedge).is_convex(min_part);
  }

  /// Replaces the edge by the other diagonal of its two faces, in constant time plus that of walking over the input
  /// edges in two corners.
  /// The new edge is that of `previous(halfedge)`, which leads from the apex of the face of `halfedge` to the other
  /// one. What has been `previous(halfedge)` is now `twin(halfedge)`, and what has been `previous(twin(halfedge))` is
  /// now `halfedge`, both of which by the twin of before; all other halfedges stay. \pre `is_flippable(halfedge)`
  void flip(Index halfedge)
  {
    CGAL_precondition(is_flippable(halfedge));
    this->replace_diagonal(halfedge, flat_diamond(*this, halfedge).other_diagonal());
  }

  /// Whether the angles opposite the edge sum up to at most pi, plus `delaunay_tolerance`.
  bool is_delaunay(Index halfedge) const
  {
    return is_border(halfedge) || opposite_angles(halfedge) <= pi + delaunay_tolerance;
  }

  /// Flips edges until all are Delaunay; the faces of edges that cannot be flipped have angles of pi but for rounding.
  /// Near linear in practice. \return the number of flips
  std::size_t make_delaunay()
  {
    std::vector<Index> queue;
    std::vector<char> is_queued(this->number_of_halfedges(), 0);
    const auto push = [&](Index h) {
      if (!is_queued[h]) {
        is_queued[h] = 1;
        queue.push_back(h);
      }
    };
    for (Index h = 0; h < this->number_of_halfedges(); ++h) {
      if (!is_border(h) && edge(h) == h) {
        push(h);
      }
    }
    std::size_t number_of_flips = 0;
    while (!queue.empty()) {
      const Index h = queue.back();
      queue.pop_back();
      is_queued[h] = 0;
      if (is_delaunay(h) || !flip_if_better(h)) {
        continue;
      }
      ++number_of_flips;
      const Index t = next(twin(previous(h)));
      for (const Index side : {h, next(h), t, next(t)}) {
        push(side);
      }
    }
    return number_of_flips;
  }
  /// @}

  /// \name Traces
  /// @{
  /// Writes to `trace` the edges of the input that `halfedge` crosses, in order from its origin. Which ones is exact;
  /// where, is exact up to rounding. O(k) for an edge that crosses k input edges which cross few edges themselves.
  void trace(Index halfedge, Edge_trace& trace) const
  {
    this->trace_over_input(halfedge, trace, [this](Index h) { return twin(h); });
  }
  /// @}

  /// What the angles opposite an edge may exceed pi by, in radians: far more than rounding makes of cocircular
  /// vertices, far less than would be felt in cotangents.
  static constexpr double delaunay_tolerance = 1e-9;

private:
  static constexpr double pi = boost::math::constants::pi<double>();
  /// The least part of the area of a quadrilateral that a diagonal has to leave on either side.
  static constexpr double min_part = 1e-9;

  double opposite_angles(Index halfedge) const
  {
    return this->angle(previous(halfedge)) + this->angle(previous(twin(halfedge)));
  }

  /// Flips a non-Delaunay edge, unless rounding lets the other diagonal look no better. \return whether it did
  bool flip_if_better(Index halfedge)
  {
    if (!is_flippable(halfedge)) {
      return false;
    }
    const Index t = twin(halfedge);
    const double diagonal = flat_diamond(*this, halfedge).other_diagonal();
    const Flat_triangle at_target{length(next(halfedge)), diagonal, length(previous(t))};
    const Flat_triangle at_origin{length(next(t)), diagonal, length(previous(halfedge))};
    if (at_target.angle() + at_origin.angle() >= pi) {
      return false;
    }
    this->replace_diagonal(halfedge, diagonal);
    return true;
  }
};

/// Makes the intrinsic Delaunay triangulation of the first `number_of_faces` faces of `surface`, which is referred to.
template <class Triangulation>
Intrinsic_triangulation<Triangulation> make_intrinsic_delaunay(const Triangulation& surface, Index number_of_faces)
{
  Intrinsic_triangulation<Triangulation> result(surface, number_of_faces);
  result.make_delaunay();
  return result;
}

/// The same of the faces that are part of the surface: those that fill holes, which are the last ones, are left out.
template <class Triangulation>
Intrinsic_triangulation<Triangulation> make_intrinsic_delaunay(const Triangulation& surface)
{
  Index number_of_faces = surface.number_of_faces();
  while (number_of_faces > 0 && is_hole_filling_face(surface, number_of_faces - 1)) {
    --number_of_faces;
  }
  return make_intrinsic_delaunay(surface, number_of_faces);
}

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_INTRINSIC_TRIANGULATION_H
