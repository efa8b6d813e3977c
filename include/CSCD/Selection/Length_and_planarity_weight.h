// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The default weight of a separator.

#ifndef CSCD_SELECTION_LENGTH_AND_PLANARITY_WEIGHT_H
#define CSCD_SELECTION_LENGTH_AND_PLANARITY_WEIGHT_H

#include <CSCD/Separator/Separator.h>

namespace CSCD {

/// Prefers short, planar separators. The default model of `SeparatorWeight`: of two separators that overlap, the one of
/// lesser weight is packed.
struct Length_and_planarity_weight
{
  /// Weight of the relative deviation from a plane: one of a quarter of the length counts as twice the length.
  static constexpr double planarity_factor = 4;

  /// The weight of `separator`, a length.
  double operator()(const Separator& separator) const
  {
    return separator.length * (1 + planarity_factor * separator.planarity);
  }
};

} // namespace CSCD

#endif // CSCD_SELECTION_LENGTH_AND_PLANARITY_WEIGHT_H
