// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the surface cut along packed separators to its skeleton: topology, a start inside the body, relaxation.

#ifndef CSCD_SKELETON_EMBED_SKELETON_H
#define CSCD_SKELETON_EMBED_SKELETON_H

#include <CSCD/Options.h>
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
#include <CSCD/Vector3.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Writes the graph that `cut` describes to `graph`, with nodes in the middle of the body nearby: junctions in that of
/// inscribed balls, tips below the ends of limbs.
inline void place_nodes(const Cut_solid& cut, Inside_routing<Triangulated_solid>& routing, Skeleton_builder& graph)
{
  const Piece_vertices pieces(cut);
  const Cut_graph_nodes nodes(cut, pieces, graph);
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

/// Removes nodes from straight parts of branches: nodes that no vertex of the input belongs to, and all nodes whose
/// neighbors are at most `node_spacing` radii apart. The edges that replace them stay inside the body.
/// \param radius of each node, as measured on the surface; the remaining nodes keep theirs
/// \return whether a node was removed
inline bool thin_branches(const Triangulated_solid& solid, const Vertex_assignment& assignment, double node_spacing,
                          Inside_routing<Triangulated_solid>& routing, Skeleton_builder& graph,
                          std::vector<double>& radius)
{
  // A node without vertices may be this far from the edge that replaces it, relative to R; its radius may differ as
  // much. The edge is at most this long, relative to R, so that deviations do not add up.
  constexpr double max_deviation = 0.04;
  constexpr double max_length = 4;

  std::vector<char> owns_vertex(graph.size(), 0);
  for (Index vertex = 0; vertex < solid.triangulation().number_of_vertices(); ++vertex) {
    owns_vertex[assignment.node(vertex)] |= char(solid.input_vertex(vertex) != no_index);
  }
  for (Index index = 0; index < graph.size(); ++index) {
    const Skeleton_builder::Node& node = graph[index];
    if (!graph.is_regular(index) || node.is_opening || !graph.is_bypassable(index)) {
      continue;
    }
    const Index a = node.neighbors[0];
    const Index b = node.neighbors[1];
    const double to_a = graph.edge_length(index, a);
    const double along = to_a / (to_a + graph.edge_length(index, b));
    const Vector3 place = (1 - along) * graph[a].position + along * graph[b].position;
    const double deviation = (place - node.position).norm() / radius[index];
    const double change_of_radius =
        std::abs((1 - along) * radius[a] + along * radius[b] - radius[index]) / radius[index];
    const double length = graph.edge_length(a, b) / radius[index];
    const bool is_needed = owns_vertex[index] || graph.is_junction(a) || graph.is_junction(b) || length > max_length ||
                           std::max(deviation, change_of_radius) > max_deviation;
    if ((!is_needed || length <= node_spacing) && routing.is_free(a, b)) {
      graph.bypass(index);
    }
  }
  Index number_of_nodes = 0;
  for (Index index = 0; index < graph.size(); ++index) {
    if (!graph[index].is_removed) {
      radius[number_of_nodes++] = radius[index];
    }
  }
  radius.resize(number_of_nodes);
  const bool is_thinned = number_of_nodes < graph.size();
  graph.compact();
  return is_thinned;
}

/// The skeleton that `cut_graph` describes, of the surface cut along the `packed` ones of `separators`. Counts the
/// nodes and edges that could not be led inside in `report`.
/// \param node_spacing see `Options`
inline Embedded_skeleton embed_skeleton(const Triangulated_solid& solid, const std::vector<Separator>& separators,
                                        const std::vector<Index>& packed, const Cut_graph& cut_graph,
                                        double node_spacing, Skeletonization_report& report)
{
  Embedded_skeleton result;
  Skeleton_builder& graph = result.graph;
  Inside_routing<Triangulated_solid> routing(solid, graph);
  place_nodes({solid, separators, packed, cut_graph}, routing, graph);
  routing.route_edges();
  divide_branches(graph);
  Branch_relaxation(solid, graph)();
  Fork_straightening(routing, graph)();
  finish_on_sheets(solid, graph);
  routing.route_edges(true);
  graph.compact();
  const auto assign_vertices = [&] { return Vertex_assignment(solid.triangulation(), cut_graph, graph); };
  const Vertex_assignment assignment = assign_vertices();
  result.radius = assignment.radii();
  const bool is_thinned = thin_branches(solid, assignment, node_spacing, routing, graph, result.radius);
  result.node_of_vertex = (is_thinned ? assign_vertices() : assignment).nodes_of_vertices();
  const auto outside = routing.count_outside();
  report.number_of_nodes_outside = outside.number_of_nodes;
  report.number_of_edges_outside = outside.number_of_edges;
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_SKELETON_EMBED_SKELETON_H
