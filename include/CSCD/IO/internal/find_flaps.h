// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds faces that hang on a surface without being part of it, as in scans that were stitched together.

#ifndef CSCD_IO_INTERNAL_FIND_FLAPS_H
#define CSCD_IO_INTERNAL_FIND_FLAPS_H

#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The sides of triangles, sorted so that those at one edge are together.
class Sides_of_edges
{
public:
  /// O(n log n).
  explicit Sides_of_edges(const std::vector<std::array<Index, 3>>& faces)
  {
    m_sides.reserve(3 * faces.size());
    for (Index face = 0; face < faces.size(); ++face) {
      const auto [a, b, c] = faces[face];
      for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
        m_sides.push_back({std::min(from, to), std::max(from, to), face});
      }
    }
    std::sort(m_sides.begin(), m_sides.end());
  }

  /// Calls `function(faces)` for each edge with the faces at it. The argument is reused.
  template <class Function>
  void for_each_edge(const Function& function) const
  {
    std::vector<Index> faces;
    for (std::size_t i = 0; i < m_sides.size(); ++i) {
      const auto& [first, second, face] = m_sides[i];
      faces.push_back(face);
      if (i + 1 == m_sides.size() || m_sides[i + 1][0] != first || m_sides[i + 1][1] != second) {
        function(std::as_const(faces));
        faces.clear();
      }
    }
  }

private:
  std::vector<std::array<Index, 3>> m_sides; ///< the two vertices, the smaller one first, and the face
};

/// Finds the faces of flaps: parts of the surface, joined by edges of two faces, that meet a part of a hundred times
/// their area at an edge of three faces or more. Without them, that edge joins the two faces of the larger part, which
/// would be slit there. O(n log n). \return for each face, whether it is of a flap
/// \pre no face names a vertex twice, and no two faces have the same vertices
inline std::vector<char> find_flaps(const Indexed_triangles& triangles)
{
  constexpr double max_area = 0.01; // relative to that of the larger part
  const std::size_t number_of_faces = triangles.faces.size();
  const Sides_of_edges sides(triangles.faces);
  Disjoint_sets sets(number_of_faces);
  sides.for_each_edge([&](const std::vector<Index>& faces) {
    if (faces.size() == 2) {
      sets.join(faces[0], faces[1]);
    }
  });
  Index number_of_parts = 0;
  const std::vector<Index> part = sets.numbers(number_of_parts);
  const std::vector<double> face_area = face_areas(triangles);
  std::vector<double> area(number_of_parts, 0.);
  for (Index face = 0; face < number_of_faces; ++face) {
    area[part[face]] += face_area[face];
  }
  std::vector<char> is_flap(number_of_parts, 0);
  sides.for_each_edge([&](const std::vector<Index>& faces) {
    if (faces.size() > 2) {
      double largest = 0;
      for (const Index face : faces) {
        largest = std::max(largest, area[part[face]]);
      }
      for (const Index face : faces) {
        is_flap[part[face]] = is_flap[part[face]] != 0 || area[part[face]] < max_area * largest ? 1 : 0;
      }
    }
  });
  std::vector<char> result(number_of_faces);
  std::transform(part.begin(), part.end(), result.begin(), [&is_flap](Index p) { return is_flap[p]; });
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_FIND_FLAPS_H
