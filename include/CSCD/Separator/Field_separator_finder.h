// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the separator of a source from its distance field over the whole surface.

#ifndef CSCD_SEPARATOR_FIELD_SEPARATOR_FINDER_H
#define CSCD_SEPARATOR_FIELD_SEPARATOR_FINDER_H

#include <CSCD/Separator/Cut_loop.h>
#include <CSCD/Separator/Cut_loop_finder.h>
#include <CSCD/Separator/Cut_loop_outcome.h>
#include <CSCD/Separator/Field_search_result.h>
#include <CSCD/Separator/Target_rule.h>
#include <CSCD/internal/Vector_3.h>

#include <utility>
#include <vector>

namespace CSCD::internal {

/// The published way from a distance field to a separator (Alg. 3): cut points by the thresholds of Laplacian and
/// gradient angle, the target, two ways back from it, and shortening within the locality ball. One object serves one
/// thread; it keeps working memory of the size of the surface.
/// \tparam Measures `Cut_measures` of a triangulation, or `Point_cut_measures`
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

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_FIELD_SEPARATOR_FINDER_H
