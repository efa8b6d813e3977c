// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the separator of a source from its distance field over the whole surface.

#ifndef CSCD_SEPARATOR_FIELD_SEPARATOR_FINDER_H
#define CSCD_SEPARATOR_FIELD_SEPARATOR_FINDER_H

#include <CSCD/Separator/Field_search_settings.h>
#include <CSCD/Cut_locus/Cut_locus_indicators.h>
#include <CSCD/Cut_locus/Point_derivatives.h>
#include <CSCD/Cut_locus/Tangent_frames.h>
#include <CSCD/Geodesic/Heat_method.h>
#include <CSCD/Geodesic/Tufted_cover.h>
#include <CSCD/Separator/Cut_loop_finder.h>
#include <CSCD/Separator/Edge_flip_shortening.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/Separator_shortening.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Intrinsic_triangulation.h>
#include <CSCD/Surface/Point_complex.h>
#include <CSCD/Surface/Point_neighborhoods.h>
#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <CGAL/assertions.h>

#include <optional>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The result of the search for the separator of one source.
struct Field_search_result
{
  /// `found`, or why no loop was.
  Cut_loop_outcome outcome = Cut_loop_outcome::no_cut_point;
  /// Of the loop, if one was found; `collapsed` leaves no separator.
  Shortening_outcome shortening = Shortening_outcome::collapsed;
  Separator separator;

  bool has_separator() const
  {
    return outcome == Cut_loop_outcome::found && shortening != Shortening_outcome::collapsed;
  }
};

/// The published way from a distance field to a separator (Alg. 3): cut points by the thresholds of Laplacian and
/// gradient angle, the target, two ways back from it, and shortening within the locality ball. One object serves one
/// thread; it keeps working memory of the size of the surface.
/// \tparam Measures `Cut_locus_indicators` of a triangulation, or `Point_cut_locus_indicators`
/// \tparam Shortening has the member `shorten_vertex_loop(vertices, source, separator)`
template <class Measures, class Shortening>
class Field_separator_finder
{
public:
  /// What measures are made of, prepared once for a surface.
  using Basis = typename Measures::Basis;

  /// \param basis is referred to, as \param points, the positions of the vertices
  /// \param target_rule which cut point is the target
  /// \param shortening_arguments what the shortening is constructed of
  template <class... Arguments>
  Field_separator_finder(const Basis& basis, const std::vector<Vector_3>& points, Target_rule target_rule,
                         Arguments&&... shortening_arguments)
      : m_basis(basis), m_target_rule(target_rule), m_loop_finder(Measures::frames_of(basis), points),
        m_shortening(std::forward<Arguments>(shortening_arguments)...)
  {
  }

  /// Seeks the separator of `source`, from which `distances` are those of all vertices. O(n) for n vertices, though
  /// most of the work is that of the loop.
  void operator()(Index source, const std::vector<double>& distances, Field_search_result& result)
  {
    const Measures measures(m_basis, distances);
    m_loop_finder(measures, source, Measures::default_criterion(), m_target_rule, m_loop);
    result.outcome = m_loop.outcome;
    if (m_loop.outcome == Cut_loop_outcome::found) {
      result.separator.source = source;
      result.separator.level = 0;
      result.shortening = m_shortening.shorten_vertex_loop(m_loop_finder.vertices(m_loop), source, result.separator);
    }
  }

private:
  const Basis& m_basis;
  Target_rule m_target_rule;
  Cut_loop_finder<Measures> m_loop_finder;
  Shortening m_shortening;
  Cut_loop m_loop;
};

/// How distances on a `Surface` are estimated, and separators found from them: prepared once, shared by all threads.
/// A specialization has the type `Finder`, whose objects are called as `Field_separator_finder` is, the constant
/// `default_shortening_rule`, and the members of that for meshes.
template <class Surface>
class Field_search_space;

/// Meshes: the heat method on the intrinsic Delaunay triangulation, and loops along the edges of the mesh.
template <>
class Field_search_space<Triangulated_surface>
{
public:
  using Finder = Field_separator_finder<Cut_locus_indicators<Triangulated_surface>, Separator_shortening>;


  /// \param surface is referred to and must outlive this object
  Field_search_space(const Triangulated_surface& surface, const Field_search_settings& settings)
      : m_surface(surface), m_target_rule(settings.target_rule), m_frames(surface),
        m_heat_method(make_intrinsic_delaunay(surface))
  {
    if (settings.shortening_rule == Shortening_rule::variational) {
      m_queries.emplace(surface);
    }
  }
  Field_search_space(Triangulated_surface&&, const Field_search_settings&) = delete;

  const Heat_method& heat_method() const { return m_heat_method; }

  /// Makes a finder, which refers to this object.
  Finder make_finder() const
  {
    return Finder(m_frames, m_surface.points(), m_target_rule, m_surface, m_queries ? &*m_queries : nullptr);
  }

private:
  const Triangulated_surface& m_surface;
  Target_rule m_target_rule;
  Tangent_frames<Triangulated_surface> m_frames;
  Heat_method m_heat_method;
  std::optional<Solid_queries> m_queries; ///< for the variational shortening
};

/// Point clouds: the heat method on the intrinsic Delaunay triangulation of the tufted cover, loops along the edges of
/// the complex, and the variational flow.
template <>
class Field_search_space<Point_complex>
{
public:
  using Finder = Field_separator_finder<Point_cut_locus_indicators, Point_separator_shortening>;


  /// \param complex is referred to and must outlive this object
  /// \pre `settings.shortening_rule` is not `edge_flips`: points have no edges to be flipped
  Field_search_space(const Point_complex& complex, const Field_search_settings& settings)
      : m_complex(complex), m_target_rule(settings.target_rule), m_frames(complex), m_heat_method(make_intrinsic_delaunay(Tufted_cover(complex))),
        m_derivatives(m_frames, m_heat_method.operators().elements), m_neighborhoods(complex)
  {
    CGAL_precondition(settings.shortening_rule != Shortening_rule::edge_flips);
  }
  Field_search_space(Point_complex&&, const Field_search_settings&) = delete;

  const Heat_method& heat_method() const { return m_heat_method; }

  /// Makes a finder, which refers to this object.
  Finder make_finder() const
  {
    return Finder(m_derivatives, m_complex.points(), m_target_rule, m_complex, m_neighborhoods);
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
