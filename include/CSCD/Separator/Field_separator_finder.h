// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the separator of a source from its distance field over the whole surface.

#ifndef CSCD_SEPARATOR_FIELD_SEPARATOR_FINDER_H
#define CSCD_SEPARATOR_FIELD_SEPARATOR_FINDER_H

#include <CSCD/Cut_locus/Cut_measures.h>
#include <CSCD/Cut_locus/Tangent_frames.h>
#include <CSCD/Separator/Cut_loop.h>
#include <CSCD/Separator/Cut_loop_finder.h>
#include <CSCD/Separator/Edge_flip_shortening.h>
#include <CSCD/Separator/Edge_step.h>
#include <CSCD/Separator/Locality_ball.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/Surface_path.h>
#include <CSCD/Separator/curve_measures.h>
#include <CSCD/Separator/push_off_vertices.h>
#include <CSCD/Traits/Triangulated_surface.h>
#include <CSCD/internal/Vector_3.h>

#include <vector>

namespace CSCD::internal {

/// How the search for the separator of one source ended.
enum class Field_search_outcome
{
  found,     ///< a separator was found
  no_target, ///< no cut point was accepted as target
  collapsed, ///< the loop shrank to a point when it was shortened
  degenerate ///< the shortened loop is no curve of enough edges
};

/// The result of the search for the separator of one source.
struct Field_search_result
{
  Field_search_outcome outcome = Field_search_outcome::no_target;
  Separator separator; ///< where one was found
};

/// The published way from a distance field to a separator (Alg. 3): cut points by the thresholds of Laplacian and
/// gradient angle, the target, two ways back from it, shortening by edge flips within the locality ball. One object
/// serves one thread; it keeps working memory of the size of the surface.
class Field_separator_finder
{
public:
  /// \param frames those of `surface`; both are referred to
  Field_separator_finder(const Triangulated_surface& surface, const Tangent_frames<Triangulated_surface>& frames,
                         Target_rule target_rule)
      : m_surface(surface), m_frames(frames), m_target_rule(target_rule), m_loop_finder(frames, surface.points()),
        m_shortening(surface)
  {
  }

  /// Seeks the separator of `source`, which is at distance 0 of the vertices' `distances`. O(n) for n vertices, though
  /// most of the work is that of the loop.
  void operator()(Index source, const std::vector<double>& distances, Field_search_result& result)
  {
    const Cut_measures<Triangulated_surface> measures(m_frames, distances);
    m_loop_finder(measures, source, Cut_criterion(), m_target_rule, m_loop);
    result.outcome =
        m_loop.outcome == Cut_loop_outcome::found ? shorten(source, result.separator) : Field_search_outcome::no_target;
  }

private:
  /// A loop of fewer edges encloses nothing.
  static constexpr std::size_t least_loop_size = 3;

  Field_search_outcome shorten(Index source, Separator& separator)
  {
    m_halfedges.clear();
    for (const Edge_step& step : m_loop.steps) {
      m_halfedges.push_back(step.is_reversed ? m_surface.twin(step.halfedge) : step.halfedge);
    }
    const Locality_ball is_outside(m_surface, m_surface.point(source), m_halfedges);
    if (m_shortening(m_halfedges, true, is_outside, m_path) == Shortening_outcome::collapsed) {
      return Field_search_outcome::collapsed;
    }
    if (!push_off_vertices(m_surface, m_path, separator.crossings) || separator.crossings.size() < least_loop_size) {
      return Field_search_outcome::degenerate;
    }
    crossing_points(m_surface, separator.crossings, m_points);
    set_measures(separator, m_points);
    separator.source = source;
    separator.level = 0;
    return Field_search_outcome::found;
  }

  const Triangulated_surface& m_surface;
  const Tangent_frames<Triangulated_surface>& m_frames;
  Target_rule m_target_rule;
  Cut_loop_finder<Triangulated_surface> m_loop_finder;
  Edge_flip_shortening<Triangulated_surface> m_shortening;
  Cut_loop m_loop;
  std::vector<Index> m_halfedges;
  Surface_path m_path;
  std::vector<Vector_3> m_points;
};

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_FIELD_SEPARATOR_FINDER_H
