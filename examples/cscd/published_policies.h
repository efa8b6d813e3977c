// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The published method as the options ask for it.

#ifndef CSCD_PROGRAM_PUBLISHED_POLICIES_H
#define CSCD_PROGRAM_PUBLISHED_POLICIES_H

#include "Skeletonize_options.h"
#include <CSCD/Published_policies.h>
#include <CSCD/Separator/Separator_shortening.h>
#include <CSCD/Separator/Cut_loop_finder.h>

namespace cscd {

/// The policies for the surface `Traits`.
template <class Traits>
CSCD::Published_policies<Traits> published_policies(const Skeletonize_options& options)
{
  using Policies = CSCD::Published_policies<Traits>;
  return Policies(options.target == geodesic_target ? CSCD::Target_rule::nearest_along_surface
                                                    : CSCD::Target_rule::nearest_in_space,
                  options.shortening.empty()                     ? Policies::default_shortening_rule
                  : options.shortening == variational_shortening ? CSCD::Shortening_rule::variational
                                                                 : CSCD::Shortening_rule::edge_flips);
}

} // namespace cscd

#endif // CSCD_PROGRAM_PUBLISHED_POLICIES_H
