// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the axis of a limb runs, and how thick the limb is.

#ifndef CSCD_TREE_SECTION_H
#define CSCD_TREE_SECTION_H

#include <CSCD/Tree/Circle_outcome.h>
#include <CSCD/internal/Vector_3.h>

namespace CSCD::internal {

/// A section of a limb: what a slice tells of it.
struct Section
{
  Vector_3 center = Vector_3::Zero();
  Vector_3 direction = Vector_3::Zero(); ///< of the limb, unit length
  double radius = 0;
  double confidence = 0; ///< of center and radius, in [0, 1]
  bool is_rough = true;  ///< whether no circle near it tells the radius
  Circle_outcome outcome = Circle_outcome::few_points;

  /// Whether center and radius are those of a circle.
  bool is_circle() const { return outcome == Circle_outcome::fitted; }
};

} // namespace CSCD::internal

#endif // CSCD_TREE_SECTION_H
