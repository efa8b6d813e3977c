// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Removes branches of a cut locus that are too short to mean anything.

#ifndef CSCD_CUT_LOCUS_DROP_SHORT_BRANCHES_H
#define CSCD_CUT_LOCUS_DROP_SHORT_BRANCHES_H

#include <CSCD/Cut_locus/Cut_tree.h>
#include <CSCD/internal/Vector_3.h>

#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Removes from `cut` the branches that end in a leaf and are shorter than `least_length`, the shortest first; what
/// they leave of their fork may then be one longer branch. A branch ends at a fork, at a root, or where it is
/// protected. O(n log n) for n vertices. \param length gives the length of a halfedge
template <class Length>
void drop_short_branches(Cut_tree& cut, double least_length, const Length& length)
{
  const Org_tree& tree = cut.tree();
  const auto ends_at = [&](Index vertex) { return cut.is_protected(vertex) || cut.number_of_children(vertex) > 1; };
  const auto branch_length = [&](Index leaf) {
    double sum = 0;
    Index vertex = leaf;
    do {
      sum += length(tree.halfedge_to_parent(vertex));
      vertex = tree.parent(vertex);
    } while (!ends_at(vertex) && sum < least_length);
    return sum;
  };
  std::priority_queue<std::pair<double, Index>, std::vector<std::pair<double, Index>>, std::greater<>> queue;
  for (Index vertex : tree.order()) {
    if (cut.is_free_leaf(vertex)) {
      queue.emplace(branch_length(vertex), vertex);
    }
  }
  while (!queue.empty() && queue.top().first < least_length) {
    const auto [known_length, leaf] = queue.top();
    queue.pop();
    const double current_length = branch_length(leaf);
    if (current_length > known_length) {
      queue.emplace(current_length, leaf);
      continue;
    }
    for (Index vertex = leaf; cut.is_free_leaf(vertex); vertex = tree.parent(vertex)) {
      cut.remove(vertex);
    }
  }
}

} // namespace CSCD::internal

#endif // CSCD_CUT_LOCUS_DROP_SHORT_BRANCHES_H
