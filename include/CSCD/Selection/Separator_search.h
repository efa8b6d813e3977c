// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Seeks separators from sources all over the surface, in parallel, with an answer that does not depend on threads.

#ifndef CSCD_SELECTION_SEPARATOR_SEARCH_H
#define CSCD_SELECTION_SEPARATOR_SEARCH_H

#include <CSCD/Selection/Coverage.h>
#include <CSCD/Selection/Source_sequence.h>
#include <CSCD/Separator/Local_separator_finder.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/internal/Vector_3.h>
#include <CSCD/internal/for_each_index.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Takes sources in batches of fixed size. The separators of a batch are found independently, from what was known
/// before the batch, and taken over in the order of the sources; a source that a separator before it in the batch
/// covers is dropped, so that it does not matter whether its separator was computed. The answer is that of a single
/// thread.
template <class ConcurrencyTag, class Finder>
class Separator_search
{
public:
  /// \param make_finder makes the finder of one thread
  template <class MakeFinder>
  Separator_search(const Surface_levels& levels, unsigned random_seed, unsigned number_of_threads,
                   MakeFinder make_finder)
      : m_coverage(levels), m_sources(levels, random_seed), m_for_each(std::move(make_finder), number_of_threads)
  {
  }

  /// Seeks separators until the surface is covered or `most_sources` have been tried; appends them to `separators` and
  /// counts in `report`. `progress(fraction)` is called after each batch and may throw.
  template <class Progress>
  void operator()(std::size_t most_sources, std::vector<Separator>& separators, Skeletonization_report& report,
                  const Progress& progress)
  {
    report.number_of_threads = m_for_each.number_of_threads();
    while (report.number_of_sources < most_sources) {
      m_sources.next_batch(m_coverage, std::min(batch_size, most_sources - report.number_of_sources), m_batch);
      if (m_batch.empty()) {
        return;
      }
      search_batch(separators, report);
      progress(m_sources.progress());
    }
  }

  /// Lets the search go on among the vertices of the finest level for which `is_wanted(vertex)` holds, which count as
  /// covered only when `factor` times as many separators pass them.
  template <class Predicate>
  void explore(const Predicate& is_wanted, unsigned factor)
  {
    m_coverage.require_more(factor);
    m_sources.restart(is_wanted);
  }

private:
  /// Sources in a batch: enough for a few threads, while the share of dropped ones stays below a tenth.
  static constexpr std::size_t batch_size = 16;

  void search_batch(std::vector<Separator>& separators, Skeletonization_report& report)
  {
    std::array<Index, batch_size> hints{};
    for (std::size_t i = 0; i < m_batch.size(); ++i) {
      hints[i] = m_coverage.level_hint(m_batch[i]);
    }
    const auto search = [&](Index i, Finder& finder) { finder(m_batch[i], hints[i], m_results[i]); };
    const auto take = [&](Index i) { take_result(m_batch[i], m_results[i], separators, report); };
    const auto size = Index(m_batch.size());
    if (m_for_each.number_of_threads() == 1) {
      // What is dropped need not be computed.
      m_for_each(size, [&](Index i, Finder& finder) {
        if (!m_coverage.is_covered(m_batch[i])) {
          search(i, finder);
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

  void take_result(Index source, const Search_result& result, std::vector<Separator>& separators,
                   Skeletonization_report& report)
  {
    m_coverage.add(source, result);
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

  Coverage m_coverage;
  Source_sequence m_sources;
  For_each_index<ConcurrencyTag, Finder> m_for_each;
  std::vector<Index> m_batch;
  std::array<Search_result, batch_size> m_results;
};

} // namespace CSCD::internal

#endif // CSCD_SELECTION_SEPARATOR_SEARCH_H
