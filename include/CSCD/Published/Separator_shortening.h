// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes separators of closed curves along edges.

#ifndef CSCD_PUBLISHED_SEPARATOR_SHORTENING_H
#define CSCD_PUBLISHED_SEPARATOR_SHORTENING_H

#include <CSCD/Published/Edge_flip_shortening.h>
#include <CSCD/Published/Intrinsic_patch.h>
#include <CSCD/Published/Variational_shortening.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Shortens the closed curve along `halfedges` within the smallest ball around the vertex `source` that holds it, and
/// sets the crossings, points and measures of `separator`. Where the result is `collapsed`, `separator` stays as it
/// was. One object serves one thread.
using Separator_shortening =
    std::function<Shortening_outcome(const std::vector<Index>& halfedges, Index source, Separator& separator)>;

/// The locality constraint of appendix E.2: whether a vertex lies outside of the smallest ball around the source that
/// holds the curve, where the curve is not operated upon. E.2 names no shape; the ball is that of F.2.
class Locality_ball
{
public:
  /// The ball around `center` that holds the origins of `halfedges`, those of `triangulation`. Linear.
  /// \param points the positions of its vertices
  template <class Triangulation>
  Locality_ball(const Triangulation& triangulation, const std::vector<Vector_3>& points, const Vector_3& center,
                const std::vector<Index>& halfedges)
      : m_points(points), m_center(center)
  {
    for (const Index h : halfedges) {
      m_squared_radius = std::max(m_squared_radius, (m_points[triangulation.origin(h)] - center).squaredNorm());
    }
    m_squared_radius *= margin * margin;
  }

  bool operator()(Index vertex) const { return (m_points[vertex] - m_center).squaredNorm() > m_squared_radius; }

private:
  /// How much larger the ball is, so that the outermost vertices of a curve are not on its sphere.
  static constexpr double margin = 1.05;

  const std::vector<Vector_3>& m_points;
  Vector_3 m_center;
  double m_squared_radius = 0;
};

/// A model of `Separator_shortening` by edge flips with the locality constraint (algorithm 3, appendix E).
/// \tparam Triangulation a model of `SurfaceTriangulation`, or an `Intrinsic_triangulation` of one
template <class Triangulation>
class Separator_flip_shortening
{
public:
  /// Linear; `triangulation` is referred to and must outlive this object.
  explicit Separator_flip_shortening(const Triangulation& triangulation)
      : m_triangulation(triangulation), m_surface(input_of(triangulation)), m_shortening(triangulation)
  {
  }

  /// See `Separator_shortening`. The curve is moved off the vertices that it passes, so that it only crosses edges.
  /// \return `collapsed` also where fewer than three edges are crossed
  Shortening_outcome operator()(const std::vector<Index>& halfedges, Index source, Separator& separator)
  {
    const std::vector<Vector_3>& points = m_surface.points();
    const Locality_ball ball(m_triangulation, points, points[source], halfedges);
    const Shortening_outcome outcome = m_shortening(halfedges, true, ball, m_path);
    if (outcome == Shortening_outcome::collapsed || !push_off_vertices(m_surface, m_path, m_crossings)) {
      return Shortening_outcome::collapsed;
    }
    separator.crossings = m_crossings;
    // The measures are those of the geodesic, before it is moved off the vertices.
    crossing_points(m_surface, m_path.points, m_points);
    set_measures(separator, m_points);
    return outcome;
  }

private:
  const Triangulation& m_triangulation;
  const Input_of<Triangulation>& m_surface;
  Edge_flip_shortening<Triangulation> m_shortening;
  Surface_path m_path;
  std::vector<Edge_crossing> m_crossings;
  std::vector<Vector_3> m_points;
};

/// A model of `Separator_shortening` by the variational flow within the ball (appendix F).
/// \tparam Projection `Closest_point_projection` or `Moving_least_squares_projection`
/// \tparam Trace finds the crossed edges: `Polygon_trace` or `Complex_trace`
template <class Projection, class Trace>
class Separator_variational_shortening
{
public:
  /// \param surface that of `projection` and `Trace`; it is referred to and must outlive this object
  template <class Surface>
  Separator_variational_shortening(const Surface& surface, Projection projection)
      : m_shortening(std::move(projection)), m_trace(surface)
  {
  }

  /// See `Separator_shortening`.
  /// \return `collapsed` also where the trace fails or the loop has fewer than three edges
  Shortening_outcome operator()(const std::vector<Index>& halfedges, Index source, Separator& separator)
  {
    if (halfedges.size() < 3) {
      return Shortening_outcome::collapsed;
    }
    const auto& surface = m_trace.surface();
    const Vector_3& center = surface.point(source);
    double radius = 0;
    m_points.clear();
    for (const Index h : halfedges) {
      m_points.push_back(surface.point(surface.origin(h)));
      radius = std::max(radius, (m_points.back() - center).norm());
    }
    const std::size_t number_of_samples =
        std::clamp(Trace::samples_per_edge * halfedges.size(), min_samples, max_samples);
    const Shortening_outcome outcome =
        m_shortening(m_points, number_of_samples, center, radius, surface.origin(halfedges.front())).outcome;
    if (outcome == Shortening_outcome::collapsed || !m_trace(m_shortening.curve(), m_crossings)) {
      return Shortening_outcome::collapsed;
    }
    separator.crossings = m_crossings;
    if constexpr (!Trace::is_polygon_of_crossings) {
      separator.points = m_points;
    }
    set_measures(separator, m_points);
    return outcome;
  }

private:
  /// The number of sides of the polygon: more of them cost more and change nothing.
  static constexpr std::size_t min_samples = 32;
  static constexpr std::size_t max_samples = 128;

  Variational_shortening<Projection> m_shortening;
  Trace m_trace;
  std::vector<Vector_3> m_points;
  std::vector<Edge_crossing> m_crossings;
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_SEPARATOR_SHORTENING_H
