// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Merges and centers junctions.

#ifndef CSCD_SKELETON_PLACE_JUNCTIONS_H
#define CSCD_SKELETON_PLACE_JUNCTIONS_H

#include <CSCD/Skeleton/Sheet_nodes.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
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
      before = std::exchange(node, m_builder.other_neighbor(node, before));
      path.length += m_builder.edge_length(before, node);
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

/// A ball in the body.
struct Ball
{
  Vector_3 center = Vector_3::Zero();
  double radius = 0;
};

/// Grows an inscribed ball from `start`: steps away from the nearest bounding point as long as the ball gets larger,
/// for at most `max_shift` in all.
/// \param nearest a function that returns the bounding point nearest to a point
/// \param place a function that returns where a point is to be instead, if anywhere
template <class Nearest, class Place>
Ball inscribed_ball(const Nearest& nearest, const Place& place, const Vector_3& start, double max_shift)
{
  // More steps move a junction by less than a hundredth of its radius.
  constexpr int number_of_steps = 10;
  constexpr double first_step = 0.5;
  Vector_3 touched = nearest(start);
  Ball ball{start, (start - touched).norm()};
  double step = first_step;
  for (int i = 0; i < number_of_steps && ball.radius > 0; ++i) {
    const std::optional<Vector_3> candidate = place(ball.center + step * (ball.center - touched));
    const Vector_3 candidate_touched = nearest(candidate.value_or(start));
    const double radius = candidate ? (*candidate - candidate_touched).norm() : 0;
    if (radius <= ball.radius || (*candidate - start).norm() > max_shift) {
      step /= 2;
      continue;
    }
    ball = {*candidate, radius};
    touched = candidate_touched;
  }
  return ball;
}

/// Moves junctions to the center of an inscribed ball nearby, or on sheets, of a disc between borders.
class Junction_centering
{
public:
  Junction_centering(const Triangulated_solid& solid, Skeleton_builder& builder) : m_solid(solid), m_builder(builder) {}

  /// Moves every junction or, if `is_on_sheets`, the junctions on sheets, at most by the maximal radius around it.
  void operator()(bool is_on_sheets = false)
  {
    for (Index node = 0; node < m_builder.size(); ++node) {
      if (m_builder.is_junction(node) && (!is_on_sheets || m_builder[node].is_on_sheet) &&
          m_solid.is_inside(m_builder[node].position)) {
        center(node);
      }
    }
  }

private:
  void center(Index node)
  {
    double radius = 0;
    for (const Index neighbor : m_builder[node].neighbors) {
      radius = std::max(radius, m_builder[neighbor].radius);
    }
    const Ball ball = m_builder[node].is_on_sheet ? disc(m_builder[node].position, radius)
                                                  : ball_in_body(m_builder[node].position, radius);
    if (m_solid.is_inside(ball.center)) {
      m_builder[node].position = ball.center;
      m_builder[node].radius = ball.radius;
    }
  }

  Ball ball_in_body(const Vector_3& start, double max_shift) const
  {
    return inscribed_ball([this](const Vector_3& point) { return m_solid.closest_point(point).point; },
                          [](const Vector_3& point) { return std::optional<Vector_3>(point); }, start, max_shift);
  }

  /// A ball around a point of a sheet, up to the border.
  Ball disc(const Vector_3& start, double max_shift)
  {
    if (m_rim.empty()) {
      m_rim = rim_points(m_solid);
    }
    const auto nearest = [this](const Vector_3& point) {
      return *std::min_element(m_rim.begin(), m_rim.end(), [&point](const Vector_3& a, const Vector_3& b) {
        return (a - point).squaredNorm() < (b - point).squaredNorm();
      });
    };
    const auto place = [this](const Vector_3& point) { return point_in_sheet(m_solid, point); };
    return inscribed_ball(nearest, place, start, max_shift);
  }

  const Triangulated_solid& m_solid;
  Skeleton_builder& m_builder;
  std::vector<Vector_3> m_rim; ///< of sheets; empty until there is a junction on one
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_PLACE_JUNCTIONS_H
