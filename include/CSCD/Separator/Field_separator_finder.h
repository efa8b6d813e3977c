// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the separator of a source from its distance field over the whole surface.

#ifndef CSCD_SEPARATOR_FIELD_SEPARATOR_FINDER_H
#define CSCD_SEPARATOR_FIELD_SEPARATOR_FINDER_H

#include <CSCD/Cut_locus/Cut_locus_indicators.h>
#include <CSCD/Cut_locus/Point_derivatives.h>
#include <CSCD/Cut_locus/Tangent_frames.h>
#include <CSCD/Geodesic/Heat_method.h>
#include <CSCD/Geodesic/Tufted_cover.h>
#include <CSCD/Separator/Curve_trace.h>
#include <CSCD/Separator/Cut_loop_finder.h>
#include <CSCD/Separator/Field_search_settings.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/Separator_shortening.h>
#include <CSCD/Separator/Surface_projection.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Intrinsic_triangulation.h>
#include <CSCD/Surface/Point_complex.h>
#include <CSCD/Surface/Point_neighborhoods.h>
#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <CGAL/assertions.h>

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The result of the search for the separator of one source by its distance field.
struct Field_search_result
{
  Search_outcome outcome = Search_outcome::no_cut;
  /// `found`, or why there is no cut.
  Cut_loop_outcome loop = Cut_loop_outcome::no_cut_point;
  /// Where a loop was found, how its shortening ended; `collapsed` otherwise.
  Shortening_outcome shortening = Shortening_outcome::collapsed;
  Separator separator; ///< where one was found
};

/// Finds separators from distance fields as published (Alg. 3): cut points by the thresholds of Laplacian and gradient
/// angle, the target, two paths back from it, and shortening within the locality ball. One object serves one thread; it
/// keeps working memory of the size of the surface.
/// \tparam Measures `Cut_locus_indicators` of a triangulation, or `Point_cut_locus_indicators`
template <class Measures>
class Field_separator_finder
{
public:
  /// What measures are made of, prepared once for a surface.
  using Basis = typename Measures::Basis;

  /// \param basis is referred to, as \param points, the positions of the vertices
  /// \param target_rule which cut point is the target
  Field_separator_finder(const Basis& basis, const std::vector<Vector_3>& points, Target_rule target_rule,
                         Separator_shortening shorten)
      : m_basis(basis), m_target_rule(target_rule), m_loop_finder(Measures::frames_of(basis), points),
        m_shorten(std::move(shorten))
  {
  }
  Field_separator_finder(const Field_separator_finder&) = delete;
  Field_separator_finder& operator=(const Field_separator_finder&) = delete;
  ~Field_separator_finder() = default;

  /// Seeks the separator of `source`, from which `distances` are those of all vertices. O(n) for n vertices, though
  /// most of the work is that of the loop.
  void operator()(Index source, const std::vector<double>& distances, Field_search_result& result)
  {
    const Measures measures(m_basis, distances);
    m_loop_finder(measures, source, Measures::default_criterion(), m_target_rule, m_loop);
    result.loop = m_loop.outcome;
    result.outcome = Search_outcome::no_cut;
    result.shortening = Shortening_outcome::collapsed;
    if (m_loop.outcome == Cut_loop_outcome::found) {
      result.separator.source = source;
      result.separator.level = 0;
      result.shortening = m_shorten(m_loop_finder.halfedges(m_loop), source, result.separator);
      result.outcome =
          result.shortening == Shortening_outcome::collapsed ? Search_outcome::degenerate : Search_outcome::found;
    }
  }

private:
  const Basis& m_basis;
  Target_rule m_target_rule;
  Cut_loop_finder<Measures> m_loop_finder;
  Separator_shortening m_shorten;
  Cut_loop m_loop;
};

/// How distances on a surface are estimated, and separators found from them: prepared once, shared by all threads. The
/// heat method on the intrinsic Delaunay triangulation, and loops along the edges.
/// \tparam Triangulation a model of `SurfaceTriangulation`; there is a specialization for `Point_complex`
template <class Triangulation>
class Field_search_space
{
public:
  using Finder = Field_separator_finder<Cut_locus_indicators<Triangulation>>;

  /// \param surface is referred to and must outlive this object
  /// \pre `settings.shortening_rule` is not `variational`, which needs closest points, unless the surface is a
  ///      `Triangulated_surface`
  Field_search_space(const Triangulation& surface, const Field_search_settings& settings)
      : m_surface(surface), m_target_rule(settings.target_rule), m_frames(surface),
        m_heat_method(make_intrinsic_delaunay(surface))
  {
    const bool is_variational = settings.shortening_rule == Shortening_rule::variational;
    if constexpr (std::is_same_v<Triangulation, Triangulated_surface>) {
      if (is_variational) {
        m_queries = std::make_unique<const Solid_queries>(surface);
      }
    } else {
      CGAL_precondition(!is_variational);
    }
  }
  Field_search_space(Triangulation&&, const Field_search_settings&) = delete;

  const Heat_method& heat_method() const { return m_heat_method; }

  /// Makes a finder, which refers to this object.
  Finder make_finder() const { return Finder(m_frames, m_surface.points(), m_target_rule, make_shortening()); }

private:
  Separator_shortening make_shortening() const
  {
    if constexpr (std::is_same_v<Triangulation, Triangulated_surface>) {
      using Flow = Separator_variational_shortening<Closest_point_projection, Polygon_trace>;
      if (m_queries) {
        return Flow(m_surface, Closest_point_projection(m_surface, *m_queries));
      }
    }
    const auto shortening = std::make_shared<Separator_flip_shortening<Triangulation>>(m_surface);
    return [shortening](const std::vector<Index>& halfedges, Index source, Separator& separator) {
      return (*shortening)(halfedges, source, separator);
    };
  }

  const Triangulation& m_surface;
  Target_rule m_target_rule;
  Tangent_frames<Triangulation> m_frames;
  Heat_method m_heat_method;
  std::unique_ptr<const Solid_queries> m_queries; ///< for the variational flow
};

/// Point clouds: the heat method on the intrinsic Delaunay triangulation of the tufted cover, loops along the edges of
/// the complex, and the variational flow.
template <>
class Field_search_space<Point_complex>
{
public:
  using Finder = Field_separator_finder<Point_cut_locus_indicators>;

  /// \param complex is referred to and must outlive this object
  /// \pre `settings.shortening_rule` is not `edge_flips`: points have no edges to be flipped
  Field_search_space(const Point_complex& complex, const Field_search_settings& settings)
      : m_complex(complex), m_target_rule(settings.target_rule), m_frames(complex),
        m_heat_method(make_intrinsic_delaunay(Tufted_cover(complex))),
        m_derivatives(m_frames, m_heat_method.elements()), m_neighborhoods(complex)
  {
    CGAL_precondition(settings.shortening_rule != Shortening_rule::edge_flips);
  }
  Field_search_space(Point_complex&&, const Field_search_settings&) = delete;

  const Heat_method& heat_method() const { return m_heat_method; }

  /// Makes a finder, which refers to this object.
  Finder make_finder() const
  {
    using Flow = Separator_variational_shortening<Moving_least_squares_projection, Complex_trace>;
    return Finder(m_derivatives, m_complex.points(), m_target_rule,
                  Flow(m_complex, Moving_least_squares_projection(m_complex, m_neighborhoods)));
  }

private:
  const Point_complex& m_complex;
  Target_rule m_target_rule;
  Point_frames m_frames;
  Heat_method m_heat_method;
  Point_derivatives m_derivatives;
  Point_neighborhoods m_neighborhoods;
};

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_FIELD_SEPARATOR_FINDER_H
