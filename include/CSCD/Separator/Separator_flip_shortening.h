// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes a separator of a closed curve along edges, by edge flips.

#ifndef CSCD_SEPARATOR_SEPARATOR_FLIP_SHORTENING_H
#define CSCD_SEPARATOR_SEPARATOR_FLIP_SHORTENING_H

#include <CSCD/Separator/Edge_flip_shortening.h>
#include <CSCD/Separator/Locality_ball.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/Shortening_outcome.h>
#include <CSCD/Separator/Surface_path.h>
#include <CSCD/Separator/Vertex_loop.h>
#include <CSCD/Separator/curve_measures.h>
#include <CSCD/Separator/push_off_vertices.h>
#include <CSCD/Traits/Edge_crossing.h>
#include <CSCD/Traits/Triangulated_surface.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

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

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_SEPARATOR_FLIP_SHORTENING_H
