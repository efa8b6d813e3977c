// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the surface cut along packed separators to its skeleton.

#ifndef CSCD_SKELETON_BUILD_CUT_GRAPH_SKELETON_H
#define CSCD_SKELETON_BUILD_CUT_GRAPH_SKELETON_H

#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Branch_refinement.h>
#include <CSCD/Skeleton/Inside_repair.h>
#include <CSCD/Skeleton/Node_placement.h>
#include <CSCD/Skeleton/Rim_trimming.h>
#include <CSCD/Skeleton/Sheet_ends.h>
#include <CSCD/Skeleton/Sheet_placement.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeleton/Vertex_assignment.h>
#include <CSCD/Skeleton/place_junctions.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector_3.h>

#include <utility>
#include <vector>

namespace CSCD::internal {

/// The skeleton that `cut_graph` describes, of the surface cut along the `packed` ones of `separators`: nodes are
/// placed, junctions centered, ends in rims cut off, branches refined, smoothed and centered, and what left the body is
/// brought back; what could not be is counted in `report`. Nodes that own little of the surface go. As many threads as
/// found the separators share what can be shared.
inline Embedded_skeleton build_cut_graph_skeleton(const Triangulated_solid& solid,
                                                  const std::vector<Separator>& separators,
                                                  const std::vector<Index>& packed, const Cut_graph& cut_graph,
                                                  Skeletonization_report& report)
{
  const auto number_of_threads = unsigned(report.number_of_threads);
  Embedded_skeleton result;
  result.graph = Node_placement(solid, separators, packed, cut_graph)();
  make_simple(result.graph);
  merge_junctions(result.graph);
  Junction_centering(solid, result.graph)();
  drop_overshoots(result.graph);
  Rim_trimming(solid, result.graph)();
  Branch_refinement(solid, result.graph)();
  smooth_branches(result.graph);
  Branch_centering(solid, result.graph, number_of_threads)();
  finish_on_sheets(solid, result.graph);
  Branch_straightening straightening(solid, result.graph);
  straightening.drop_folds();
  Inside_repair repair(solid, result.graph, number_of_threads);
  repair.draw_back_tips();
  repair();
  Sheet_placement(solid, result.graph).finish();
  straightening.drop_scarce_nodes(
      Vertex_assignment(solid.triangulation(), cut_graph, result.graph, number_of_threads).numbers_of_vertices());
  straightening.blunt_turns();
  result.graph.compact();
  Inside_repair check(solid, result.graph, number_of_threads);
  report.number_of_nodes_outside = check.number_of_nodes_outside();
  report.number_of_edges_outside = check.number_of_edges_outside();
  Vertex_assignment(solid.triangulation(), cut_graph, result.graph, number_of_threads).move_to(result);
  return result;
}

/// The same for separators that were packed without cutting the surface; those that cross an earlier one are left out.
inline Embedded_skeleton build_cut_graph_skeleton(const Triangulated_solid& solid,
                                                  const std::vector<Separator>& separators,
                                                  const std::vector<Index>& packed, Skeletonization_report& report)
{
  Separator_arrangement arrangement(solid.triangulation());
  std::vector<Index> inserted;
  for (Index separator : packed) {
    if (arrangement.insert(separator, separators[separator].crossings)) {
      inserted.push_back(separator);
    }
  }
  Cut_graph cut_graph(solid.triangulation(), arrangement);
  cut_graph.cut(arrangement);
  return build_cut_graph_skeleton(solid, separators, inserted, cut_graph, report);
}

} // namespace CSCD::internal

#endif // CSCD_SKELETON_BUILD_CUT_GRAPH_SKELETON_H
