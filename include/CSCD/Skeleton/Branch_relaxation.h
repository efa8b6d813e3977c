// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Divides the edges of branches, and moves their nodes to the middle of the body.
//
// R is the radius of the body at a node. A node of degree 2 has a target: the center of the section of the body, or of
// the sheet, perpendicular to the branch. Each sweep moves it part of the way there, and part of the way to a smooth
// curve through its neighbors. A step that leads an edge out of the body, or makes the branch turn back, is halved.

#ifndef CSCD_SKELETON_BRANCH_RELAXATION_H
#define CSCD_SKELETON_BRANCH_RELAXATION_H

#include <CSCD/Separator/Plane_section.h>
#include <CSCD/Skeleton/Inside_routing.h>
#include <CSCD/Skeleton/Sheet_nodes.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector3.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Divides long edges, so that branches have nodes at the right distance: as many short parts as the vertices allow
/// and, for any number of vertices, none too long.
inline void divide_branches(Skeleton_builder& graph)
{
  // The length of the parts of an edge, relative to R, if they own enough vertices, ...
  constexpr double part_length = 0.5;
  // ... which are so many for each part, on the average, ...
  constexpr double part_vertices = 12;
  // ... and for any number of owned vertices: longer edges look broken in thick bodies.
  constexpr double max_part_length = 1;
  // Bounds the work on long, thin edges.
  constexpr double max_parts = 30;

  const auto owned = [&graph](Index node) { return graph[node].number_of_vertices / double(graph.degree(node)); };
  for (const auto& [a, b] : graph.edges()) {
    const Skeleton_builder::Node from = graph[a];
    const Skeleton_builder::Node to = graph[b];
    if (from.is_opening || to.is_opening) {
      continue;
    }
    const double length = 2 * graph.edge_length(a, b) / (from.radius + to.radius);
    const double short_parts =
        std::min(std::floor(length / part_length) + 1, std::floor((owned(a) + owned(b)) / part_vertices));
    // The ball of a junction has no sections to center more nodes in.
    const double wanted = graph.is_junction(a) || graph.is_junction(b) ? 1 : short_parts;
    const double parts = std::min(std::max(wanted, std::floor(length / max_part_length) + 1), max_parts);
    Index last = a;
    for (int i = 1; i < parts; ++i) {
      const double along = i / parts;
      last = graph.split_edge(last, b, (1 - along) * from.position + along * to.position,
                              (1 - along) * from.radius + along * to.radius);
    }
  }
}

/// Sections of the body. Reuse one object.
class Body_section
{
public:
  explicit Body_section(const Triangulated_solid& solid)
      : m_solid(solid), m_section(solid.query_surface()), m_reference(solid.triangulation().point(0))
  {
  }

  /// The section of `component` through `point` perpendicular to `axis`, if it surrounds the point, its centroid is in
  /// it, and it is about as large as expected and compact.
  std::optional<Ball> operator()(Index component, const Vector3& point, const Vector3& axis, double radius)
  {
    const Vector3 aside = axis.cross(m_reference);
    const auto hit =
        m_solid.queries(component).first_hit(point, aside.norm() > 0 ? aside.normalized() : axis.unitOrthogonal());
    if (!hit || !m_section.cut_at_face(hit->face, axis, point, max_length * 2 * pi * radius) ||
        !is_in_outline(m_section.points(), point, axis)) {
      return std::nullopt;
    }
    const Section_disc disc = section_disc(m_section.points());
    const bool is_compact = m_section.length() * m_section.length() <= max_squared_length * 4 * pi * disc.area;
    return is_compact && disc.radius() <= max_radius * radius && is_in_outline(m_section.points(), disc.center, axis)
               ? std::optional<Ball>({disc.center, disc.radius()})
               : std::nullopt;
  }

private:
  static constexpr double pi = boost::math::double_constants::pi;
  /// The length of a section, relative to the expected circle.
  static constexpr double max_length = 4;
  /// The radius of a section, relative to the expected one.
  static constexpr double max_radius = 1.5;
  /// The squared length of a section, relative to that of the circle of the same area.
  static constexpr double max_squared_length = 2;

  const Triangulated_solid& m_solid;
  Plane_section m_section;
  Vector3 m_reference; ///< a vector that moves with the body
};

/// Moves the nodes of branches to the middle of the body, and smooths the branches.
class Branch_relaxation
{
public:
  /// Both are referred to.
  Branch_relaxation(const Triangulated_solid& solid, Skeleton_builder& graph)
      : m_solid(solid), m_graph(graph), m_routing(solid, graph), m_body_section(solid), m_sheet_section(solid)
  {
  }

  /// Relaxes all branches or, if `is_on_sheets`, the branches on sheets.
  void operator()(bool is_on_sheets = false)
  {
    const auto is_chosen = [&](Index node) {
      return m_graph.is_regular(node) && !m_graph[node].is_opening && (!is_on_sheets || m_graph[node].is_on_sheet);
    };
    std::vector<std::optional<Ball>> targets(m_graph.size());
    for (int sweep = 0; sweep < number_of_sweeps + number_of_smoothings; ++sweep) {
      const bool is_smoothing = sweep >= number_of_sweeps;
      for (Index node = 0; node < m_graph.size(); ++node) {
        targets[node] = is_chosen(node) && !is_smoothing ? target(node) : std::nullopt;
      }
      for (Index node = 0; node < m_graph.size(); ++node) {
        if (is_chosen(node)) {
          move(node, targets[node], is_smoothing);
        }
      }
    }
  }

private:
  using Node = Skeleton_builder::Node;

  static constexpr int number_of_sweeps = 4;
  /// Further sweeps without targets: centers of sections scatter with the triangles.
  static constexpr int number_of_smoothings = 2;
  /// The part of the way to the target, ...
  static constexpr double center_share = 0.6;
  /// ... of the way to the smooth curve, next to a target and ...
  static constexpr double smooth_share = 0.25;
  /// ... in sweeps without targets, ...
  static constexpr double last_smooth_share = 0.3;
  /// ... and of the way to the middle of the neighbors if a node has no target.
  static constexpr double plain_share = 0.2;
  /// The change of R, relative to its difference from the radius of the section.
  static constexpr double radius_share = 0.5;
  /// The distance of a target from its node, relative to R.
  static constexpr double max_shift = 0.5;
  /// How often a step is halved.
  static constexpr int max_halvings = 3;

  /// The middle of the body near the regular `index`, if a section decides it.
  std::optional<Ball> target(Index index)
  {
    const Node& node = m_graph[index];
    const Index from = node.neighbors[0];
    const Index to = node.neighbors[1];
    const Vector3 way = m_graph[to].position - m_graph[from].position;
    if (!(way.norm() > 0) || turn_cosine(index) < 0 || is_in_junction(index, from) || is_in_junction(index, to)) {
      return std::nullopt;
    }
    const Vector3 axis = way.normalized();
    const std::optional<Ball> middle = node.is_on_sheet
                                           ? m_sheet_section(node.component, node.position, axis, node.radius)
                                           : m_body_section(node.component, node.position, axis, node.radius);
    const bool is_near = middle && (middle->center - node.position).norm() <= max_shift * node.radius;
    return is_near ? middle : std::nullopt;
  }

  /// Whether `node` is in the ball of the junction `neighbor`, where sections lead into other branches.
  bool is_in_junction(Index node, Index neighbor) const
  {
    return m_graph.is_junction(neighbor) && m_graph.edge_length(node, neighbor) < m_graph[neighbor].radius;
  }

  /// The cosine of the turn at a regular node, 1 at any other.
  double turn_cosine(Index node) const
  {
    if (!m_graph.is_regular(node)) {
      return 1;
    }
    const Vector3 in = m_graph[node].position - m_graph[m_graph[node].neighbors[0]].position;
    const Vector3 out = m_graph[m_graph[node].neighbors[1]].position - m_graph[node].position;
    const double product = in.norm() * out.norm();
    return product > 0 ? in.dot(out) / product : -1;
  }

  /// Where the regular `node` would be for the least sum of squared second differences of the branch: this leaves the
  /// curvature as it is.
  Vector3 smoothed(Index node) const
  {
    const std::vector<Index>& neighbors = m_graph[node].neighbors;
    Vector3 sum = 2 * (m_graph[neighbors[0]].position + m_graph[neighbors[1]].position);
    double weight = 4;
    for (Index neighbor : neighbors) {
      if (m_graph.is_regular(neighbor)) {
        sum += 2 * m_graph[neighbor].position - m_graph[m_graph.other_neighbor(neighbor, node)].position;
        weight += 1;
      }
    }
    return sum / weight;
  }

  /// Moves the regular `index` as far as that is allowed.
  void move(Index index, const std::optional<Ball>& target, bool is_smoothing)
  {
    Node& node = m_graph[index];
    const Vector3 start = node.position;
    Vector3 step = Vector3::Zero();
    if (turn_cosine(index) < 0) {
      step = m_graph.middle_of_neighbors(index) - start;
    } else if (target) {
      step = center_share * (target->center - start) + smooth_share * (smoothed(index) - start);
      node.radius += radius_share * (target->radius - node.radius);
    } else if (is_smoothing) {
      step = last_smooth_share * (smoothed(index) - start);
    } else {
      step = plain_share * (m_graph.middle_of_neighbors(index) - start);
    }
    for (int halving = 0; halving <= max_halvings; ++halving, step /= 2) {
      const Vector3 position = place(node, start + step);
      if (is_allowed(index, position)) {
        node.position = position;
        return;
      }
    }
  }

  /// `point`, on sheets between their sides.
  Vector3 place(const Node& node, const Vector3& point) const
  {
    return node.is_on_sheet ? middle_of_sheet(m_solid.queries(node.component), point, node.radius).value_or(point)
                            : point;
  }

  /// Whether no turn gets sharper than a right angle, and no edge leaves the body, if the node moves to `position`.
  /// A turn or an edge that was so before may stay.
  bool is_allowed(Index index, const Vector3& position)
  {
    const double turn_before = sharpest_turn(index);
    const Vector3 start = std::exchange(m_graph[index].position, position);
    const double turn = sharpest_turn(index);
    const auto stays_free = [&](Index neighbor) {
      if (m_graph[index].is_on_sheet || m_routing.is_free(index, neighbor)) {
        return true;
      }
      m_graph[index].position = start;
      const bool was_free = m_routing.is_free(index, neighbor);
      m_graph[index].position = position;
      return !was_free;
    };
    const std::vector<Index>& neighbors = m_graph[index].neighbors;
    const bool result =
        (turn >= 0 || turn >= turn_before) && std::all_of(neighbors.begin(), neighbors.end(), stays_free);
    m_graph[index].position = start;
    return result;
  }

  /// The least cosine of the turns at `node` and its neighbors.
  double sharpest_turn(Index node) const
  {
    double result = turn_cosine(node);
    for (Index neighbor : m_graph[node].neighbors) {
      result = std::min(result, turn_cosine(neighbor));
    }
    return result;
  }

  const Triangulated_solid& m_solid;
  Skeleton_builder& m_graph;
  Inside_routing<Triangulated_solid> m_routing;
  Body_section m_body_section;
  Sheet_section m_sheet_section;
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_BRANCH_RELAXATION_H
