// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes separators of closed curves along edges.

#ifndef CSCD_SEPARATOR_SEPARATOR_SHORTENING_H
#define CSCD_SEPARATOR_SEPARATOR_SHORTENING_H

#include <CSCD/Separator/Field_search_settings.h>
#include <CSCD/Separator/Curve_trace.h>
#include <CSCD/Separator/Edge_flip_shortening.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/Surface_projection.h>
#include <CSCD/Separator/Variational_shortening.h>
#include <CSCD/Separator/Vertex_loop.h>
#include <CSCD/Surface/Point_complex.h>
#include <CSCD/Surface/Point_neighborhoods.h>
#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <optional>
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

/// The shortening of the published method: edge flips with the locality constraint (algorithm 3, appendix E).
/// One object serves one thread. Reuse it.
class Separator_flip_shortening
{
public:
  /// Linear; `surface` is the finest level.
  explicit Separator_flip_shortening(const Triangulated_surface& surface) : m_surface(surface), m_shortening(surface) {}

  /// Shortens the closed curve along `halfedges` within its ball around `source`, and sets the crossings and measures
  /// of `separator`. The curve is taken off the vertices that it passes, so that it only crosses edges.
  /// \return `collapsed` also where fewer than three edges are crossed; `separator` then stays as it was
  Shortening_outcome shorten(const std::vector<Index>& halfedges, Index source, Separator& separator)
  {
    const Locality_ball ball(m_surface, m_surface.point(source), halfedges);
    const Shortening_outcome outcome = m_shortening(halfedges, true, ball, m_path);
    if (outcome == Shortening_outcome::collapsed || !push_off_vertices(m_surface, m_path, m_crossings)) {
      return Shortening_outcome::collapsed;
    }
    separator.crossings = m_crossings;
    // The measures are those of the geodesic, not of what was pushed off.
    crossing_points(m_surface, m_path.points, m_points);
    set_measures(separator, m_points);
    return outcome;
  }

  /// The same for a curve along the edges between consecutive vertices of `loop`.
  /// \return `collapsed` also where there is no such edge
  Shortening_outcome shorten_vertex_loop(const Vertex_loop& loop, Index source, Separator& separator)
  {
    m_halfedges.clear();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      m_halfedges.push_back(m_surface.find_halfedge(loop[i], loop[i + 1 < loop.size() ? i + 1 : 0]));
    }
    if (std::find(m_halfedges.begin(), m_halfedges.end(), no_index) != m_halfedges.end()) {
      return Shortening_outcome::collapsed;
    }
    return shorten(m_halfedges, source, separator);
  }

private:
  const Triangulated_surface& m_surface;
  Edge_flip_shortening<Triangulated_surface> m_shortening;
  std::vector<Index> m_halfedges;
  Surface_path m_path;
  std::vector<Edge_crossing> m_crossings;
  std::vector<Vector_3> m_points;
};

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
    const std::size_t number_of_samples = std::clamp(samples_per_edge * loop.size(), min_samples, max_samples);
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
  static constexpr std::size_t min_samples = 32;
  static constexpr std::size_t max_samples = 128;

  const Triangulated_surface& m_surface;
  Variational_shortening<Closest_point_projection> m_shortening;
  Polygon_trace m_trace;
  std::vector<Vector_3> m_points;
  std::vector<Surface_point> m_surface_points;
  std::vector<Edge_crossing> m_crossings;
};

/// Shortening on meshes by edge flips or by the variational flow, as is chosen once. One object serves one thread.
class Separator_shortening
{
public:
  /// \param surface is referred to
  /// \param queries those of `surface`, for the variational flow; null for edge flips
  explicit Separator_shortening(const Triangulated_surface& surface, const Solid_queries* queries = nullptr)
      : m_flips(surface)
  {
    if (queries != nullptr) {
      m_flow.emplace(surface, *queries);
    }
  }

  /// Shortens the closed curve along the edges between consecutive vertices of `loop` within the ball around `source`
  /// that holds it, and sets the crossings and measures of `separator`.
  /// \return `collapsed` where nothing is left that separates; `separator` then stays as it was
  Shortening_outcome shorten_vertex_loop(const Vertex_loop& loop, Index source, Separator& separator)
  {
    return m_flow ? m_flow->shorten_vertex_loop(loop, source, separator)
                  : m_flips.shorten_vertex_loop(loop, source, separator);
  }

private:
  Separator_flip_shortening m_flips;
  std::optional<Separator_variational_shortening> m_flow;
};

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
  static constexpr std::size_t min_samples = 32;
  static constexpr std::size_t max_samples = 128;

  /// Puts samples of `loop` on the surface, each next to the one before. \return its largest distance from `center`
  double start(const Vertex_loop& loop, const Vector_3& center)
  {
    m_points.clear();
    double radius = 0;
    for (const Index vertex : loop) {
      m_points.push_back(m_complex.point(vertex));
      radius = std::max(radius, (m_points.back() - center).norm());
    }
    resample_polygon(m_points, std::clamp(samples_per_edge * loop.size(), min_samples, max_samples), m_samples);
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

#endif // CSCD_SEPARATOR_SEPARATOR_SHORTENING_H
