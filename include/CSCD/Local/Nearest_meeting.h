// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the cut point nearest to the source while the front still grows, and traces the loop through it.

#ifndef CSCD_LOCAL_NEAREST_MEETING_H
#define CSCD_LOCAL_NEAREST_MEETING_H

#include <CSCD/Local/Geodesic_polar_coordinates.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>

namespace CSCD::internal {

/// Observes geodesic polar coordinates while they grow and keeps the meeting that is nearest in space to the source
/// (the target of section 3.1.3), among those seen across the body: the chord from the source must enter the surface at
/// the source and leave it at the meeting. It stops the front soon after the first such meeting.
class Nearest_meeting
{
public:
  /// \param is_across tells of vertices whether meetings there are across the body; without it, the direction decides
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
    const Vector_3 chord = (m_surface.point(vertex) + m_surface.point(neighbor)) / 2 - m_source_point;
    const double length = chord.norm();
    if (length >= m_chord_length || !is_across_body(chord, length, vertex)) {
      return;
    }
    const float stop_distance = reach_beyond_target * distance;
    m_stop_distance = has_found() ? std::min(m_stop_distance, stop_distance) : stop_distance;
    m_chord_length = length;
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

  bool is_across_body(const Vector_3& chord, double length, Index vertex) const
  {
    if (m_is_across) {
      return m_is_across(vertex);
    }
    return -chord.dot(m_source_normal) > min_chord_cosine * length &&
           chord.dot(m_surface.vertex_normal(vertex)) > min_chord_cosine * length;
  }

  const Triangulated_surface& m_surface;
  const Geodesic_polar_coordinates& m_front;
  Vector_3 m_source_point;
  Vector_3 m_source_normal;
  std::function<bool(Index)> m_is_across;
  Index m_first = no_index;
  Index m_second = no_index;
  double m_chord_length = std::numeric_limits<double>::max();
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

#endif // CSCD_LOCAL_NEAREST_MEETING_H
