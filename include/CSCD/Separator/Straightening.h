// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves on the surface made shorter by sweeps, and carried from level to level.

#ifndef CSCD_SEPARATOR_STRAIGHTENING_H
#define CSCD_SEPARATOR_STRAIGHTENING_H

#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/Dijkstra_search.h>
#include <CSCD/internal/flat_arrays.h>

#include <boost/core/noinit_adaptor.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
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
    const Vector3 goal = surface.point(to);
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

/// Straightens the closed curve of `crossings` by sweeps that move each crossing along its edge to where the unfolded
/// curve is straight. A few sweeps take out the zigzag of a loop along edges and keep it where it is. Linear.
inline void straighten(const Triangulated_surface& surface, std::vector<Edge_crossing>& crossings)
{
  constexpr int number_of_sweeps = 15;
  constexpr double end_margin = 0.02; // from the ends of an edge, relative to its length
  cancel_backtracks(surface, crossings);
  const std::size_t size = crossings.size();
  for (std::size_t i = 0; i < number_of_sweeps * size; ++i) {
    Edge_crossing& crossing = crossings[i % size];
    const Vector3& origin = surface.point(surface.origin(crossing.halfedge));
    const Vector3 edge = surface.point(surface.target(crossing.halfedge)) - origin;
    const double squared_length = edge.squaredNorm();
    const Vector3 before = crossing_point(surface, crossings[(i + size - 1) % size]) - origin;
    const Vector3 after = crossing_point(surface, crossings[(i + 1) % size]) - origin;
    // The areas that the edge spans with the two: their distances from it, times its length.
    const double height_before = edge.cross(before).norm();
    const double height_after = edge.cross(after).norm();
    if (squared_length > 0 && height_before + height_after > 0) {
      const double along = (height_after * before.dot(edge) + height_before * after.dot(edge)) /
                           ((height_before + height_after) * squared_length);
      crossing.position = std::clamp(along, end_margin, 1 - end_margin);
    }
  }
}

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_STRAIGHTENING_H
