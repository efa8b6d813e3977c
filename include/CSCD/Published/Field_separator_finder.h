// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the separator of a source from its distance field over the whole surface.

#ifndef CSCD_PUBLISHED_FIELD_SEPARATOR_FINDER_H
#define CSCD_PUBLISHED_FIELD_SEPARATOR_FINDER_H

#include <CSCD/Points/Point_complex.h>
#include <CSCD/Points/Point_neighborhoods.h>
#include <CSCD/Published/Curve_trace.h>
#include <CSCD/Published/Cut_locus_indicators.h>
#include <CSCD/Published/Cut_locus_settings.h>
#include <CSCD/Published/Cut_loop_finder.h>
#include <CSCD/Published/Cut_tree.h>
#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Published/Heat_method.h>
#include <CSCD/Published/Intrinsic_triangulation.h>
#include <CSCD/Published/Point_derivatives.h>
#include <CSCD/Published/Separator_shortening.h>
#include <CSCD/Published/Surface_projection.h>
#include <CSCD/Published/Tangent_frames.h>
#include <CSCD/Published/Tufted_cover.h>
#include <CSCD/Published/close_loops.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <CGAL/assertions.h>

#include <memory>
#include <optional>
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
/// angle or the cut locus, the target, two paths back from it, and shortening within the locality ball. One object
/// serves one thread; it keeps working memory of the size of the surface.
/// \tparam Measures `Cut_locus_indicators` of a triangulation, or `Point_cut_locus_indicators`
template <class Measures>
class Field_separator_finder
{
public:
  /// What measures are made of, prepared once for a surface.
  using Basis = typename Measures::Basis;

  /// \param basis is referred to, as \param points, the positions of the vertices
  /// \param settings which cut point is the target, and what cut points are
  Field_separator_finder(const Basis& basis, const std::vector<Vector_3>& points, const Field_search_settings& settings,
                         Separator_shortening shorten)
      : m_basis(basis), m_points(points), m_target_rule(settings.target_rule),
        m_cut_locus_rule(settings.cut_locus_rule), m_loop_finder(Measures::frames_of(basis), points),
        m_shorten(std::move(shorten))
  {
    const Cut_criterion criterion = Measures::default_criterion();
    m_cut_locus.criterion = {settings.laplacian_threshold.value_or(criterion.laplacian_threshold),
                             settings.angle_threshold.value_or(criterion.angle_threshold)};
    m_has_handles = m_cut_locus_rule == Cut_locus_rule::tree && has_handles(Measures::frames_of(basis).triangulation());
    m_cut_locus.policy = settings.cut_locus_policy;
    m_cut_locus.minimum_branch_length = settings.minimum_branch_length;
  }
  Field_separator_finder(const Field_separator_finder&) = delete;
  Field_separator_finder& operator=(const Field_separator_finder&) = delete;
  ~Field_separator_finder() = default;

  /// Seeks the separator of `source`, from which `distances` are those of all vertices. O(n) for n vertices, though
  /// most of the work is that of the loop; O(n log n) where the tree of the cut locus is built.
  void operator()(Index source, const std::vector<double>& distances, Field_search_result& result)
  {
    result.loop = find_loop(source, m_points[source], distances).outcome;
    result.outcome = Search_outcome::no_cut;
    result.shortening = Shortening_outcome::collapsed;
    if (m_loop.outcome == Cut_loop_outcome::found) {
      result.separator.source = source;
      result.separator.level = 0;
      result.shortening = m_shorten(halfedges(m_loop), source, result.separator);
      result.outcome =
          result.shortening == Shortening_outcome::collapsed ? Search_outcome::degenerate : Search_outcome::found;
    }
  }

  /// Finds the loop alone, of a source at `source_point` in a face at the vertex `source`, to which the loop leads. It
  /// is valid until the next call.
  const Cut_loop& find_loop(Index source, const Vector_3& source_point, const std::vector<double>& distances)
  {
    const Measures measures(m_basis, distances);
    if (m_cut_locus_rule == Cut_locus_rule::tree) {
      const std::vector<Index> sources{source};
      const Org_tree tree(measures, m_has_handles ? find_loop_vertices(measures, sources)
                                                  : std::vector<char>(distances.size(), 0));
      const Cut_tree cut = find_cut_tree(measures, tree, sources, m_cut_locus, m_has_handles);
      m_loop_finder.find(
          measures, source, source_point, m_target_rule, [&](Index vertex) { return cut.is_kept(vertex); }, m_loop);
    } else {
      m_loop_finder.find(
          measures, source, source_point, m_target_rule,
          [&](Index vertex) { return measures.is_cut(vertex, m_cut_locus.criterion); }, m_loop);
    }
    return m_loop;
  }

  /// The halfedges of a loop in order, from the target on.
  std::vector<Index> halfedges(const Cut_loop& loop) const { return m_loop_finder.halfedges(loop); }

private:
  const Basis& m_basis;
  const std::vector<Vector_3>& m_points;
  Target_rule m_target_rule;
  Cut_locus_rule m_cut_locus_rule;
  Cut_locus_settings m_cut_locus;
  bool m_has_handles = false;
  Cut_loop_finder<Measures> m_loop_finder;
  Separator_shortening m_shorten;
  Cut_loop m_loop;
};

/// How loops on a triangulation are shortened: prepared once, shared by all threads.
/// \tparam Triangulation a model of `SurfaceTriangulation`, or an `Intrinsic_triangulation` of one
template <class Triangulation>
class Loop_shortening_space
{
public:
  /// \param surface is referred to and must outlive this object
  /// \pre `rule` is not `variational`, which needs closest points, unless the surface is a `Triangulated_surface`
  Loop_shortening_space(const Triangulation& surface, const std::optional<Shortening_rule>& rule) : m_surface(surface)
  {
    const bool is_variational = rule == Shortening_rule::variational;
    if constexpr (std::is_same_v<Triangulation, Triangulated_surface>) {
      if (is_variational) {
        m_queries = std::make_unique<const Solid_queries>(surface);
      }
    } else {
      CGAL_precondition(!is_variational);
    }
  }

  /// Makes what shortens loops for one thread, which refers to this object.
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

private:
  const Triangulation& m_surface;
  std::unique_ptr<const Solid_queries> m_queries; ///< for the variational flow
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
  /// \pre see `Loop_shortening_space`
  Field_search_space(const Triangulation& surface, const Field_search_settings& settings)
      : m_settings(settings), m_frames(surface), m_heat_method(make_intrinsic_delaunay(surface)),
        m_shortening(surface, settings.shortening_rule)
  {
  }
  Field_search_space(Triangulation&&, const Field_search_settings&) = delete;

  const Triangulation& triangulation() const { return m_frames.triangulation(); }
  const Heat_method& heat_method() const { return m_heat_method; }
  double mean_edge_length() const { return m_frames.mean_edge_length(); }

  /// Makes a finder, which refers to this object.
  Finder make_finder() const
  {
    return Finder(m_frames, triangulation().points(), m_settings, m_shortening.make_shortening());
  }

private:
  Field_search_settings m_settings;
  Tangent_frames<Triangulation> m_frames;
  Heat_method m_heat_method;
  Loop_shortening_space<Triangulation> m_shortening;
};

/// The same where all that the heat method is on the intrinsic Delaunay triangulation is there too (appendix G.1): cut
/// points, paths along its edges, and loops, which are shortened on it. Faces that fill holes are part of the surface
/// for all of these.
template <class Triangulation>
class Intrinsic_search_space
{
  using Intrinsic = Intrinsic_triangulation<Triangulation>;

public:
  using Finder = Field_separator_finder<Cut_locus_indicators<Intrinsic>>;

  /// \param surface is referred to and must outlive this object
  /// \pre `settings.shortening_rule` is not `variational`
  Intrinsic_search_space(const Triangulation& surface, const Field_search_settings& settings)
      : m_settings(settings), m_triangulation(make_intrinsic_delaunay(surface, surface.number_of_faces())),
        m_frames(m_triangulation), m_heat_method(m_triangulation),
        m_shortening(m_triangulation, settings.shortening_rule)
  {
  }
  Intrinsic_search_space(const Intrinsic_search_space&) = delete;
  Intrinsic_search_space& operator=(const Intrinsic_search_space&) = delete;
  ~Intrinsic_search_space() = default;

  const Heat_method& heat_method() const { return m_heat_method; }

  /// Makes a finder, which refers to this object.
  Finder make_finder() const
  {
    return Finder(m_frames, m_triangulation.input().points(), m_settings, m_shortening.make_shortening());
  }

private:
  Field_search_settings m_settings;
  Intrinsic m_triangulation;
  Tangent_frames<Intrinsic> m_frames;
  Heat_method m_heat_method;
  Loop_shortening_space<Intrinsic> m_shortening;
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
      : m_complex(complex), m_settings(settings), m_frames(complex),
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
    return Finder(m_derivatives, m_complex.points(), m_settings,
                  Flow(m_complex, Moving_least_squares_projection(m_complex, m_neighborhoods)));
  }

private:
  const Point_complex& m_complex;
  Field_search_settings m_settings;
  Point_frames m_frames;
  Heat_method m_heat_method;
  Point_derivatives m_derivatives;
  Point_neighborhoods m_neighborhoods;
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_FIELD_SEPARATOR_FINDER_H
