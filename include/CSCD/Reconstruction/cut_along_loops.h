// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cuts a surface open along loops.

#ifndef CSCD_RECONSTRUCTION_CUT_ALONG_LOOPS_H
#define CSCD_RECONSTRUCTION_CUT_ALONG_LOOPS_H

#include <CSCD/Traits/Indexed_triangles.h>
#include <CSCD/Traits/Triangulated_surface.h>
#include <CSCD/Traits/Vertex_loop.h>
#include <CSCD/internal/Vector_3.h>

#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// Cuts `triangles` open along `loops`: the faces to the right of a loop get copies of its vertices, which are
/// appended. Linear in the degrees of the vertices. \return for every copy, in order, the vertex of which it is one
/// \pre `surface` is that of `triangles`, with the same numbers; the loops have no vertex in common, and consecutive
///      vertices are neighbors
inline std::vector<Index> cut_along_loops(Indexed_triangles& triangles, const Triangulated_surface& surface,
                                          const std::vector<Vertex_loop>& loops)
{
  std::vector<Index> originals;
  for (const Vertex_loop& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index copy = Index(triangles.points.size());
      triangles.points.push_back(Vector_3(triangles.points[loop[i]]));
      originals.push_back(loop[i]);
      const Index forward = surface.find_halfedge(loop[i], loop[(i + 1) % loop.size()]);
      const Index before = loop[(i + loop.size() - 1) % loop.size()];
      // Clockwise from the way out to the way in lie the faces to the right.
      Index h = forward;
      do {
        h = surface.previous_around_origin(h);
        triangles.faces[h / 3][h % 3] = copy;
      } while (surface.target(h) != before);
    }
  }
  return originals;
}

} // namespace CSCD::internal

#endif // CSCD_RECONSTRUCTION_CUT_ALONG_LOOPS_H
