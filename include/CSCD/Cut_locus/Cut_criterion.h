// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// When a vertex counts as a point of the cut locus.

#ifndef CSCD_CUT_LOCUS_CUT_CRITERION_H
#define CSCD_CUT_LOCUS_CUT_CRITERION_H

#include <boost/math/constants/constants.hpp>

namespace CSCD::internal {

/// When a vertex counts as a point of the cut locus; scale-free.
struct Cut_criterion
{
  /// The scale-free Laplacian is at most this. Across a straight ridge where unit gradients meet at the angle a, it is
  /// about -2.3 sin(a/2); elsewhere it is positive or small.
  double laplacian_threshold = -0.5;
  /// Gradients around the vertex run against each other at this angle at least, in radians.
  double angle_threshold = boost::math::double_constants::third_pi;
};

} // namespace CSCD::internal

#endif // CSCD_CUT_LOCUS_CUT_CRITERION_H
