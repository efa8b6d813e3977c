// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The fan of triangles around every vertex, laid out for a geodesic front: one stream of small records a vertex.

#ifndef CSCD_SURFACE_VERTEX_FAN_TABLE_H
#define CSCD_SURFACE_VERTEX_FAN_TABLE_H

#include <CSCD/Surface/Triangulated_surface.h>

#include <CGAL/Iterator_range.h>

#include <cstddef>
#include <vector>

namespace CSCD {

/// One corner of a vertex `v`: the triangle between an outgoing edge and the next one counterclockwise.
struct Corner
{
  Index neighbor; ///< the target of the outgoing edge
  float length;   ///< of the outgoing edge
  float cosine;   ///< of the angle at `v`
  float sine;     ///< of the angle at `v`
};

/// The corners of all vertices of a surface. 16 bytes a corner: a front that visits `v` reads a single short stream,
/// instead of following halfedges to points.
class Vertex_fan_table
{
public:
  Vertex_fan_table() = default;

  /// Computes all corners of `surface`; linear.
  explicit Vertex_fan_table(const Triangulated_surface& surface)
  {
    const Index n = surface.number_of_vertices();
    m_begin.resize(std::size_t(n) + 1);
    m_corners.reserve(std::size_t(surface.number_of_halfedges()) + n);
    double length_sum = 0;
    for (Index vertex = 0; vertex < n; ++vertex) {
      m_begin[vertex] = Index(m_corners.size());
      append_fan(surface, vertex, length_sum);
    }
    m_begin[n] = Index(m_corners.size());
    m_mean_length = length_sum / double(surface.number_of_halfedges());
  }

  /// The corners of `vertex` in counterclockwise order; the first one stands again at the end, so that corner `i + 1`
  /// is the next one without wrapping around. The degree of `vertex` is therefore the size less one.
  CGAL::Iterator_range<const Corner*> fan(Index vertex) const
  {
    return {m_corners.data() + m_begin[vertex], m_corners.data() + m_begin[vertex + 1]};
  }
  /// The same without the repetition.
  CGAL::Iterator_range<const Corner*> neighbors(Index vertex) const
  {
    return {m_corners.data() + m_begin[vertex], m_corners.data() + m_begin[vertex + 1] - 1};
  }

  /// Asks the processor for the corners of `vertex`, which are read soon: up to a half of the time of what goes from
  /// vertex to neighbor is waiting for the first corner.
  void prefetch([[maybe_unused]] Index vertex) const
  {
#if defined(__GNUC__)
    constexpr std::size_t cache_line = 64;
    const char* corner = reinterpret_cast<const char*>(m_corners.data() + m_begin[vertex]);
    __builtin_prefetch(corner);
    __builtin_prefetch(corner + cache_line);
#endif
  }

  /// The mean length of the edges.
  double mean_length() const
  {
    return m_mean_length;
  }

private:
  void append_fan(const Triangulated_surface& surface, Index vertex, double& length_sum)
  {
    const Vector_3& center = surface.point(vertex);
    for (Index halfedge : surface.outgoing(vertex)) {
      const Index neighbor = surface.target(halfedge);
      const Vector_3 incident_edge = surface.point(neighbor) - center;
      const Vector_3 next_incident_edge = surface.point(surface.opposite_vertex(halfedge)) - center;
      const double length = incident_edge.norm();
      const double product = length * next_incident_edge.norm();
      // A incident edge of no length spans no angle.
      const double cosine = product > 0 ? incident_edge.dot(next_incident_edge) / product : 1.;
      const double sine = product > 0 ? incident_edge.cross(next_incident_edge).norm() / product : 0.;
      m_corners.push_back({neighbor, float(length), float(cosine), float(sine)});
      length_sum += length;
    }
    m_corners.push_back(m_corners[m_begin[vertex]]);
  }

  std::vector<Corner> m_corners;
  std::vector<Index> m_begin;
  double m_mean_length = 0;
};

} // namespace CSCD

#endif // CSCD_SURFACE_VERTEX_FAN_TABLE_H
