// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops on the surface that cross a separator, and how both are linked: which of them surrounds a hole of the body.

#ifndef CSCD_PACKING_LOOPS_ACROSS_H
#define CSCD_PACKING_LOOPS_ACROSS_H

#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/input_concepts.h>
#include <CSCD/internal/Box_tree.h>
#include <CSCD/internal/Dijkstra_search.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The polygon of a curve on the surface, moved outwards by `offset` relative to the edges. A crossing at the position
/// 0 is a vertex.
inline std::vector<Vector3> curve_off_surface(const Triangulated_surface& surface,
                                              const std::vector<Edge_crossing>& curve, double offset)
{
  std::vector<Vector3> result;
  result.reserve(curve.size());
  for (const Edge_crossing& crossing : curve) {
    const auto [h, position] = crossing;
    const Vector3 normal =
        (1 - position) * surface.vertex_normal(surface.origin(h)) + position * surface.vertex_normal(surface.target(h));
    result.push_back(crossing_point(surface, crossing) + offset * double(surface.length(h)) * normal);
  }
  return result;
}

/// A closed polygon as it is seen from one side: the third coordinate points at the viewer, and the first point is also
/// the last one.
struct Seen_polygon
{
  Seen_polygon(const std::vector<Vector3>& polygon) // NOLINT(google-explicit-constructor): callers have polygons
  {
    // Hardly any two edges of a mesh look parallel from there.
    const Vector3 up = Vector3(0.531, 0.274, 0.802).normalized();
    const Vector3 right = up.cross(Vector3::UnitX()).normalized();
    const Vector3 ahead = up.cross(right);
    points.reserve(polygon.size() + 1);
    for (const Vector3& point : polygon) {
      points.emplace_back(right.dot(point), ahead.dot(point), up.dot(point));
    }
    points.push_back(points.front());
    box = Bounding_box(points);
  }

  std::vector<Vector3> points;
  Bounding_box box;
};

/// How often two disjoint closed polygons wind around each other: the number of times that, seen from one side, `a`
/// passes over `b`, with the sign of the direction. O(mn).
inline int linking_number(const Seen_polygon& a, const Seen_polygon& b)
{
  // Twice the area of a triangle, positive if it turns left.
  const auto turn = [](const Vector3& p, const Vector3& q, const Vector3& r) {
    return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
  };
  // The edges that are not aside of all others: few of a loop that is long compared with a separator.
  const auto edges_near = [](const Bounding_box& box, const std::vector<Vector3>& points) {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Vector3 aside =
          (box.min() - points[i].cwiseMax(points[i + 1])).cwiseMax(points[i].cwiseMin(points[i + 1]) - box.max());
      if (aside.x() <= 0 && aside.y() <= 0) {
        result.push_back(i);
      }
    }
    return result;
  };
  const std::vector<Vector3>& over = a.points;
  const std::vector<Vector3>& under = b.points;
  const std::vector<std::size_t> edges_over = edges_near(b.box, over);
  const std::vector<std::size_t> edges_under = edges_near(a.box, under);
  int result = 0;
  for (const std::size_t i : edges_over) {
    for (const std::size_t j : edges_under) {
      const double from = turn(over[i], over[i + 1], under[j]);
      const double to = turn(over[i], over[i + 1], under[j + 1]);
      if ((from > 0) != (to > 0)) {
        const double before = turn(under[j], under[j + 1], over[i]);
        const double after = turn(under[j], under[j + 1], over[i + 1]);
        const double height = (after * over[i].z() - before * over[i + 1].z()) / (after - before);
        const double depth = (to * under[j].z() - from * under[j + 1].z()) / (to - from);
        result += (before > 0) != (after > 0) && height > depth ? (to > 0 ? 1 : -1) : 0;
      }
    }
  }
  return result;
}

/// How often two closed curves on the surface that cross once, a separator and a loop, wind around each other.
struct Linking
{
  /// How far curves are moved off the surface, relative to the edges.
  static constexpr double offset = 1e-3;

  /// O(mn) for the numbers of points.
  Linking(const Triangulated_surface& surface, const std::vector<Edge_crossing>& separator,
          const std::vector<Edge_crossing>& loop)
      : of_separator(
            linking_number(curve_off_surface(surface, separator, -offset), curve_off_surface(surface, loop, offset))),
        of_loop(
            linking_number(curve_off_surface(surface, loop, -offset), curve_off_surface(surface, separator, offset)))
  {
  }

  /// Whether the numbers are right: where the surface intersects itself, they may not be.
  bool is_consistent() const { return std::abs(of_separator - of_loop) == 1; }

  /// Of the separator, pushed into the body, with the loop, pushed out of it: 0 if the separator bounds a surface in
  /// the body.
  int of_separator;
  /// Of the loop, pushed into the body, with the separator, pushed out of it.
  int of_loop;
};

/// Finds the shortest loops that cross a separator: around the hole that it passes, if there is one.
class Loops_across
{
public:
  /// A loop along edges; none without vertices.
  struct Loop
  {
    std::vector<Index> vertices; ///< from the right to the left side of the separator
    std::vector<Index> crossed;  ///< the positions of all separators that it crosses
    float length = 0;
    Index right = no_index; ///< the crossing of the separator next to the first vertex
    Index left = no_index;  ///< the crossing next to the last vertex
  };

  /// All are referred to. O(n) for n edges of the surface.
  /// \param packed disjoint separators, as positions in the list of all separators
  Loops_across(const Triangulated_surface& surface, const std::vector<Separator>& separators,
               const std::vector<Index>& packed)
      : m_surface(surface), m_separators(separators), m_packed(packed),
        m_crossing(surface.number_of_halfedges(),
                   [&](const auto& add) {
                     for (Index i = 0; i < packed.size(); ++i) {
                       for (const Edge_crossing& crossing : separators[packed[i]].crossings) {
                         const bool is_twin = surface.edge(crossing.halfedge) != crossing.halfedge;
                         add(surface.edge(crossing.halfedge), {i, is_twin ? 1 - crossing.position : crossing.position});
                       }
                     }
                   }),
        m_search(surface.number_of_vertices()), m_entered(surface.number_of_vertices(), no_index)
  {
  }

  /// The loop through the separator at position `i`, if it is shorter than `max_length`. It crosses that once: only by
  /// the step from its last vertex to the first one. O(n log n) for n vertices that are nearer.
  /// \param may_cross_others whether it may cross other separators
  Loop find(Index i, bool may_cross_others, float max_length)
  {
    constexpr double tolerance = 0.999; // for lengths in single precision
    const std::map<Index, Nearest_crossing> ends = crossings_on_side(i, false);
    const std::map<Index, Nearest_crossing> begins = crossings_on_side(i, true);
    const Bounding_box box = box_of_curve(i);
    m_search.clear();
    for (const auto& [vertex, nearest] : begins) {
      m_search.reach(vertex, nearest.first);
      m_entered[vertex] = no_index;
    }
    Loop loop;
    loop.crossed = {i};
    loop.length = max_length;
    m_search.spread([&](Index vertex, float distance) {
      if (distance >= loop.length) {
        m_search.clear();
        return;
      }
      const auto end = ends.find(vertex);
      if (end != ends.end() && distance + end->second.first < loop.length) {
        loop.length = distance + end->second.first;
        loop.vertices = {vertex};
        loop.right = end->second.second;
      }
      for (const Index h : m_surface.outgoing(vertex)) {
        const float length = distance + float(m_surface.length(h));
        // The way back is at least as long as that to the box.
        const auto way_back = float(tolerance * std::sqrt(box.squared_distance(m_surface.point(m_surface.target(h)))));
        if (length + way_back < loop.length && is_free_to_cross(h, i, may_cross_others) &&
            m_search.reach(m_surface.target(h), length)) {
          m_entered[m_surface.target(h)] = h;
        }
      }
    });
    while (!loop.vertices.empty() && m_entered[loop.vertices.back()] != no_index) {
      const Index h = m_entered[loop.vertices.back()];
      for (const Crossing& crossing : m_crossing[m_surface.edge(h)]) {
        loop.crossed.push_back(crossing.separator);
      }
      loop.vertices.push_back(m_surface.origin(h));
    }
    if (!loop.vertices.empty()) {
      loop.left = begins.at(loop.vertices.back()).second;
    }
    return loop;
  }

  /// The curve of `loop`, closed along its separator. \pre it has vertices
  std::vector<Edge_crossing> curve(const Loop& loop) const
  {
    std::vector<Edge_crossing> result;
    for (const Index vertex : loop.vertices) {
      result.push_back({*m_surface.outgoing(vertex).begin(), 0});
    }
    const std::vector<Edge_crossing>& crossings = m_separators[m_packed[loop.crossed.front()]].crossings;
    const auto size = Index(crossings.size());
    const bool is_forward = (loop.right + size - loop.left) % size <= size / 2; // the shorter way
    for (Index k = loop.left;; k = (k + (is_forward ? 1 : size - 1)) % size) {
      result.push_back(crossings[k]);
      if (k == loop.right) {
        return result;
      }
    }
  }

private:
  /// The distance of a vertex from a crossing of a separator, and the position of this crossing.
  using Nearest_crossing = std::pair<float, Index>;

  /// Where the packed separator at position `separator` crosses an edge.
  struct Crossing
  {
    Index separator;
    double position; ///< from the origin of the halfedge that stands for the edge
  };

  Bounding_box box_of_curve(Index i) const
  {
    Bounding_box box;
    for (const Edge_crossing& crossing : m_separators[m_packed[i]].crossings) {
      box.extend(crossing_point(m_surface, crossing));
    }
    return box;
  }

  bool is_free_to_cross(Index halfedge, Index i, bool may_cross_others) const
  {
    const auto crossings = m_crossing[m_surface.edge(halfedge)];
    return may_cross_others ? std::none_of(crossings.begin(), crossings.end(),
                                           [i](const Crossing& crossing) { return crossing.separator == i; })
                            : crossings.empty();
  }

  /// Whether a separator crosses the edge between `crossing` and its origin or, if `is_left`, its target.
  bool is_crossed_between(const Edge_crossing& crossing, bool is_left) const
  {
    const Index edge = m_surface.edge(crossing.halfedge);
    const bool is_reversed = edge != crossing.halfedge;
    const double own = is_reversed ? 1 - crossing.position : crossing.position;
    const auto crossings = m_crossing[edge];
    return std::any_of(crossings.begin(), crossings.end(), [&](const Crossing& other) {
      return is_left != is_reversed ? other.position > own : other.position < own;
    });
  }

  /// The vertices next to the separator at position `i` on its left or right side.
  std::map<Index, Nearest_crossing> crossings_on_side(Index i, bool is_left) const
  {
    std::map<Index, Nearest_crossing> result;
    const std::vector<Edge_crossing>& crossings = m_separators[m_packed[i]].crossings;
    for (Index k = 0; k < crossings.size(); ++k) {
      const Edge_crossing& crossing = crossings[k];
      const Index vertex = is_left ? m_surface.target(crossing.halfedge) : m_surface.origin(crossing.halfedge);
      if (!is_crossed_between(crossing, is_left)) {
        const Nearest_crossing nearest{float((m_surface.point(vertex) - crossing_point(m_surface, crossing)).norm()),
                                       k};
        Nearest_crossing& least = result.emplace(vertex, nearest).first->second;
        least = std::min(least, nearest);
      }
    }
    return result;
  }

  const Triangulated_surface& m_surface;
  const std::vector<Separator>& m_separators;
  const std::vector<Index>& m_packed;
  Compressed_rows<Crossing> m_crossing; ///< of every edge, by its number
  Dijkstra_search m_search;             ///< over vertices
  std::vector<Index> m_entered;         ///< for each reached vertex, the halfedge on the way to it
};

} // namespace CSCD::internal

#endif // CSCD_PACKING_LOOPS_ACROSS_H
