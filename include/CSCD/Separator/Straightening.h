// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves on the surface made shorter by sweeps, and carried from level to level.

#ifndef CSCD_SEPARATOR_STRAIGHTENING_H
#define CSCD_SEPARATOR_STRAIGHTENING_H

#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Dijkstra_search.h>
#include <CSCD/internal/flat_arrays.h>

#include <boost/core/noinit_adaptor.hpp>
#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Joins consecutive vertices of a coarse loop by shortest paths (A*) along the edges of the finest level.
/// Work is local to the loop. Reuse one object.
class Loop_projection
{
public:
  explicit Loop_projection(const Surface_levels& levels)
      : m_levels(levels), m_heap(levels.finest().surface.number_of_vertices()),
        m_reached(levels.finest().surface.number_of_vertices()),
        m_settled(levels.finest().surface.number_of_vertices()), m_labels(levels.finest().surface.number_of_vertices())
  {
  }

  /// Writes to `fine_loop` the projection of `loop`, which runs along edges of `level`, without repeated vertices.
  /// \return false if a path strays too far, or if the rest is not the greater part of a loop
  bool operator()(const Surface_level& level, const Vertex_loop& loop, Vertex_loop& fine_loop)
  {
    m_path.clear();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index from = level.to_finest(loop[i]);
      const Index to = level.to_finest(loop[i + 1 < loop.size() ? i + 1 : 0]);
      if (!append_path(from, to)) {
        return false;
      }
    }
    return erase_spurs(fine_loop);
  }

private:
  /// A path may be this many times as long as the straight line.
  static constexpr double max_detour = 3;
  static constexpr std::size_t min_loop_size = 4;

  struct Label
  {
    float distance;
    Index parent;
  };

  /// Appends the path from `from` to `to`, without its last vertex.
  bool append_path(Index from, Index to)
  {
    const Triangulated_surface& surface = m_levels.finest().surface;
    const Vector_3 goal = surface.point(to);
    const float limit = float(max_detour * (surface.point(from) - goal).norm());
    m_heap.clear();
    m_reached.clear();
    m_settled.clear();
    reach(from, 0, no_index);
    m_heap.push(from, 0);
    while (!m_heap.empty()) {
      const Index vertex = m_heap.pop().vertex;
      if (vertex == to) {
        append_backtrace(to);
        return true;
      }
      m_settled.mark(vertex);
      for (const Index halfedge : surface.outgoing(vertex)) {
        const Index neighbor = surface.target(halfedge);
        const float distance = m_labels[vertex].distance + float(surface.length(halfedge));
        const bool is_new = !m_reached.is_marked(neighbor);
        // The estimates are consistent except for rounding: a vertex that has left the heap stays as it is.
        if (distance >= limit || m_settled.is_marked(neighbor) ||
            (!is_new && distance >= m_labels[neighbor].distance)) {
          continue;
        }
        const float estimate = distance + float((surface.point(neighbor) - goal).norm());
        reach(neighbor, distance, vertex);
        if (is_new) {
          m_heap.push(neighbor, estimate);
        } else {
          m_heap.decrease(neighbor, estimate);
        }
      }
    }
    return false;
  }

  void reach(Index vertex, float distance, Index parent)
  {
    m_reached.mark(vertex);
    m_labels[vertex] = {distance, parent};
  }

  void append_backtrace(Index to)
  {
    const std::size_t begin = m_path.size();
    for (Index vertex = m_labels[to].parent; vertex != no_index; vertex = m_labels[vertex].parent) {
      m_path.push_back(vertex);
    }
    std::reverse(m_path.begin() + std::ptrdiff_t(begin), m_path.end());
  }

  /// Copies the path to `loop`; where it returns to a vertex, the part between is left out.
  bool erase_spurs(Vertex_loop& loop)
  {
    loop.clear();
    m_reached.clear();
    for (Index vertex : m_path) {
      if (m_reached.mark(vertex)) {
        m_labels[vertex].parent = Index(loop.size());
        loop.push_back(vertex);
        continue;
      }
      const std::size_t kept = m_labels[vertex].parent;
      if (kept >= loop.size() || loop[kept] != vertex) {
        // The earlier visit has been left out itself.
        m_labels[vertex].parent = Index(loop.size());
        loop.push_back(vertex);
      } else if (loop.size() - kept > m_path.size() / 2) {
        return false;
      } else {
        loop.resize(kept + 1);
      }
    }
    return loop.size() >= min_loop_size;
  }

  const Surface_levels& m_levels;
  Indexed_heap m_heap;
  Epoch_marks m_reached;
  Epoch_marks m_settled;
  std::vector<Label, boost::noinit_adaptor<std::allocator<Label>>> m_labels; // of reached vertices
  Vertex_loop m_path;
};

/// Straightens closed curves: moves each crossing to where the unfolded curve is straight, and where the curve is stuck
/// at a vertex with less than a straight angle on the other side, passes it over the vertex.
/// A few passes take out the zigzag and keep the curve where it is, without any further constraint (the locality of
/// appendix E.2). Reuse one object.
class Straightening
{
public:
  explicit Straightening(const Triangulated_surface& surface) : m_surface(surface) {}

  /// Straightens `crossings` in place by `number_of_passes` sweeps, each linear in their number.
  void operator()(std::vector<Edge_crossing>& crossings, int number_of_passes)
  {
    for (int pass = 0; pass < number_of_passes && crossings.size() >= 4; ++pass) {
      for (std::size_t i = 0; i < crossings.size(); ++i) {
        straighten_at(crossings, i);
      }
      pass_over_vertices(crossings);
      cancel_backtracks(m_surface, crossings);
    }
  }

private:
  /// Crossings keep this distance from the ends of their edge, relative to its length.
  static constexpr double end_margin = 0.02;
  /// Crossings within this distance of an end are stuck there, likewise: clamped crossings, up to rounding.
  static constexpr double stuck_margin = 1.01 * end_margin;
  /// Where a curve is put after it has passed over a vertex, likewise.
  static constexpr double passed_position = 3 * end_margin;
  /// A curve is passed over a vertex if the angle on the other side is less than pi by more than this, in radians.
  static constexpr double angle_margin = 1e-3;
  static constexpr double pi = boost::math::constants::pi<double>();

  /// The position along a line and the distance from it.
  struct Unfolded_point
  {
    double along;
    double height;
  };

  static Unfolded_point unfold(const Vector_3& point, const Vector_3& origin, const Vector_3& direction)
  {
    const Vector_3 offset = point - origin;
    const double along = offset.dot(direction);
    return {along, (offset - along * direction).norm()};
  }

  Vector_3 point(const std::vector<Edge_crossing>& crossings, std::size_t i) const
  {
    const std::size_t size = crossings.size();
    return crossing_point(m_surface, crossings[i % size]);
  }

  void straighten_at(std::vector<Edge_crossing>& crossings, std::size_t i) const
  {
    Edge_crossing& crossing = crossings[i];
    const Vector_3& origin = m_surface.point(m_surface.origin(crossing.halfedge));
    const Vector_3 edge = m_surface.point(m_surface.target(crossing.halfedge)) - origin;
    const double length = edge.norm();
    if (!(length > 0)) {
      return;
    }
    const Unfolded_point before = unfold(point(crossings, i + crossings.size() - 1), origin, edge / length);
    const Unfolded_point after = unfold(point(crossings, i + 1), origin, edge / length);
    const double height = before.height + after.height;
    if (height > 0) {
      const double along = before.along + (after.along - before.along) * before.height / height;
      crossing.position = std::clamp(along / length, end_margin, 1 - end_margin);
    }
  }

  /// The vertex that `crossing` is stuck at, `no_index` if it is free.
  Index stuck_at(const Edge_crossing& crossing) const
  {
    if (crossing.position <= stuck_margin) {
      return m_surface.origin(crossing.halfedge);
    }
    return crossing.position >= 1 - stuck_margin ? m_surface.target(crossing.halfedge) : no_index;
  }

  /// Finds the runs of crossings around a vertex where one of them is stuck, and tries to pass each over it.
  void pass_over_vertices(std::vector<Edge_crossing>& crossings)
  {
    const std::size_t size = crossings.size();
    const auto continues = [&](std::size_t i) {
      const Edge_crossing& a = crossings[i % size];
      const Edge_crossing& b = crossings[(i + 1) % size];
      return stuck_at(a) != no_index && stuck_at(a) == stuck_at(b) && (a.position < 0.5) == (b.position < 0.5);
    };
    std::size_t start = 0;
    while (start < size && continues(start)) {
      ++start;
    }
    if (start == size) {
      return;
    }
    ++start;
    m_result.clear();
    for (std::size_t i = start; i < start + size;) {
      const Edge_crossing& crossing = crossings[i % size];
      const Index vertex = stuck_at(crossing);
      if (vertex == no_index) {
        m_result.push_back(crossing);
        ++i;
        continue;
      }
      // The run around the vertex also holds neighbors that cross its incident edges farther out.
      const bool is_on_right = crossing.position < 0.5;
      const auto is_in_run = [&](std::size_t j) { return passes(crossings[j % size], vertex, is_on_right); };
      std::size_t first = i;
      while (first > start && is_in_run(first - 1) && is_last_result(crossings[(first - 1) % size])) {
        m_result.pop_back();
        --first;
      }
      std::size_t last = i;
      while (last + 1 < start + size && is_in_run(last + 1)) {
        ++last;
      }
      if (!append_passed(crossings, first, last, vertex, is_on_right)) {
        for (std::size_t j = first; j <= last; ++j) {
          m_result.push_back(crossings[j % size]);
        }
      }
      i = last + 1;
    }
    std::swap(crossings, m_result);
  }

  /// Whether `crossing` crosses a incident edge of `vertex`, which lies on its right or left.
  bool passes(const Edge_crossing& crossing, Index vertex, bool is_on_right) const
  {
    return (is_on_right ? m_surface.origin(crossing.halfedge) : m_surface.target(crossing.halfedge)) == vertex;
  }

  bool is_last_result(const Edge_crossing& crossing) const
  {
    return !m_result.empty() && m_result.back().halfedge == crossing.halfedge &&
           m_result.back().position == crossing.position;
  }

  /// Appends to the result the crossings of the other side of `vertex`, around which the crossings from `first` to
  /// `last` run, if that is a shortcut.
  bool append_passed(const std::vector<Edge_crossing>& crossings, std::size_t first, std::size_t last, Index vertex,
                     bool is_on_right)
  {
    const std::size_t size = crossings.size();
    const Edge_crossing& before = crossings[(first + size - 1) % size];
    const Edge_crossing& after = crossings[(last + 1) % size];
    const auto touches = [&](Index h) { return m_surface.origin(h) == vertex || m_surface.target(h) == vertex; };
    if (last - first + 2 >= size || touches(before.halfedge) || touches(after.halfedge)) {
      return false;
    }
    collect_other_side(crossings[first % size].halfedge, crossings[last % size].halfedge, is_on_right);
    if (m_incident_edges.empty() || angle_over_incident_edges(vertex, crossing_point(m_surface, before),
                                                              crossing_point(m_surface, after)) >= pi - angle_margin) {
      return false;
    }
    for (Index incident_edge : m_incident_edges) {
      if (is_on_right) {
        m_result.push_back({m_surface.twin(incident_edge), 1 - passed_position});
      } else {
        m_result.push_back({incident_edge, passed_position});
      }
    }
    return true;
  }

  /// Collects the incident edges of the vertex that the run does not cross, in the order of their crossings with the
  /// new curve.
  void collect_other_side(Index first, Index last, bool is_on_right)
  {
    m_incident_edges.clear();
    const Index begin = is_on_right ? first : m_surface.twin(first);
    const Index end = is_on_right ? last : m_surface.twin(last);
    const auto step = [&](Index h) {
      return is_on_right ? m_surface.next_around_origin(h) : m_surface.previous_around_origin(h);
    };
    for (Index h = step(begin); h != end && h != begin; h = step(h)) {
      m_incident_edges.push_back(h);
    }
  }

  double angle_over_incident_edges(Index vertex, const Vector_3& before, const Vector_3& after) const
  {
    const Vector_3& center = m_surface.point(vertex);
    const auto angle_between = [](const Vector_3& u, const Vector_3& v) {
      return std::atan2(u.cross(v).norm(), u.dot(v));
    };
    Vector_3 direction = before - center;
    double angle = 0;
    for (Index incident_edge : m_incident_edges) {
      const Vector_3 next_direction = m_surface.point(m_surface.target(incident_edge)) - center;
      angle += angle_between(direction, next_direction);
      direction = next_direction;
    }
    return angle + angle_between(direction, after - center);
  }

  const Triangulated_surface& m_surface;
  std::vector<Edge_crossing> m_result;
  std::vector<Index> m_incident_edges;
};

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_STRAIGHTENING_H
