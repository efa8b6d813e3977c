// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the graph of a skeleton simple without changing its topology.

#ifndef CSCD_SKELETON_MAKE_SIMPLE_H
#define CSCD_SKELETON_MAKE_SIMPLE_H

#include <CSCD/Skeleton/Skeleton_draft.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Divides loops and all but one of parallel edges by further nodes, so that every cycle has at least three nodes.
/// A divided edge is bent aside, since its two ends may lie in one place or be joined by a straight edge already.
inline void make_simple(Skeleton_draft& draft)
{
  std::vector<std::pair<Index, Index>> edges;
  draft.for_each_edge([&](Index a, Index b) { edges.emplace_back(a, b); });
  std::set<std::pair<Index, Index>> seen;
  for (const auto& [a, b] : edges) {
    const double radius = (draft[a].radius + draft[b].radius) / 2;
    const Vector_3 along = draft[b].position - draft[a].position;
    if (a == b) {
      const Index first = draft.split_edge(a, a, draft[a].position + radius * Vector_3::UnitX() / 2, radius);
      draft.split_edge(first, a, draft[a].position + radius * Vector_3::UnitY() / 2, radius);
    } else if (!seen.insert({a, b}).second) {
      const Vector_3 aside = along.norm() > 0 ? Vector_3(along.unitOrthogonal()) : Vector_3(Vector_3::UnitX());
      draft.split_edge(a, b, draft[a].position + along / 2 + radius / 2 * aside, radius);
    }
  }
}

} // namespace CSCD::internal

#endif // CSCD_SKELETON_MAKE_SIMPLE_H
