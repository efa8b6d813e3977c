// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the surface cut along packed separators to its skeleton: topology, a start inside the body, relaxation, and the
// node that each vertex belongs to.

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
#include <CSCD/Skeleton/place_junctions.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/Box_tree.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// For each piece of the cut surface, the nodes that its vertices may belong to, in ascending order: its own, the nodes
/// of the separators around it, and the nodes between these and the next nodes of other pieces and separators.
inline std::vector<std::vector<Index>> nodes_of_pieces(const Cut_graph& cut_graph, const Skeleton_builder& graph)
{
  std::vector<std::vector<Index>> result(cut_graph.pieces().size());
  for (Index node = 0; node < graph.size(); ++node) {
    for (Index piece : graph[node].pieces) {
      result[piece].push_back(node);
    }
  }
  std::vector<Index> last_piece(graph.size(), no_index); // that each node was added to
  for (Index piece = 0; piece < result.size(); ++piece) {
    std::vector<Index>& nodes = result[piece];
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (Index neighbor : graph[nodes[i]].neighbors) {
        if (graph[neighbor].pieces.empty() && std::exchange(last_piece[neighbor], piece) != piece) {
          nodes.push_back(neighbor);
        }
      }
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  }
  return result;
}

/// For each vertex, the nearest node of its piece of the cut surface; so vertices on a limb stay with that limb,
/// however near another one comes.
inline std::vector<Index> assign_vertices(const Triangulated_surface& surface, const Cut_graph& cut_graph,
                                          const Skeleton_builder& graph)
{
  constexpr Index leaf_size = 16; // nodes; most pieces have fewer, whose distances are faster than a search
  const std::vector<std::vector<Index>> nodes_of_piece = nodes_of_pieces(cut_graph, graph);
  std::vector<Box_tree> trees;
  for (const std::vector<Index>& nodes : nodes_of_piece) {
    std::vector<Bounding_box> boxes(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      boxes[i].extend(graph[nodes[i]].position);
    }
    trees.emplace_back(boxes, leaf_size);
  }
  std::vector<Index> result(surface.number_of_vertices());
  for (Index vertex = 0; vertex < result.size(); ++vertex) {
    const Vector3& point = surface.point(vertex);
    const Index piece = cut_graph.piece_of_vertex(vertex);
    std::pair<double, Index> nearest(std::numeric_limits<double>::infinity(), no_index);
    trees[piece].minimize([&point](const Bounding_box& box) { return box.squared_distance(point); },
                          [&](Index i) {
                            const Index node = nodes_of_piece[piece][i];
                            const double squared_distance = (point - graph[node].position).squaredNorm();
                            nearest = std::min(nearest, {squared_distance, node});
                            return squared_distance;
                          });
    result[vertex] = nearest.second;
  }
  return result;
}

/// The distance of `point` from the edges at `node`, or from `node` where it has none.
inline double distance_from_curve(const Skeleton_builder& graph, const Vector3& point, Index node)
{
  const Vector3 offset = point - graph[node].position;
  double least = offset.squaredNorm();
  for (Index neighbor : graph[node].neighbors) {
    const Vector3 edge = graph[neighbor].position - graph[node].position;
    const double squared_length = edge.squaredNorm();
    const double along = squared_length > 0 ? std::clamp(edge.dot(offset) / squared_length, 0., 1.) : 0.;
    if (along > 0) {
      least = std::min(least, (offset - along * edge).squaredNorm());
    }
  }
  return std::sqrt(least);
}

/// For each node, the mean distance of the surface around it from the curve, by area; of an opening, the radius of the
/// border.
inline std::vector<double> mean_radii(const Triangulated_surface& surface, const std::vector<Index>& node_of_vertex,
                                      const Skeleton_builder& graph)
{
  std::vector<double> weight(graph.size(), 0);
  std::vector<double> result(graph.size(), 0);
  for (Index vertex = 0; vertex < node_of_vertex.size(); ++vertex) {
    const Index node = node_of_vertex[vertex];
    const double vertex_weight = double(surface.vertex_area(vertex));
    result[node] += vertex_weight * distance_from_curve(graph, surface.point(vertex), node);
    weight[node] += vertex_weight;
  }
  for (Index node = 0; node < graph.size(); ++node) {
    // A node may lie in its only vertex, where a sheet has no thickness.
    const bool is_measured = weight[node] > 0 && result[node] > 0 && !graph[node].is_opening;
    result[node] = is_measured ? result[node] / weight[node] : graph[node].radius;
  }
  return result;
}

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
  center_junctions(cut.solid, graph);
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
/// The remaining nodes keep their radii. \return whether a node was removed
inline bool thin_branches(const Triangulated_solid& solid, double node_spacing,
                          Inside_routing<Triangulated_solid>& routing, Embedded_skeleton& skeleton)
{
  // A node without vertices may be this far from the edge that replaces it, relative to R; its radius may differ as
  // much. The edge is at most this long, relative to R, so that deviations do not add up.
  constexpr double max_deviation = 0.04;
  constexpr double max_length = 4;

  Skeleton_builder& graph = skeleton.graph;
  std::vector<double>& radius = skeleton.radius;
  std::vector<char> owns_vertex(graph.size(), 0);
  for (Index vertex = 0; vertex < skeleton.node_of_vertex.size(); ++vertex) {
    owns_vertex[skeleton.node_of_vertex[vertex]] |= char(!solid.input_vertices(vertex).empty());
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
  const Index size = graph.size();
  radius = reordered(radius, graph.compact());
  return graph.size() < size;
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
  const Triangulated_surface& surface = solid.triangulation();
  result.node_of_vertex = assign_vertices(surface, cut_graph, graph);
  result.radius = mean_radii(surface, result.node_of_vertex, graph);
  if (thin_branches(solid, node_spacing, routing, result)) {
    result.node_of_vertex = assign_vertices(surface, cut_graph, graph);
  }
  routing.count_outside(report);
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_SKELETON_EMBED_SKELETON_H
