// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Merges and centers junctions.

#ifndef CSCD_SKELETON_PLACE_JUNCTIONS_H
#define CSCD_SKELETON_PLACE_JUNCTIONS_H

#include <CSCD/Skeleton/Sheet_nodes.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector3.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace CSCD::internal {

/// Merges two junctions with one node between them if the path over that is shorter than the body is thick there, and
/// the only one of its kind: the graph stays simple.
inline void merge_junctions(Skeleton_builder& graph)
{
  constexpr double max_length = 1; // of the path, relative to the radius at the node between them
  for (Index node = 0; node < graph.size(); ++node) {
    if (!graph.is_regular(node)) {
      continue;
    }
    const Index a = graph[node].neighbors[0];
    const Index b = graph[node].neighbors[1];
    const auto leads_to_b = [&](Index next) {
      return next == b || (graph.is_regular(next) && graph.other_neighbor(next, a) == b);
    };
    const std::vector<Index>& around = graph[a].neighbors;
    if (graph.is_junction(a) && graph.is_junction(b) &&
        graph.edge_length(a, node) + graph.edge_length(node, b) < max_length * graph[node].radius &&
        std::count_if(around.begin(), around.end(), leads_to_b) == 1) {
      const double share = double(graph.degree(b)) / double(graph.degree(a) + graph.degree(b));
      graph[a].position += share * (graph[b].position - graph[a].position);
      graph[a].radius = std::max(graph[a].radius, graph[b].radius);
      graph.contract(node, a);
      graph.contract(b, a);
    }
  }
}

/// A ball in the body.
struct Ball
{
  Vector3 center = Vector3::Zero();
  double radius = 0;
};

/// Grows an inscribed ball from `start`: steps away from the nearest bounding point as long as the ball gets larger,
/// for at most `max_shift` in all.
/// \param nearest a function that returns the bounding point nearest to a point
/// \param place a function that returns where a point is to be instead, if anywhere
template <class Nearest, class Place>
Ball inscribed_ball(const Nearest& nearest, const Place& place, const Vector3& start, double max_shift)
{
  // More steps move a junction by less than a hundredth of its radius.
  constexpr int number_of_steps = 10;
  constexpr double first_step = 0.5;
  Vector3 touched = nearest(start);
  Ball ball{start, (start - touched).norm()};
  double step = first_step;
  for (int i = 0; i < number_of_steps && ball.radius > 0; ++i) {
    const std::optional<Vector3> candidate = place(ball.center + step * (ball.center - touched));
    const Vector3 candidate_touched = nearest(candidate.value_or(start));
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

  Ball ball_in_body(const Vector3& start, double max_shift) const
  {
    return inscribed_ball([this](const Vector3& point) { return m_solid.closest_point(point).point; },
                          [](const Vector3& point) { return std::optional<Vector3>(point); }, start, max_shift);
  }

  /// A ball around a point of a sheet, up to the border.
  Ball disc(const Vector3& start, double max_shift)
  {
    if (m_rim.empty()) {
      m_rim = rim_points(m_solid);
    }
    const auto nearest = [this](const Vector3& point) {
      return *std::min_element(m_rim.begin(), m_rim.end(), [&point](const Vector3& a, const Vector3& b) {
        return (a - point).squaredNorm() < (b - point).squaredNorm();
      });
    };
    const auto place = [this](const Vector3& point) { return point_in_sheet(m_solid, point); };
    return inscribed_ball(nearest, place, start, max_shift);
  }

  const Triangulated_solid& m_solid;
  Skeleton_builder& m_builder;
  std::vector<Vector3> m_rim; ///< of sheets; empty until there is a junction on one
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_PLACE_JUNCTIONS_H
