// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether a section of a limb is told by a circle.

#ifndef CSCD_TREE_CIRCLE_OUTCOME_H
#define CSCD_TREE_CIRCLE_OUTCOME_H

#include <cstddef>

namespace CSCD {

/// What became of the attempt to fit a circle to the points around a node. Without one, center and radius are told by
/// the scatter of the points, by the circles around, and by what the limb carries.
enum class Circle_outcome
{
  fitted,     ///< there is one
  few_points, ///< too few points, or all on a line
  short_arc,  ///< too little of the circle is covered by points
  scattered,  ///< the points are too far from the circle: leaves, or noise as large as the limb is thin
  too_wide    ///< the circle is wider than the parent of the limb, or much wider than the scatter of the points
};

/// Number of values of `Circle_outcome`.
inline constexpr std::size_t number_of_circle_outcomes = 5;

} // namespace CSCD

#endif // CSCD_TREE_CIRCLE_OUTCOME_H
