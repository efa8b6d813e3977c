// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The ball that a curve is not to leave while it is shortened.

#ifndef CSCD_SEPARATOR_LOCALITY_BALL_H
#define CSCD_SEPARATOR_LOCALITY_BALL_H

#include <CSCD/Traits/Triangulated_surface.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <vector>

namespace CSCD::internal {

/// The locality constraint of appendix E.2: tells of a vertex whether it lies out of the smallest ball around the
/// source that holds the curve, where the curve is not operated upon. E.2 names no shape; the ball is that of F.2.
class Locality_ball
{
public:
  /// The ball around `center` that holds the origins of `halfedges`. Linear.
  Locality_ball(const Triangulated_surface& surface, const Vector_3& center, const std::vector<Index>& halfedges)
      : m_surface(&surface), m_center(center)
  {
    for (const Index h : halfedges) {
      m_squared_radius = std::max(m_squared_radius, (surface.point(surface.origin(h)) - center).squaredNorm());
    }
    m_squared_radius *= margin * margin;
  }

  bool operator()(Index vertex) const { return (m_surface->point(vertex) - m_center).squaredNorm() > m_squared_radius; }

private:
  /// How much larger the ball is, so that the outermost vertices of a curve are not at its rim.
  static constexpr double margin = 1.05;

  const Triangulated_surface* m_surface;
  Vector_3 m_center;
  double m_squared_radius = 0;
};

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_LOCALITY_BALL_H
