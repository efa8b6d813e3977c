// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Brings what lies outside back into the body.

#ifndef CSCD_SKELETON_INSIDE_REPAIR_H
#define CSCD_SKELETON_INSIDE_REPAIR_H

#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Box_tree.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Moves nodes that lie outside of the body to its middle, and bends edges that leave it by further nodes.
/// \tparam Surface a model of `SkeletonizationSurface`
template <class Surface>
class Inside_repair
{
public:
  Inside_repair(const Surface& surface, Skeleton_builder& builder)
      : m_surface(surface), m_builder(builder), m_offset(relative_offset * diagonal(surface.triangulation().points())),
        m_is_outside(builder.size(), 0)
  {
    for (Index node = 0; node < builder.size(); ++node) {
      const bool has_place = !builder[node].is_removed && !builder[node].is_opening;
      m_is_outside[node] = has_place && !surface.is_inside(builder[node].position) ? 1 : 0;
    }
  }

  /// Repairs what can be repaired, in a few rounds.
  void operator()()
  {
    repair_nodes();
    std::vector<Edge> edges;
    m_builder.for_each_edge([&](Index a, Index b) { edges.emplace_back(a, b); });
    for (int round = 0; round < max_rounds && !edges.empty(); ++round) {
      edges = repair_edges(edges);
    }
  }

  std::size_t number_of_nodes_outside() const
  {
    return std::size_t(std::count(m_is_outside.begin(), m_is_outside.end(), char(1)));
  }

  std::size_t number_of_edges_outside()
  {
    std::size_t count = 0;
    m_builder.for_each_edge([&](Index a, Index b) { count += first_stretch_outside(a, b) ? 1 : 0; });
    return count;
  }

private:
  using Edge = std::pair<Index, Index>;

  static constexpr int max_rounds = 4;
  /// Shorter stretches outside are taken for rounding; relative to the diagonal of the bounding box.
  static constexpr double relative_offset = 1e-7;

  static double diagonal(const std::vector<Vector_3>& points)
  {
    Bounding_box box;
    for (const Vector_3& point : points) {
      box.extend(point);
    }
    return box.diagonal();
  }

  void repair_nodes()
  {
    for (Index node = 0; node < m_builder.size(); ++node) {
      if (m_is_outside[node] == 0) {
        continue;
      }
      if (const std::optional<Vector_3> middle = m_surface.middle_behind(m_builder[node].position)) {
        m_builder[node].position = *middle;
        m_is_outside[node] = 0;
      }
    }
  }

  /// The middle of the first stretch of the edge that is outside. At an opening there is no surface that says.
  std::optional<Vector_3> first_stretch_outside(Index a, Index b)
  {
    if (m_builder[a].is_opening || m_builder[b].is_opening) {
      return std::nullopt;
    }
    const Vector_3& from = m_builder[a].position;
    const Vector_3& to = m_builder[b].position;
    m_surface.crossings(from, to, m_crossings);
    const double length = (to - from).norm();
    m_crossings.push_back(length);
    bool is_outside = m_is_outside[a] != 0;
    double last = 0;
    for (double crossing : m_crossings) {
      if (is_outside && crossing - last > m_offset) {
        return Vector_3(from + (last + crossing) / (2 * length) * (to - from));
      }
      is_outside = !is_outside;
      last = crossing;
    }
    return std::nullopt;
  }

  /// Splits those of `edges` that leave the body. \return the parts, which may leave it again
  std::vector<Edge> repair_edges(const std::vector<Edge>& edges)
  {
    std::vector<Edge> parts;
    for (const auto& [a, b] : edges) {
      const std::optional<Vector_3> outside = first_stretch_outside(a, b);
      if (!outside) {
        continue;
      }
      if (const std::optional<Vector_3> middle = m_surface.middle_behind(*outside)) {
        const Index node = m_builder.split_edge(a, b, *middle, (m_builder[a].radius + m_builder[b].radius) / 2);
        m_is_outside.push_back(0);
        parts.emplace_back(a, node);
        parts.emplace_back(node, b);
      }
    }
    return parts;
  }

  const Surface& m_surface;
  Skeleton_builder& m_builder;
  double m_offset;
  std::vector<char> m_is_outside; ///< for every node
  std::vector<double> m_crossings;
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_INSIDE_REPAIR_H
