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
#include <limits>
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
      : m_surface(surface), m_builder(builder), m_diagonal(diagonal(surface.triangulation().points())),
        m_offset(relative_offset * m_diagonal), m_is_outside(builder.size(), 0)
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
      if (round == rounds_to_nearest && number_outside(edges) > max_edges_led_around) {
        return;
      }
      edges = repair_edges(edges, round >= rounds_to_nearest);
    }
  }

  std::size_t number_of_nodes_outside() const
  {
    return std::size_t(std::count(m_is_outside.begin(), m_is_outside.end(), char(1)));
  }

  std::size_t number_of_edges_outside()
  {
    std::vector<Edge> edges;
    m_builder.for_each_edge([&](Index a, Index b) { edges.emplace_back(a, b); });
    return number_outside(edges);
  }

private:
  using Edge = std::pair<Index, Index>;

  /// Edges that are still outside after this many rounds are led where the way is free ...
  static constexpr int rounds_to_nearest = 4;
  /// ... in the rounds that are left. Twice as many bring no further edge of the Princeton meshes inside.
  static constexpr int max_rounds = 8;
  /// Meshes of bodies have one or two such edges. Where there are more, the surface cuts itself, and looking for ways
  /// around would take most of the time.
  static constexpr std::size_t max_edges_led_around = 8;
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

  std::size_t number_outside(const std::vector<Edge>& edges)
  {
    return std::size_t(std::count_if(edges.begin(), edges.end(), [this](const Edge& edge) {
      return first_stretch_outside(edge.first, edge.second).has_value();
    }));
  }

  /// Splits those of `edges` that leave the body, by nodes behind the nearest surface or, if `is_thorough`, wherever
  /// the way is free. \return the parts, which may leave it again
  std::vector<Edge> repair_edges(const std::vector<Edge>& edges, bool is_thorough)
  {
    std::vector<Edge> parts;
    for (const auto& [a, b] : edges) {
      const std::optional<Vector_3> outside = first_stretch_outside(a, b);
      if (!outside) {
        continue;
      }
      const std::optional<Vector_3> middle =
          is_thorough ? middle_around(*outside, {a, b}) : m_surface.middle_behind(*outside);
      if (middle) {
        const Index node = m_builder.split_edge(a, b, *middle, (m_builder[a].radius + m_builder[b].radius) / 2);
        m_is_outside.push_back(0);
        parts.emplace_back(a, node);
        parts.emplace_back(node, b);
      } else {
        parts.emplace_back(a, b);
      }
    }
    return parts;
  }

  /// Of the middles of the body along lines from `outside` in directions all around, the nearest that sees both ends of
  /// `edge`.
  std::optional<Vector_3> middle_around(const Vector_3& outside, const Edge& edge)
  {
    std::optional<Vector_3> best;
    double least = std::numeric_limits<double>::max();
    for (const Vector_3& direction : directions(outside - m_builder[edge.first].position, outside)) {
      const std::optional<Vector_3> middle = middle_along(outside, direction);
      if (!middle || (*middle - m_builder[edge.first].position).norm() <= m_offset ||
          (*middle - m_builder[edge.second].position).norm() <= m_offset) {
        continue; // none, or an end of the edge, which may have been moved there itself
      }
      const double distance = (*middle - outside).squaredNorm();
      if (distance < least && sees_ends(*middle, edge)) {
        best = middle;
        least = distance;
      }
    }
    return best;
  }

  bool sees_ends(const Vector_3& point, const Edge& edge)
  {
    for (const Index end : {edge.first, edge.second}) {
      m_surface.crossings(m_builder[end].position, point, m_crossings);
      if (!m_crossings.empty()) {
        return false;
      }
    }
    return true;
  }

  /// The middle of the first stretch of the body that the ray from `outside` along `direction` meets.
  std::optional<Vector_3> middle_along(const Vector_3& outside, const Vector_3& direction)
  {
    m_surface.crossings(outside, outside + m_diagonal * direction, m_crossings);
    if (m_crossings.size() < 2) {
      return std::nullopt;
    }
    const Vector_3 middle = outside + (m_crossings[0] + m_crossings[1]) / 2 * direction;
    return m_surface.is_inside(middle) ? std::optional<Vector_3>(middle) : std::nullopt;
  }

  /// Directions all around: those to the faces, edges and corners of a cube with a side along `first`, turned towards
  /// `second`, so that they turn with the body.
  static std::vector<Vector_3> directions(const Vector_3& first, const Vector_3& second)
  {
    const Vector_3 x = first.norm() > 0 ? first.normalized() : Vector_3(Vector_3::UnitX());
    const Vector_3 across = second - second.dot(x) * x;
    const Vector_3 y = across.norm() > 0 ? across.normalized() : x.unitOrthogonal();
    const Vector_3 z = x.cross(y);
    std::vector<Vector_3> result;
    result.reserve(26);
    for (int i = -1; i <= 1; ++i) {
      for (int j = -1; j <= 1; ++j) {
        for (int k = -1; k <= 1; ++k) {
          if (i != 0 || j != 0 || k != 0) {
            result.push_back((double(i) * x + double(j) * y + double(k) * z).normalized());
          }
        }
      }
    }
    return result;
  }

  const Surface& m_surface;
  Skeleton_builder& m_builder;
  double m_diagonal;
  double m_offset;
  std::vector<char> m_is_outside; ///< for every node
  std::vector<double> m_crossings;
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_INSIDE_REPAIR_H
