// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers that say how a cut locus is found.

#ifndef CSCD_CUT_LOCUS_CUT_LOCUS_SETTINGS_H
#define CSCD_CUT_LOCUS_CUT_LOCUS_SETTINGS_H

#include <CSCD/Cut_locus/Cut_criterion.h>

namespace CSCD::internal {

/// How a cut locus is found; scale-free.
struct Cut_locus_settings
{
  Cut_criterion criterion;
  /// Relative to the distance of the farthest point. Found by eye on a dozen meshes: less leaves thorns, more takes
  /// fingers.
  double minimum_branch_length = 0.03;
  int number_of_iterations = 10;
};

} // namespace CSCD::internal

#endif // CSCD_CUT_LOCUS_CUT_LOCUS_SETTINGS_H
