// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which node each vertex belongs to, and how thick the body is around each node.

#ifndef CSCD_SKELETON_VERTEX_ASSIGNMENT_H
#define CSCD_SKELETON_VERTEX_ASSIGNMENT_H

#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/parallel.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Assigns each vertex to the nearest node that can be reached by going downhill, in distance, from a node of its own
/// piece of the surface; so vertices on a limb stay with that limb, however near another one comes.
class Vertex_assignment
{
public:
  /// Assigns all vertices; linear in their number for skeletons of bounded degree.
  Vertex_assignment(const Triangulated_surface& surface, const Cut_graph& cut_graph, const Skeleton_builder& builder,
                    unsigned number_of_threads = 1)
      : m_surface(surface), m_builder(builder), m_node(surface.number_of_vertices())
  {
    collect_starts(cut_graph);
    for_each_range(Index(m_node.size()), number_of_threads, [&](Index begin, Index end) {
      for (Index vertex = begin; vertex < end; ++vertex) {
        m_node[vertex] =
            descend(surface.point(vertex), nearest_start(surface.point(vertex), cut_graph.piece_of_vertex(vertex)));
      }
    });
  }

  /// The node to which `vertex` belongs.
  Index node(Index vertex) const { return m_node[vertex]; }
  /// For each node, how many vertices belong to it.
  std::vector<Index> numbers_of_vertices() const
  {
    std::vector<Index> result(m_builder.size(), 0);
    for (Index node : m_node) {
      ++result[node];
    }
    return result;
  }

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

  /// Hands nodes and radii over to `skeleton`, and is empty afterwards.
  void move_to(Embedded_skeleton& skeleton) &&
  {
    skeleton.radius = radii();
    skeleton.node_of_vertex = std::move(m_node);
  }

private:
  /// For each piece, the nodes of its separators and its own.
  void collect_starts(const Cut_graph& cut_graph)
  {
    m_starts.resize(cut_graph.pieces().size());
    std::vector<Index> node_of_separator;
    for (Index node = 0; node < m_builder.size(); ++node) {
      for (Index separator : m_builder[node].separators) {
        node_of_separator.resize(std::max<std::size_t>(node_of_separator.size(), separator + 1), no_index);
        node_of_separator[separator] = node;
      }
      for (Index piece : m_builder[node].pieces) {
        m_starts[piece].push_back(node);
      }
    }
    for (Index piece = 0; piece < m_starts.size(); ++piece) {
      for (Index separator : cut_graph.pieces()[piece].separators) {
        m_starts[piece].push_back(node_of_separator[separator]);
      }
    }
  }

  double squared_distance(const Vector_3& point, Index node) const
  {
    return (point - m_builder[node].position).squaredNorm();
  }

  Index nearest_start(const Vector_3& point, Index piece) const
  {
    return *std::min_element(m_starts[piece].begin(), m_starts[piece].end(),
                             [&](Index a, Index b) { return squared_distance(point, a) < squared_distance(point, b); });
  }

  Index descend(const Vector_3& point, Index node) const
  {
    double least = squared_distance(point, node);
    for (bool is_descending = true; is_descending;) {
      is_descending = false;
      for (Index neighbor : m_builder[node].neighbors) {
        const double distance = squared_distance(point, neighbor);
        if (distance < least) {
          least = distance;
          node = neighbor;
          is_descending = true;
          break;
        }
      }
    }
    return node;
  }

  /// The squared distance of `point` from the edges at `node`, or from `node` where it has none.
  double squared_distance_from_curve(const Vector_3& point, Index node) const
  {
    double least = squared_distance(point, node);
    const Vector_3& origin = m_builder[node].position;
    for (Index neighbor : m_builder[node].neighbors) {
      const Vector_3 edge = m_builder[neighbor].position - origin;
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
  std::vector<Index> m_node;
  std::vector<std::vector<Index>> m_starts;
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_VERTEX_ASSIGNMENT_H
