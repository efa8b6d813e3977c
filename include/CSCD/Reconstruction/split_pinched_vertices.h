// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes a manifold of triangles that meet in single points.

#ifndef CSCD_RECONSTRUCTION_SPLIT_PINCHED_VERTICES_H
#define CSCD_RECONSTRUCTION_SPLIT_PINCHED_VERTICES_H

#include <CSCD/Traits/Halfedge_pairing.h>
#include <CSCD/Traits/Indexed_triangles.h>
#include <CSCD/internal/Vector_3.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// Calls `use(h)` for each halfedge `h` that leaves the origin of `halfedge` inside the same fan of faces.
template <class Use>
void for_each_in_fan(const Halfedge_pairing& pairing, Index halfedge, const Use& use)
{
  Index at = halfedge;
  do {
    use(at);
    at = pairing.twin(Halfedge_pairing::previous(at));
  } while (at != no_index && at != halfedge);
  if (at == no_index) {
    for (at = pairing.twin(halfedge); at != no_index; at = pairing.twin(at)) {
      at = Halfedge_pairing::next(at);
      use(at);
    }
  }
}

/// Gives every fan of faces around a vertex a vertex of its own: the first keeps it, the others get copies, which are
/// appended. The pairing remains valid. Linear. \return for every copy, in order, the vertex of which it is one
/// \pre `pairing`, that of the faces, has no conflict
inline std::vector<Index> split_pinched_vertices(Indexed_triangles& triangles, const Halfedge_pairing& pairing)
{
  std::vector<char> is_visited(pairing.number_of_halfedges(), 0);
  std::vector<char> has_fan(triangles.points.size(), 0);
  std::vector<Index> originals;
  for (Index halfedge = 0; halfedge < pairing.number_of_halfedges(); ++halfedge) {
    if (is_visited[halfedge]) {
      continue;
    }
    Index vertex = triangles.faces[halfedge / 3][halfedge % 3];
    if (has_fan[vertex]) {
      originals.push_back(vertex);
      triangles.points.push_back(Vector_3(triangles.points[vertex]));
      vertex = Index(triangles.points.size() - 1);
    } else {
      has_fan[vertex] = 1;
    }
    for_each_in_fan(pairing, halfedge, [&](Index h) {
      is_visited[h] = 1;
      triangles.faces[h / 3][h % 3] = vertex;
    });
  }
  return originals;
}

} // namespace CSCD::internal

#endif // CSCD_RECONSTRUCTION_SPLIT_PINCHED_VERTICES_H
