// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From closed polygons of surface points to the edges that they cross.

#ifndef CSCD_SEPARATOR_POLYGON_TRACE_H
#define CSCD_SEPARATOR_POLYGON_TRACE_H

#include <CSCD/Separator/Separator.h>
#include <CSCD/Traits/Solid_queries.h>
#include <CSCD/Traits/Triangulated_surface.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// Traces closed polygons over a surface: from point to point it walks in the plane that holds both and the mean normal
/// of their faces. Points are first moved a little into their faces, so that no plane begins at an edge.
class Polygon_trace
{
public:
  explicit Polygon_trace(const Triangulated_surface& surface) : m_surface(surface) {}

  /// Writes to `crossings` the edges that the closed polygon `points` crosses; linear in their number.
  /// \return false if a walk misses its point, as where the surface turns sharply between points that are far apart, or
  ///         if fewer than three edges are crossed
  bool operator()(const std::vector<Surface_point>& points, std::vector<Edge_crossing>& crossings) const
  {
    crossings.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!walk(moved_inside(points[i]), moved_inside(points[(i + 1) % points.size()]), crossings)) {
        return false;
      }
    }
    cancel_backtracks(crossings);
    return crossings.size() >= 3;
  }

private:
  /// How far points are moved towards the center of their face, relative to their distance from it.
  static constexpr double inward_part = 1e-3;
  /// A walk that has gone on for this many times its length has missed its point.
  static constexpr double longest_walk = 2;
  /// So has one that crosses so many edges: it goes round and round something small. Polygons as they are traced here
  /// have sides of half an edge or so.
  static constexpr std::size_t most_crossings = 1000;
  /// Crossings keep this distance from the ends of their edge, relative to its length.
  static constexpr double end_margin = 1e-6;

  Surface_point moved_inside(const Surface_point& p) const
  {
    const Vector_3 center =
        (m_surface.point(m_surface.origin(3 * p.face)) + m_surface.point(m_surface.origin(3 * p.face + 1)) +
         m_surface.point(m_surface.origin(3 * p.face + 2))) /
        3;
    return {p.point + inward_part * (center - p.point), p.face};
  }

  Vector_3 normal(Index face) const { return m_surface.face_vector(face).normalized(); }

  bool walk(const Surface_point& from, const Surface_point& to, std::vector<Edge_crossing>& crossings) const
  {
    const Vector_3 way = to.point - from.point;
    const Vector_3 plane_normal = way.cross(normal(from.face) + normal(to.face));
    const auto height = [&](Index vertex) { return (m_surface.point(vertex) - from.point).dot(plane_normal); };
    const std::size_t end = crossings.size() + most_crossings;
    Index face = from.face;
    while (face != to.face) {
      Index exit = no_index;
      for (Index h = 3 * face; h < 3 * face + 3; ++h) {
        // The plane's normal points to the right, where the origin of a crossed halfedge is.
        if (height(m_surface.origin(h)) >= 0 && height(m_surface.target(h)) < 0) {
          exit = h;
        }
      }
      if (exit == no_index || crossings.size() == end) {
        return false;
      }
      const double right = height(m_surface.origin(exit));
      const double position = right / (right - height(m_surface.target(exit)));
      crossings.push_back({exit, std::clamp(position, end_margin, 1 - end_margin)});
      face = Triangulated_surface::face(m_surface.twin(exit));
      const Vector_3 point =
          (1 - position) * m_surface.point(m_surface.origin(exit)) + position * m_surface.point(m_surface.target(exit));
      if ((point - from.point).squaredNorm() > longest_walk * longest_walk * way.squaredNorm()) {
        return false;
      }
    }
    return true;
  }

  /// Removes pairs of consecutive crossings that go through an edge and straight back, also where the end meets the
  /// beginning.
  void cancel_backtracks(std::vector<Edge_crossing>& crossings) const
  {
    const auto cancels = [this](const Edge_crossing& a, const Edge_crossing& b) {
      return a.halfedge == m_surface.twin(b.halfedge);
    };
    std::size_t size = 0;
    for (const Edge_crossing& crossing : crossings) {
      if (size > 0 && cancels(crossings[size - 1], crossing)) {
        --size;
      } else {
        crossings[size++] = crossing;
      }
    }
    std::size_t stem = 0;
    while (2 * stem + 2 <= size && cancels(crossings[size - 1 - stem], crossings[stem])) {
      ++stem;
    }
    crossings.resize(size - stem);
    crossings.erase(crossings.begin(), crossings.begin() + std::ptrdiff_t(stem));
  }

  const Triangulated_surface& m_surface;
};

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_POLYGON_TRACE_H
