// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The default algorithms of the pipeline's stages.

#ifndef CSCD_LOCAL_POLICIES_H
#define CSCD_LOCAL_POLICIES_H

#include <CSCD/Selection/Length_and_planarity_weight.h>
#include <CSCD/Separator/Local_separator_finder.h>

namespace CSCD {

/// The local policies: everything touches only the surface around a source. The default model of
/// `SkeletonizationPolicies`.
/// \tparam Traits a model of `MultiresolutionSkeletonizationTraits`
/// \tparam SeparatorWeight a model of `SeparatorWeight`
template <class Traits, class SeparatorWeight = Length_and_planarity_weight>
struct Local_policies
{
  /// Finds the separator of a source; one object a thread.
  using Separator_finder = Local_separator_finder<Traits>;

  /// The finder of one thread, for the surface of `traits`.
  Separator_finder make_separator_finder(const Traits& traits) const { return Separator_finder(traits); }

  /// Of two separators that overlap, the one of lesser weight is packed.
  SeparatorWeight separator_weight{};
};

} // namespace CSCD

#endif // CSCD_LOCAL_POLICIES_H
