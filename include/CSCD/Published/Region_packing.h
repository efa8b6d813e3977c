// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From many separators to few, as published, and the regions that belong to them.

#ifndef CSCD_PUBLISHED_REGION_PACKING_H
#define CSCD_PUBLISHED_REGION_PACKING_H

#include <CSCD/Points/Point_complex.h>
#include <CSCD/Published/Balance_and_roundness.h>
#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Published/Separator_overlaps.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Dijkstra_search.h>
#include <CSCD/internal/Disjoint_sets.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <type_traits>
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
  /// \param rule with `nearest_vertex`, separators start from the vertices that they pass closest to; with `crossing`,
  ///        from both ends of each crossed edge, at their distances: a region can then have no vertex, or not be
  ///        connected
  /// \pre no two of the packed separators overlap by `rule`
  template <class Surface>
  Separator_regions(const Surface& surface, const std::vector<Separator>& separators, const std::vector<Index>& packed,
                    Overlap_rule rule = Overlap_rule::nearest_vertex)
      : m_front(surface.number_of_vertices()), m_size(Index(packed.size()))
  {
    const auto for_each_neighbor = [&surface](Index vertex, const auto& visit) {
      for (const Index halfedge : surface.outgoing(vertex)) {
        visit(surface.target(halfedge), float(surface.length(halfedge)));
      }
    };
    for (Index i = 0; i < packed.size(); ++i) {
      for (const Edge_crossing& crossing : separators[packed[i]].crossings) {
        if (rule == Overlap_rule::nearest_vertex) {
          m_front.reach(nearest_vertex(surface, crossing), 0, i);
        } else {
          const auto length = float(surface.length(crossing.halfedge));
          m_front.reach(surface.origin(crossing.halfedge), float(crossing.position) * length, i);
          m_front.reach(surface.target(crossing.halfedge), float(1 - crossing.position) * length, i);
        }
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
  /// The distance of `vertex` from its separator along the edges.
  float distance(Index vertex) const { return m_front.distance(vertex); }
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
  /// Weighs, prunes and packs `separators` by the rules of `settings`; counts in `report`.
  /// \tparam Surface a model of `SkeletonizationSurface`
  template <class Surface>
  Region_packing(const Surface& surface, const std::vector<Separator>& separators,
                 const Field_search_settings& settings, Skeletonization_report& report)
      : Region_packing(surface, separators, pack(surface, separators, settings, report), settings.overlap_rule)
  {
  }
  /// Packs those of `separators` at the positions `packed`, no two of which overlap by `rule`.
  template <class Surface>
  Region_packing(const Surface& surface, const std::vector<Separator>& separators, std::vector<Index> packed,
                 Overlap_rule rule = Overlap_rule::nearest_vertex)
      : m_packed(std::move(packed)), m_regions(surface.triangulation(), separators, m_packed, rule)
  {
  }

  /// The packed separators, as positions in the list of all separators, the first packed first.
  const std::vector<Index>& packed() const { return m_packed; }
  const Separator_regions& regions() const { return m_regions; }

private:
  template <class Surface>
  static std::vector<Index> pack(const Surface& surface, const std::vector<Separator>& separators,
                                 const Field_search_settings& settings, Skeletonization_report& report)
  {
    using Judge = Balance_and_roundness<Surface>;
    Judge judge(surface, settings.weight_rule);
    std::vector<double> weights(separators.size());
    report.number_of_bumps = 0;
    report.number_of_tunnels = 0;
    for (std::size_t i = 0; i < separators.size(); ++i) {
      const typename Judge::Verdict verdict = judge(separators[i], weights[i]);
      report.number_of_bumps += verdict == Judge::Verdict::bump ? 1 : 0;
      report.number_of_tunnels += verdict == Judge::Verdict::tunnel ? 1 : 0;
    }
    const auto& triangulation = surface.triangulation();
    if constexpr (!std::is_same_v<std::decay_t<decltype(triangulation)>, Point_complex>) {
      if (settings.overlap_rule == Overlap_rule::crossing) {
        const Separator_overlaps overlaps = Separator_overlaps::meeting(triangulation, separators);
        return resolved(triangulation, separators, pack_by_overlap(overlaps, weights));
      }
    }
    CGAL_precondition(settings.overlap_rule == Overlap_rule::nearest_vertex);
    return pack_by_overlap(Separator_overlaps(triangulation, separators), weights);
  }

  /// Those of `packed`, no two of which cross, that the vertices resolve. Where several run between the same vertices,
  /// the regions of the inner ones have no vertices or fall into pieces, which would make cycles: these are dropped.
  /// O(n log n) for n vertices, times the number of rounds until all regions are connected.
  template <class Triangulation>
  static std::vector<Index> resolved(const Triangulation& surface, const std::vector<Separator>& separators,
                                     std::vector<Index> packed)
  {
    std::vector<Index> kept;
    for (;;) {
      const Separator_regions regions(surface, separators, packed, Overlap_rule::crossing);
      const std::vector<Index> number_of_parts = count_parts(surface, regions);
      kept.clear();
      for (std::size_t i = 0; i < packed.size(); ++i) {
        if (number_of_parts[i] == 1) {
          kept.push_back(packed[i]);
        }
      }
      if (kept.size() == packed.size()) {
        return packed;
      }
      packed.swap(kept);
    }
  }

  /// For each region, into how many parts it falls that are connected by edges.
  template <class Triangulation>
  static std::vector<Index> count_parts(const Triangulation& surface, const Separator_regions& regions)
  {
    std::vector<Index> result(regions.size(), 0);
    Disjoint_sets parts(surface.number_of_vertices());
    for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
      ++result[regions[vertex]];
    }
    for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
      const Index region = regions[surface.origin(h)];
      if (region == regions[surface.target(h)] && parts.join(surface.origin(h), surface.target(h))) {
        --result[region];
      }
    }
    return result;
  }

  std::vector<Index> m_packed;
  Separator_regions m_regions;
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_REGION_PACKING_H
