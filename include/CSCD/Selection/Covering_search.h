// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Seeks separators until the surface is covered by them, and then looks closer where they leave much of it.

#ifndef CSCD_SELECTION_COVERING_SEARCH_H
#define CSCD_SELECTION_COVERING_SEARCH_H

#include <CSCD/Selection/Bump_branches.h>
#include <CSCD/Selection/Cut_graph.h>
#include <CSCD/Selection/Disjoint_separators.h>
#include <CSCD/Selection/Search_settings.h>
#include <CSCD/Selection/Separator_search.h>
#include <CSCD/Selection/Surface_regions.h>
#include <CSCD/Selection/weigh.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Traits/Surface_levels.h>
#include <CSCD/Traits/Triangulated_surface.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// Seeks separators from sources all over the surface until it is covered by them, packs them for trial, and looks
/// closer at the ends of limbs and where limbs meet. Small limbs that grow from there, as toes from a foot, are easily
/// missed at first.
/// \tparam Traits a model of `MultiresolutionSkeletonizationTraits`
/// \tparam Finder a model of `SeparatorFinder` that can be made of a `Traits` object
template <class ConcurrencyTag, class Traits, class Finder>
class Covering_search
{
public:
  Covering_search(const Traits& traits, const Search_settings& settings)
      : m_levels(traits.levels()), m_most_sources(settings.maximum_number_of_sources),
        m_search(traits.levels(), settings.random_seed, settings.number_of_threads,
                 [&traits] { return Finder(traits); })
  {
  }

  /// Finds separators and counts in `report`; `progress(fraction)` is called often and may throw.
  /// \param weight a model of `SeparatorWeight`
  template <class SeparatorWeight, class Progress>
  std::vector<Separator> operator()(const SeparatorWeight& weight, Skeletonization_report& report,
                                    const Progress& progress)
  {
    std::vector<Separator> separators;
    m_search(m_most_sources, separators, report, [&](double fraction) { progress(first_pass_share * fraction); });
    explore_ends(separators, weigh(separators, weight));
    m_search(m_most_sources, separators, report,
             [&](double fraction) { progress(first_pass_share + (1 - first_pass_share) * fraction); });
    return separators;
  }

private:
  /// The part of the search that its first pass is, for the progress.
  static constexpr double first_pass_share = 0.75;
  /// Surface farther than this from the nearest packed separator is explored again, relative to the separator's radius.
  static constexpr double unexplored_distance = 0.6;
  /// How many times as many separators are asked for there.
  static constexpr unsigned exploration_factor = 3;

  /// The separators that would be packed so far, less those of bumps.
  std::vector<Index> pack_for_trial(const std::vector<Separator>& separators, const std::vector<double>& weights) const
  {
    const Triangulated_surface& surface = m_levels.finest().surface;
    Disjoint_separators disjoint(surface, separators, weights);
    disjoint.pack([](Index) { return true; });
    Cut_graph cut_graph(surface, disjoint.arrangement());
    cut_graph.cut(disjoint.arrangement());
    const Bump_branches bumps(cut_graph, separators, disjoint.packed());
    std::vector<char> is_bump(separators.size(), 0);
    for (Index separator : bumps.separators()) {
      is_bump[separator] = 1;
    }
    std::vector<Index> packed = disjoint.packed();
    packed.erase(std::remove_if(packed.begin(), packed.end(), [&](Index separator) { return is_bump[separator] != 0; }),
                 packed.end());
    return packed;
  }

  /// Lets the search go on where the separators that would be packed so far leave much of the surface.
  void explore_ends(const std::vector<Separator>& separators, const std::vector<double>& weights)
  {
    const std::vector<Index> packed = pack_for_trial(separators, weights);
    const Surface_regions regions(m_levels, separators, packed, Surface_regions::rough_size);
    m_search.explore(
        [&](Index vertex) {
          const Index level_vertex = regions.level().from_finest(vertex);
          const Index separator = regions.separator(level_vertex);
          return separator != no_index &&
                 double(regions.distance(level_vertex)) > unexplored_distance * separators[packed[separator]].radius();
        },
        exploration_factor);
  }

  const Surface_levels& m_levels;
  std::size_t m_most_sources;
  Separator_search<ConcurrencyTag, Finder> m_search;
};

} // namespace CSCD::internal

#endif // CSCD_SELECTION_COVERING_SEARCH_H
