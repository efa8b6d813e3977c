// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Refuses triangles that do not form an oriented manifold, with or without border.

#ifndef CSCD_TRAITS_CHECK_MANIFOLD_H
#define CSCD_TRAITS_CHECK_MANIFOLD_H

#include <CSCD/Traits/Halfedge_pairing.h>
#include <CSCD/Traits/Indexed_triangles.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CSCD::internal {

/// Throws for the edge of `halfedge`, whose faces contradict each other.
template <class VertexName>
[[noreturn]] void refuse_edge(const Indexed_triangles& triangles, Index halfedge, const VertexName& name)
{
  const std::array<Index, 3>& owner = triangles.faces[halfedge / 3];
  const Index source = owner[halfedge % 3];
  const Index target = owner[(halfedge + 1) % 3];
  const auto has_edge = [source, target](const std::array<Index, 3>& face) {
    return std::count(face.begin(), face.end(), source) + std::count(face.begin(), face.end(), target) == 2;
  };
  const auto number_of_faces = std::count_if(triangles.faces.begin(), triangles.faces.end(), has_edge);
  const std::string edge =
      "the edge between vertices " + std::to_string(name(source)) + " and " + std::to_string(name(target));
  if (number_of_faces > 2) {
    throw Input_error(edge + " has " + std::to_string(number_of_faces) +
                      " faces, a surface has at most two: remove faces or split the edge, for instance by "
                      "CGAL::Polygon_mesh_processing::orient_polygon_soup");
  }
  throw Input_error(edge + " has two faces of opposite orientation: orient the faces consistently, for instance by "
                           "CGAL::Polygon_mesh_processing::orient_polygon_soup; a one-sided surface has no inside");
}

/// Marks all corners of the fan of faces that holds `halfedge` around its origin.
inline void mark_fan(const Halfedge_pairing& pairing, Index halfedge, std::vector<char>& marked)
{
  Index at = halfedge;
  do {
    marked[at] = 1;
    at = pairing.twin(Halfedge_pairing::previous(at));
  } while (at != no_index && at != halfedge);
  if (at == no_index) {
    for (at = pairing.twin(halfedge); at != no_index; at = pairing.twin(at)) {
      at = Halfedge_pairing::next(at);
      marked[at] = 1;
    }
  }
}

/// Pairs the halfedges of `triangles`, after making sure that every edge has at most two faces, oriented consistently,
/// and that the faces around every vertex form one fan. Linear.
/// \param name gives the number by which a message calls a vertex
/// \throw Input_error naming the first edge or vertex that violates this
template <class VertexName>
Halfedge_pairing check_manifold(const Indexed_triangles& triangles, const VertexName& name)
{
  Halfedge_pairing pairing(triangles.faces, triangles.points.size());
  if (pairing.conflict() != no_index) {
    refuse_edge(triangles, pairing.conflict(), name);
  }
  std::vector<char> marked(pairing.number_of_halfedges(), 0);
  std::vector<char> has_fan(triangles.points.size(), 0);
  for (Index halfedge = 0; halfedge < pairing.number_of_halfedges(); ++halfedge) {
    if (marked[halfedge]) {
      continue;
    }
    const Index vertex = triangles.faces[halfedge / 3][halfedge % 3];
    if (has_fan[vertex]) {
      throw Input_error("vertex " + std::to_string(name(vertex)) +
                        " is pinched: its faces form several fans that touch in this point only; duplicate it, for "
                        "instance by CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices");
    }
    has_fan[vertex] = 1;
    mark_fan(pairing, halfedge, marked);
  }
  return pairing;
}

} // namespace CSCD::internal

#endif // CSCD_TRAITS_CHECK_MANIFOLD_H
