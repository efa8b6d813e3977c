// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From many separators to few, as published, and the regions that belong to them.

#ifndef CSCD_SELECTION_REGION_PACKING_H
#define CSCD_SELECTION_REGION_PACKING_H

#include <CSCD/Selection/Balance_and_roundness.h>
#include <CSCD/Selection/Separator_overlaps.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Dijkstra_search.h>

#include <cstddef>
#include <utility>
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
  /// Whether a separator passes closest to `vertex`.
  bool is_on_separator(Index vertex) const { return m_front.distance(vertex) == 0; }

private:
  Multi_source_dijkstra_search m_front;
  Index m_size;
};

/// Packed separators, and the regions of the surface that are nearest to them.
class Region_packing
{
public:
  /// Weighs, prunes and packs `separators`; counts in `report`.
  /// \tparam Surface a model of `SkeletonizationSurface`
  template <class Surface>
  Region_packing(const Surface& surface, const std::vector<Separator>& separators, Skeletonization_report& report)
      : Region_packing(surface, separators, pack(surface, separators, report))
  {
  }
  /// Packs those of `separators` at the positions `packed`, no two of which overlap.
  template <class Surface>
  Region_packing(const Surface& surface, const std::vector<Separator>& separators, std::vector<Index> packed)
      : m_packed(std::move(packed)), m_regions(surface.triangulation(), separators, m_packed)
  {
  }

  /// The packed separators, as positions in the list of all separators, the first packed first.
  const std::vector<Index>& packed() const { return m_packed; }
  const Separator_regions& regions() const { return m_regions; }

private:
  template <class Surface>
  static std::vector<Index> pack(const Surface& surface, const std::vector<Separator>& separators,
                                 Skeletonization_report& report)
  {
    using Judge = Balance_and_roundness<Surface>;
    Judge judge(surface);
    std::vector<double> weights(separators.size());
    report.number_of_bumps = 0;
    report.number_of_tunnels = 0;
    for (std::size_t i = 0; i < separators.size(); ++i) {
      const typename Judge::Verdict verdict = judge(separators[i], weights[i]);
      report.number_of_bumps += verdict == Judge::Verdict::bump ? 1 : 0;
      report.number_of_tunnels += verdict == Judge::Verdict::tunnel ? 1 : 0;
    }
    return pack_by_overlap(Separator_overlaps(surface.triangulation(), separators), weights);
  }

  std::vector<Index> m_packed;
  Separator_regions m_regions;
};

} // namespace CSCD::internal

#endif // CSCD_SELECTION_REGION_PACKING_H
