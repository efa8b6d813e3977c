// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a distance field to the vertices of its cut locus and how they are joined.

#ifndef CSCD_CUT_LOCUS_FIND_CUT_TREE_H
#define CSCD_CUT_LOCUS_FIND_CUT_TREE_H

#include <CSCD/Cut_locus/Cut_criterion.h>
#include <CSCD/Cut_locus/Cut_tree.h>
#include <CSCD/Cut_locus/Org_tree.h>
#include <CSCD/Cut_locus/close_loops.h>
#include <CSCD/Cut_locus/drop_short_branches.h>
#include <CSCD/Cut_locus/thin_branches.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <vector>

namespace CSCD::internal {

/// Finds the cut locus of `sources` as part of `tree`, the ORG tree of `measures`: filtered by `policy`, its loops
/// closed, made one vertex wide, without short branches. O(n log n) for n vertices.
/// \param least_branch_length relative to the distance of the farthest vertex; branches of less than three mean
///        edge lengths, which the triangulation alone can make, are dropped anyway
template <class Measures, class CutLocusPolicy>
Cut_tree find_cut_tree(const Measures& measures, const Org_tree& tree, const std::vector<Index>& sources,
                       const Cut_criterion& criterion, const CutLocusPolicy& policy, double least_branch_length)
{
  constexpr double least_edges_of_branch = 3;
  const auto& frames = measures.frames();
  Cut_tree cut(tree);
  const auto gradients = measures.gradients();
  policy([&](Index vertex) { return tree.is_on_loop(vertex) || measures.is_cut(vertex, criterion, gradients); }, cut);
  close_loops(measures, sources, cut);
  thin_branches(frames, cut);
  double greatest_distance = 0;
  for (Index root : tree.roots()) {
    greatest_distance = std::max(greatest_distance, measures.distance(root));
  }
  const double least_length =
      std::max(least_branch_length * greatest_distance, least_edges_of_branch * frames.mean_edge_length());
  drop_short_branches(cut, least_length, [&](Index halfedge) { return frames.length(halfedge); });
  return cut;
}

} // namespace CSCD::internal

#endif // CSCD_CUT_LOCUS_FIND_CUT_TREE_H
