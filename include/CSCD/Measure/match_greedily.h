// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pairs of things that are at the same place.

#ifndef CSCD_MEASURE_MATCH_GREEDILY_H
#define CSCD_MEASURE_MATCH_GREEDILY_H

#include <CSCD/Measure/Skeleton_comparison.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CSCD::internal {

/// Matches the indices 0 to m - 1 with 0 to n - 1, each at most once, nearest pairs first.
/// O(m n) calls of `distance`, and O(p log p) for p pairs that are near enough.
/// \param distance of two indices
/// \param match_distance greatest distance of a pair
template <class Distance>
Match_count match_greedily(std::size_t m, std::size_t n, const Distance& distance, double match_distance)
{
  std::vector<std::tuple<double, Index, Index>> pairs;
  for (Index i = 0; i < m; ++i) {
    for (Index j = 0; j < n; ++j) {
      const double d = distance(i, j);
      if (d <= match_distance) {
        pairs.emplace_back(d, i, j);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  Match_count result{m, n, 0};
  std::vector<char> is_first_taken(m, 0);
  std::vector<char> is_second_taken(n, 0);
  for (const auto& [d, i, j] : pairs) {
    if (is_first_taken[i] == 0 && is_second_taken[j] == 0) {
      is_first_taken[i] = is_second_taken[j] = 1;
      ++result.number_matched;
    }
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_MEASURE_MATCH_GREEDILY_H
