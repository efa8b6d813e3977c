// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the published method shortens loops.

#ifndef CSCD_SEPARATOR_SHORTENING_RULE_H
#define CSCD_SEPARATOR_SHORTENING_RULE_H

namespace CSCD {

/// How the published method shortens the loop of a source.
enum class Shortening_rule
{
  edge_flips, ///< to a geodesic, by flips of intrinsic edges (appendix E)
  variational ///< by the variational flow, projected to the surface (appendix F)
};

} // namespace CSCD

#endif // CSCD_SEPARATOR_SHORTENING_RULE_H
