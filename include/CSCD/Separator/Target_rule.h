// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which cut point is the target of a source.

#ifndef CSCD_SEPARATOR_TARGET_RULE_H
#define CSCD_SEPARATOR_TARGET_RULE_H

namespace CSCD {

/// Which cut point is the target of a source.
enum class Target_rule
{
  nearest_in_space,     ///< least Euclidean distance: around the limb, however wide it is
  nearest_along_surface ///< least geodesic distance: on a wide body that may be around another limb (supplement, J.1)
};

} // namespace CSCD

#endif // CSCD_SEPARATOR_TARGET_RULE_H
