// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Moves nodes into the body, leads edges inside, and counts the rest.

#ifndef CSCD_SKELETON_INSIDE_ROUTING_H
#define CSCD_SKELETON_INSIDE_ROUTING_H

#include <CSCD/Skeleton/Sheet_section.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeleton/Way_inside.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Box_tree.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Keeps the nodes and edges of a skeleton inside the body.
/// \tparam Surface a model of `SkeletonizationSurface`
template <class Surface>
class Inside_routing
{
public:
  /// Both are referred to.
  Inside_routing(const Surface& surface, Skeleton_builder& graph)
      : m_surface(surface), m_graph(graph), m_offset(relative_offset * diagonal(surface.triangulation().points()))
  {
  }

  /// Moves `node` to the middle of the body nearby if it is outside; a junction, such as the one between a handle and
  /// the wall of a cup, to the middle of its neighbors or of the body behind them.
  void bring_inside(Index node)
  {
    if (is_outside(node)) {
      const Vector_3 start = m_graph.is_junction(node) ? m_graph.middle_of_neighbors(node) : m_graph[node].position;
      const std::optional<Vector_3> place =
          m_graph.is_junction(node) && m_surface.is_inside(start) ? start : middle_behind(start, node);
      m_graph[node].position = place.value_or(m_graph[node].position);
    }
  }
  /// Moves all nodes.
  void bring_inside()
  {
    for (Index node = 0; node < m_graph.size(); ++node) {
      bring_inside(node);
    }
  }

  /// Leads all edges inside, as far as that is possible; those of sheets only if `is_on_sheets`, and then only those.
  void route_edges(bool is_on_sheets = false)
  {
    std::optional<Way_inside> way;
    for (const auto& [a, b] : m_graph.edges()) {
      if (is_on_sheets == (m_graph[a].is_on_sheet || m_graph[b].is_on_sheet)) {
        route(a, b, way);
      }
    }
  }

  /// Whether the segment stays inside, if it starts there.
  bool is_free(const Vector_3& from, const Vector_3& to)
  {
    m_surface.crossings(from, to, m_crossings);
    return m_crossings.empty();
  }
  /// Whether the edge stays inside. At an opening, where no surface decides, it does.
  bool is_free(Index a, Index b)
  {
    // Along a face, the answer may depend on the direction: it is always the same one.
    const auto [first, second] = std::minmax(a, b);
    return m_graph[a].is_opening || m_graph[b].is_opening || is_free(m_graph[first].position, m_graph[second].position);
  }

  /// How many nodes and edges are not wholly inside.
  struct Outside
  {
    std::size_t number_of_nodes = 0;
    std::size_t number_of_edges = 0;
  };
  Outside count_outside()
  {
    Outside result;
    std::vector<char> is_node_outside(m_graph.size());
    for (Index node = 0; node < m_graph.size(); ++node) {
      is_node_outside[node] = is_outside(node) ? 1 : 0;
      result.number_of_nodes += is_node_outside[node] != 0 ? 1 : 0;
    }
    m_graph.for_each_edge([&](Index a, Index b) {
      result.number_of_edges += first_stretch_outside(a, b, is_node_outside[a] != 0) ? 1 : 0;
    });
    return result;
  }

private:
  /// How often an edge is bisected at points behind the surface that it meets.
  static constexpr int max_bends = 4;
  /// Shorter stretches outside count as rounding; relative to the diagonal of the bounding box.
  static constexpr double relative_offset = 1e-7;

  static double diagonal(const std::vector<Vector_3>& points)
  {
    Bounding_box box;
    for (const Vector_3& point : points) {
      box.extend(point);
    }
    return box.diagonal();
  }

  /// Whether `node` is the only one of a component without thickness, such as a single triangle. That has no inside:
  /// rays would find another component.
  bool is_flat(Index node) const { return m_graph.degree(node) == 0 && m_graph[node].radius <= m_offset; }

  bool is_outside(Index node) const
  {
    const Skeleton_builder::Node& its = m_graph[node];
    return !its.is_removed && !its.is_opening && (is_flat(node) || !m_surface.is_inside(its.position));
  }

  /// The middle of the body behind `point`, which is at `node` or on an edge there.
  std::optional<Vector_3> middle_behind(const Vector_3& point, Index node) const
  {
    if (m_graph[node].is_on_sheet) {
      return middle_of_sheet(m_surface, point, m_graph[node].radius);
    }
    return is_flat(node) ? std::nullopt : m_surface.middle_behind(point);
  }

  /// The middle of the first stretch of the edge that is outside.
  std::optional<Vector_3> first_stretch_outside(Index a, Index b, bool starts_outside)
  {
    if (is_free(a, b) && (!starts_outside || m_graph[b].is_opening)) {
      return std::nullopt;
    }
    const Vector_3& from = m_graph[a].position;
    const Vector_3& to = m_graph[b].position;
    const double length = (to - from).norm();
    m_surface.crossings(from, to, m_crossings);
    m_crossings.push_back(length);
    bool is_stretch_outside = starts_outside;
    double last = 0;
    for (double crossing : m_crossings) {
      if (is_stretch_outside && crossing - last > m_offset) {
        return Vector_3(from + (last + crossing) / (2 * length) * (to - from));
      }
      is_stretch_outside = !is_stretch_outside;
      last = crossing;
    }
    return std::nullopt;
  }

  /// Leads the edge from `a` to `b` along the surface where it leaves the body or, where that fails, over the middle of
  /// the body behind its first stretch outside.
  void route(Index a, Index b, std::optional<Way_inside>& way, int level = 0)
  {
    if (is_free(a, b)) {
      return;
    }
    const std::optional<Vector_3> stretch = first_stretch_outside(a, b, is_outside(a));
    if (!stretch || follow_surface(a, b, way) || level == max_bends) {
      return;
    }
    if (const std::optional<Vector_3> middle = middle_behind(*stretch, a)) {
      const Index node = m_graph.split_edge(a, b, *middle, mean_radius(a, b));
      route(a, node, way, level + 1);
      route(node, b, way, level + 1);
    }
  }

  /// Leads the edge along the surface, if there is a free way.
  bool follow_surface(Index a, Index b, std::optional<Way_inside>& way)
  {
    if constexpr (std::is_same_v<Surface, Triangulated_solid>) {
      if (m_graph[a].is_on_sheet || m_graph[b].is_on_sheet || is_outside(a) || is_outside(b)) {
        return false;
      }
      if (!way) {
        way.emplace(m_surface);
      }
      std::vector<Vector_3> points = way->find(m_graph[a].position, m_graph[b].position);
      if (points.empty() || !is_free_way(m_graph[a].position, points, m_graph[b].position)) {
        return false;
      }
      const double radius = mean_radius(a, b);
      for (const Vector_3& point : points) {
        a = m_graph.split_edge(a, b, point, radius);
      }
      return true;
    }
    return false;
  }

  /// Whether each part of the way is free in both directions: along faces that touch, the answers may differ.
  bool is_free_way(Vector_3 from, const std::vector<Vector_3>& points, const Vector_3& to)
  {
    const auto goes_to = [&](const Vector_3& point) {
      const Vector_3 last = std::exchange(from, point);
      return is_free(last, point) && is_free(point, last);
    };
    return std::all_of(points.begin(), points.end(), goes_to) && goes_to(to);
  }

  double mean_radius(Index a, Index b) const { return (m_graph[a].radius + m_graph[b].radius) / 2; }

  const Surface& m_surface;
  Skeleton_builder& m_graph;
  double m_offset;
  std::vector<double> m_crossings;
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_INSIDE_ROUTING_H
