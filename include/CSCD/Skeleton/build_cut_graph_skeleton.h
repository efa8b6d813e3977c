// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the surface cut along packed separators to its skeleton.

#ifndef CSCD_SKELETON_BUILD_CUT_GRAPH_SKELETON_H
#define CSCD_SKELETON_BUILD_CUT_GRAPH_SKELETON_H

#include <CSCD/Selection/Separator_packing.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Branch_refinement.h>
#include <CSCD/Skeleton/Embedded_skeleton.h>
#include <CSCD/Skeleton/Inside_repair.h>
#include <CSCD/Skeleton/Node_placement.h>
#include <CSCD/Skeleton/Site_assignment.h>
#include <CSCD/Skeleton/center_junctions.h>
#include <CSCD/Skeleton/drop_overshoots.h>
#include <CSCD/Skeleton/make_simple.h>
#include <CSCD/Skeleton/merge_junctions.h>
#include <CSCD/Skeleton/smooth_branches.h>
#include <CSCD/Skeletonization_report.h>

#include <utility>
#include <vector>

namespace CSCD::internal {

/// The skeleton that the cut graph of `packing` describes: nodes are placed, junctions centered, branches refined and
/// smoothed, and what left the body is brought back; what could not be is counted in `report`.
/// \tparam Traits a model of `TriangulatedSolidSkeletonizationTraits`
template <class Traits>
Embedded_skeleton build_cut_graph_skeleton(const Traits& traits, const std::vector<Separator>& separators,
                                           const Separator_packing& packing, Skeletonization_report& report)
{
  Node_placement<Traits> placement(traits, separators, packing.packed(), packing.cut_graph());
  Embedded_skeleton result;
  result.draft = placement();
  make_simple(result.draft);
  merge_junctions(result.draft);
  center_junctions(traits, result.draft);
  drop_overshoots(result.draft);
  Branch_refinement<Traits>(traits, result.draft)();
  smooth_branches(result.draft);
  Inside_repair<Traits> repair(traits, result.draft);
  repair();
  result.draft.compact();
  report.number_of_nodes_outside = repair.number_of_nodes_outside();
  report.number_of_edges_outside = repair.number_of_edges_outside();
  Site_assignment<Traits>(traits, packing.cut_graph(), result.draft).move_to(result);
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_SKELETON_BUILD_CUT_GRAPH_SKELETON_H
