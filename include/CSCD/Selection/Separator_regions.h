// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of the surface that belongs to each packed separator.

#ifndef CSCD_SELECTION_SEPARATOR_REGIONS_H
#define CSCD_SELECTION_SEPARATOR_REGIONS_H

#include <CSCD/Selection/Separator_overlaps.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Traits/Corner_table.h>
#include <CSCD/Traits/Surface_levels.h>
#include <CSCD/Traits/Triangulated_surface.h>
#include <CSCD/internal/Distance_front.h>
#include <CSCD/internal/Vector_3.h>

#include <vector>

namespace CSCD::internal {

/// Assigns every vertex to the packed separator that is nearest along the edges (Alg. 2, line 12). Each separator
/// starts from the ring of vertices that it passes closest to; so its region is connected and never empty. A component
/// of the surface without any separator is a region of its own.
class Separator_regions
{
public:
  /// Computes the regions of the separators `packed` of the list `separators`; O(n log n).
  /// \param level the finest level \pre no two of the packed separators overlap, as `Separator_overlaps` has it
  Separator_regions(const Surface_level& level, const std::vector<Separator>& separators,
                    const std::vector<Index>& packed)
      : m_region(level.surface.number_of_vertices(), no_index), m_size(Index(packed.size()))
  {
    Distance_front front(m_region.size());
    for (Index i = 0; i < packed.size(); ++i) {
      for (const Edge_crossing& crossing : separators[packed[i]].crossings) {
        reach(nearest_vertex(level.surface, crossing), 0, i, front);
      }
    }
    spread(level.corners, front);
    for (Index vertex = 0; vertex < m_region.size(); ++vertex) {
      if (m_region[vertex] == no_index) {
        reach(vertex, 0, m_size++, front);
        spread(level.corners, front);
      }
    }
  }

  /// The number of regions: first those of the packed separators, in their order, then those of components without any.
  Index size() const { return m_size; }
  /// The region of `vertex`.
  Index operator[](Index vertex) const { return m_region[vertex]; }

private:
  void reach(Index vertex, float distance, Index region, Distance_front& front)
  {
    if (front.reach(vertex, distance)) {
      m_region[vertex] = region;
    }
  }

  void spread(const Corner_table& corners, Distance_front& front)
  {
    front.spread([&](Index vertex, float distance) {
      for (const Corner& corner : corners.neighbors(vertex)) {
        reach(corner.neighbor, distance + corner.length, m_region[vertex], front);
      }
    });
  }

  std::vector<Index> m_region;
  Index m_size;
};

} // namespace CSCD::internal

#endif // CSCD_SELECTION_SEPARATOR_REGIONS_H
