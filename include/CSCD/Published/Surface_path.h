// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves over a surface that may pass through vertices, and the edges that they cross next to these.

#ifndef CSCD_PUBLISHED_SURFACE_PATH_H
#define CSCD_PUBLISHED_SURFACE_PATH_H

#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>

#include <cstddef>
#include <vector>

namespace CSCD {

/// How the shortening of a curve ended.
enum class Shortening_outcome
{
  straight,  ///< it is a geodesic: nowhere can it be shortened locally
  held,      ///< it can be shortened at pinned vertices only, or is held by the ball around its source
  collapsed, ///< a closed curve has shrunk to a point, or to less than the allowed part of its length
  unfinished ///< it can still be shortened, but not by flips, or not in the allowed number of steps
};

} // namespace CSCD

namespace CSCD::internal {

/// A polygon over a surface, open or closed, which may pass through vertices and along edges.
struct Surface_path
{
  /// Where it crosses edges, see `Edge_crossing`, and the vertices that it passes through, in order. At a vertex,
  /// `position` is 0 and `halfedge` is from the vertex: the path leaves along it if the next point is a vertex too, and
  /// otherwise into its face. The last point of an open path is a vertex, given by any of its halfedges.
  std::vector<Edge_crossing> points;
  double length = 0;
};

/// Whether a point of a `Surface_path` is a vertex.
inline bool is_vertex(const Edge_crossing& point)
{
  return point.position == 0;
}

/// How far from a vertex a path that passes through it is pushed, relative to the length of the crossed edge.
inline constexpr double vertex_offset = 0.01;

/// Appends to `crossings` the edges around a vertex of a path that lie on the left of the path, from where it
/// comes in to where it goes out. `before`, `vertex` and `after` are consecutive points of the path.
template <class Surface>
void push_off_vertex(const Surface& surface, const Edge_crossing& before, const Edge_crossing& vertex,
                     const Edge_crossing& after, std::vector<Edge_crossing>& crossings)
{
  const auto previous_around_origin = [&surface](Index h) { return Surface::next(surface.twin(h)); };
  const bool comes_along = is_vertex(before);
  const Index back = surface.twin(before.halfedge);
  const Index way_in = comes_along ? back : Surface::previous(back);
  const Index way_out = vertex.halfedge;
  Index incident_edge = comes_along ? previous_around_origin(way_in) : way_in;
  // Both ends in one face: the left side holds all incident edges or none.
  if (way_in == way_out && !comes_along && !is_vertex(after) && 1 - before.position < after.position) {
    crossings.push_back({incident_edge, vertex_offset});
    incident_edge = previous_around_origin(incident_edge);
  }
  for (; incident_edge != way_out; incident_edge = previous_around_origin(incident_edge)) {
    crossings.push_back({incident_edge, vertex_offset});
  }
}

/// Writes to `crossings` the edges that the closed `path` crosses when it is pushed a little to its left where it
/// passes through vertices and along edges. Linear in the number of points and the degrees of the vertices.
/// \tparam Surface a model of `SurfaceTriangulation`
/// \return whether at least three edges are crossed
template <class Surface>
bool push_off_vertices(const Surface& surface, const Surface_path& path, std::vector<Edge_crossing>& crossings)
{
  crossings.clear();
  const std::vector<Edge_crossing>& points = path.points;
  const std::size_t size = points.size();
  for (std::size_t i = 0; i < size; ++i) {
    if (is_vertex(points[i])) {
      push_off_vertex(surface, points[(i + size - 1) % size], points[i], points[(i + 1) % size], crossings);
    } else {
      crossings.push_back(points[i]);
    }
  }
  cancel_backtracks(surface, crossings);
  return crossings.size() >= 3;
}

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_SURFACE_PATH_H
