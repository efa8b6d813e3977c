// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cost of separators, by which they are packed.

#ifndef CSCD_PACKING_SEPARATOR_COST_H
#define CSCD_PACKING_SEPARATOR_COST_H

#include <CSCD/Separator/Separator.h>

#include <vector>

namespace CSCD::internal {

/// The cost of `separator`, a length: of two separators that overlap, the one of lower cost is packed. Prefers short,
/// planar separators.
inline double separator_cost(const Separator& separator)
{
  // A deviation from a plane by a quarter of the length counts as twice the length.
  constexpr double planarity_factor = 4;
  return separator.length * (1 + planarity_factor * separator.planarity);
}

/// The costs of `separators`.
inline std::vector<double> separator_costs(const std::vector<Separator>& separators)
{
  std::vector<double> result;
  result.reserve(separators.size());
  for (const Separator& separator : separators) {
    result.push_back(separator_cost(separator));
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_PACKING_SEPARATOR_COST_H
