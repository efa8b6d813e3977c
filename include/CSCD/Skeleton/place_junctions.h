// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Merges and centers junctions.

#ifndef CSCD_SKELETON_PLACE_JUNCTIONS_H
#define CSCD_SKELETON_PLACE_JUNCTIONS_H

#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CSCD::internal {

/// Merges two junctions whenever the path between them is shorter than the body is thick there.
/// The number of independent cycles stays: junctions that are joined by more than one path are left alone.
class Junction_merging
{
public:
  explicit Junction_merging(Skeleton_builder& builder) : m_builder(builder) {}

  void operator()()
  {
    for (Index node = 0; node < m_builder.size(); ++node) {
      while (m_builder.is_junction(node) && merge_one_into(node)) {
      }
    }
  }

private:
  /// Junctions are merged if the path between them is shorter than this, relative to the minimal radius on the path.
  static constexpr double max_length = 1;
  /// A path of more nodes than this is never that short.
  static constexpr std::size_t max_path_nodes = 4;

  /// The nodes strictly between two junctions, and the second junction.
  struct Path
  {
    std::vector<Index> inner;
    Index end = no_index;
    double length = 0;
    double min_radius = std::numeric_limits<double>::max();
  };

  Path walk(Index start, Index first) const
  {
    Path path;
    Index before = start;
    Index node = first;
    path.length = m_builder.edge_length(start, first);
    while (m_builder.is_regular(node) && path.inner.size() < max_path_nodes) {
      path.inner.push_back(node);
      path.min_radius = std::min(path.min_radius, m_builder[node].radius);
      const std::vector<Index>& neighbors = m_builder[node].neighbors;
      const Index next = neighbors[0] == before ? neighbors[1] : neighbors[0];
      path.length += m_builder.edge_length(node, next);
      before = node;
      node = next;
    }
    path.end = node;
    return path;
  }

  bool merge_one_into(Index junction)
  {
    for (Index first : m_builder[junction].neighbors) {
      const Path path = walk(junction, first);
      const bool is_short = !path.inner.empty() && path.length < max_length * path.min_radius;
      if (is_short && path.end != junction && m_builder.is_junction(path.end) && is_only_path(junction, path.end)) {
        merge(junction, path);
        return true;
      }
    }
    return false;
  }

  bool is_only_path(Index junction, Index end) const
  {
    const std::vector<Index>& neighbors = m_builder[junction].neighbors;
    return std::count_if(neighbors.begin(), neighbors.end(),
                         [&](Index first) { return walk(junction, first).end == end; }) == 1;
  }

  void merge(Index junction, const Path& path)
  {
    const auto weight = double(m_builder.degree(junction));
    const auto other_weight = double(m_builder.degree(path.end));
    m_builder[junction].position =
        (weight * m_builder[junction].position + other_weight * m_builder[path.end].position) / (weight + other_weight);
    m_builder[junction].radius = std::max(m_builder[junction].radius, m_builder[path.end].radius);
    for (Index node : path.inner) {
      m_builder.contract(node, junction);
    }
    m_builder.contract(path.end, junction);
  }

  Skeleton_builder& m_builder;
};

/// Merges junctions of `builder` that are closer to each other than the body is thick there.
inline void merge_junctions(Skeleton_builder& builder)
{
  Junction_merging merging(builder);
  merging();
}

/// A ball in the body.
struct Ball
{
  Vector_3 center = Vector_3::Zero();
  double radius = 0;
};

/// Grows an inscribed ball from `start`: steps away from the nearest point of the surface as long as the ball gets
/// larger, for at most `max_shift` in all.
inline Ball inscribed_ball(const Triangulated_solid& solid, const Vector_3& start, double max_shift)
{
  // More steps move a junction by less than a hundredth of its radius.
  constexpr int number_of_steps = 10;
  constexpr double first_step = 0.5;
  Vector_3 nearest = solid.closest_point(start).point;
  Ball ball{start, (start - nearest).norm()};
  double step = first_step;
  for (int i = 0; i < number_of_steps && ball.radius > 0; ++i) {
    const Vector_3 candidate = ball.center + step * (ball.center - nearest);
    const Vector_3 candidate_nearest = solid.closest_point(candidate).point;
    const double radius = (candidate - candidate_nearest).norm();
    if (radius <= ball.radius || (candidate - start).norm() > max_shift) {
      step /= 2;
      continue;
    }
    ball = {candidate, radius};
    nearest = candidate_nearest;
  }
  return ball;
}

/// Moves every junction of `builder` to the center of an inscribed ball nearby, at most by the maximal radius around
/// it.
inline void center_junctions(const Triangulated_solid& solid, Skeleton_builder& builder)
{
  for (Index node = 0; node < builder.size(); ++node) {
    if (!builder.is_junction(node) || builder[node].is_on_sheet) {
      continue;
    }
    double radius = 0;
    for (Index neighbor : builder[node].neighbors) {
      radius = std::max(radius, builder[neighbor].radius);
    }
    if (!solid.is_inside(builder[node].position)) {
      continue;
    }
    const Ball ball = inscribed_ball(solid, builder[node].position, radius);
    if (solid.is_inside(ball.center)) {
      builder[node].position = ball.center;
      builder[node].radius = ball.radius;
    }
  }
}

/// Removes the nodes next to a junction, within its ball, at which the branch turns by more than a right angle: the
/// junction was moved past them, and the branch would double back. Neither topology nor the simplicity of the graph
/// change.
inline void drop_overshoots(Skeleton_builder& builder)
{
  const auto doubles_back = [&](Index junction, Index node, Index next) {
    const Vector_3& position = builder[node].position;
    const Vector_3 step = position - builder[junction].position;
    return step.norm() < builder[junction].radius && step.dot(builder[next].position - position) < 0;
  };
  const auto overshooting_neighbor = [&](Index junction) {
    for (Index node : builder[junction].neighbors) {
      if (!builder.is_regular(node)) {
        continue;
      }
      const std::vector<Index>& ends = builder[node].neighbors;
      const Index next = ends[0] == junction ? ends[1] : ends[0];
      const std::vector<Index>& around = builder[junction].neighbors;
      const bool stays_simple = next != junction && std::find(around.begin(), around.end(), next) == around.end();
      if (stays_simple && builder.degree(next) == 2 && doubles_back(junction, node, next)) {
        return node;
      }
    }
    return no_index;
  };
  for (Index junction = 0; junction < builder.size(); ++junction) {
    while (builder.is_junction(junction)) {
      const Index node = overshooting_neighbor(junction);
      if (node == no_index) {
        break;
      }
      builder.bypass(node);
    }
  }
}

} // namespace CSCD::internal

#endif // CSCD_SKELETON_PLACE_JUNCTIONS_H
