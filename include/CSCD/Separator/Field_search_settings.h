// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a user may set about the search for separators from distance fields.

#ifndef CSCD_SEPARATOR_FIELD_SEARCH_SETTINGS_H
#define CSCD_SEPARATOR_FIELD_SEARCH_SETTINGS_H

#include <optional>

namespace CSCD {

/// Which cut point is the target of a source.
enum class Target_rule
{
  nearest_in_space,     ///< minimum Euclidean distance: around the limb, however wide it is
  nearest_along_surface ///< minimum geodesic distance: on a wide body that may be around another limb (supplement, J.1)
};

/// How the published method shortens the loop of a source.
enum class Shortening_rule
{
  edge_flips, ///< to a geodesic, by flips of intrinsic edges (appendix E)
  variational ///< by the variational flow, projected to the surface (appendix F)
};

/// What a user may set about the search for separators from distance fields.
struct Field_search_settings
{
  /// Which cut point is the target.
  Target_rule target_rule = Target_rule::nearest_in_space;
  /// By default edge flips on meshes and the variational flow among points, where edges cannot be flipped.
  std::optional<Shortening_rule> shortening_rule;
};

} // namespace CSCD

#endif // CSCD_SEPARATOR_FIELD_SEARCH_SETTINGS_H
