// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Takes a closed curve off the vertices that it passes through.

#ifndef CSCD_SEPARATOR_PUSH_OFF_VERTICES_H
#define CSCD_SEPARATOR_PUSH_OFF_VERTICES_H

#include <CSCD/Separator/Surface_path.h>
#include <CSCD/Traits/Edge_crossing.h>
#include <CSCD/Traits/Triangulated_surface.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// Appends to `crossings` the edges around a vertex of a path that lie on the left of the path, from the way in to the
/// way out. `before`, `vertex` and `after` are consecutive points of the path.
template <class Append>
void push_off_vertex(const Triangulated_surface& surface, const Edge_crossing& before, const Edge_crossing& vertex,
                     const Edge_crossing& after, const Append& append)
{
  // Distance from the vertex, relative to the length of the crossed edge.
  constexpr double offset = 0.01;
  const bool comes_along = is_vertex(before);
  const Index back = surface.twin(before.halfedge);
  const Index way_in = comes_along ? back : Triangulated_surface::previous(back);
  const Index way_out = vertex.halfedge;
  Index spoke = comes_along ? surface.previous_around_origin(way_in) : way_in;
  // Both ways in one face: the left side holds all spokes or none.
  if (way_in == way_out && !comes_along && !is_vertex(after) && 1 - before.position < after.position) {
    append({spoke, offset});
    spoke = surface.previous_around_origin(spoke);
  }
  for (; spoke != way_out; spoke = surface.previous_around_origin(spoke)) {
    append({spoke, offset});
  }
}

/// Writes to `crossings` the edges that `path` crosses when it is pushed a little to its left where it passes through
/// vertices and along edges. Linear in the number of points and the degrees of the vertices.
/// \return whether at least three edges are crossed
/// \pre `path` is closed
inline bool push_off_vertices(const Triangulated_surface& surface, const Surface_path& path,
                              std::vector<Edge_crossing>& crossings)
{
  CGAL_precondition(path.is_closed);
  const auto cancels = [&surface](const Edge_crossing& a, const Edge_crossing& b) {
    return a.halfedge == surface.twin(b.halfedge);
  };
  const auto append = [&](const Edge_crossing& crossing) {
    if (!crossings.empty() && cancels(crossings.back(), crossing)) {
      crossings.pop_back();
    } else {
      crossings.push_back(crossing);
    }
  };
  crossings.clear();
  const std::vector<Edge_crossing>& points = path.points;
  const std::size_t size = points.size();
  for (std::size_t i = 0; i < size; ++i) {
    if (is_vertex(points[i])) {
      push_off_vertex(surface, points[(i + size - 1) % size], points[i], points[(i + 1) % size], append);
    } else {
      append(points[i]);
    }
  }
  std::size_t stem = 0;
  while (2 * stem + 2 <= crossings.size() && cancels(crossings[crossings.size() - 1 - stem], crossings[stem])) {
    ++stem;
  }
  crossings.erase(crossings.end() - std::ptrdiff_t(stem), crossings.end());
  crossings.erase(crossings.begin(), crossings.begin() + std::ptrdiff_t(stem));
  return crossings.size() >= 3;
}

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_PUSH_OFF_VERTICES_H
