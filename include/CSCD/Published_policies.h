// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The algorithms of the pipeline as published.

#ifndef CSCD_PUBLISHED_POLICIES_H
#define CSCD_PUBLISHED_POLICIES_H

#include <CSCD/Selection/Region_packing.h>
#include <CSCD/Selection/Sampled_search.h>
#include <CSCD/Selection/Search_settings.h>
#include <CSCD/Separator/Cut_loop_finder.h>
#include <CSCD/Separator/Field_separator_finder.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/Separator_shortening.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeleton/build_quotient_skeleton.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/concepts.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD {

/// The method as published, CSCD-M: distances by the heat method on the intrinsic Delaunay triangulation, the cut locus
/// from the whole distance field, shortening by edge flips or the variational flow, random sources, the quotient graph
/// of regions. A model of `SkeletonizationPolicies`. Slower than `Local_policies` by an order of magnitude; its time
/// grows with the number of sources times that of vertices. \tparam Traits a model of `SolidSkeletonizationTraits`, for
/// the surface of which there is an `internal::Field_search_space`
template <class Traits>
class Published_policies
{
public:
  /// The packed separators, and the regions of the surface around them.
  using Packing = internal::Region_packing;

  /// The number of sources of the published experiments.
  static constexpr std::size_t default_number_of_sources = 3000;
  /// Edge flips on meshes, the variational flow among points.
  static constexpr Shortening_rule default_shortening_rule = internal::Field_search_space<
      std::decay_t<decltype(std::declval<const Traits&>().surface())>>::default_shortening_rule;

  /// \param target_rule which cut point is the target of a source
  /// \param shortening_rule how the loop through it is shortened
  explicit Published_policies(Target_rule target_rule = Target_rule::nearest_in_space,
                              Shortening_rule shortening_rule = default_shortening_rule)
      : m_target_rule(target_rule), m_shortening_rule(shortening_rule)
  {
    check_solid_skeletonization_traits<Traits>();
  }

  /// Draws `settings.maximum_number_of_sources` sources, or `default_number_of_sources` where that has no bound.
  template <class ConcurrencyTag, class Progress>
  std::vector<Separator> find_separators(const Traits& traits, const Search_settings& settings,
                                         Skeletonization_report& report, const Progress& progress) const
  {
    internal::Sampled_search<ConcurrencyTag, Traits> search(traits, settings, m_target_rule, m_shortening_rule);
    const bool is_bounded = settings.maximum_number_of_sources != Search_settings().maximum_number_of_sources;
    return search(is_bounded ? settings.maximum_number_of_sources : default_number_of_sources, report, progress);
  }

  /// Drops separators by weight, inside test and overlap, and gives each vertex to the nearest that remains.
  Packing pack_separators(const Traits& traits, const std::vector<Separator>& separators,
                          Skeletonization_report& report) const
  {
    return Packing(traits, separators, report);
  }

  /// Builds the skeleton of the quotient graph: a node for each region, an edge where two regions touch.
  Embedded_skeleton build_skeleton(const Traits& traits, const std::vector<Separator>& /* separators */,
                                   const Packing& packing, Skeletonization_report& report) const
  {
    return internal::Quotient_skeleton_builder<Traits>(traits, packing.regions())(report);
  }

private:
  Target_rule m_target_rule;
  Shortening_rule m_shortening_rule;
};

} // namespace CSCD

#endif // CSCD_PUBLISHED_POLICIES_H
