// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Merges and centers junctions, and moves those of narrow forks.

#ifndef CSCD_SKELETON_PLACE_JUNCTIONS_H
#define CSCD_SKELETON_PLACE_JUNCTIONS_H

#include <CSCD/Skeleton/Inside_routing.h>
#include <CSCD/Skeleton/Sheet_nodes.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
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

/// Grows an inscribed ball from `start`: steps away from the nearest bounding point as long as the ball gets larger,
/// for at most `max_shift` in all.
/// \param rim points of the borders if the ball is to be in a sheet; empty in a body
inline Ball inscribed_ball(const Solid_queries& body, const std::vector<Vector3>& rim, const Vector3& start,
                           double max_shift)
{
  // More steps move a junction by less than a hundredth of its radius.
  constexpr int number_of_steps = 10;
  constexpr double first_step = 0.5;
  const auto nearest = [&](const Vector3& point) {
    const auto is_nearer = [&](const Vector3& a, const Vector3& b) {
      return (a - point).squaredNorm() < (b - point).squaredNorm();
    };
    return rim.empty() ? body.closest_point(point).point : *std::min_element(rim.begin(), rim.end(), is_nearer);
  };
  Vector3 touched = nearest(start);
  Ball ball{start, (start - touched).norm()};
  double step = first_step;
  for (int i = 0; i < number_of_steps && ball.radius > 0; ++i) {
    const Vector3 next = ball.center + step * (ball.center - touched);
    const std::optional<Vector3> candidate = rim.empty() ? next : point_in_sheet(body, next);
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

/// Moves every junction, at most by the maximal radius around it, to the center of an inscribed ball nearby or, on a
/// sheet, of a disc between borders.
inline void center_junctions(const Triangulated_solid& solid, Skeleton_builder& graph)
{
  const std::vector<Vector3> no_rim;
  std::vector<Vector3> rim; // of sheets; empty until there is a junction on one
  for (Index node = 0; node < graph.size(); ++node) {
    if (!graph.is_junction(node)) {
      continue;
    }
    const Solid_queries& body = solid.queries(graph[node].component);
    if (!body.is_inside(graph[node].position)) {
      continue;
    }
    double max_shift = 0;
    for (const Index neighbor : graph[node].neighbors) {
      max_shift = std::max(max_shift, graph[neighbor].radius);
    }
    if (graph[node].is_on_sheet && rim.empty()) {
      rim = rim_points(solid);
    }
    const Ball ball = inscribed_ball(body, graph[node].is_on_sheet ? rim : no_rim, graph[node].position, max_shift);
    if (body.is_inside(ball.center)) {
      graph[node].position = ball.center;
      graph[node].radius = ball.radius;
    }
  }
}

/// Straightens forks of tubes, as of vessels: a stem parts at a small angle in two branches, and the middle of the body
/// is that of both until their walls part. There, a junction lies up to three radii behind the axes' meeting point.
class Fork_straightening
{
public:
  /// Both are referred to.
  Fork_straightening(Inside_routing<Triangulated_solid>& routing, Skeleton_builder& graph)
      : m_routing(routing), m_graph(graph)
  {
  }

  /// Moves the junctions of all narrow forks of relaxed branches.
  void operator()()
  {
    const Index number_of_nodes = m_graph.size();
    for (Index node = 0; node < number_of_nodes; ++node) {
      if (m_graph.degree(node) == 3 && !m_graph[node].is_on_sheet) {
        straighten(node);
      }
    }
  }

private:
  /// The cosine of the angle between the branches is at least this: of wider forks, the walls part within a radius.
  static constexpr double min_cosine = 0.5;
  /// The cosine of the turn from the stem to the mean direction of the branches.
  static constexpr double min_straightness = 0.8;
  /// The radius of the stem, relative to that of the thicker branch: by Murray's law at most the cube root of two. The
  /// trunk of a body is thicker than its legs.
  static constexpr double max_thickness = 1.26;
  /// The direction of a branch is that of a part of this length, relative to its radius.
  static constexpr double axis_length = 2;
  /// The distance between the axes of the branches, and from these to that of the stem, relative to its radius.
  static constexpr double max_gap = 0.4;
  /// The way of a junction, likewise: shorter ways are not worth it, longer ones not certain.
  static constexpr double min_way = 0.5;
  static constexpr double max_way = 4;
  /// The next node of the stem is at least this far from the new junction, likewise.
  static constexpr double min_edge = 0.3;

  /// A branch, seen from the junction.
  struct Limb
  {
    std::vector<Index> nodes;        ///< from the junction to where the branch has walls of its own
    Vector3 start = Vector3::Zero(); ///< the last of these
    Vector3 direction = Vector3::Zero();
    double radius = 0;
  };

  /// The branch from `junction` over its neighbor `node`; none if it is short.
  std::optional<Limb> limb(Index junction, Index node) const
  {
    Limb result;
    Index last = junction;
    const auto go_on = [&] { last = std::exchange(node, m_graph.other_neighbor(node, last)); };
    const auto is_on_branch = [&] { return m_graph.is_regular(node) && !m_graph[node].is_opening; };
    const auto is_in_ball = [&] { return m_graph.edge_length(node, junction) < m_graph[junction].radius; };
    for (; is_on_branch() && is_in_ball(); go_on()) {
      result.nodes.push_back(node);
    }
    if (!is_on_branch()) {
      return std::nullopt;
    }
    result.nodes.push_back(node);
    result.start = m_graph[node].position;
    result.radius = m_graph[node].radius;
    double length = 0;
    while (is_on_branch() && length < axis_length * result.radius) {
      go_on();
      length += m_graph.edge_length(last, node);
    }
    result.direction = (m_graph[node].position - result.start).normalized();
    return length >= axis_length * result.radius / 2 ? std::optional<Limb>(result) : std::nullopt;
  }

  void straighten(Index junction)
  {
    std::array<Limb, 3> limbs;
    for (std::size_t i = 0; i < 3; ++i) {
      std::optional<Limb> found = limb(junction, m_graph[junction].neighbors[i]);
      if (!found) {
        return;
      }
      limbs[i] = *std::move(found);
    }
    // The stem is opposite to the two that part at the smallest angle.
    const auto cosine = [&](std::size_t i) { return limbs[(i + 1) % 3].direction.dot(limbs[(i + 2) % 3].direction); };
    const std::size_t stem = cosine(0) >= std::max(cosine(1), cosine(2)) ? 0 : cosine(1) >= cosine(2) ? 1 : 2;
    std::rotate(limbs.begin(), limbs.begin() + std::ptrdiff_t(stem), limbs.end());
    const std::optional<Vector3> place = meeting_point(m_graph[junction].position, limbs);
    if (!place) {
      return;
    }
    if (const auto passed = nodes_before(*place, junction, limbs[0])) {
      move(junction, *place, *passed, limbs);
    }
  }

  /// Where the axes of the branches, `limbs` 1 and 2, meet in the stem, `limbs` 0.
  std::optional<Vector3> meeting_point(const Vector3& junction, const std::array<Limb, 3>& limbs)
  {
    const auto& [stem, a, b] = limbs;
    const double cosine = a.direction.dot(b.direction);
    const double squared_sine = 1 - cosine * cosine;
    if (cosine < min_cosine || !(squared_sine > 0) || stem.radius > max_thickness * std::max(a.radius, b.radius) ||
        -stem.direction.dot((a.direction + b.direction).normalized()) < min_straightness) {
      return std::nullopt;
    }
    const Vector3 apart = b.start - a.start;
    const double along_a = (apart.dot(a.direction) - cosine * apart.dot(b.direction)) / squared_sine;
    const double along_b = (cosine * apart.dot(a.direction) - apart.dot(b.direction)) / squared_sine;
    const Vector3 on_a = a.start + along_a * a.direction;
    const Vector3 on_b = b.start + along_b * b.direction;
    const Vector3 place = (on_a + on_b) / 2;
    const Vector3 way = place - junction;
    const double along_stem = way.dot(stem.direction);
    const double gap = std::max((on_a - on_b).norm(), (way - along_stem * stem.direction).norm());
    const bool is_near =
        gap <= max_gap * stem.radius && way.norm() >= min_way * stem.radius && way.norm() <= max_way * stem.radius;
    return is_near && along_stem > 0 && along_a < 0 && along_b < 0 &&
                   m_routing.is_free(a.nodes.back(), place, a.start) &&
                   m_routing.is_free(b.nodes.back(), place, b.start)
               ? std::optional<Vector3>(place)
               : std::nullopt;
  }

  /// The nodes of `stem` that the junction passes on its way to `place`; none if the stem ends there, or the next edge
  /// would leave the body.
  std::optional<std::vector<Index>> nodes_before(const Vector3& place, Index junction, const Limb& stem)
  {
    std::vector<Index> passed;
    Index last = junction;
    Index node = stem.nodes.front();
    while ((m_graph[node].position - place).dot(stem.direction) < min_edge * stem.radius) {
      if (!m_graph.is_regular(node) || m_graph[node].is_opening) {
        return std::nullopt;
      }
      passed.push_back(node);
      last = std::exchange(node, m_graph.other_neighbor(node, last));
    }
    return m_routing.is_free(node, place, m_graph[node].position) ? std::optional(passed) : std::nullopt;
  }

  /// Moves `junction` to `place`, and the first nodes of the branches to straight lines from there. The pieces of the
  /// `passed` nodes go to the nearest of these.
  void move(Index junction, const Vector3& place, const std::vector<Index>& passed, const std::array<Limb, 3>& limbs)
  {
    std::vector<Skeleton_builder::Node> removed;
    for (const Index node : passed) {
      removed.push_back(m_graph[node]);
      m_graph[node].pieces.clear();
      m_graph.contract(node, junction);
    }
    m_graph[junction].position = place;
    m_graph[junction].radius = limbs[0].radius;
    std::vector<Index> nodes{junction};
    lead_straight(junction, limbs[1], nodes);
    lead_straight(junction, limbs[2], nodes);
    for (const Skeleton_builder::Node& node : removed) {
      const auto squared_distance = [&](Index i) { return (m_graph[i].position - node.position).squaredNorm(); };
      Skeleton_builder::Node& heir = m_graph[*std::min_element(
          nodes.begin(), nodes.end(), [&](Index i, Index j) { return squared_distance(i) < squared_distance(j); })];
      heir.pieces.insert(heir.pieces.end(), node.pieces.begin(), node.pieces.end());
    }
  }

  /// Moves the nodes of `limb` to the line from `junction` to its start, inserts others where they would be more than a
  /// radius apart, and appends all to `nodes`.
  void lead_straight(Index junction, const Limb& limb, std::vector<Index>& nodes)
  {
    const Vector3 from = m_graph[junction].position;
    const Vector3 way = limb.start - from;
    const std::size_t number = limb.nodes.size();
    const std::size_t parts = std::max(std::size_t(std::ceil(way.norm() / limb.radius)), number);
    Index last = junction;
    for (std::size_t i = 1; i <= parts; ++i) {
      const Vector3 position = from + double(i) / double(parts) * way;
      const bool is_new = i + number <= parts;
      last = is_new ? m_graph.split_edge(last, limb.nodes.front(), position, limb.radius)
                    : limb.nodes[i + number - parts - 1];
      m_graph[last].position = position;
      nodes.push_back(last);
    }
  }

  Inside_routing<Triangulated_solid>& m_routing;
  Skeleton_builder& m_graph;
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_PLACE_JUNCTIONS_H
