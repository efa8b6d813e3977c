// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes separators of point clouds of curves along edges, by the variational flow.

#ifndef CSCD_SEPARATOR_POINT_SEPARATOR_SHORTENING_H
#define CSCD_SEPARATOR_POINT_SEPARATOR_SHORTENING_H

#include <CSCD/Point_cloud/Point_complex.h>
#include <CSCD/Point_cloud/Point_neighborhoods.h>
#include <CSCD/Separator/Closest_point_projection.h>
#include <CSCD/Separator/Complex_trace.h>
#include <CSCD/Separator/Moving_least_squares_projection.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/Shortening_outcome.h>
#include <CSCD/Separator/Variational_shortening.h>
#include <CSCD/Separator/curve_measures.h>
#include <CSCD/Separator/resample_polygon.h>
#include <CSCD/Traits/Edge_crossing.h>
#include <CSCD/Traits/Vertex_loop.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// The shortening of the published method for point clouds: the variational flow within the ball (appendix F), with
/// reprojection by moving least squares. One object serves one thread. Reuse it.
class Point_separator_shortening
{
public:
  /// \param neighborhoods those of `complex`; both are referred to and must outlive this object
  Point_separator_shortening(const Point_complex& complex, const Point_neighborhoods& neighborhoods)
      : m_complex(complex), m_projection(complex, neighborhoods), m_shortening(m_projection), m_trace(complex)
  {
  }

  /// Shortens the closed curve along the edges between consecutive vertices of `loop` within the ball around `source`
  /// that holds it (F.2), and sets the points, crossings and measures of `separator`.
  /// \return `collapsed` also where the edges that the curve crosses do not go around; `separator` then stays as it was
  Shortening_outcome shorten_vertex_loop(const Vertex_loop& loop, Index source, Separator& separator)
  {
    if (loop.size() < 3) {
      return Shortening_outcome::collapsed;
    }
    const double radius = start(loop, m_complex.point(source));
    const Shortening_outcome outcome = m_shortening(m_curve, m_complex.point(source), radius).outcome;
    if (outcome == Shortening_outcome::collapsed || !m_trace(m_shortening.curve(), m_crossings)) {
      return Shortening_outcome::collapsed;
    }
    m_points.clear();
    for (const Projected_point& p : m_shortening.curve()) {
      m_points.push_back(p.point);
    }
    separator.points = m_points;
    separator.crossings = m_crossings;
    set_measures(separator, m_points);
    return outcome;
  }

private:
  /// Sides of the polygon are about as long as edges, within these numbers: more of them cost more and change nothing.
  static constexpr std::size_t samples_per_edge = 1;
  static constexpr std::size_t least_samples = 32;
  static constexpr std::size_t most_samples = 128;

  /// Puts samples of `loop` on the surface, each next to the one before. \return its largest distance from `center`
  double start(const Vertex_loop& loop, const Vector_3& center)
  {
    m_points.clear();
    double radius = 0;
    for (const Index vertex : loop) {
      m_points.push_back(m_complex.point(vertex));
      radius = std::max(radius, (m_points.back() - center).norm());
    }
    resample_polygon(m_points, std::clamp(samples_per_edge * loop.size(), least_samples, most_samples), m_samples);
    m_curve.clear();
    Index site = loop.front();
    for (const Vector_3& sample : m_samples) {
      m_curve.push_back(m_projection(sample, site));
      site = m_curve.back().site;
    }
    return radius;
  }

  const Point_complex& m_complex;
  Moving_least_squares_projection m_projection;
  Variational_shortening<Moving_least_squares_projection> m_shortening;
  Complex_trace m_trace;
  std::vector<Vector_3> m_points;
  std::vector<Vector_3> m_samples;
  std::vector<Projected_point> m_curve;
  std::vector<Edge_crossing> m_crossings;
};

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_POINT_SEPARATOR_SHORTENING_H
