// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of the surface that is nearest to each packed separator.

#ifndef CSCD_PACKING_SURFACE_REGIONS_H
#define CSCD_PACKING_SURFACE_REGIONS_H

#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Dijkstra_search.h>

#include <vector>

namespace CSCD::internal {

/// Assigns every vertex to the separator that is nearest along the edges (Dijkstra from all separators at once).
/// Runs on a level on which separators are several vertices apart.
class Surface_regions
{
public:
  /// The size of the level that is precise enough to decide what is nearest.
  static constexpr Index rough_size = 16000;

  /// Computes the regions of the separators `packed` of the list `separators`, on the finest level of at most
  /// `max_vertices` vertices; O(n log n) there.
  Surface_regions(const Surface_levels& levels, const std::vector<Separator>& separators,
                  const std::vector<Index>& packed, Index max_vertices)
      : m_finest(levels.finest()), m_level(levels[levels.finest_with_at_most(max_vertices)]),
        m_front(m_level.surface.number_of_vertices())
  {
    for (Index i = 0; i < packed.size(); ++i) {
      for (const Edge_crossing& crossing : separators[packed[i]].crossings) {
        const Vector_3 point = (1 - crossing.position) * position(m_finest.surface.origin(crossing.halfedge)) +
                               crossing.position * position(m_finest.surface.target(crossing.halfedge));
        reach_from(point, m_finest.surface.origin(crossing.halfedge), i);
        reach_from(point, m_finest.surface.target(crossing.halfedge), i);
      }
    }
    const Vertex_fan_table& corners = m_level.corners();
    m_front.spread([&corners](Index vertex, const auto& visit) {
      for (const Corner& corner : corners.neighbors(vertex)) {
        if (visit(corner.neighbor, corner.length)) {
          corners.prefetch(corner.neighbor);
        }
      }
    });
  }

  /// The level that the regions live on.
  const Surface_level& level() const { return m_level; }
  /// The position of the packed separator nearest to a vertex of `level()`; `no_index` where a component has none.
  Index separator(Index vertex) const { return m_front.label(vertex); }
  /// The distance from it, infinite where there is none.
  float distance(Index vertex) const { return m_front.distance(vertex); }

private:
  const Vector_3& position(Index finest_vertex) const { return m_finest.surface.point(finest_vertex); }

  void reach_from(const Vector_3& point, Index finest_vertex, Index separator)
  {
    const Index vertex = m_level.from_finest(finest_vertex);
    if (m_front.reach(vertex, float((m_level.surface.point(vertex) - point).norm()), separator)) {
      m_level.corners().prefetch(vertex);
    }
  }

  const Surface_level& m_finest;
  const Surface_level& m_level;
  Multi_source_dijkstra_search m_front;
};

} // namespace CSCD::internal

#endif // CSCD_PACKING_SURFACE_REGIONS_H
