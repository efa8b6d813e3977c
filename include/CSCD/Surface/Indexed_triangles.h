// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles as indices of points, and their order.

#ifndef CSCD_SURFACE_INDEXED_TRIANGLES_H
#define CSCD_SURFACE_INDEXED_TRIANGLES_H

#include <CSCD/Options.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Compressed_rows.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD {

/// Halfedge `h` runs along side `h % 3` of face `h / 3`, counterclockwise: so going around a face needs no memory.
/// Triangulations are derived from this.
struct Triangle_halfedges
{
  /// The halfedge after `halfedge` in its face.
  static Index next(Index halfedge) { return halfedge % 3 == 2 ? halfedge - 2 : halfedge + 1; }
  /// The halfedge before `halfedge` in its face.
  static Index previous(Index halfedge) { return halfedge % 3 == 0 ? halfedge + 2 : halfedge - 1; }
  /// The face of `halfedge`.
  static Index face(Index halfedge) { return halfedge / 3; }
};

/// The genus of a closed surface, all components together: their Euler numbers V - E + F = V - F/2, each 2 - 2 g, add
/// up.
constexpr std::size_t genus_of_closed_surface(std::size_t number_of_components, std::size_t number_of_vertices,
                                              std::size_t number_of_faces)
{
  return (2 * number_of_components + number_of_faces / 2 - number_of_vertices) / 2;
}

/// Points and triangles, counterclockwise seen from outside.
struct Indexed_triangles
{
  /// The positions of the vertices.
  std::vector<Vector_3> points;
  /// The vertices of each face, counterclockwise seen from outside.
  std::vector<std::array<Index, 3>> faces;
  /// The faces from this one on only bridge borders: they close the surface but carry no area.
  std::size_t first_hole_filling_face = 0;
};

namespace internal {

/// The areas of the faces.
inline std::vector<double> face_areas(const Indexed_triangles& triangles)
{
  std::vector<double> areas;
  areas.reserve(triangles.faces.size());
  for (const auto& [a, b, c] : triangles.faces) {
    areas.push_back(triangle_area(triangles.points[a], triangles.points[b], triangles.points[c]));
  }
  return areas;
}

} // namespace internal

/// Removes the numbers that no face uses from the numbering, and returns the old numbers of those that remain, in
/// order.
inline std::vector<Index> compact_numbers(std::vector<std::array<Index, 3>>& faces, std::size_t number_of_vertices)
{
  std::vector<Index> new_number(number_of_vertices, no_index);
  for (const std::array<Index, 3>& face : faces) {
    for (Index corner : face) {
      new_number[corner] = 0;
    }
  }
  std::vector<Index> old_number;
  old_number.reserve(number_of_vertices);
  for (Index vertex = 0; vertex < number_of_vertices; ++vertex) {
    if (new_number[vertex] != no_index) {
      new_number[vertex] = Index(old_number.size());
      old_number.push_back(vertex);
    }
  }
  if (old_number.size() < number_of_vertices) {
    for (std::array<Index, 3>& face : faces) {
      for (Index& corner : face) {
        corner = new_number[corner];
      }
    }
  }
  return old_number;
}

/// Sorts faces lexicographically, hole-filling faces after all others; linear where degrees are bounded.
/// \pre the smallest corner of every face comes first
inline void sort_faces(Indexed_triangles& triangles)
{
  // One bucket for each smallest corner, those of the hole-filling faces after the others.
  const std::size_t n = triangles.points.size();
  const auto bucket = [&triangles, n](std::size_t f) {
    return triangles.faces[f].front() + (f < triangles.first_hole_filling_face ? 0 : n);
  };
  internal::Compressed_rows<std::array<Index, 3>> buckets(2 * n, [&](const auto& add) {
    for (std::size_t f = 0; f < triangles.faces.size(); ++f) {
      add(bucket(f), triangles.faces[f]);
    }
  });
  for (Index b = 0; b < 2 * n; ++b) {
    std::sort(buckets[b].begin(), buckets[b].end());
  }
  triangles.faces = std::move(buckets).values();
}

/// Gives the vertex `order[i]` of `triangles` the number `i`, and sorts the faces accordingly, each from its smallest
/// corner on. Linear where degrees are bounded.
/// \pre `order` is a permutation
inline void renumber(Indexed_triangles& triangles, const std::vector<Index>& order)
{
  std::vector<Index> number(order.size());
  std::vector<Vector_3> points(order.size());
  for (Index i = 0; i < order.size(); ++i) {
    number[order[i]] = i;
    points[i] = triangles.points[order[i]];
  }
  triangles.points = std::move(points);
  for (std::array<Index, 3>& face : triangles.faces) {
    for (Index& corner : face) {
      corner = number[corner];
    }
    if (face[1] < face[0] && face[1] < face[2]) {
      face = {face[1], face[2], face[0]};
    } else if (face[2] < face[0]) {
      face = {face[2], face[0], face[1]};
    }
  }
  sort_faces(triangles);
}

} // namespace CSCD

#endif // CSCD_SURFACE_INDEXED_TRIANGLES_H
