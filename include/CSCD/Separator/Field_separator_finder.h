// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the separator of a source from its distance field over the whole surface.

#ifndef CSCD_SEPARATOR_FIELD_SEPARATOR_FINDER_H
#define CSCD_SEPARATOR_FIELD_SEPARATOR_FINDER_H

#include <CSCD/Cut_locus/Cut_criterion.h>
#include <CSCD/Cut_locus/Cut_measures.h>
#include <CSCD/Cut_locus/Tangent_frames.h>
#include <CSCD/Separator/Cut_loop.h>
#include <CSCD/Separator/Cut_loop_finder.h>
#include <CSCD/Separator/Cut_loop_outcome.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/Separator_flip_shortening.h>
#include <CSCD/Separator/Separator_variational_shortening.h>
#include <CSCD/Separator/Shortening_outcome.h>
#include <CSCD/Separator/Target_rule.h>
#include <CSCD/Traits/Solid_queries.h>
#include <CSCD/Traits/Triangulated_surface.h>
#include <CSCD/internal/Vector_3.h>

#include <optional>
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
class Field_separator_finder
{
public:
  /// \param frames those of `surface`; both are referred to
  /// \param queries those of `surface`, for the variational shortening; null for shortening by edge flips
  Field_separator_finder(const Triangulated_surface& surface, const Tangent_frames<Triangulated_surface>& frames,
                         Target_rule target_rule, const Solid_queries* queries = nullptr)
      : m_frames(frames), m_target_rule(target_rule), m_loop_finder(frames, surface.points()), m_flips(surface)
  {
    if (queries != nullptr) {
      m_flow.emplace(surface, *queries);
    }
  }

  /// Seeks the separator of `source`, from which `distances` are those of all vertices. O(n) for n vertices, though
  /// most of the work is that of the loop.
  void operator()(Index source, const std::vector<double>& distances, Field_search_result& result)
  {
    const Cut_measures<Triangulated_surface> measures(m_frames, distances);
    m_loop_finder(measures, source, Cut_criterion(), m_target_rule, m_loop);
    result.outcome = m_loop.outcome;
    if (m_loop.outcome == Cut_loop_outcome::found) {
      result.separator.source = source;
      result.separator.level = 0;
      const std::vector<Index> vertices = m_loop_finder.vertices(m_loop);
      result.shortening = m_flow ? m_flow->shorten_vertex_loop(vertices, source, result.separator)
                                 : m_flips.shorten_vertex_loop(vertices, source, result.separator);
    }
  }

private:
  const Tangent_frames<Triangulated_surface>& m_frames;
  Target_rule m_target_rule;
  Cut_loop_finder<Cut_measures<Triangulated_surface>> m_loop_finder;
  Separator_flip_shortening m_flips;
  std::optional<Separator_variational_shortening> m_flow;
  Cut_loop m_loop;
};

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_FIELD_SEPARATOR_FINDER_H
