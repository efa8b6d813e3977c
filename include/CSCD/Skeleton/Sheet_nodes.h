// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons of sheets: sections across them, and nodes in the middle between their borders.

#ifndef CSCD_SKELETON_SHEET_NODES_H
#define CSCD_SKELETON_SHEET_NODES_H

#include <CSCD/Separator/Plane_section.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The point at `distance` from the point at position `first` of the closed curve `points`, along the curve.
inline Vector3 point_along(const std::vector<Vector3>& points, std::size_t first, double distance)
{
  for (std::size_t i = first;; ++i) {
    const Vector3& a = points[i % points.size()];
    const Vector3& b = points[(i + 1) % points.size()];
    const double length = (b - a).norm();
    if (distance <= length) {
      return length > 0 ? Vector3(a + distance / length * (b - a)) : a;
    }
    distance -= length;
  }
}

/// The middle of the open curve that the closed one of `crossings` on `level` follows on both sides of a sheet: between
/// the points halfway along the longest part on each side. Nothing where it stays on one. Linear.
inline std::optional<Vector3> middle_of_open_curve(const Triangulated_solid& solid, const Surface_level& level,
                                                   const std::vector<Edge_crossing>& crossings)
{
  constexpr unsigned both_sides = 3;
  std::vector<Vector3> points;
  crossing_points(level.surface, crossings, points);
  const auto side_of_sheet = [&](Index vertex) { return solid.side_of_sheet(level.to_finest(vertex)); };
  std::vector<unsigned> sides;
  sides.reserve(crossings.size());
  for (const Edge_crossing& crossing : crossings) {
    sides.push_back(sides_of_sheet(level.surface, side_of_sheet, {crossing}));
  }
  const std::size_t n = points.size();
  const auto start = std::size_t(std::find(sides.begin(), sides.end(), both_sides) - sides.begin());
  std::array<double, both_sides + 1> longest{-1, -1, -1, -1}; // on each side
  std::array<Vector3, both_sides + 1> middle;
  for (std::size_t first = start + 1; start < n && first < start + n; ++first) {
    const unsigned side = sides[first % n];
    double length = 0;
    const std::size_t begin = first;
    for (; sides[(first + 1) % n] == side && side != both_sides; ++first) {
      length += (points[(first + 1) % n] - points[first % n]).norm();
    }
    if (length >= longest[side]) {
      longest[side] = length;
      middle[side] = point_along(points, begin, length / 2);
    }
  }
  return std::min(longest[1], longest[2]) < 0 ? std::nullopt : std::optional<Vector3>((middle[1] + middle[2]) / 2);
}

/// The middle between the sides of a sheet, behind the surface nearest to `point`.
/// \param radius half of the width of the sheet there: a middle farther away is that of another body
template <class Body>
std::optional<Vector3> middle_of_sheet(const Body& body, const Vector3& point, double radius)
{
  constexpr double max_shift = 2; // relative to the radius
  const std::optional<Vector3> middle = body.middle_behind(point);
  return middle && (*middle - point).norm() <= max_shift * radius ? middle : std::nullopt;
}

/// Sections of sheets perpendicular to a branch. Reuse one object.
class Sheet_section
{
public:
  explicit Sheet_section(const Triangulated_solid& solid) : m_solid(solid), m_section(solid.query_surface()) {}

  /// The middle of the open section of the sheet `component` with the plane through `point` perpendicular to `axis`,
  /// and half of its width, if that is about as expected.
  std::optional<Ball> operator()(Index component, const Vector3& point, const Vector3& axis, double expected_half_width)
  {
    const double expected_length = 4 * expected_half_width; // on both sides
    const Index face = m_solid.queries(component).closest_point(point).face;
    // Where edges are in the plane, as on grids, it may miss the face next to them.
    const bool is_cut = m_section.cut_at_face(face, axis, point, max_length * expected_length) ||
                        m_section.cut_at_vertex(nearest_corner(face, point, axis), axis, max_length * expected_length);
    if (!is_cut || m_section.length() < min_length * expected_length) {
      return std::nullopt;
    }
    const auto middle = middle_of_open_curve(m_solid, m_solid.query_level(), m_section.crossings());
    return middle ? std::optional<Ball>({*middle, m_section.length() / 4}) : std::nullopt;
  }

private:
  /// Bounds for the length of an accepted section, relative to the expected one: as for radii in `Body_section`.
  static constexpr double min_length = 0.6;
  static constexpr double max_length = 1.5;

  /// The corner of `face` that is nearest to the plane through `point` perpendicular to `axis`.
  Index nearest_corner(Index face, const Vector3& point, const Vector3& axis) const
  {
    const Triangulated_surface& surface = m_solid.query_surface();
    const auto distance = [&](Index h) { return std::fabs(axis.dot(surface.point(surface.origin(h)) - point)); };
    const auto sides = Triangulated_surface::face_halfedges(face);
    return surface.origin(
        *std::min_element(sides.begin(), sides.end(), [&](Index a, Index b) { return distance(a) < distance(b); }));
  }

  const Triangulated_solid& m_solid;
  Plane_section m_section;
};

/// Moves `node`, of `separator`, to the middle of that if it is open, with half of the width of the sheet as radius.
inline void place_on_sheet(const Triangulated_solid& solid, const Separator& separator, Skeleton_builder::Node& node)
{
  if (solid.side_of_sheet(solid.triangulation().origin(separator.crossings.front().halfedge)) == 0) {
    return;
  }
  node.is_on_sheet = true;
  if (const auto middle = middle_of_open_curve(solid, solid.levels().finest(), separator.crossings)) {
    node.position = *middle;
    node.radius = separator.length / 4;
  }
}

/// Marks all nodes next to nodes of sheets, too, and moves nodes outside to the middle between the sides.
inline void settle_on_sheets(const Triangulated_solid& solid, Skeleton_builder& graph)
{
  const auto is_on_sheet = [&graph](Index node) { return graph[node].is_on_sheet; };
  for (Index node = 0; solid.number_of_sheets() > 0 && node < graph.size(); ++node) {
    const std::vector<Index>& neighbors = graph[node].neighbors;
    if (!is_on_sheet(node) &&
        (graph[node].is_opening || std::none_of(neighbors.begin(), neighbors.end(), is_on_sheet))) {
      continue;
    }
    graph[node].is_on_sheet = true;
    if (const auto middle =
            middle_of_sheet(solid.queries(graph[node].component), graph[node].position, graph[node].radius)) {
      graph[node].position = *middle;
    }
  }
}

/// `point`, if it is between the sides of a sheet, or else the middle between these behind the nearest point; nothing
/// where that is not found.
inline std::optional<Vector3> point_in_sheet(const Solid_queries& sheet, const Vector3& point)
{
  return sheet.is_inside(point) ? std::optional<Vector3>(point) : sheet.middle_behind(point);
}

/// Points of the rims of all sheets, as far from each other as their vertices. Linear.
inline std::vector<Vector3> rim_points(const Triangulated_solid& solid)
{
  const Surface_level& level = solid.query_level();
  const Triangulated_surface& surface = level.surface;
  const auto side = [&](Index vertex) { return solid.side_of_sheet(level.to_finest(vertex)); };
  std::vector<Vector3> result;
  for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
    if (side(surface.origin(h)) == 1 && side(surface.target(h)) == 2) {
      result.push_back((surface.point(surface.origin(h)) + surface.point(surface.target(h))) / 2);
    }
  }
  return result;
}

/// Leads branches on to where their sheets end. Separators across the end of a sheet cut off hardly more than a corner
/// does, and are none; so the last one is about half a width before the end.
class Sheet_ends
{
public:
  Sheet_ends(const Triangulated_solid& solid, Skeleton_builder& graph)
      : m_solid(solid), m_graph(graph), m_section(solid)
  {
  }

  /// Adds nodes in the middle of sections of the sheet beyond every tip on a sheet, the last one at the border.
  void operator()()
  {
    const Index size = m_graph.size();
    for (Index node = 0; node < size; ++node) {
      if (m_graph.degree(node) == 1 && m_graph[node].is_on_sheet) {
        prolong(node);
      }
    }
  }

private:
  /// The length of a step, relative to half of the width. Nodes are twice as far apart, like nodes that divide
  /// branches.
  static constexpr double step_length = 0.25;
  /// Steps are halved down to this length, likewise: the distance of the tip from the border.
  static constexpr double min_step_length = 0.01;
  /// A step that is led back by more than this part of it has met the border.
  static constexpr double min_progress = 0.5;
  /// A section is cut off by the border at the end if its middle is farther aside than this, relative to a step, ...
  static constexpr double max_shift = 0.25;
  /// ... and its half width has fallen by this part of that distance: all of it, if one end is cut
  /// off.
  static constexpr double min_loss = 0.75;
  /// The tangent of the angle between the sections tried for the shortest one, and the number of rounds.
  static constexpr double turn = 0.15;
  static constexpr int number_of_turns = 5;
  /// A bound for the steps towards a point, near which they get shorter and shorter.
  static constexpr int max_steps = 64;

  void prolong(Index end)
  {
    if (!start_at(end)) {
      return;
    }
    const double min_step = min_step_length * m_here.radius;
    double step = step_length * m_here.radius;
    Index last = end; // nodes up to here stay
    Index tip = no_index;
    for (int i = 0; i < max_steps && step >= min_step; ++i) {
      if (!advance(step)) {
        step /= 2;
        continue;
      }
      step = std::min(step, step_length * m_here.radius);
      if (tip == no_index) {
        tip = m_graph.extend(last, m_here.center, m_here.radius);
      }
      m_graph[tip].position = m_here.center;
      m_graph[tip].radius = m_here.radius;
      if (m_graph.edge_length(last, tip) >= 2 * step_length * m_here.radius) {
        last = std::exchange(tip, no_index);
      }
    }
  }

  /// Goes on by one step, to the middle of the section there, or straight on, where that is cut off by the border at
  /// the end, which need not be perpendicular to the branch. \return false if the sheet ends before
  bool advance(double step)
  {
    const std::optional<Vector3> point =
        point_in_sheet(m_solid.queries(m_component), m_here.center + step * m_direction);
    if (!point || m_direction.dot(*point - m_here.center) < min_progress * step) {
      return false;
    }
    const std::optional<Ball> middle = m_section(m_component, *point, m_direction, m_here.radius);
    const double shift = middle ? (middle->center - *point).norm() : m_here.radius;
    const double loss = middle ? m_here.radius - middle->radius : 0;
    // A middle that is farther aside than the step is long is that of a section along the border at the end.
    if (!middle || shift >= std::min(step, m_here.radius) || (shift > max_shift * step && loss > min_loss * shift)) {
      m_here.center = *point;
    } else {
      m_direction = (m_direction + 2 * (middle->center - m_here.center).normalized()).normalized();
      m_here = *middle;
    }
    return true;
  }

  /// Goes to the end `tip` of a branch, in the direction of its last part, as long as half of the width. \return false
  /// if that has no direction
  bool start_at(Index tip)
  {
    m_here = {m_graph[tip].position, m_graph[tip].radius};
    m_component = m_graph[tip].component;
    Index before = tip;
    Index node = m_graph[tip].neighbors.front();
    while (m_graph.is_regular(node) && m_graph.edge_length(tip, node) < m_here.radius) {
      before = std::exchange(node, m_graph.other_neighbor(node, before));
    }
    const Vector3 way = m_here.center - m_graph[node].position;
    if (!(m_here.radius > 0 && way.norm() > 0)) {
      return false;
    }
    m_direction = way.normalized();
    for (int i = 0; i < number_of_turns; ++i) {
      turn_to_shortest_section();
    }
    return true;
  }

  /// Turns the direction until the section here is shortest, as that of a parabola through three lengths, and goes to
  /// its middle.
  void turn_to_shortest_section()
  {
    const Index face = m_solid.queries(m_component).closest_point(m_here.center).face;
    const Vector3 aside = m_direction.cross(m_solid.query_surface().face_vector(face)).normalized();
    std::array<double, 3> half_width{};
    for (std::size_t k = 0; k < half_width.size(); ++k) {
      const auto middle =
          m_section(m_component, m_here.center, m_direction + (double(k) - 1) * turn * aside, m_here.radius);
      if (!middle) {
        return;
      }
      half_width[k] = middle->radius;
    }
    const double slope = half_width[2] - half_width[0];
    const double bend = half_width[0] + half_width[2] - 2 * half_width[1];
    const double change = bend > 0 ? std::clamp(-slope / (2 * bend), -1., 1.) : (slope > 0 ? -1. : 1.);
    const Vector3 direction = (m_direction + change * turn * aside).normalized();
    const std::optional<Ball> middle = m_section(m_component, m_here.center, direction, m_here.radius);
    if (middle && (middle->center - m_here.center).norm() < m_here.radius) {
      m_here = *middle;
      m_direction = direction;
    }
  }

  const Triangulated_solid& m_solid;
  Skeleton_builder& m_graph;
  Sheet_section m_section;
  Index m_component = 0; ///< of the branch
  Ball m_here;           ///< where the branch has been led to, with half of the width of the sheet
  Vector3 m_direction = Vector3::Zero();
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_SHEET_NODES_H
