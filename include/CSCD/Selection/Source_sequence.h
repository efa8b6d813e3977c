// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The order in which vertices are tried as sources.

#ifndef CSCD_SELECTION_SOURCE_SEQUENCE_H
#define CSCD_SELECTION_SOURCE_SEQUENCE_H

#include <CSCD/Selection/Coverage.h>
#include <CSCD/Traits/Surface_levels.h>
#include <CSCD/internal/Vector_3.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Goes through the vertices of a level in a scattered order, in batches of those that are not covered.
///
/// The order is scattered like a random one, but nearly the same for every seed: the seed only decides which of a few
/// dozen consecutive sources comes first. Coverage, not chance, decides where separators are sought, so there is
/// nothing to gain from a wholly different order, and a user who changes the seed or the pose of a shape gets the same
/// branches.
class Source_sequence
{
public:
  /// Scatters the vertices; the order depends on `random_seed` and the numbering of the surface alone.
  Source_sequence(const Surface_levels& levels, unsigned random_seed)
  {
    const Surface_level& level = levels[levels.finest_with_at_most(most_candidates)];
    m_candidates.resize(level.surface.number_of_vertices());
    std::iota(m_candidates.begin(), m_candidates.end(), Index(0));
    boost::random::mt19937 scatter;
    shuffle(0, m_candidates.size(), scatter);
    boost::random::mt19937 generator(random_seed);
    for (std::size_t begin = 0; begin < m_candidates.size(); begin += block_size) {
      shuffle(begin, std::min(begin + block_size, m_candidates.size()), generator);
    }
    for (Index& candidate : m_candidates) {
      candidate = level.to_finest(candidate);
    }
  }

  /// Writes the next sources that `coverage` does not cover to `batch`, at most `size`; none at the end.
  void next_batch(const Coverage& coverage, std::size_t size, std::vector<Index>& batch)
  {
    batch.clear();
    while (m_next < m_candidates.size() && batch.size() < size) {
      const Index candidate = m_candidates[m_next++];
      if (!coverage.is_covered(candidate)) {
        batch.push_back(candidate);
      }
    }
  }

  /// Begins again with the candidates for which `is_wanted(vertex)` holds, in the same order.
  template <class Predicate>
  void restart(const Predicate& is_wanted)
  {
    m_next = 0;
    m_candidates.erase(std::remove_if(m_candidates.begin(), m_candidates.end(),
                                      [&](Index candidate) { return !is_wanted(candidate); }),
                       m_candidates.end());
  }

  /// The part of the vertices that has been gone through, in [0, 1].
  double progress() const { return m_candidates.empty() ? 1. : double(m_next) / double(m_candidates.size()); }

private:
  /// Sources are taken from the finest level of at most this many vertices: more lie closer together than the bands of
  /// any limb that they could find.
  static constexpr Index most_candidates = 60000;
  /// Sources among which the seed decides.
  static constexpr std::size_t block_size = 32;

  /// Shuffles the candidates from `begin` to `end`.
  void shuffle(std::size_t begin, std::size_t end, boost::random::mt19937& generator)
  {
    // std::shuffle may differ between standard libraries; Boost's distribution does not.
    for (std::size_t i = end; i > begin + 1; --i) {
      const std::size_t j = boost::random::uniform_int_distribution<std::size_t>(begin, i - 1)(generator);
      std::swap(m_candidates[i - 1], m_candidates[j]);
    }
  }

  std::vector<Index> m_candidates;
  std::size_t m_next = 0;
};

} // namespace CSCD::internal

#endif // CSCD_SELECTION_SOURCE_SEQUENCE_H
