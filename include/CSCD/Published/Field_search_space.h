// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a search from distance fields needs of a surface or of points: distances, frames, the shortening of loops.

#ifndef CSCD_PUBLISHED_FIELD_SEARCH_SPACE_H
#define CSCD_PUBLISHED_FIELD_SEARCH_SPACE_H

#include <CSCD/Points/Point_complex.h>
#include <CSCD/Published/Curve_trace.h>
#include <CSCD/Published/Edge_flip_shortening.h>
#include <CSCD/Published/Heat_method.h>
#include <CSCD/Published/Intrinsic_triangulation.h>
#include <CSCD/Published/Surface_path.h>
#include <CSCD/Published/Tangent_frames.h>
#include <CSCD/Published/Variational_shortening.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Vector3.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace CSCD::internal {

/// Shortens closed curves by edge flips with the locality constraint (algorithm 3, appendix E). One object serves one
/// thread.
/// \tparam Surface a model of `SurfaceTriangulation`
template <class Surface>
class Separator_flip_shortening
{
public:
  /// Linear.
  /// \param surface is referred to, as \param triangulation, an intrinsic one of it, on whose edges curves are given
  Separator_flip_shortening(const Surface& surface, const Intrinsic_triangulation& triangulation)
      : m_surface(surface), m_triangulation(triangulation), m_shortening(triangulation)
  {
  }

  /// Shortens the closed curve along `halfedges` within the ball around the vertex `source`, and sets the crossings and
  /// measures of `separator`. The curve is moved off the vertices that it passes, so that it only crosses edges.
  /// \return `collapsed`, and `separator` must not be used, also where fewer than three edges are crossed
  Shortening_outcome operator()(const std::vector<Index>& halfedges, Index source, Separator& separator)
  {
    const std::vector<Vector3>& points = m_surface.points();
    const Vector3& center = points[source];
    double squared_radius = 0;
    for (const Index h : halfedges) {
      squared_radius = std::max(squared_radius, (points[m_triangulation.origin(h)] - center).squaredNorm());
    }
    squared_radius *= ball_margin * ball_margin;
    const auto is_outside = [&](Index vertex) { return (points[vertex] - center).squaredNorm() > squared_radius; };
    const Shortening_outcome outcome = m_shortening(halfedges, true, m_path, is_outside);
    if (outcome == Shortening_outcome::collapsed || !push_off_vertices(m_surface, m_path, separator.crossings)) {
      return Shortening_outcome::collapsed;
    }
    // The measures are those of the geodesic, before it is moved off the vertices.
    crossing_points(m_surface, m_path.points, m_points);
    set_measures(separator, m_points);
    return outcome;
  }

private:
  /// The locality constraint of appendix E.2: vertices outside of the smallest ball around the source that holds the
  /// curve are pinned. E.2 names no shape; the ball is that of F.2. It is so much larger that the outermost vertices of
  /// a curve are not on its sphere.
  static constexpr double ball_margin = 1.05;

  const Surface& m_surface;
  const Intrinsic_triangulation& m_triangulation;
  Edge_flip_shortening m_shortening;
  Surface_path m_path;
  std::vector<Vector3> m_points;
};

/// Shortens closed curves among points by the variational flow within the ball (appendix F). One object serves one
/// thread.
class Separator_variational_shortening
{
public:
  /// \param projection that of `complex`; both are referred to and must outlive this object
  Separator_variational_shortening(const Point_complex& complex, const Moving_least_squares_projection& projection)
      : m_complex(complex), m_shortening(projection), m_trace(complex)
  {
  }

  /// As `Separator_flip_shortening`; sets the points of `separator`, too.
  /// \return `collapsed` also where the trace fails or the loop has fewer than three edges
  Shortening_outcome operator()(const std::vector<Index>& halfedges, Index source, Separator& separator)
  {
    if (halfedges.size() < 3) {
      return Shortening_outcome::collapsed;
    }
    const Vector3& center = m_complex.point(source);
    double radius = 0;
    m_points.clear();
    for (const Index h : halfedges) {
      m_points.push_back(m_complex.point(m_complex.origin(h)));
      radius = std::max(radius, (m_points.back() - center).norm());
    }
    const std::size_t number_of_samples = std::clamp(halfedges.size(), min_samples, max_samples);
    const Shortening_outcome outcome =
        m_shortening(m_points, number_of_samples, center, radius, m_complex.origin(halfedges.front()));
    if (outcome == Shortening_outcome::collapsed || !m_trace(m_shortening.curve(), separator.crossings)) {
      return Shortening_outcome::collapsed;
    }
    separator.points = m_points;
    set_measures(separator, m_points);
    return outcome;
  }

private:
  /// The number of sides of the polygon, which may be as long as edges: more of them cost more and change nothing.
  static constexpr std::size_t min_samples = 32;
  static constexpr std::size_t max_samples = 128;

  const Point_complex& m_complex;
  Variational_shortening m_shortening;
  Complex_trace m_trace;
  std::vector<Vector3> m_points;
};

/// What all threads share that seek separators on a surface from distance fields, prepared once. Distances, cut points,
/// paths and loops belong to the intrinsic Delaunay triangulation (appendix G.1), including faces that fill holes.
/// \tparam Surface a model of `SurfaceTriangulation`; there is a specialization for `Point_complex`
template <class Surface>
struct Field_search_space
{
  using Frames = Tangent_frames;
  using Shortening = Separator_flip_shortening<Surface>;

  /// \param input is referred to and must outlive this object
  explicit Field_search_space(const Surface& input)
      : surface(input), triangulation(make_intrinsic_delaunay(input)), frames(triangulation), heat_method(triangulation)
  {
  }

  std::unique_ptr<Shortening> make_shortening() const { return std::make_unique<Shortening>(surface, triangulation); }

  const Surface& surface;
  Intrinsic_triangulation triangulation;
  Frames frames;
  Heat_method heat_method;
};

/// Point clouds: the heat method on the intrinsic Delaunay triangulation of the tufted cover, loops along the edges of
/// the complex, and the variational flow.
template <>
struct Field_search_space<Point_complex>
{
  using Frames = Point_frames;
  using Shortening = Separator_variational_shortening;

  /// \param complex is referred to and must outlive this object
  explicit Field_search_space(const Point_complex& complex)
      : surface(complex), heat_method(make_intrinsic_delaunay(Tufted_cover(complex))),
        frames(complex, heat_method.elements), projection(complex)
  {
  }

  std::unique_ptr<Shortening> make_shortening() const { return std::make_unique<Shortening>(surface, projection); }

  const Point_complex& surface;
  Heat_method heat_method;
  Frames frames;
  Moving_least_squares_projection projection;
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_FIELD_SEARCH_SPACE_H
