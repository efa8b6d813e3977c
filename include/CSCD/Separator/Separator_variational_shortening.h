// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes separators of curves along edges, by the variational flow.

#ifndef CSCD_SEPARATOR_SEPARATOR_VARIATIONAL_SHORTENING_H
#define CSCD_SEPARATOR_SEPARATOR_VARIATIONAL_SHORTENING_H

#include <CSCD/Separator/Closest_point_projection.h>
#include <CSCD/Separator/Polygon_trace.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/Shortening_outcome.h>
#include <CSCD/Separator/Variational_shortening.h>
#include <CSCD/Separator/Vertex_loop.h>
#include <CSCD/Separator/curve_measures.h>
#include <CSCD/Traits/Solid_queries.h>
#include <CSCD/Traits/Triangulated_surface.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// The other shortening of the published method: the variational flow within the ball (appendix F), for meshes.
/// One object serves one thread. Reuse it.
class Separator_variational_shortening
{
public:
  /// \param surface the finest level
  /// \param queries those of `surface`; both are referred to and must outlive this object
  Separator_variational_shortening(const Triangulated_surface& surface, const Solid_queries& queries)
      : m_surface(surface), m_shortening(Closest_point_projection(surface, queries)), m_trace(surface)
  {
  }

  /// Shortens the closed curve along the edges between consecutive vertices of `loop` within the ball around `source`
  /// that holds it (F.2), and sets the crossings and measures of `separator`.
  /// \return `collapsed` also where the points cannot be joined over the surface; `separator` then stays as it was
  Shortening_outcome shorten_vertex_loop(const Vertex_loop& loop, Index source, Separator& separator)
  {
    const Vector_3& center = m_surface.point(source);
    m_points.clear();
    double radius = 0;
    for (const Index vertex : loop) {
      m_points.push_back(m_surface.point(vertex));
      radius = std::max(radius, (m_points.back() - center).norm());
    }
    if (loop.size() < 3) {
      return Shortening_outcome::collapsed;
    }
    const std::size_t number_of_samples = std::clamp(samples_per_edge * loop.size(), least_samples, most_samples);
    const Shortening_outcome outcome = m_shortening(m_points, number_of_samples, center, radius).outcome;
    m_surface_points.clear();
    for (const Projected_point& p : m_shortening.curve()) {
      m_surface_points.push_back({p.point, p.site});
    }
    if (outcome == Shortening_outcome::collapsed || !m_trace(m_surface_points, m_crossings)) {
      return Shortening_outcome::collapsed;
    }
    separator.crossings = m_crossings;
    set_measures(separator, m_points);
    return outcome;
  }

private:
  /// Sides of the polygon are about half as long as edges, so that a side crosses few of them: within these numbers.
  static constexpr std::size_t samples_per_edge = 2;
  static constexpr std::size_t least_samples = 32;
  static constexpr std::size_t most_samples = 128;

  const Triangulated_surface& m_surface;
  Variational_shortening<Closest_point_projection> m_shortening;
  Polygon_trace m_trace;
  std::vector<Vector_3> m_points;
  std::vector<Surface_point> m_surface_points;
  std::vector<Edge_crossing> m_crossings;
};

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_SEPARATOR_VARIATIONAL_SHORTENING_H
