// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A triangulation that has nothing but what the heat method asks for.

#ifndef CSCD_TEST_PUBLISHED_LENGTH_TRIANGULATION_H
#define CSCD_TEST_PUBLISHED_LENGTH_TRIANGULATION_H

#include <CSCD/Vector_3.h>

#include <array>
#include <vector>

namespace CSCD::test {

/// Faces with lengths of sides; several edges may join the same vertices, and an edge may join a vertex to itself.
struct Length_triangulation
{

  Index number_of_vertices() const { return vertices; }
  Index number_of_faces() const { return Index(faces.size()); }
  Index origin(Index halfedge) const { return faces[halfedge / 3][halfedge % 3]; }
  double length(Index halfedge) const { return lengths[halfedge / 3][halfedge % 3]; }

  Index vertices = 0;
  std::vector<std::array<Index, 3>> faces;
  std::vector<std::array<double, 3>> lengths; ///< from corner 0 to 1, 1 to 2, 2 to 0 of every face
};

/// The faces of `triangulation` that bridge no border, without all else.
template <class Triangulation>
Length_triangulation lengths_of(const Triangulation& triangulation)
{
  Length_triangulation result{triangulation.number_of_vertices(), {}, {}};
  for (CSCD::Index h = 0; h < 3 * triangulation.first_hole_filling_face(); h += 3) {
    result.faces.push_back({triangulation.origin(h), triangulation.origin(h + 1), triangulation.origin(h + 2)});
    result.lengths.push_back({triangulation.length(h), triangulation.length(h + 1), triangulation.length(h + 2)});
  }
  return result;
}

} // namespace CSCD::test

#endif // CSCD_TEST_PUBLISHED_LENGTH_TRIANGULATION_H
