// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Removes branches that only make a cut locus several vertices wide.

#ifndef CSCD_CUT_LOCUS_THIN_BRANCHES_H
#define CSCD_CUT_LOCUS_THIN_BRANCHES_H

#include <CSCD/Cut_locus/Cut_tree.h>
#include <CSCD/internal/Vector_3.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Whether the free leaf `leaf` of `cut` lies beside another branch: next to a kept vertex that is neither its parent
/// nor a child of its parent. Of two leaves side by side only the one with the greater Laplacian counts.
template <class Frames>
bool is_beside_branch(const Frames& frames, const Cut_tree& cut, Index leaf)
{
  const Org_tree& tree = cut.tree();
  const Index parent = tree.parent(leaf);
  bool result = false;
  frames.for_each_neighbor(leaf, [&](Index neighbor, Index) {
    if (neighbor == leaf || neighbor == parent || !cut.is_kept(neighbor) || tree.parent(neighbor) == parent) {
      return;
    }
    const bool is_weaker = std::pair(tree.laplacian(leaf), leaf) > std::pair(tree.laplacian(neighbor), neighbor);
    result = result || cut.number_of_children(neighbor) > 0 || cut.is_protected(neighbor) || is_weaker;
  });
  return result;
}

/// Removes from `cut`, leaf by leaf, branches that lie beside other ones. O(n) for n vertices.
/// \param frames know the neighbors of a vertex: `Tangent_frames` or `Point_frames`
template <class Frames>
void thin_branches(const Frames& frames, Cut_tree& cut)
{
  std::vector<Index> queue;
  for (Index vertex : cut.tree().order()) {
    if (cut.is_free_leaf(vertex)) {
      queue.push_back(vertex);
    }
  }
  for (std::size_t i = 0; i < queue.size(); ++i) {
    if (is_beside_branch(frames, cut, queue[i])) {
      const Index parent = cut.tree().parent(queue[i]);
      cut.remove(queue[i]);
      if (cut.is_free_leaf(parent)) {
        queue.push_back(parent);
      }
    }
  }
}

} // namespace CSCD::internal

#endif // CSCD_CUT_LOCUS_THIN_BRANCHES_H
