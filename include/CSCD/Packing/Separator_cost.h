// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cost of separators, by which they are packed.

#ifndef CSCD_PACKING_SEPARATOR_COST_H
#define CSCD_PACKING_SEPARATOR_COST_H

#include <CSCD/Separator/Separator.h>

#include <functional>
#include <vector>

namespace CSCD {

/// Prefers short, planar separators. The default model of `SeparatorCost`: of two separators that overlap, the one of
/// lower cost is packed.
struct Length_and_planarity_cost
{
  /// Weight of the relative deviation from a plane: one of a quarter of the length counts as twice the length.
  static constexpr double planarity_factor = 4;

  /// The cost of `separator`, a length.
  double operator()(const Separator& separator) const
  {
    return separator.length * (1 + planarity_factor * separator.planarity);
  }
};

/// Any model of `SeparatorCost`.
using Separator_cost = std::function<double(const Separator&)>;

} // namespace CSCD

namespace CSCD::internal {

/// The costs of `separators`.
inline std::vector<double> separator_costs(const std::vector<Separator>& separators, const Separator_cost& cost)
{
  std::vector<double> result;
  result.reserve(separators.size());
  for (const Separator& separator : separators) {
    result.push_back(cost(separator));
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_PACKING_SEPARATOR_COST_H
