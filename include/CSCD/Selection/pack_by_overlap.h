// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Set packing in the order of weights that overlaps lower.

#ifndef CSCD_SELECTION_PACK_BY_OVERLAP_H
#define CSCD_SELECTION_PACK_BY_OVERLAP_H

#include <CSCD/Selection/Separator_overlaps.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CSCD::internal {

/// Packs separators that do not overlap, greedily (section 3.2.3): first those whose weight is large against the
/// weights of all that they would exclude, w / (1 + sum of the w of its overlaps), as Baerentzen and Rotenberg order
/// local separators.
/// \param weights for each separator, how good it is; those of weight 0 and those that cross themselves are not packed
/// \return the packed separators, the first packed first; equal ones in the order of their numbers
inline std::vector<Index> pack_by_overlap(const Separator_overlaps& overlaps, const std::vector<double>& weights)
{
  const std::size_t size = weights.size();
  std::vector<double> order_weight(size, 0);
  std::vector<Index> order;
  const auto is_allowed = [&](Index i) { return weights[i] > 0 && !overlaps.crosses_itself(i); };
  for (Index i = 0; i < size; ++i) {
    if (!is_allowed(i)) {
      continue;
    }
    double excluded = 0;
    for (Index other : overlaps.others(i)) {
      excluded += is_allowed(other) ? weights[other] : 0;
    }
    order_weight[i] = weights[i] / (1 + excluded);
    order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return order_weight[a] > order_weight[b]; });
  std::vector<std::uint8_t> is_packed(size, 0);
  std::vector<Index> packed;
  for (Index i : order) {
    const auto others = overlaps.others(i);
    if (std::none_of(others.begin(), others.end(), [&](Index other) { return is_packed[other] != 0; })) {
      is_packed[i] = 1;
      packed.push_back(i);
    }
  }
  return packed;
}

} // namespace CSCD::internal

#endif // CSCD_SELECTION_PACK_BY_OVERLAP_H
