// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the surface cut along packed separators to its skeleton: topology, a start inside the body, relaxation.

#ifndef CSCD_SKELETON_EMBED_SKELETON_H
#define CSCD_SKELETON_EMBED_SKELETON_H

#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Branch_relaxation.h>
#include <CSCD/Skeleton/Cut_graph_nodes.h>
#include <CSCD/Skeleton/Inside_routing.h>
#include <CSCD/Skeleton/Limb_ends.h>
#include <CSCD/Skeleton/Sheet_nodes.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeleton/Vertex_assignment.h>
#include <CSCD/Skeleton/place_junctions.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector_3.h>

#include <utility>
#include <vector>

namespace CSCD::internal {

/// Writes the graph that `cut` describes to `graph`, with nodes in the middle of the body nearby: junctions in that of
/// inscribed balls, tips below the ends of limbs.
inline void place_nodes(const Cut_solid& cut, Inside_routing<Triangulated_solid>& routing, Skeleton_builder& graph)
{
  const Piece_vertices pieces(cut);
  const Cut_graph_nodes nodes(cut, pieces, routing, graph);
  make_simple(graph);
  merge_junctions(graph);
  settle_on_sheets(cut.solid, graph);
  routing.bring_inside();
  Junction_centering(cut.solid, graph)();
  Limb_ends(cut, pieces, nodes, graph)();
}

/// Centers the nodes of `graph` that are on sheets, and leads branches to the borders.
inline void finish_on_sheets(const Triangulated_solid& solid, Skeleton_builder& graph)
{
  if (solid.number_of_sheets() > 0) {
    Branch_relaxation relaxation(solid, graph);
    relaxation(true);
    Sheet_ends(solid, graph)();
    relaxation(true); // the last nodes have a direction now
    settle_on_sheets(solid, graph);
  }
}

/// The skeleton that `cut_graph` describes, of the surface cut along the `packed` ones of `separators`. Counts the
/// nodes and edges that could not be led inside in `report`.
inline Embedded_skeleton embed_skeleton(const Triangulated_solid& solid, const std::vector<Separator>& separators,
                                        const std::vector<Index>& packed, const Cut_graph& cut_graph,
                                        Skeletonization_report& report)
{
  Embedded_skeleton result;
  Skeleton_builder& graph = result.graph;
  Inside_routing<Triangulated_solid> routing(solid, graph);
  place_nodes({solid, separators, packed, cut_graph}, routing, graph);
  routing.route_edges();
  Branch_division(routing, graph)();
  Branch_relaxation(solid, graph)();
  finish_on_sheets(solid, graph);
  routing.route_edges(true);
  graph.compact();
  const auto outside = routing.count_outside();
  report.number_of_nodes_outside = outside.number_of_nodes;
  report.number_of_edges_outside = outside.number_of_edges;
  Vertex_assignment(solid.triangulation(), cut_graph, graph).move_to(result);
  return result;
}

/// The same for separators that were packed without cutting the surface; separators that cross an earlier one are left
/// out.
inline Embedded_skeleton embed_skeleton(const Triangulated_solid& solid, const std::vector<Separator>& separators,
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
  return embed_skeleton(solid, separators, inserted, cut_graph, report);
}

} // namespace CSCD::internal

#endif // CSCD_SKELETON_EMBED_SKELETON_H
