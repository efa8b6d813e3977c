// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the surface cut along packed separators to its skeleton: topology, a start inside the body, relaxation, and the
// node that each vertex belongs to.

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
#include <CSCD/Skeleton/place_junctions.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// Assigns each vertex to the nearest node of its piece of the cut surface; so vertices on a limb stay with that limb,
/// however near another one comes. The nodes of a piece are its own, the nodes of the separators around it, and the
/// nodes between these and the next nodes of other pieces and separators.
class Vertex_assignment
{
public:
  /// Assigns all vertices: compares each with all nodes of its piece.
  Vertex_assignment(const Triangulated_surface& surface, const Cut_graph& cut_graph, const Skeleton_builder& builder)
      : m_surface(surface), m_builder(builder), m_nodes(cut_graph.pieces().size()), m_node(surface.number_of_vertices())
  {
    collect_nodes(cut_graph);
    for (Index vertex = 0; vertex < m_node.size(); ++vertex) {
      m_node[vertex] = nearest(surface.point(vertex), m_nodes[cut_graph.piece_of_vertex(vertex)]);
    }
  }

  /// The nodes of `piece`, in ascending order.
  const std::vector<Index>& nodes(Index piece) const { return m_nodes[piece]; }
  /// The node of `vertex`.
  Index node(Index vertex) const { return m_node[vertex]; }

  /// Mean distance of the surface around each node from the curve, by area; of an opening, the radius of the border.
  std::vector<double> radii() const
  {
    std::vector<double> weight(m_builder.size(), 0);
    std::vector<double> result(m_builder.size(), 0);
    for (Index vertex = 0; vertex < m_node.size(); ++vertex) {
      const double vertex_weight = double(m_surface.vertex_area(vertex));
      result[m_node[vertex]] +=
          vertex_weight * std::sqrt(squared_distance_from_curve(m_surface.point(vertex), m_node[vertex]));
      weight[m_node[vertex]] += vertex_weight;
    }
    for (Index node = 0; node < m_builder.size(); ++node) {
      // A node may lie in its only vertex, where a sheet has no thickness.
      const bool is_measured = weight[node] > 0 && result[node] > 0 && !m_builder[node].is_opening;
      result[node] = is_measured ? result[node] / weight[node] : m_builder[node].radius;
    }
    return result;
  }

  /// The nodes of all vertices.
  const std::vector<Index>& nodes_of_vertices() const { return m_node; }

private:
  void collect_nodes(const Cut_graph& cut_graph)
  {
    std::vector<Index> node_of_separator;
    for (Index node = 0; node < m_builder.size(); ++node) {
      for (Index separator : m_builder[node].separators) {
        node_of_separator.resize(std::max<std::size_t>(node_of_separator.size(), separator + 1), no_index);
        node_of_separator[separator] = node;
      }
      for (Index piece : m_builder[node].pieces) {
        m_nodes[piece].push_back(node);
      }
    }
    std::vector<Index> last_piece(m_builder.size(), no_index); // that each node was added to
    for (Index piece = 0; piece < m_nodes.size(); ++piece) {
      for (Index separator : cut_graph.pieces()[piece].separators) {
        m_nodes[piece].push_back(node_of_separator[separator]);
      }
      add_nodes_between(piece, last_piece);
    }
  }

  /// Adds to the nodes of `piece` the nodes that can be reached from them over nodes that stand for no piece or
  /// separator.
  void add_nodes_between(Index piece, std::vector<Index>& last_piece)
  {
    std::vector<Index>& nodes = m_nodes[piece];
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (Index neighbor : m_builder[nodes[i]].neighbors) {
        const Skeleton_builder::Node& node = m_builder[neighbor];
        if (node.separators.empty() && node.pieces.empty() && last_piece[neighbor] != piece) {
          last_piece[neighbor] = piece;
          nodes.push_back(neighbor);
        }
      }
    }
    std::sort(nodes.begin(), nodes.end());
  }

  double squared_distance(const Vector3& point, Index node) const
  {
    return (point - m_builder[node].position).squaredNorm();
  }

  Index nearest(const Vector3& point, const std::vector<Index>& nodes) const
  {
    return *std::min_element(nodes.begin(), nodes.end(),
                             [&](Index a, Index b) { return squared_distance(point, a) < squared_distance(point, b); });
  }

  /// The squared distance of `point` from the edges at `node`, or from `node` where it has none.
  double squared_distance_from_curve(const Vector3& point, Index node) const
  {
    double least = squared_distance(point, node);
    const Vector3& origin = m_builder[node].position;
    for (Index neighbor : m_builder[node].neighbors) {
      const Vector3 edge = m_builder[neighbor].position - origin;
      const double squared_length = edge.squaredNorm();
      const double along = squared_length > 0 ? std::clamp(edge.dot(point - origin) / squared_length, 0., 1.) : 0.;
      if (along > 0) {
        least = std::min(least, (point - origin - along * edge).squaredNorm());
      }
    }
    return least;
  }

  const Triangulated_surface& m_surface;
  const Skeleton_builder& m_builder;
  std::vector<std::vector<Index>> m_nodes; ///< of each piece
  std::vector<Index> m_node;               ///< of each vertex
};

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
    owns_vertex[assignment.node(vertex)] |= char(!solid.input_vertices(vertex).empty());
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
