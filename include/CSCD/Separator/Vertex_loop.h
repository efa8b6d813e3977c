// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed curves along edges: from the two arms of a front to a list of crossed edges.

#ifndef CSCD_SEPARATOR_VERTEX_LOOP_H
#define CSCD_SEPARATOR_VERTEX_LOOP_H

#include <CSCD/Geodesic/Polar_front.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Traits/Triangulated_surface.h>
#include <CSCD/Traits/Vertex_loop.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// Writes to `loop` the closed curve from the source of `front` to `first`, across the edge to `second`, and back.
/// Where both arms leave the source by the same path, that path is left out.
inline void trace_loop(const Polar_front& front, Index first, Index second, Vertex_loop& loop)
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

/// Writes to `crossings` the edges that `loop` crosses when it is pushed a little to its left.
/// \return whether consecutive vertices are neighbors and at least three edges are crossed
inline bool push_off(const Triangulated_surface& surface, const Vertex_loop& loop,
                     std::vector<Edge_crossing>& crossings)
{
  // Distance from the loop, relative to the length of the crossed edge; straightening moves it anyway.
  constexpr double offset = 0.15;
  crossings.clear();
  const std::size_t size = loop.size();
  for (std::size_t i = 0; i < size; ++i) {
    const Index before = loop[(i + size - 1) % size];
    const Index after = loop[(i + 1) % size];
    const Index forward = surface.find_halfedge(loop[i], after);
    if (forward == no_index || before == after || surface.find_halfedge(loop[i], before) == no_index) {
      return false;
    }
    const std::size_t first_here = crossings.size();
    for (Index h = surface.next_around_origin(forward); surface.target(h) != before;
         h = surface.next_around_origin(h)) {
      crossings.push_back({h, offset});
    }
    // The spokes were collected from the way out to the way in.
    std::reverse(crossings.begin() + std::ptrdiff_t(first_here), crossings.end());
  }
  return crossings.size() >= 3;
}

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_VERTEX_LOOP_H
