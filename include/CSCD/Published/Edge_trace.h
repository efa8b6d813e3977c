// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A straight line from vertex to vertex over the faces that it crosses.

#ifndef CSCD_PUBLISHED_EDGE_TRACE_H
#define CSCD_PUBLISHED_EDGE_TRACE_H

#include <CSCD/Published/Flat_triangle.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// The edges that a straight line from vertex to vertex crosses, in order. Reuse one object.
class Edge_trace
{
public:
  /// Empty where the line runs along an edge.
  const std::vector<Edge_crossing>& crossings() const { return m_crossings; }

  void clear() { m_crossings.clear(); }
  /// Adds the next edge to be crossed; `straighten()` finds where.
  void cross(Index halfedge) { m_crossings.push_back({halfedge, 0.5}); }

  /// Unfolds the faces along the line and sets the positions of all crossings. Linear.
  /// \param corner the halfedge from the first vertex such that the line starts into its face
  /// \pre the crossings are those of a line that starts so; each is in the face that the one before has entered
  template <class Triangulation>
  void straighten(const Triangulation& triangulation, Index corner)
  {
    if (m_crossings.empty()) {
      return;
    }
    const Point end = unfold(triangulation, corner);
    const auto side_of_line = [&end](const Point& p) { return end.x() * p.y() - end.y() * p.x(); };
    for (std::size_t i = 0; i < m_crossings.size(); ++i) {
      // The origin lies on the right of the line, the target on the left, but for rounding.
      const double right = side_of_line(m_sides[i].origin);
      const double left = side_of_line(m_sides[i].target);
      const double position = left > right ? -right / (left - right) : 0.5;
      m_crossings[i].position = std::clamp(position, end_margin, 1 - end_margin);
    }
  }

private:
  using Point = Eigen::Vector2d;

  /// Crossings keep this distance from the ends of their edge, relative to its length, whatever rounding makes of them.
  static constexpr double end_margin = 1e-9;

  struct Unfolded_side
  {
    Point origin;
    Point target;
  };

  /// Writes the unfolded edges to `m_sides`, the first vertex in the origin, and returns the last vertex.
  template <class Triangulation>
  Point unfold(const Triangulation& triangulation, Index corner)
  {
    const Flat_triangle first = flat_triangle(triangulation, corner);
    Unfolded_side side{{first.base, 0}, {first.foot(), first.height()}};
    m_sides.clear();
    for (std::size_t i = 0;; ++i) {
      m_sides.push_back(side);
      const Index entered = triangulation.twin(m_crossings[i].halfedge);
      Point apex = unfold_apex(flat_triangle(triangulation, entered), side);
      if (i + 1 == m_crossings.size()) {
        return apex;
      }
      if (m_crossings[i + 1].halfedge == Triangulation::next(entered)) {
        side.target = apex;
      } else {
        side.origin = apex;
      }
    }
  }

  /// Where the apex of `triangle` lies, which is entered over `side`; its base runs from `target` to `origin`.
  static Point unfold_apex(const Flat_triangle& triangle, const Unfolded_side& side)
  {
    const Point along = (side.origin - side.target) / triangle.base;
    return side.target + triangle.foot() * along + triangle.height() * Point(-along.y(), along.x());
  }

  std::vector<Edge_crossing> m_crossings;
  std::vector<Unfolded_side> m_sides;
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_EDGE_TRACE_H
