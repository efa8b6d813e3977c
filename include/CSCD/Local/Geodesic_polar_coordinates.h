// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The front in polar coordinates around a source, and the nearest cut point where it meets itself.

#ifndef CSCD_LOCAL_GEODESIC_POLAR_COORDINATES_H
#define CSCD_LOCAL_GEODESIC_POLAR_COORDINATES_H

#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/Dijkstra_search.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Geodesic polar coordinates around a source, computed outwards vertex by vertex until an observer has seen enough.
///
/// A front that accepts every vertex once, in the manner of Melvaer and Reimers, "Geodesic polar coordinates on
/// polygonal meshes" (2012): where two neighbors on a triangle are known, the source is unfolded into the triangle's
/// plane and the third corner gets its distance to that image; the initial angle is interpolated between the two
/// neighbors by the angles that the image sees. Where the ray misses the triangle, distance and angle come along an
/// edge. Reuse one object for many sources: nothing of the size of the surface is touched for each of them.
class Geodesic_polar_coordinates
{
public:
  /// Two neighbors whose initial directions differ by more than this have been reached around different sides, in
  /// radians. Found on ten meshes: at 1.4, flat spots yield false meetings; at 2.0 none are lost.
  static constexpr float wide_angle = 2.0f;

  explicit Geodesic_polar_coordinates(const Vertex_fan_table& corners, std::size_t number_of_vertices)
      : m_corners(&corners), m_nodes(number_of_vertices), m_heap(number_of_vertices)
  {
  }

  /// Grows the front from `source`, visiting at most `max_visits` vertices unless `observer` has found something.
  ///
  /// Vertices are accepted nearly, not strictly, in order of distance: over an obtuse angle the front reaches a corner
  /// that is nearer than the vertex it came from. That is one vertex in a hundred on smooth bodies, three where noise
  /// is as large as the edges; vertices accepted before keep their distances.
  /// \tparam Observer has
  ///         - `on_meeting(vertex, neighbor)`: `vertex` was accepted, its neighbor had been before, and their initial
  ///           directions differ by more than `wide_angle`;
  ///         - `stop_distance()`: no vertex farther than this is visited;
  ///         - `has_found()`: while false, the front is capped by the largest number of visits
  /// \return whether it was capped; else nothing was left to visit, or the stop distance was passed
  template <class Observer>
  bool grow(Index source, std::size_t max_visits, Observer& observer)
  {
    start(source);
    while (!m_heap.empty()) {
      const Indexed_heap::Entry entry = m_heap.pop();
      if (entry.key > observer.stop_distance()) {
        return false;
      }
      ++m_number_of_visits;
      if (m_number_of_visits > max_visits && !observer.has_found()) {
        return true;
      }
      m_nodes[entry.vertex].epoch = accepted_epoch();
      expand(entry.vertex, observer);
    }
    return false;
  }

  std::size_t number_of_visits() const { return m_number_of_visits; }
  /// The length of the longest edge at the source of the last front.
  float ring_radius() const { return m_ring_radius; }

  /// Geodesic distance from the source; valid for accepted vertices.
  float distance(Index vertex) const { return m_nodes[vertex].distance; }
  /// The neighbor that the shortest path comes from, `no_index` at the source.
  Index parent(Index vertex) const { return m_nodes[vertex].parent; }

private:
  static constexpr float pi = boost::math::constants::pi<float>();
  /// If the initial directions at the two ends of an edge differ by more than this, in radians, the edge spans the cut
  /// locus and no ray may be passed through it.
  static constexpr float spanning_angle = 1.5f;
  /// The cut locus of a meeting must leave at least this between the directions once the angle that the edge itself
  /// subtends at the source is subtracted, in radians; guards against long edges close to the source.
  static constexpr float min_gap_angle = 1.2f;

  struct Node
  {
    float distance = 0;
    float angle = 0;
    Index parent = no_index;
    std::uint32_t epoch = 0;
  };

  std::uint32_t accepted_epoch() const { return m_epoch + 1; }
  bool is_reached(const Node& node) const { return node.epoch == m_epoch; }
  bool is_accepted(const Node& node) const { return node.epoch == accepted_epoch(); }

  static float wrapped(float angle)
  {
    if (angle > pi) {
      return angle - 2 * pi;
    }
    return angle < -pi ? angle + 2 * pi : angle;
  }

  /// Gives a vertex its distance, or a shorter one.
  void put(Index vertex, float distance, float angle, Index parent)
  {
    Node& node = m_nodes[vertex];
    const bool is_new = !is_reached(node);
    node = {distance, angle, parent, m_epoch};
    if (is_new) {
      m_corners->prefetch(vertex);
      m_heap.push(vertex, distance);
    } else {
      m_heap.decrease(vertex, distance);
    }
  }

  void start(Index source)
  {
    // Two epochs a front: reached and accepted.
    if (m_epoch >= std::numeric_limits<std::uint32_t>::max() - 3) {
      std::fill(m_nodes.begin(), m_nodes.end(), Node());
      m_epoch = 0;
    }
    m_epoch += 2;
    m_heap.clear();
    m_source = source;
    m_number_of_visits = 1;
    m_nodes[source] = {0, 0, no_index, accepted_epoch()};
    start_ring(source);
  }

  /// Puts the neighbors of the source, with the angles around it scaled to a full turn.
  void start_ring(Index source)
  {
    const auto corner_angle = [](const Corner& corner) { return std::atan2(corner.sine, corner.cosine); };
    float cone_angle = 0;
    m_ring_radius = 0;
    for (const Corner& corner : m_corners->neighbors(source)) {
      cone_angle += corner_angle(corner);
      m_ring_radius = std::max(m_ring_radius, corner.length);
    }
    const float scale = cone_angle > 0 ? 2 * pi / cone_angle : 0.f;
    float angle = 0;
    for (const Corner& corner : m_corners->neighbors(source)) {
      // Where an edge is doubled, its shorter appearance counts.
      if (!is_reached(m_nodes[corner.neighbor]) || corner.length < m_nodes[corner.neighbor].distance) {
        put(corner.neighbor, corner.length, wrapped(angle * scale), source);
      }
      angle += corner_angle(corner);
    }
  }

  template <class Observer>
  void expand(Index vertex, Observer& observer)
  {
    const Corner* corner = m_corners->fan(vertex).begin();
    const Corner* last = m_corners->fan(vertex).end() - 1;
    bool is_left_accepted = is_accepted(m_nodes[corner->neighbor]);
    for (; corner != last; ++corner) {
      const bool is_right_accepted = is_left_accepted;
      is_left_accepted = is_accepted(m_nodes[(corner + 1)->neighbor]);
      if (is_right_accepted) {
        meet(vertex, *corner, observer);
      } else {
        relax_edge(vertex, *corner);
      }
      if (is_right_accepted != is_left_accepted) {
        const Corner& from = is_right_accepted ? *corner : *(corner + 1);
        const Corner& to = is_right_accepted ? *(corner + 1) : *corner;
        relax_face(vertex, from, to, *corner);
      }
    }
  }

  void relax_edge(Index vertex, const Corner& corner)
  {
    const Node& from = m_nodes[vertex];
    const Node& to = m_nodes[corner.neighbor];
    const float distance = from.distance + corner.length;
    if (!is_reached(to) || distance < to.distance) {
      put(corner.neighbor, distance, from.angle, vertex);
    }
  }

  /// Passes the front through the triangle of `vertex`, the accepted neighbor of `from`, and the neighbor of `to`;
  /// `angle_at_vertex` is the corner that holds the angle between the two.
  void relax_face(Index vertex, const Corner& from, const Corner& to, const Corner& angle_at_vertex)
  {
    const Node& near = m_nodes[vertex];
    const Node& side = m_nodes[from.neighbor];
    const float turn = wrapped(side.angle - near.angle);
    if (!(from.length > 0) || (near.parent != m_source && std::fabs(turn) > spanning_angle)) {
      return;
    }
    // The plane of the triangle: `vertex` at the origin, the neighbor of `from` at (base, 0), the target at (x, y), the
    // image of the source below the base.
    const float base = from.length;
    const float x = to.length * angle_at_vertex.cosine;
    const float y = to.length * angle_at_vertex.sine;
    const float squared_distance = near.distance * near.distance;
    const float image_x = (squared_distance + base * base - side.distance * side.distance) / (2 * base);
    const float squared_depth = squared_distance - image_x * image_x;
    if (!(squared_depth > 0)) {
      return;
    }
    const float depth = std::sqrt(squared_depth);
    const float ray_x = x - image_x;
    const float ray_y = y + depth;
    const float crossing = image_x * ray_y + ray_x * depth;
    if (!(crossing > 0 && crossing < base * ray_y)) {
      return;
    }
    const float distance = std::sqrt(ray_x * ray_x + ray_y * ray_y);
    const Node& target = m_nodes[to.neighbor];
    if (is_reached(target) && distance >= target.distance) {
      return;
    }
    // The sines of the two angles that the image sees stand for the angles: they are small, and only their ratio
    // counts.
    const float near_sine = std::fabs(image_x * ray_y + depth * ray_x) * side.distance;
    const float side_sine = std::fabs((base - image_x) * ray_y - depth * ray_x) * near.distance;
    const float part = near_sine / (near_sine + side_sine + std::numeric_limits<float>::min());
    put(to.neighbor, distance, wrapped(near.angle + part * turn), part < 0.5f ? vertex : from.neighbor);
  }

  template <class Observer>
  void meet(Index vertex, const Corner& corner, Observer& observer)
  {
    const Node& node = m_nodes[vertex];
    const Node& other = m_nodes[corner.neighbor];
    const bool is_at_source = other.parent == no_index || (node.parent == m_source && other.parent == m_source);
    if (node.distance <= m_ring_radius || is_at_source) {
      return;
    }
    const float turn = std::fabs(wrapped(node.angle - other.angle));
    if (turn <= wide_angle) {
      return;
    }
    const float cosine =
        (node.distance * node.distance + other.distance * other.distance - corner.length * corner.length) /
        (2 * node.distance * other.distance);
    if (cosine < 1 && turn - std::acos(std::max(-1.f, cosine)) < min_gap_angle) {
      return;
    }
    observer.on_meeting(vertex, corner.neighbor);
  }

  const Vertex_fan_table* m_corners;
  std::vector<Node> m_nodes;
  Indexed_heap m_heap;
  std::uint32_t m_epoch = 0;
  Index m_source = no_index;
  std::size_t m_number_of_visits = 0;
  float m_ring_radius = 0;
};

/// Observes geodesic polar coordinates while they grow and keeps the meeting that is nearest in space to the source
/// (the target of section 3.1.3), among the meetings seen across the body: the chord from the source must enter the
/// surface at the source and leave it at the meeting. It stops the front soon after the first such meeting.
class Nearest_meeting
{
public:
  /// \param is_across returns whether meetings at a vertex are across the body; without it, the direction decides
  Nearest_meeting(const Triangulated_surface& surface, const Geodesic_polar_coordinates& front, Index source,
                  std::function<bool(Index)> is_across = nullptr)
      : m_surface(surface), m_front(front), m_source_point(surface.point(source)),
        m_source_normal(surface.vertex_normal(source)), m_is_across(std::move(is_across))
  {
  }

  void on_meeting(Index vertex, Index neighbor)
  {
    const float distance = m_front.distance(vertex);
    if (m_stop_distance == std::numeric_limits<float>::max()) {
      m_stop_distance = reach_without_target * std::max(distance, min_rings * m_front.ring_radius());
    }
    const Vector3 chord = (m_surface.point(vertex) + m_surface.point(neighbor)) / 2 - m_source_point;
    const double length = chord.norm();
    if (float(length) >= m_chord_length || !is_across_body(chord, length, vertex)) {
      return;
    }
    const float stop_distance = reach_beyond_target * distance;
    m_stop_distance = has_found() ? std::min(m_stop_distance, stop_distance) : stop_distance;
    m_chord_length = float(length);
    m_first = vertex;
    m_second = neighbor;
  }

  float stop_distance() const { return m_stop_distance; }
  bool has_found() const { return m_first != no_index; }

  /// The two neighbors between which the target lies.
  Index first() const { return m_first; }
  Index second() const { return m_second; }

private:
  /// The front goes on to this multiple of the distance of the best meeting so far, in case a nearer one follows.
  static constexpr float reach_beyond_target = 1.05f;
  /// While all meetings are refused, it goes on to this multiple of the distance of the first one ...
  static constexpr float reach_without_target = 2;
  /// ... but at least to this many of the longest edge at the source: on a rough surface, false meetings near the
  /// source would otherwise end the search.
  static constexpr float min_rings = 6;
  /// Cosine of the largest angle between the chord and the inward normal at the source, and the outward normal at the
  /// meeting. Any value from 0 keeps out tunnels; this one also drops meetings on the flank of a bump early.
  static constexpr double min_chord_cosine = 0.5;

  bool is_across_body(const Vector3& chord, double length, Index vertex) const
  {
    if (m_is_across) {
      return m_is_across(vertex);
    }
    return -chord.dot(m_source_normal) > min_chord_cosine * length &&
           chord.dot(m_surface.vertex_normal(vertex)) > min_chord_cosine * length;
  }

  const Triangulated_surface& m_surface;
  const Geodesic_polar_coordinates& m_front;
  Vector3 m_source_point;
  Vector3 m_source_normal;
  std::function<bool(Index)> m_is_across;
  Index m_first = no_index;
  Index m_second = no_index;
  float m_chord_length = std::numeric_limits<float>::max(); ///< of equally near meetings, rounded so, the first counts
  float m_stop_distance = std::numeric_limits<float>::max();
};

/// Writes to `loop` the closed curve from the source of `front` to `first`, across the edge to `second`, and back.
/// Where both arms leave the source by the same path, that path is left out.
inline void trace_loop(const Geodesic_polar_coordinates& front, Index first, Index second, Vertex_loop& loop)
{
  loop.clear();
  for (Index vertex = first; vertex != no_index; vertex = front.parent(vertex)) {
    loop.push_back(vertex);
  }
  std::reverse(loop.begin(), loop.end());
  const std::size_t size_of_first_arm = loop.size();
  for (Index vertex = second; vertex != no_index; vertex = front.parent(vertex)) {
    loop.push_back(vertex);
  }
  // Both arms end at the source: drop the second source, then the common stem.
  loop.pop_back();
  std::size_t stem = 0;
  while (stem + 1 < size_of_first_arm && loop.size() > size_of_first_arm && loop.back() == loop[stem + 1]) {
    loop.pop_back();
    ++stem;
  }
  loop.erase(loop.begin(), loop.begin() + std::ptrdiff_t(stem));
}

} // namespace CSCD::internal

#endif // CSCD_LOCAL_GEODESIC_POLAR_COORDINATES_H
