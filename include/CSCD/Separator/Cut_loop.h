// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A closed curve from a source to its cut locus and back, before it is shortened.

#ifndef CSCD_SEPARATOR_CUT_LOOP_H
#define CSCD_SEPARATOR_CUT_LOOP_H

#include <CSCD/Separator/Edge_step.h>
#include <CSCD/internal/Vector_3.h>

#include <array>
#include <cstddef>

namespace CSCD {

/// Which cut point is the target of a source.
enum class Target_rule
{
  nearest_in_space,     ///< least Euclidean distance: around the limb, however wide it is
  nearest_along_surface ///< least geodesic distance: on a wide body that may be around another limb (supplement, J.1)
};

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

inline constexpr std::size_t number_of_cut_loop_outcomes = std::size_t(Cut_loop_outcome::narrow) + 1;

namespace internal {

/// A simple closed curve along edges, and how it was found.
struct Cut_loop
{
  /// `found`, or why there is none: `no_cut_point`, else what the last candidate was rejected for.
  Cut_loop_outcome outcome = Cut_loop_outcome::no_cut_point;
  /// From the target to the base and back, if there is a curve.
  Edge_steps steps;
  Index target = no_index;
  /// Where the two ways to the source join: the source or a vertex near it.
  Index base = no_index;
  /// Distance of the target along the surface.
  double distance = 0;
  /// Distance in space between the two ways half way down, relative to that of the target along the surface: 0.64 on a
  /// round tube, about 0 around a bump.
  double aperture = 0;
  /// How many candidates had which outcome, in the order of `Cut_loop_outcome`.
  std::array<std::size_t, number_of_cut_loop_outcomes> number_of_candidates{};
};

} // namespace internal
} // namespace CSCD

#endif // CSCD_SEPARATOR_CUT_LOOP_H
