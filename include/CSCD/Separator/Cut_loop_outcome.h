// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What became of the way from a source to its cut locus and back.

#ifndef CSCD_SEPARATOR_CUT_LOOP_OUTCOME_H
#define CSCD_SEPARATOR_CUT_LOOP_OUTCOME_H

#include <cstddef>

namespace CSCD {

/// What became of a source or of one of its cut points.
enum class Cut_loop_outcome
{
  found,                ///< a closed curve
  no_cut_point,         ///< the source has no cut point outside of its neighborhood
  distance_below_chord, ///< the distance is less than that in space, which only an estimate can be
  one_direction,        ///< all fronts arrive from one side
  not_connected,        ///< no way leads to the source
  meets_at_once,        ///< the ways to the source join at the target or next to it: nothing is enclosed
  long_stem,            ///< the ways to the source join far from it: the curve is not that of this source
  narrow                ///< the ways to the source stay close together: they go around a bump
};

/// Number of values of `Cut_loop_outcome`.
inline constexpr std::size_t number_of_cut_loop_outcomes = std::size_t(Cut_loop_outcome::narrow) + 1;

} // namespace CSCD

#endif // CSCD_SEPARATOR_CUT_LOOP_OUTCOME_H
