// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cut locus as all cut points and what joins them.

#ifndef CSCD_CUT_LOCUS_PRUNING_POLICY_H
#define CSCD_CUT_LOCUS_PRUNING_POLICY_H

#include <CSCD/Cut_locus/Cut_tree.h>
#include <CSCD/internal/Vector_3.h>

namespace CSCD {

/// Keeps every cut point and its way to the root of the tree: what remains when leaves that are none are removed until
/// there are none left. Nothing is missed, but false cut points far away keep their ways too. `Growing_policy`
/// is the other choice.
struct Pruning_policy
{
  /// Adds to `cut` the vertices for which `is_cut(vertex)` holds, and their ways to the root; linear.
  template <class Predicate>
  void operator()(const Predicate& is_cut, internal::Cut_tree& cut) const
  {
    for (internal::Index vertex : cut.tree().order()) {
      if (is_cut(vertex)) {
        cut.keep(vertex);
      }
    }
  }
};

} // namespace CSCD

#endif // CSCD_CUT_LOCUS_PRUNING_POLICY_H
