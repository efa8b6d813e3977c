// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The default algorithms of the pipeline's stages.

#ifndef CSCD_LOCAL_POLICIES_H
#define CSCD_LOCAL_POLICIES_H

#include <CSCD/Selection/Covering_search.h>
#include <CSCD/Selection/Search_settings.h>
#include <CSCD/Selection/Separator_cost.h>
#include <CSCD/Selection/Separator_packing.h>
#include <CSCD/Selection/cut_handles.h>
#include <CSCD/Separator/Local_separator_finder.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeleton/build_cut_graph_skeleton.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/concepts.h>

#include <utility>
#include <vector>

namespace CSCD {

/// The local policies: a separator is sought on the surface around its source alone, sources cover the surface, and
/// the surface is cut along the packed separators. The default model of `SkeletonizationPolicies`.
/// \tparam Traits a model of `TriangulatedSolidSkeletonizationTraits`
/// \tparam SeparatorCost a model of `SeparatorCost`
/// \tparam SeparatorFinder a model of `SeparatorFinder` that can be made of a `Traits` object
template <class Traits, class SeparatorCost = Length_and_planarity_cost,
          class SeparatorFinder = Local_separator_finder<Traits>>
class Local_policies
{
public:
  /// The packed separators, and the surface cut along them.
  using Packing = internal::Separator_packing;

  /// Prepares with the default weight of separators.
  Local_policies() : Local_policies(SeparatorCost()) {}
  /// \param weight of two separators that overlap, the one of lesser weight is packed
  explicit Local_policies(SeparatorCost weight) : m_weight(std::move(weight))
  {
    check_triangulated_solid_skeletonization_traits<Traits>();
    check_separator_cost<SeparatorCost>();
    check_separator_finder<SeparatorFinder, Traits>();
  }

  /// Seeks separators until they cover the surface, or the bound of `settings` on the number of sources is reached.
  template <class ConcurrencyTag, class Progress>
  std::vector<Separator> find_separators(const Traits& traits, const Search_settings& settings,
                                         Skeletonization_report& report, const Progress& progress) const
  {
    internal::Covering_search<ConcurrencyTag, Traits, SeparatorFinder> search(traits, settings);
    return search(m_weight, report, progress);
  }

  /// Appends separators to `separators` around handles that no source has found.
  Packing pack_separators(const Traits& traits, std::vector<Separator>& separators,
                          Skeletonization_report& report) const
  {
    Packing packing(traits.levels().finest().surface, separators, internal::separator_costs(separators, m_weight));
    report.number_of_handle_cuts = internal::cut_handles(traits, separators, packing);
    return packing;
  }

  /// Builds the skeleton of the cut graph.
  Embedded_skeleton build_skeleton(const Traits& traits, const std::vector<Separator>& separators,
                                   const Packing& packing, Skeletonization_report& report) const
  {
    return internal::build_cut_graph_skeleton(traits, separators, packing, report);
  }

private:
  SeparatorCost m_weight;
};

} // namespace CSCD

#endif // CSCD_LOCAL_POLICIES_H
