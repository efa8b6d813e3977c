// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the tree over all vertices to the part of it that is the cut locus.

#ifndef CSCD_CUT_LOCUS_FILTER_ORG_TREE_H
#define CSCD_CUT_LOCUS_FILTER_ORG_TREE_H

#include <CSCD/Cut_locus/Cut_criterion.h>
#include <CSCD/Cut_locus/Cut_tree.h>
#include <CSCD/Cut_locus/Org_tree.h>
#include <CSCD/Cut_locus/drop_short_branches.h>
#include <CSCD/Cut_locus/thin_branches.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>

namespace CSCD::internal {

/// Keeps of `tree`, the ORG tree of `measures`, what `policy` makes of the cut points; then calls `close_loops(cut)`,
/// which may add chords; then makes branches one vertex wide and drops the short ones. O(n log n) for n vertices, and
/// what `close_loops` costs.
/// \tparam Measures `Cut_measures` of a triangulation, or `Point_cut_measures`
/// \param least_branch_length relative to the distance of the farthest vertex; branches of less than three mean
///        edge lengths, which the triangulation alone can make, are dropped anyway
template <class Measures, class CutLocusPolicy, class CloseLoops>
Cut_tree filter_org_tree(const Measures& measures, const Org_tree& tree, const Cut_criterion& criterion,
                         const CutLocusPolicy& policy, double least_branch_length, const CloseLoops& close_loops)
{
  constexpr double least_edges_of_branch = 3;
  const auto& frames = measures.frames();
  Cut_tree cut(tree);
  const auto gradients = measures.gradients();
  policy([&](Index vertex) { return tree.is_on_loop(vertex) || measures.is_cut(vertex, criterion, gradients); }, cut);
  close_loops(cut);
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

#endif // CSCD_CUT_LOCUS_FILTER_ORG_TREE_H
