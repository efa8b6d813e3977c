// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a distance field to the vertices of its cut locus and how they are joined.

#ifndef CSCD_CUT_LOCUS_FIND_CUT_TREE_H
#define CSCD_CUT_LOCUS_FIND_CUT_TREE_H

#include <CSCD/Cut_locus/Cut_criterion.h>
#include <CSCD/Cut_locus/Cut_measures.h>
#include <CSCD/Cut_locus/Cut_tree.h>
#include <CSCD/Cut_locus/Org_tree.h>
#include <CSCD/Cut_locus/close_loops.h>
#include <CSCD/Cut_locus/filter_org_tree.h>
#include <CSCD/internal/Vector_3.h>

#include <vector>

namespace CSCD::internal {

/// Finds the cut locus of `sources` as part of `tree`, the ORG tree of `measures`: filtered by `policy`, its loops
/// closed, made one vertex wide, without short branches. O(n log n) for n vertices.
/// \param least_branch_length see `filter_org_tree()`
template <class Triangulation, class CutLocusPolicy>
Cut_tree find_cut_tree(const Cut_measures<Triangulation>& measures, const Org_tree& tree,
                       const std::vector<Index>& sources, const Cut_criterion& criterion, const CutLocusPolicy& policy,
                       double least_branch_length)
{
  return filter_org_tree(measures, tree, criterion, policy, least_branch_length,
                         [&](Cut_tree& cut) { close_loops(measures, sources, cut); });
}

} // namespace CSCD::internal

#endif // CSCD_CUT_LOCUS_FIND_CUT_TREE_H
