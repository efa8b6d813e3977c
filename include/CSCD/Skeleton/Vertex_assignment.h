// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which node each vertex belongs to, and how thick the body is around each node.

#ifndef CSCD_SKELETON_VERTEX_ASSIGNMENT_H
#define CSCD_SKELETON_VERTEX_ASSIGNMENT_H

#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>

#include <algorithm>
#include <cstddef>
#include <utility>
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

} // namespace CSCD::internal

#endif // CSCD_SKELETON_VERTEX_ASSIGNMENT_H
