// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Halfedges of a triangulation whose edges can be flipped, with their lengths and normal coordinates.

#ifndef CSCD_PUBLISHED_INTRINSIC_HALFEDGES_H
#define CSCD_PUBLISHED_INTRINSIC_HALFEDGES_H

#include <CSCD/Published/Edge_trace.h>
#include <CSCD/Published/Flat_triangle.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace CSCD::internal {

/// The normal coordinate of an edge: the number of input edges that cross it, or `along_input_edge`.
using Normal_coordinate = std::int32_t;

/// The normal coordinate of an edge that runs along an edge of the input.
inline constexpr Normal_coordinate along_input_edge = -1;

/// The number of curves that cross an edge.
inline Normal_coordinate crossings_of(Normal_coordinate coordinate)
{
  return std::max(coordinate, Normal_coordinate(0));
}

/// The curves that pass through a triangle, by the corner that they belong to; the corners are the origins of the
/// first, second and third side. Curves are disjoint but for their ends and never cross a side twice in turn, hence
/// those in a triangle either go round a corner, from one of its sides to the other, or emanate from one
/// (Gillespie, Sharp, Crane: Integer coordinates for intrinsic geometry processing, 2021, section 3).
struct Triangle_curves
{
  Normal_coordinate around[3];
  Normal_coordinate from[3];

  /// Sorts the curves that cross the sides of a triangle, whose normal coordinates are given counterclockwise.
  Triangle_curves(Normal_coordinate first, Normal_coordinate second, Normal_coordinate third)
  {
    const Normal_coordinate side[] = {crossings_of(first), crossings_of(second), crossings_of(third)};
    for (int k = 0; k < 3; ++k) {
      from[k] = emanating(side[k], side[(k + 1) % 3], side[(k + 2) % 3]);
    }
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3;
      const int m = (k + 2) % 3;
      around[k] = (side[k] + side[m] - side[l] + from[k] - from[l] - from[m]) / 2;
    }
  }

  /// The number of curves that emanate from the corner between the sides `before` and `after`.
  static Normal_coordinate emanating(Normal_coordinate before, Normal_coordinate opposite, Normal_coordinate after)
  {
    return crossings_of(crossings_of(opposite) - crossings_of(before) - crossings_of(after));
  }
};

/// The normal coordinate of the other diagonal kl of the quadrilateral of the triangles ijk and jil, from those of its
/// sides and of its diagonal ij.
inline Normal_coordinate flipped_coordinate(Normal_coordinate ij, Normal_coordinate jk, Normal_coordinate ki,
                                            Normal_coordinate il, Normal_coordinate lj)
{
  const Triangle_curves left(ij, jk, ki);  // corners i, j, k
  const Triangle_curves right(ij, il, lj); // corners j, i, l
  // Along ij come, from i on and on either side: curves around i, curves that end at the apex, curves around j.
  const Normal_coordinate left_end = left.around[0] + left.from[2];
  const Normal_coordinate right_end = right.around[1] + right.from[2];
  if (std::max(left.around[0], right.around[1]) < std::min(left_end, right_end)) {
    return along_input_edge; // one curve goes from apex to apex
  }
  // Curves from ki across ij to lj, and from il across ij to jk.
  const Normal_coordinate across = crossings_of(left.around[0] - right_end) + crossings_of(right.around[1] - left_end);
  const Normal_coordinate at_ends = left.from[0] + left.from[1] + right.from[0] + right.from[1];
  const Normal_coordinate diagonal = ij == along_input_edge ? 1 : 0;
  return left.around[2] + right.around[2] + across + at_ends + diagonal;
}

/// Two triangles on both sides of a common base.
class Flat_diamond
{
public:
  /// Unfolds `left`, and `right`, whose base is that of `left` in the other direction.
  Flat_diamond(const Flat_triangle& left, const Flat_triangle& right)
      : m_base(left.base), m_left_foot(left.foot()), m_left_height(left.height()),
        m_right_foot(left.base - right.foot()), m_right_height(right.height())
  {
  }

  /// Whether the other diagonal runs strictly inside, leaving on either side at least the part `margin` of the area.
  bool is_convex(double margin) const
  {
    const double height = m_left_height + m_right_height;
    if (!(height > 0)) {
      return false;
    }
    const double crossing = (m_left_foot * m_right_height + m_right_foot * m_left_height) / height;
    return crossing > margin * m_base && crossing < (1 - margin) * m_base;
  }

  /// The length of the other diagonal, if the diamond is convex.
  double other_diagonal() const
  {
    const double along = m_left_foot - m_right_foot;
    const double across = m_left_height + m_right_height;
    return std::sqrt(along * along + across * across);
  }

private:
  double m_base;
  double m_left_foot;
  double m_left_height;
  double m_right_foot;
  double m_right_height;
};

/// The two faces of the edge of `halfedge`, which must have two.
template <class Triangulation>
Flat_diamond flat_diamond(const Triangulation& triangulation, Index halfedge)
{
  return {flat_triangle(triangulation, halfedge), flat_triangle(triangulation, triangulation.twin(halfedge))};
}

/// Faces, in the layout of `Triangulated_surface`, whose edges are straight lines over an input triangulation with the
/// same vertices. What is stored determines exactly, whatever rounding does to lengths, which input edges each edge
/// crosses: its normal coordinate, and the input corner into which each of its halfedges leaves its origin (Gillespie,
/// Sharp, Crane: Integer coordinates for intrinsic geometry processing, 2021; their roundabouts, counted from the input
/// halfedge before instead of after).
/// Edges may have equal ends, and several may have the same two.
/// What owns the faces is derived from this: a whole triangulation, or the part of it that was touched.
/// \tparam Triangulation the input: halfedges in the layout of `Triangulated_surface`, with `origin()`, `twin()`
///         (`no_index` on a border) and `length()`
template <class Triangulation>
class Intrinsic_halfedges : public Triangle_halfedges
{
public:
  /// \name Combinatorics
  /// @{
  Index number_of_halfedges() const { return Index(m_halfedges.size()); }
  Index number_of_faces() const { return Index(m_halfedges.size() / 3); }

  Index origin(Index halfedge) const { return m_halfedges[halfedge].origin; }
  Index target(Index halfedge) const { return m_halfedges[next(halfedge)].origin; }
  Index opposite_vertex(Index halfedge) const { return m_halfedges[previous(halfedge)].origin; }
  /// @}

  /// \name Geometry
  /// @{
  double length(Index halfedge) const { return m_halfedges[halfedge].length; }
  /// The angle of the face of `halfedge` at its origin.
  double angle(Index halfedge) const { return corner_angle(*this, halfedge); }
  /// @}

  /// \name Relation to the input
  /// @{
  const Triangulation& input() const { return *m_input; }
  /// What was added to the length of every input edge.
  double added_length() const { return m_added_length; }
  /// Whether the edge runs along an edge of the input.
  bool is_input_edge(Index halfedge) const { return m_halfedges[halfedge].coordinate == along_input_edge; }
  /// See `Normal_coordinate`.
  Normal_coordinate normal_coordinate(Index halfedge) const { return m_halfedges[halfedge].coordinate; }
  /// The number of input edges that the edge crosses.
  Index number_of_crossings(Index halfedge) const { return Index(crossings_of(m_halfedges[halfedge].coordinate)); }
  /// The input halfedge from the same origin that `halfedge` runs along, or into whose face it starts.
  Index input_halfedge(Index halfedge) const { return m_halfedges[halfedge].input_halfedge; }

  /// @}

protected:
  struct Halfedge
  {
    Index origin;
    Index twin;
    Index input_halfedge;
    Normal_coordinate coordinate;
    double length;
  };

  /// The input with the lengths that count here.
  struct Input_lengths
  {
    const Triangulation& input;
    double added_length;

    static Index next(Index halfedge) { return Triangulation::next(halfedge); }
    static Index previous(Index halfedge) { return Triangulation::previous(halfedge); }
    Index twin(Index halfedge) const { return input.twin(halfedge); }
    double length(Index halfedge) const { return input.length(halfedge) + added_length; }
  };

  Intrinsic_halfedges(const Triangulation& input, double added_length) : m_input(&input), m_added_length(added_length)
  {
  }

  /// Adds a face of the input as it is, without neighbors.
  void append_face(Index input_face)
  {
    for (Index h = 3 * input_face; h < 3 * input_face + 3; ++h) {
      m_halfedges.push_back({m_input->origin(h), no_index, h, along_input_edge, m_input->length(h) + m_added_length});
    }
  }

  void link(Index halfedge, Index twin)
  {
    m_halfedges[halfedge].twin = twin;
    m_halfedges[twin].twin = halfedge;
  }

  /// Replaces the edge of `h`, from i to j in a face with apex k, by the edge from k to l, the other apex, whose
  /// halfedges are afterwards `previous(h)` and `previous(twin)`. The halfedge from k to i moves to `twin`, that from l
  /// to j moves to `h`, the other two keep their place.
  /// \pre the diamond is convex, and its faces are two
  void replace_diagonal(Index h, double new_length)
  {
    const Index t = m_halfedges[h].twin;
    const Index h_next = next(h);
    const Index h_previous = previous(h);
    const Index t_next = next(t);
    const Index t_previous = previous(t);
    const Normal_coordinate coordinate = flipped_coordinate(
        m_halfedges[h].coordinate, m_halfedges[h_next].coordinate, m_halfedges[h_previous].coordinate,
        m_halfedges[t_next].coordinate, m_halfedges[t_previous].coordinate);
    const Index k = m_halfedges[h_previous].origin;
    const Index l = m_halfedges[t_previous].origin;
    move_two(h_previous, t, t_previous, h);
    m_halfedges[h_previous] = {k, t_previous, leaving_corner(t, t_next, coordinate), coordinate, new_length};
    m_halfedges[t_previous] = {l, h_previous, leaving_corner(h, h_next, coordinate), coordinate, new_length};
  }

  std::vector<Halfedge> m_halfedges;

  /// Where a curve is that crosses an edge: it enters the face of `halfedge`, after `rank` others, seen from the
  /// origin.
  struct Curve_position
  {
    Index halfedge;
    Normal_coordinate rank;
  };

  /// Follows the curve to the next edge that it crosses. \return false if it ends at the apex instead; `rank` is then
  /// its rank among those that emanate there, counterclockwise
  template <class Twin>
  bool follow(Curve_position& at, const Twin& twin_of) const
  {
    const Index after = next(at.halfedge);
    const Index before = previous(at.halfedge);
    const Normal_coordinate side = m_halfedges[at.halfedge].coordinate;
    const Normal_coordinate side_after = m_halfedges[after].coordinate;
    const Triangle_curves curves(side, side_after, m_halfedges[before].coordinate);
    if (at.rank < curves.around[0]) {
      at.halfedge = twin_of(before);
      return true;
    }
    if (at.rank >= curves.around[0] + curves.from[2]) {
      at = {twin_of(after), side_after - side + at.rank};
      return true;
    }
    at.rank -= curves.around[0];
    return false;
  }

  /// Writes to `trace` the edges of the input that `halfedge` crosses, in order from its origin. `twin_of(h)` is the
  /// twin of `h`, and may add faces.
  template <class Twin>
  void trace_over_input(Index halfedge, Edge_trace& trace, const Twin& twin_of) const
  {
    trace.clear();
    for (Normal_coordinate i = 0; i < m_halfedges[halfedge].coordinate; ++i) {
      trace.cross(m_input->twin(left_input_halfedge(halfedge, i, twin_of)));
    }
    trace.straighten(Input_lengths{*m_input, m_added_length}, m_halfedges[halfedge].input_halfedge);
  }

  /// The input halfedge that is `number` steps counterclockwise from `halfedge`.
  Index advance(Index halfedge, Normal_coordinate number) const
  {
    for (; number > 0; --number) {
      halfedge = m_input->twin(Triangulation::previous(halfedge));
    }
    return halfedge;
  }

private:
  /// Moves two halfedges at a time, each of which may be the twin of the other.
  void move_two(Index from_1, Index to_1, Index from_2, Index to_2)
  {
    const auto moved = [&](Index halfedge) { return halfedge == from_1 ? to_1 : halfedge == from_2 ? to_2 : halfedge; };
    Halfedge first = m_halfedges[from_1];
    Halfedge second = m_halfedges[from_2];
    first.twin = moved(first.twin);
    second.twin = moved(second.twin);
    m_halfedges[to_1] = first;
    m_halfedges[to_2] = second;
    for (const Index to : {to_1, to_2}) {
      if (m_halfedges[to].twin != no_index) {
        m_halfedges[m_halfedges[to].twin].twin = to;
      }
    }
  }

  /// The input halfedge into whose face a line leaves the origin of `before`, which is the next edge counterclockwise
  /// after `before`; `opposite` is the third side of the triangle of both, `coordinate` that of the line.
  Index leaving_corner(Index before, Index opposite, Normal_coordinate coordinate) const
  {
    const Normal_coordinate between =
        Triangle_curves::emanating(m_halfedges[before].coordinate, m_halfedges[opposite].coordinate, coordinate);
    return advance(m_halfedges[before].input_halfedge, between + (coordinate == along_input_edge ? 1 : 0));
  }

  /// The input edge that crosses `halfedge` after `rank` others, as a halfedge from its end on the left.
  template <class Twin>
  Index left_input_halfedge(Index halfedge, Normal_coordinate rank, const Twin& twin_of) const
  {
    Curve_position at{halfedge, rank};
    while (follow(at, twin_of)) {
    }
    return advance(m_halfedges[previous(at.halfedge)].input_halfedge, at.rank + 1);
  }

  const Triangulation* m_input;
  double m_added_length;
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_INTRINSIC_HALFEDGES_H
