// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Takes out nodes that lie beyond the junction that their branch leads to.

#ifndef CSCD_SKELETON_DROP_OVERSHOOTS_H
#define CSCD_SKELETON_DROP_OVERSHOOTS_H

#include <CSCD/Skeleton/Skeleton_draft.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <vector>

namespace CSCD::internal {

/// Removes the nodes next to a junction, within its ball, at which the branch turns by more than a right angle: the
/// junction was moved past them, and the branch would double back. Neither topology nor the simplicity of the graph
/// change.
inline void drop_overshoots(Skeleton_draft& draft)
{
  const auto doubles_back = [&](Index junction, Index node, Index next) {
    const Vector_3& position = draft[node].position;
    const Vector_3 step = position - draft[junction].position;
    return step.norm() < draft[junction].radius && step.dot(draft[next].position - position) < 0;
  };
  const auto overshooting_neighbor = [&](Index junction) {
    for (Index node : draft[junction].neighbors) {
      if (!draft.is_regular(node)) {
        continue;
      }
      const std::vector<Index>& ends = draft[node].neighbors;
      const Index next = ends[0] == junction ? ends[1] : ends[0];
      const std::vector<Index>& around = draft[junction].neighbors;
      const bool stays_simple = next != junction && std::find(around.begin(), around.end(), next) == around.end();
      if (stays_simple && draft.degree(next) == 2 && doubles_back(junction, node, next)) {
        return node;
      }
    }
    return no_index;
  };
  for (Index junction = 0; junction < draft.size(); ++junction) {
    while (draft.is_junction(junction)) {
      const Index node = overshooting_neighbor(junction);
      if (node == no_index) {
        break;
      }
      draft.bypass(node);
    }
  }
}

} // namespace CSCD::internal

#endif // CSCD_SKELETON_DROP_OVERSHOOTS_H
