// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much surface lies on either side of a separator.

#ifndef CSCD_SELECTION_SEPARATOR_SIDES_H
#define CSCD_SELECTION_SEPARATOR_SIDES_H

#include <CSCD/Separator/Separator.h>
#include <CSCD/Traits/Edge_crossing.h>
#include <CSCD/internal/Distance_front.h>
#include <CSCD/internal/Epoch_marks.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CSCD::internal {

/// Measures the surface on the two sides of separators, one after the other. The work is that of the surface near a
/// separator, up to a distance and an area that are given. One object serves one thread.
/// \tparam Surface what separators lie on
template <class Surface>
class Separator_sides
{
public:
  /// One side of a separator.
  struct Side
  {
    double band_area = 0; ///< of the surface within a distance of the separator
    double area = 0;      ///< of all the surface on this side, or something above a limit
  };

  /// \param surface is referred to
  explicit Separator_sides(const Surface& surface)
      : m_surface(surface), m_crossed(surface.number_of_halfedges()), m_front(surface.number_of_vertices())
  {
  }

  /// Measures one side.
  /// \param width the distance along edges that bounds the band \param limit where the area need not be counted further
  Side measure(const Separator& separator, bool is_left, double width, double limit)
  {
    m_crossed.clear();
    m_front.clear();
    for (const Edge_crossing& crossing : separator.crossings) {
      m_crossed.mark(m_surface.edge(crossing.halfedge));
    }
    for (const Edge_crossing& crossing : separator.crossings) {
      // The target of the halfedge lies on the left.
      const Index vertex = is_left ? m_surface.target(crossing.halfedge) : m_surface.origin(crossing.halfedge);
      const double part = is_left ? 1 - crossing.position : crossing.position;
      m_front.reach(vertex, float(part * m_surface.length(crossing.halfedge)));
    }
    return spread(width, limit);
  }

private:
  Side spread(double width, double limit)
  {
    Side side;
    m_front.spread([&](Index vertex, float distance) {
      const double area = double(m_surface.vertex_area(vertex));
      side.area += area;
      // The part of the vertex that is in the band, as if it was a square along it.
      const double extent = std::sqrt(area);
      const double from = std::max(double(distance) - extent / 2, 0.);
      const double to = std::min(double(distance) + extent / 2, width);
      side.band_area += std::max(to - from, 0.) * extent;
      if (from > width && side.area > limit) {
        return;
      }
      for (Index halfedge : m_surface.outgoing(vertex)) {
        if (!m_crossed.is_marked(m_surface.edge(halfedge))) {
          m_front.reach(m_surface.target(halfedge), distance + float(m_surface.length(halfedge)));
        }
      }
    });
    return side;
  }

  const Surface& m_surface;
  Epoch_marks m_crossed;
  Distance_front m_front;
};

} // namespace CSCD::internal

#endif // CSCD_SELECTION_SEPARATOR_SIDES_H
