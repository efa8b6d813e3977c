// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the cut locus goes around handles and between sources, found without any threshold.

#ifndef CSCD_CUT_LOCUS_FIND_LOOP_VERTICES_H
#define CSCD_CUT_LOCUS_FIND_LOOP_VERTICES_H

#include <CSCD/Cut_locus/Cut_measures.h>
#include <CSCD/Cut_locus/Disc_growth.h>
#include <CSCD/internal/Vector_3.h>

#include <vector>

namespace CSCD::internal {

/// Marks the vertices of the loops of the cut locus and of what joins these: discs grow around the sources by distance,
/// and of the edges where they meet those are taken away, one after the other, that end freely. None are left on a
/// sphere with one source. Fronts may meet there at any angle, even at one that no threshold would notice.
/// O(m log m) for m faces.
template <class Triangulation>
std::vector<char> find_loop_vertices(const Cut_measures<Triangulation>& measures, const std::vector<Index>& sources)
{
  const Triangulation& triangulation = measures.frames().triangulation();
  const auto never = [](Index) { return false; };
  const std::vector<Index> uncrossed = Disc_growth<Triangulation>(measures, sources)(never, never);

  std::vector<char> is_left(triangulation.number_of_halfedges(), 0);
  std::vector<Index> degree(triangulation.number_of_vertices(), 0);
  for (Index h : uncrossed) {
    is_left[h] = 1;
    ++degree[triangulation.origin(h)];
    ++degree[triangulation.target(h)];
  }
  const auto mark_of = [&](Index halfedge) -> char& {
    const Index twin = triangulation.twin(halfedge);
    return is_left[is_left[halfedge] || twin == no_index ? halfedge : twin];
  };
  for (Index start = 0; start < triangulation.number_of_vertices(); ++start) {
    for (Index vertex = start; vertex != no_index && degree[vertex] == 1;) {
      Index next = no_index;
      measures.frames().for_each_neighbor(vertex, [&](Index neighbor, Index halfedge) {
        if (next == no_index && mark_of(halfedge)) {
          mark_of(halfedge) = 0;
          next = neighbor;
        }
      });
      --degree[vertex];
      --degree[next];
      vertex = next;
    }
  }
  std::vector<char> result(degree.size(), 0);
  for (Index vertex = 0; vertex < degree.size(); ++vertex) {
    result[vertex] = degree[vertex] > 0 ? 1 : 0;
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_CUT_LOCUS_FIND_LOOP_VERTICES_H
