// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of the surface that belongs to each packed separator.

#ifndef CSCD_SELECTION_SEPARATOR_REGIONS_H
#define CSCD_SELECTION_SEPARATOR_REGIONS_H

#include <CSCD/Selection/Separator_overlaps.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Traits/Edge_crossing.h>
#include <CSCD/internal/Labeled_front.h>
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
  /// \param surface whose edges the separators cross
  /// \pre no two of the packed separators overlap, as `Separator_overlaps` has it
  template <class Surface>
  Separator_regions(const Surface& surface, const std::vector<Separator>& separators, const std::vector<Index>& packed)
      : m_front(surface.number_of_vertices()), m_size(Index(packed.size()))
  {
    const auto for_each_neighbor = [&surface](Index vertex, const auto& visit) {
      for (const Index halfedge : surface.outgoing(vertex)) {
        visit(surface.target(halfedge), float(surface.length(halfedge)));
      }
    };
    for (Index i = 0; i < packed.size(); ++i) {
      for (const Edge_crossing& crossing : separators[packed[i]].crossings) {
        m_front.reach(nearest_vertex(surface, crossing), 0, i);
      }
    }
    m_front.spread(for_each_neighbor);
    for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
      if (m_front.label(vertex) == no_index) {
        m_front.reach(vertex, 0, m_size++);
        m_front.spread(for_each_neighbor);
      }
    }
  }

  /// The number of regions: first those of the packed separators, in their order, then those of components without any.
  Index size() const { return m_size; }
  /// The region of `vertex`.
  Index operator[](Index vertex) const { return m_front.label(vertex); }

private:
  Labeled_front m_front;
  Index m_size;
};

} // namespace CSCD::internal

#endif // CSCD_SELECTION_SEPARATOR_REGIONS_H
