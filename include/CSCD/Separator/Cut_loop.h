// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A closed curve from a source to its cut locus and back, before it is shortened.

#ifndef CSCD_SEPARATOR_CUT_LOOP_H
#define CSCD_SEPARATOR_CUT_LOOP_H

#include <CSCD/Separator/Cut_loop_outcome.h>
#include <CSCD/Separator/Edge_step.h>
#include <CSCD/internal/Vector_3.h>

#include <array>
#include <cstddef>

namespace CSCD::internal {

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

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_CUT_LOOP_H
