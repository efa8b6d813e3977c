// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Takes the zigzag out of branches.

#ifndef CSCD_SKELETON_SMOOTH_BRANCHES_H
#define CSCD_SKELETON_SMOOTH_BRANCHES_H

#include <CSCD/Skeleton/Skeleton_draft.h>
#include <CSCD/internal/Vector_3.h>

#include <vector>

namespace CSCD::internal {

/// Moves every node of degree 2 halfway to the middle of its neighbors, all at once. More such steps decenter bends.
inline void smooth_branches(Skeleton_draft& draft)
{
  std::vector<Vector_3> smoothed(draft.size());
  for (Index node = 0; node < draft.size(); ++node) {
    smoothed[node] = draft[node].position;
    if (draft.is_regular(node)) {
      const std::vector<Index>& neighbors = draft[node].neighbors;
      smoothed[node] = smoothed[node] / 2 + (draft[neighbors[0]].position + draft[neighbors[1]].position) / 4;
    }
  }
  for (Index node = 0; node < draft.size(); ++node) {
    draft[node].position = smoothed[node];
  }
}

} // namespace CSCD::internal

#endif // CSCD_SKELETON_SMOOTH_BRANCHES_H
