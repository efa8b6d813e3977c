// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Brings what lies outside back into the body.

#ifndef CSCD_SKELETON_INSIDE_REPAIR_H
#define CSCD_SKELETON_INSIDE_REPAIR_H

#include <CSCD/Skeleton/Skeleton_draft.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Moves nodes that lie outside of the body to its middle, and bends edges that leave it by further nodes.
/// \tparam Traits a model of `SolidSkeletonizationTraits`
template <class Traits>
class Inside_repair
{
public:
  Inside_repair(const Traits& traits, Skeleton_draft& draft)
      : m_traits(traits), m_draft(draft), m_sample_length(relative_sample_length * diagonal(traits))
  {
  }

  /// Repairs what can be repaired, in a few rounds.
  void operator()()
  {
    std::vector<std::pair<Index, Index>> edges;
    m_draft.for_each_edge([&](Index a, Index b) { edges.emplace_back(a, b); });
    for (int round = 0; round < most_rounds; ++round) {
      const bool has_moved = repair_nodes();
      const bool has_split = repair_edges(edges);
      if (!has_moved && !has_split) {
        return;
      }
      if (has_moved) {
        // The edges of a moved node are not those that were found good.
        edges.clear();
        m_draft.for_each_edge([&](Index a, Index b) { edges.emplace_back(a, b); });
      }
    }
  }

  std::size_t number_of_nodes_outside() const
  {
    std::size_t count = 0;
    for (Index node = 0; node < m_draft.size(); ++node) {
      count += !m_draft[node].is_removed && !m_traits.is_inside(m_draft[node].position) ? 1 : 0;
    }
    return count;
  }

  std::size_t number_of_edges_outside() const
  {
    std::size_t count = 0;
    m_draft.for_each_edge([&](Index a, Index b) { count += first_stretch_outside(a, b) ? 1 : 0; });
    return count;
  }

private:
  static constexpr int most_rounds = 4;
  /// Edges are tested at points this far apart, relative to the diagonal of the bounding box.
  static constexpr double relative_sample_length = 1. / 250;
  /// Rays into the body start this far from the surface, relative to the same.
  static constexpr double relative_offset = 1e-7;

  static double diagonal(const Traits& traits)
  {
    Eigen::AlignedBox3d box;
    for (const Vector_3& point : traits.solid_surface().points()) {
      box.extend(point);
    }
    return box.diagonal().norm();
  }

  /// The middle of the body behind the surface point that is nearest to `point`.
  std::optional<Vector_3> middle_behind(const Vector_3& point) const
  {
    const auto nearest = m_traits.closest_point(point);
    const Vector_3 inward = -m_traits.solid_surface().face_vector(nearest.face).normalized();
    const double offset = relative_offset * m_sample_length / relative_sample_length;
    const auto hit = m_traits.first_hit(nearest.point + offset * inward, inward);
    if (!hit) {
      return std::nullopt;
    }
    const Vector_3 middle = (nearest.point + hit->point) / 2;
    return m_traits.is_inside(middle) ? std::optional<Vector_3>(middle) : std::nullopt;
  }

  bool repair_nodes()
  {
    bool has_moved = false;
    for (Index node = 0; node < m_draft.size(); ++node) {
      if (m_draft[node].is_removed || m_traits.is_inside(m_draft[node].position)) {
        continue;
      }
      if (const std::optional<Vector_3> middle = middle_behind(m_draft[node].position)) {
        m_draft[node].position = *middle;
        has_moved = true;
      }
    }
    return has_moved;
  }

  /// The middle of the first stretch of the edge that is outside.
  std::optional<Vector_3> first_stretch_outside(Index a, Index b) const
  {
    const Vector_3& from = m_draft[a].position;
    const Vector_3& to = m_draft[b].position;
    const int samples = int(std::ceil((to - from).norm() / m_sample_length));
    const auto at = [&](int i) -> Vector_3 { return from + (double(i) / samples) * (to - from); };
    for (int i = 1; i < samples; ++i) {
      if (m_traits.is_inside(at(i))) {
        continue;
      }
      int last = i;
      while (last + 1 < samples && !m_traits.is_inside(at(last + 1))) {
        ++last;
      }
      return (at(i) + at(last)) / 2;
    }
    return std::nullopt;
  }

  /// Splits the edges in `edges` that leave the body, and leaves in it the parts, which may leave it again.
  bool repair_edges(std::vector<std::pair<Index, Index>>& edges)
  {
    std::vector<std::pair<Index, Index>> parts;
    for (const auto& [a, b] : edges) {
      const std::optional<Vector_3> outside = first_stretch_outside(a, b);
      if (!outside) {
        continue;
      }
      if (const std::optional<Vector_3> middle = middle_behind(*outside)) {
        const Index node = m_draft.split_edge(a, b, *middle, (m_draft[a].radius + m_draft[b].radius) / 2);
        parts.emplace_back(a, node);
        parts.emplace_back(node, b);
      }
    }
    edges = std::move(parts);
    return !edges.empty();
  }

  const Traits& m_traits;
  Skeleton_draft& m_draft;
  double m_sample_length;
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_INSIDE_REPAIR_H
