// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A limb of a tree as a sequence of slices.

#ifndef CSCD_TREE_LIMB_H
#define CSCD_TREE_LIMB_H

#include <CSCD/internal/Vector_3.h>

#include <vector>

namespace CSCD::internal {

/// A limb from its base to its tip.
struct Limb
{
  Index parent = no_index; ///< the limb from which it grows; none for a trunk
  Index joint = no_index;  ///< the slice of the parent from which it grows
  std::vector<Index> slices;
};

} // namespace CSCD::internal

#endif // CSCD_TREE_LIMB_H
