// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangulations of a surface by intrinsic edges, which can be flipped: lengths, normal coordinates, traces over the
// input.

#ifndef CSCD_PUBLISHED_INTRINSIC_TRIANGULATION_H
#define CSCD_PUBLISHED_INTRINSIC_TRIANGULATION_H

#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>

#include <Eigen/Core>
#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// A triangle given by the lengths of its sides, counterclockwise.
/// Where they break the triangle inequality, it is as if the apex lay on the line of the longest side.
struct Flat_triangle
{
  double base;  ///< from the given corner
  double next;  ///< the opposite side of that corner
  double right; ///< back to the corner

  /// Area by Heron's formula in the form of Kahan (Miscalculating area and angles of a needle-like triangle, 2014),
  /// which is exact up to rounding also where the triangle is a needle.
  double area() const
  {
    const auto [low, high] = std::minmax(base, next);
    const double a = std::max(high, right);
    const double b = std::max(low, std::min(high, right));
    const double c = std::min(low, right);
    const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
    return product > 0 ? std::sqrt(product) / 4 : 0.;
  }

  /// The angle between `right` and `base`, in [0, pi].
  double angle() const { return std::atan2(4 * area(), base * base + right * right - next * next); }

  /// Where the foot of the height over `base` lies, from the corner on.
  double foot() const { return (base * base + (right - next) * (right + next)) / (2 * base); }
  /// The height over `base`.
  double height() const { return 2 * area() / base; }
};

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
/// first, second and third side. Curves are disjoint except for their ends and never cross a side twice in turn, hence
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

/// An intrinsic triangulation of a surface. It begins with the vertices and faces of the input; its edges can be
/// flipped. Edges are straight lines over the input. The stored data determine exactly, whatever rounding does to
/// lengths, which input edges each edge crosses: its normal coordinate, and the input corner that each of its halfedges
/// enters at its origin (Gillespie, Sharp, Crane: Integer coordinates for intrinsic geometry processing, 2021; their
/// roundabouts, counted from the input halfedge before instead of after).
///
/// It has the interface of `Triangulated_surface`, except that edges may have equal ends or both ends in common: go by
/// halfedges, never by pairs of vertices. It has only lengths. Degenerate faces are mollified: a constant is added to
/// the lengths of all edges. Copies share the input.
class Intrinsic_triangulation : public Triangle_halfedges
{
public:
  /// Takes over all faces of `input`, which is not referred to later. Linear.
  /// \tparam Triangulation has halfedges in the layout of `Triangulated_surface`, with `origin()`, `twin()`, which is
  ///         `no_index` on a border, and `length()`
  /// \param number_of_faces lengths are mollified for so many faces, the first ones, only
  template <class Triangulation>
  explicit Intrinsic_triangulation(const Triangulation& input, Index number_of_faces = no_index)
      : m_number_of_vertices(input.number_of_vertices())
  {
    auto halfedges = std::make_shared<Input>();
    for (Index h = 0; h < input.number_of_halfedges(); ++h) {
      halfedges->twin.push_back(input.twin(h));
      halfedges->length.push_back(input.length(h));
    }
    const double added_length =
        mollifying_length(halfedges->length, 3 * std::min(number_of_faces, input.number_of_faces()));
    m_halfedges.reserve(input.number_of_halfedges());
    for (Index h = 0; h < input.number_of_halfedges(); ++h) {
      halfedges->length[h] += added_length;
      m_halfedges.push_back({input.origin(h), halfedges->twin[h], h, along_input_edge, halfedges->length[h]});
    }
    m_input = std::move(halfedges);
  }

  /// \name Combinatorics
  /// @{
  Index number_of_vertices() const { return m_number_of_vertices; }
  Index number_of_halfedges() const { return Index(m_halfedges.size()); }
  Index number_of_faces() const { return Index(m_halfedges.size() / 3); }

  Index origin(Index halfedge) const { return m_halfedges[halfedge].origin; }
  Index target(Index halfedge) const { return m_halfedges[next(halfedge)].origin; }
  /// `no_index` on a border.
  Index twin(Index halfedge) const { return m_halfedges[halfedge].twin; }
  bool is_border(Index halfedge) const { return twin(halfedge) == no_index; }
  /// The next outgoing halfedge of the same origin, counterclockwise; `no_index` where a border comes before.
  Index next_around_origin(Index halfedge) const { return twin(previous(halfedge)); }
  /// @}

  /// \name Geometry
  /// @{
  double length(Index halfedge) const { return m_halfedges[halfedge].length; }
  /// The angle of the face of `halfedge` at its origin.
  double angle(Index halfedge) const { return triangle(halfedge).angle(); }
  /// @}

  /// \name Relation to the input
  /// @{
  /// The input halfedge from the same origin that `halfedge` runs along, or into whose face it starts.
  Index input_halfedge(Index halfedge) const { return m_halfedges[halfedge].input_halfedge; }

  /// The edges of the input that `halfedge` crosses, in order from its origin. Which ones is exact; where, is exact up
  /// to rounding. O(k) for an edge that crosses k input edges which cross few edges themselves.
  std::vector<Edge_crossing> trace(Index halfedge) const
  {
    std::vector<Edge_crossing> crossings;
    crossings.reserve(std::size_t(std::max(m_halfedges[halfedge].coordinate, 0)));
    for (Normal_coordinate i = 0; i < m_halfedges[halfedge].coordinate; ++i) {
      crossings.push_back({m_input->twin[left_input_halfedge(halfedge, i)], 0.5});
    }
    straighten(input_halfedge(halfedge), crossings);
    return crossings;
  }
  /// @}

  /// Flips edges until all are Delaunay; the faces of edges that cannot be flipped have angles of pi up to rounding.
  /// Near linear in practice.
  void make_delaunay()
  {
    std::vector<Index> queue;
    std::vector<char> is_queued(number_of_halfedges(), 0);
    const auto push = [&](Index h) {
      if (!is_queued[h]) {
        is_queued[h] = 1;
        queue.push_back(h);
      }
    };
    for (Index h = 0; h < number_of_halfedges(); ++h) {
      if (h < twin(h) && !is_border(h)) {
        push(h);
      }
    }
    while (!queue.empty()) {
      const Index h = queue.back();
      queue.pop_back();
      is_queued[h] = 0;
      if (!flip_if_better(h)) {
        continue;
      }
      const Index t = next(twin(previous(h)));
      for (const Index side : {h, next(h), t, next(t)}) {
        push(side);
      }
    }
  }

protected:
  struct Halfedge
  {
    Index origin;
    Index twin;
    Index input_halfedge;
    Normal_coordinate coordinate;
    double length;
  };

  /// The length of the other diagonal of the two faces of the edge, if that runs strictly inside, and leaves on either
  /// side at least the part `min_part` of the area.
  std::optional<double> other_diagonal(Index halfedge) const
  {
    if (is_border(halfedge) || face(halfedge) == face(twin(halfedge))) {
      return std::nullopt;
    }
    const Flat_triangle left = triangle(halfedge);
    const Flat_triangle right = triangle(twin(halfedge));
    const double left_foot = left.foot();
    const double right_foot = left.base - right.foot();
    const double left_height = left.height();
    const double right_height = right.height();
    const double height = left_height + right_height;
    const double crossing = (left_foot * right_height + right_foot * left_height) / height;
    if (!(height > 0 && crossing > min_part * left.base && crossing < (1 - min_part) * left.base)) {
      return std::nullopt;
    }
    const double along = left_foot - right_foot;
    return std::sqrt(along * along + height * height);
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

private:
  static constexpr double pi = boost::math::constants::pi<double>();
  /// The least part of the area of a quadrilateral that a diagonal has to leave on either side.
  static constexpr double min_part = 1e-9;

  /// What the angles opposite an edge may exceed pi by, in radians: far more than rounding makes of cocircular
  /// vertices, far less than would be felt in cotangents.
  static constexpr double delaunay_tolerance = 1e-9;
  /// By how much two sides of a triangle have to be longer, at least, than the third one, relative to the mean length
  /// of edges (Sharp, Crane: A Laplacian for nonmanifold triangle meshes, 2020, section 4.5).
  static constexpr double min_slack = 1e-5;
  /// Crossings keep this distance from the ends of their edge, relative to its length, whatever rounding makes of them.
  static constexpr double end_margin = 1e-9;

  /// The halfedges of the input, with the lengths that count here.
  struct Input
  {
    std::vector<Index> twin;
    std::vector<double> length;
  };

  /// The minimal length that, added to all edges, keeps the triangles of the first halfedges clear of the degenerate by
  /// `min_slack`; 0 for all but degenerate input. Linear.
  static double mollifying_length(const std::vector<double>& length, Index number_of_halfedges)
  {
    double sum = 0;
    double least = 0; // of how much two sides are longer than the third one
    for (Index h = 0; h < number_of_halfedges; ++h) {
      const double slack = length[next(h)] + length[previous(h)] - length[h];
      sum += length[h];
      least = h == 0 ? slack : std::min(least, slack);
    }
    const double needed = number_of_halfedges == 0 ? 0. : min_slack * sum / double(number_of_halfedges);
    return std::max(0., needed - least);
  }

  /// The face of `halfedge`, seen from its origin.
  Flat_triangle triangle(Index halfedge) const
  {
    return {length(halfedge), length(next(halfedge)), length(previous(halfedge))};
  }
  /// The same in the input.
  Flat_triangle input_triangle(Index halfedge) const
  {
    return {m_input->length[halfedge], m_input->length[next(halfedge)], m_input->length[previous(halfedge)]};
  }

  /// Flips the edge if the angles opposite it exceed pi, unless it cannot be flipped or rounding lets the other
  /// diagonal look no better. \return whether it did
  bool flip_if_better(Index halfedge)
  {
    const Index t = twin(halfedge);
    if (t == no_index || angle(previous(halfedge)) + angle(previous(t)) <= pi + delaunay_tolerance) {
      return false;
    }
    const std::optional<double> diagonal = other_diagonal(halfedge);
    if (!diagonal) {
      return false;
    }
    const Flat_triangle at_target{length(next(halfedge)), *diagonal, length(previous(t))};
    const Flat_triangle at_origin{length(next(t)), *diagonal, length(previous(halfedge))};
    if (at_target.angle() + at_origin.angle() >= pi) {
      return false;
    }
    replace_diagonal(halfedge, *diagonal);
    return true;
  }

  using Point = Eigen::Vector2d;

  /// An edge of the input in the plane.
  struct Unfolded_side
  {
    Point origin;
    Point target;
  };

  /// Unfolds the faces of the input along a straight line, which starts at the origin of `corner` into its face, and
  /// sets the positions of all crossings. Linear.
  /// \pre the crossings are those of such a line; each is in the face that the one before has entered
  void straighten(Index corner, std::vector<Edge_crossing>& crossings) const
  {
    const Flat_triangle first = input_triangle(corner);
    Unfolded_side side{{first.base, 0}, {first.foot(), first.height()}};
    std::vector<Unfolded_side> sides;
    Point end = Point::Zero(); // at last, of the line
    for (std::size_t i = 0; i < crossings.size(); ++i) {
      if (i > 0) {
        const Index entered = m_input->twin[crossings[i - 1].halfedge];
        (crossings[i].halfedge == next(entered) ? side.target : side.origin) = end;
      }
      sides.push_back(side);
      end = unfold_apex(input_triangle(m_input->twin[crossings[i].halfedge]), side);
    }
    const auto side_of_line = [&end](const Point& p) { return end.x() * p.y() - end.y() * p.x(); };
    for (std::size_t i = 0; i < crossings.size(); ++i) {
      // The origin lies on the right of the line, the target on the left, except for rounding.
      const double right = side_of_line(sides[i].origin);
      const double left = side_of_line(sides[i].target);
      const double position = left > right ? -right / (left - right) : 0.5;
      crossings[i].position = std::clamp(position, end_margin, 1 - end_margin);
    }
  }

  /// Where the apex of `triangle` lies, which is entered over `side`; its base runs from `target` to `origin`.
  static Point unfold_apex(const Flat_triangle& triangle, const Unfolded_side& side)
  {
    const Point along = (side.origin - side.target) / triangle.base;
    return side.target + triangle.foot() * along + triangle.height() * Point(-along.y(), along.x());
  }

  /// Moves two halfedges at a time. They may be twins of each other.
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

  /// Where a curve is that crosses an edge: it enters the face of `halfedge`, after `rank` others, seen from the
  /// origin.
  struct Curve_position
  {
    Index halfedge;
    Normal_coordinate rank;
  };

  /// Follows the curve to the next edge that it crosses. \return false if it ends at the apex instead; `rank` is then
  /// its rank among those that emanate there, counterclockwise
  bool follow(Curve_position& at) const
  {
    const Index after = next(at.halfedge);
    const Index before = previous(at.halfedge);
    const Normal_coordinate side = m_halfedges[at.halfedge].coordinate;
    const Normal_coordinate side_after = m_halfedges[after].coordinate;
    const Triangle_curves curves(side, side_after, m_halfedges[before].coordinate);
    if (at.rank < curves.around[0]) {
      at.halfedge = m_halfedges[before].twin;
      return true;
    }
    if (at.rank >= curves.around[0] + curves.from[2]) {
      at = {m_halfedges[after].twin, side_after - side + at.rank};
      return true;
    }
    at.rank -= curves.around[0];
    return false;
  }

  /// The input edge that crosses `halfedge` after `rank` others, as a halfedge from its end on the left.
  Index left_input_halfedge(Index halfedge, Normal_coordinate rank) const
  {
    Curve_position at{halfedge, rank};
    while (follow(at)) {
    }
    return advance(m_halfedges[previous(at.halfedge)].input_halfedge, at.rank + 1);
  }

  /// The input halfedge that is `number` steps counterclockwise from `halfedge`.
  Index advance(Index halfedge, Normal_coordinate number) const
  {
    for (; number > 0; --number) {
      halfedge = m_input->twin[previous(halfedge)];
    }
    return halfedge;
  }

  std::shared_ptr<const Input> m_input;
  Index m_number_of_vertices;
};

/// Makes the intrinsic Delaunay triangulation of `surface`, which is not referred to later.
template <class Triangulation>
Intrinsic_triangulation make_intrinsic_delaunay(const Triangulation& surface)
{
  Intrinsic_triangulation result(surface);
  result.make_delaunay();
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_INTRINSIC_TRIANGULATION_H
