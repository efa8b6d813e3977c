// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Seeks separators until the surface is covered by them, and then looks closer where they leave much of it.

#ifndef CSCD_LOCAL_COVERING_SEARCH_H
#define CSCD_LOCAL_COVERING_SEARCH_H

#include <CSCD/Local/Coverage.h>
#include <CSCD/Local/Local_separator_finder.h>
#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Packing/Separator_cost.h>
#include <CSCD/Packing/Separator_packing.h>
#include <CSCD/Packing/Spurious_branches.h>
#include <CSCD/Packing/Surface_regions.h>
#include <CSCD/Separator/Detail.h>
#include <CSCD/Separator/Search_settings.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/for_each_index.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Takes sources in batches of fixed size. The separators of a batch are found independently, from what was known
/// before the batch, and taken over in the order of the sources; a source that a separator before it in the batch
/// covers is dropped, so that it does not matter whether its separator was computed. The answer is that of a single
/// thread.
class Separator_search
{
public:
  /// \param solid is referred to
  Separator_search(const Triangulated_solid& solid, const Detail& detail, const Search_settings& settings)
      : m_solid(solid), m_coverage(solid.levels()), m_sources(solid.levels(), settings.random_seed),
        m_failure_radius([radius = Coverage_band::max_failure_radius(solid.levels())](Index) { return radius; }),
        m_for_each(
            [&solid, min_area_ratio = detail.min_loop_area_ratio()] {
              return Worker{Local_separator_finder(solid.levels(), min_area_ratio,
                                                   [&solid](Index vertex) { return solid.side_of_sheet(vertex); }),
                            Coverage_band(solid.levels())};
            },
            settings.number_of_threads)
  {
  }

  /// Seeks separators until the surface is covered or `max_sources` have been tried; appends them to `separators` and
  /// counts in `report`. `progress(fraction)` is called after each batch and may throw.
  void operator()(std::size_t max_sources, std::vector<Separator>& separators, Skeletonization_report& report,
                  const Progress& progress)
  {
    report.number_of_threads = m_for_each.number_of_threads();
    while (report.number_of_sources < max_sources) {
      m_sources.next_batch(m_coverage, std::min(batch_size, max_sources - report.number_of_sources), m_batch);
      if (m_batch.empty()) {
        return;
      }
      search_batch(separators, report);
      progress(m_sources.progress());
    }
  }

  /// Lets the search go on among the vertices of the finest level for which `is_wanted(vertex)` holds, which count as
  /// covered only when `factor` times as many separators pass them. From now on, a source without a cut point covers
  /// what is at most `failure_radius(source)` away from it; this is called by several threads at once.
  template <class Predicate>
  void explore(const Predicate& is_wanted, unsigned factor, std::function<float(Index)> failure_radius)
  {
    m_coverage.require_more(factor);
    m_sources.restart(is_wanted);
    m_failure_radius = std::move(failure_radius);
  }

private:
  /// Sources in a batch: enough for a few threads, while the share of dropped ones stays below a tenth.
  static constexpr std::size_t batch_size = 16;

  /// What one thread works with.
  struct Worker
  {
    Local_separator_finder finder;
    Coverage_band band;
  };

  void search_batch(std::vector<Separator>& separators, Skeletonization_report& report)
  {
    std::array<Index, batch_size> hints{};
    for (std::size_t i = 0; i < m_batch.size(); ++i) {
      hints[i] = m_coverage.level_hint(m_batch[i]);
    }
    const auto search = [&](Index i, Worker& worker) {
      worker.finder(m_batch[i], hints[i], m_results[i]);
      if (m_solid.number_of_sheets() > 0) {
        mark_open(m_solid, m_results[i].separator);
      }
      worker.band(m_batch[i], m_results[i], m_failure_radius(m_batch[i]), m_bands[i]);
    };
    const auto take = [&](Index i) { take_result(i, separators, report); };
    const auto size = Index(m_batch.size());
    if (m_for_each.number_of_threads() == 1) {
      // What is dropped need not be computed.
      m_for_each(size, [&](Index i, Worker& worker) {
        if (!m_coverage.is_covered(m_batch[i])) {
          search(i, worker);
          take(i);
        }
      });
      return;
    }
    m_for_each(size, search);
    for (Index i = 0; i < size; ++i) {
      if (!m_coverage.is_covered(m_batch[i])) {
        take(i);
      }
    }
  }

  void take_result(Index i, std::vector<Separator>& separators, Skeletonization_report& report)
  {
    const Search_result& result = m_results[i];
    m_coverage.add(m_batch[i], result, m_bands[i]);
    ++report.number_of_sources;
    switch (result.outcome) {
    case Search_outcome::found:
      ++(result.is_section ? report.number_of_plane_sections : report.number_of_straightened_loops);
      separators.push_back(result.separator);
      break;
    case Search_outcome::bump:
      ++report.number_of_bumps;
      break;
    case Search_outcome::no_cut:
    case Search_outcome::degenerate:
      ++report.number_of_sources_without_cut;
      break;
    }
  }

  const Triangulated_solid& m_solid;
  Coverage m_coverage;
  Source_sequence m_sources;
  std::function<float(Index)> m_failure_radius;
  For_each_index<Worker> m_for_each;
  std::vector<Index> m_batch;
  std::array<Search_result, batch_size> m_results;
  std::array<std::vector<Index>, batch_size> m_bands;
};

/// Seeks separators from sources all over the surface until it is covered by them, packs them for trial, and looks
/// closer at the ends of limbs and where limbs meet. Small limbs that grow from there, as toes from a foot, are easily
/// missed at first.
class Covering_search
{
public:
  /// \param solid is referred to \param detail how small a limb may be
  Covering_search(const Triangulated_solid& solid, const Detail& detail, const Search_settings& settings)
      : m_levels(solid.levels()), m_min_branch_area_ratio(detail.min_branch_area_ratio()),
        m_max_sources(settings.maximum_number_of_sources), m_search(solid, detail, settings)
  {
  }
  Covering_search(Covering_search&&) = delete; // the search calls back

  /// Finds separators and counts in `report`; `progress(fraction)` is called often and may throw.
  std::vector<Separator> operator()(Skeletonization_report& report, const Progress& progress)
  {
    std::vector<Separator> separators;
    m_search(m_max_sources, separators, report, [&](double fraction) { progress(first_pass_share * fraction); });
    explore_ends(separators, separator_costs(separators));
    m_search(m_max_sources, separators, report,
             [&](double fraction) { progress(first_pass_share + (1 - first_pass_share) * fraction); });
    return separators;
  }

private:
  /// The part of the search that its first pass is, for the progress.
  static constexpr double first_pass_share = 0.75;
  /// Surface farther than this from the nearest packed separator is explored again, relative to the separator's radius.
  static constexpr double unexplored_distance = 0.6;
  /// The factor by which more separators are sought there.
  static constexpr unsigned exploration_factor = 3;
  /// How far a source without a cut point covers the surface there, relative to its distance from the nearest packed
  /// separator: limbs that grow from an end, as toes from a foot, are much thinner than the end is long. From 0.1 to
  /// 0.4, tips on 100 poses of people were the same but for a few; the fewest sources are tried with the largest.
  static constexpr float failure_radius_per_distance = 0.3F;

  /// The separators that would be packed so far, less those of bumps.
  std::vector<Index> pack_for_trial(const std::vector<Separator>& separators, const std::vector<double>& costs) const
  {
    const Triangulated_surface& surface = m_levels.finest().surface;
    Disjoint_separators disjoint(surface, separators, costs);
    disjoint.pack([](Index) { return true; });
    Cut_graph cut_graph(surface, disjoint.arrangement());
    cut_graph.cut(disjoint.arrangement());
    const Spurious_branches bumps(cut_graph, separators, disjoint.packed(), m_min_branch_area_ratio);
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
  void explore_ends(const std::vector<Separator>& separators, const std::vector<double>& costs)
  {
    const std::vector<Index> packed = pack_for_trial(separators, costs);
    m_regions.emplace(m_levels, separators, packed, Surface_regions::rough_size);
    m_search.explore(
        [&](Index vertex) {
          const Index separator = m_regions->separator(m_regions->level().from_finest(vertex));
          return separator != no_index &&
                 double(distance_from_packed(vertex)) > unexplored_distance * separators[packed[separator]].radius();
        },
        exploration_factor,
        [this, max_radius = Coverage_band::max_failure_radius(m_levels)](Index vertex) {
          return std::min(max_radius, failure_radius_per_distance * distance_from_packed(vertex));
        });
  }

  /// The distance of a vertex of the finest level from the nearest separator packed for trial, infinite where there is
  /// none.
  float distance_from_packed(Index vertex) const { return m_regions->distance(m_regions->level().from_finest(vertex)); }

  const Surface_levels& m_levels;
  double m_min_branch_area_ratio;
  std::size_t m_max_sources;
  Separator_search m_search;
  std::optional<Surface_regions> m_regions; ///< of the separators packed for trial
};

} // namespace CSCD::internal

#endif // CSCD_LOCAL_COVERING_SEARCH_H
