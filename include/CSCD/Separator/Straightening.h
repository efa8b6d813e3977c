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

/// Joins consecutive vertices of a coarse loop by shortest paths along the edges of the finest level. Work is local to
/// the loop. Reuse one object.
class Loop_projection
{
public:
  explicit Loop_projection(const Surface_levels& levels)
      : m_levels(levels), m_front(levels.finest().surface.number_of_vertices()),
        m_passed(levels.finest().surface.number_of_vertices()), m_links(levels.finest().surface.number_of_vertices())
  {
  }

  /// Writes to `fine_loop` the projection of `loop`, which runs along edges of `level`, without repeated vertices.
  /// \return false if a path strays too far, or if the rest is not the greater part of a loop
  bool operator()(const Surface_level& level, const Vertex_loop& loop, Vertex_loop& fine_loop)
  {
    m_path.clear();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (!append_path(level.to_finest(loop[i]), level.to_finest(loop[(i + 1) % loop.size()]))) {
        return false;
      }
    }
    return erase_spurs(fine_loop);
  }

private:
  /// A path may be this many times as long as the straight line.
  static constexpr double max_detour = 3;
  static constexpr std::size_t min_loop_size = 4;

  /// Appends the path from `from` to `to`, without its first vertex.
  bool append_path(Index from, Index to)
  {
    const Triangulated_surface& surface = m_levels.finest().surface;
    const float limit = float(max_detour * (surface.point(from) - surface.point(to)).norm());
    bool is_found = false;
    m_front.clear();
    m_front.reach(from, 0);
    m_front.spread([&](Index vertex, float distance) {
      if (vertex == to) {
        is_found = true;
        m_front.clear();
        return;
      }
      for (const Index h : surface.outgoing(vertex)) {
        const float length = distance + float(surface.length(h));
        if (length < limit && m_front.reach(surface.target(h), length)) {
          m_links[surface.target(h)] = vertex;
        }
      }
    });
    const std::size_t begin = m_path.size();
    for (Index vertex = to; is_found && vertex != from; vertex = m_links[vertex]) {
      m_path.push_back(vertex);
    }
    std::reverse(m_path.begin() + std::ptrdiff_t(begin), m_path.end());
    return is_found;
  }

  /// Copies the path to `loop`; where it returns to a vertex, the part between is left out.
  bool erase_spurs(Vertex_loop& loop)
  {
    loop.clear();
    m_passed.clear();
    for (const Index vertex : m_path) {
      // The place in the loop, unless the earlier visit has been left out itself.
      const std::size_t place = m_passed.mark(vertex) ? loop.size() : m_links[vertex];
      if (place >= loop.size() || loop[place] != vertex) {
        m_links[vertex] = Index(loop.size());
        loop.push_back(vertex);
      } else if (loop.size() - place > m_path.size() / 2) {
        return false;
      } else {
        loop.resize(place + 1);
      }
    }
    return loop.size() >= min_loop_size;
  }

  const Surface_levels& m_levels;
  Dijkstra_search m_front;
  Epoch_marks m_passed;
  std::vector<Index, boost::noinit_adaptor<std::allocator<Index>>> m_links; ///< to the vertex before, then the place
  Vertex_loop m_path;
};

/// Straightens the closed curve of `crossings` by sweeps that move each crossing along its edge to where the unfolded
/// curve is straight. A few sweeps take out the zigzag of a loop along edges and keep it where it is. Linear.
inline void straighten(const Triangulated_surface& surface, std::vector<Edge_crossing>& crossings)
{
  constexpr int number_of_sweeps = 15;
  constexpr double end_margin = 0.02;  // from the ends of an edge, relative to its length
  constexpr double negligible = 1e-12; // area, relative to the square of the length
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
    if (squared_length > 0) {
      // Between faces without area, rounding does not decide: in the middle.
      const double height = height_before + height_after;
      const double share = height > negligible * squared_length ? height_after / height : 0.5;
      const double along = (share * before + (1 - share) * after).dot(edge) / squared_length;
      crossing.position = std::clamp(along, end_margin, 1 - end_margin);
    }
  }
}

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_STRAIGHTENING_H
