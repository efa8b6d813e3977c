// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The published method as the options ask for it.

#ifndef CSCD_PROGRAM_PUBLISHED_POLICIES_H
#define CSCD_PROGRAM_PUBLISHED_POLICIES_H

#include "Skeletonize_options.h"
#include <CSCD/Published_policies.h>
#include <CSCD/Separator/Field_search_settings.h>

namespace cscd {

inline CSCD::Published_policies published_policies(const Skeletonize_options& options)
{
  CSCD::Field_search_settings settings;
  settings.target_rule = options.target == geodesic_target ? CSCD::Target_rule::nearest_along_surface
                                                           : CSCD::Target_rule::nearest_in_space;
  if (!options.shortening.empty()) {
    settings.shortening_rule = options.shortening == variational_shortening ? CSCD::Shortening_rule::variational
                                                                            : CSCD::Shortening_rule::edge_flips;
  }
  return CSCD::Published_policies(settings);
}

} // namespace cscd

#endif // CSCD_PROGRAM_PUBLISHED_POLICIES_H
