// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the shortening of a curve has ended.

#ifndef CSCD_SEPARATOR_SHORTENING_OUTCOME_H
#define CSCD_SEPARATOR_SHORTENING_OUTCOME_H

namespace CSCD {

/// What has become of a curve that was shortened.
enum class Shortening_outcome
{
  straight,  ///< it is a geodesic: nowhere can it be shortened locally
  held,      ///< it can be shortened at pinned vertices only
  collapsed, ///< a closed curve has shrunk to a point, or to less than the allowed part of its length
  unfinished ///< it can still be shortened at a vertex, but not by flips, or not in the allowed number of steps
};

} // namespace CSCD

#endif // CSCD_SEPARATOR_SHORTENING_OUTCOME_H
