// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds faces that hang on a surface without being part of it, as in scans that were stitched together.

#ifndef CSCD_IO_INTERNAL_FIND_FLAPS_H
#define CSCD_IO_INTERNAL_FIND_FLAPS_H

#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Disjoint_sets.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Finds the faces of flaps: parts of the surface, joined by edges of two faces, that meet a part of a hundred times
/// their area at an edge of three faces or more. Without them, that edge joins the two faces of the larger part, which
/// would be slit there. O(n log n). \return for each face, whether it is of a flap
/// \pre no face names a vertex twice, and no two faces have the same vertices
inline std::vector<char> find_flaps(const Indexed_triangles& triangles)
{
  constexpr double max_area = 0.01; // relative to that of the larger part
  struct Side
  {
    Index first, second; // vertices, the smaller one first
    Index face;
  };
  std::vector<Side> sides;
  sides.reserve(3 * triangles.faces.size());
  for (Index face = 0; face < triangles.faces.size(); ++face) {
    const auto [a, b, c] = triangles.faces[face];
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      sides.push_back({std::min(from, to), std::max(from, to), face});
    }
  }
  const auto key = [](const Side& side) { return std::tie(side.first, side.second, side.face); };
  std::sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) { return key(a) < key(b); });
  const auto for_each_edge = [&sides](const auto& function) {
    for (auto begin = sides.cbegin(), end = begin; begin != sides.cend(); begin = end) {
      while (end != sides.cend() && end->first == begin->first && end->second == begin->second) {
        ++end;
      }
      function(begin, end);
    }
  };
  Disjoint_sets parts(triangles.faces.size());
  for_each_edge([&](auto begin, auto end) {
    if (end - begin == 2) {
      parts.join(begin->face, (begin + 1)->face);
    }
  });
  std::vector<double> area(triangles.faces.size(), 0.); // of each part, at the face that represents it
  const std::vector<double> face_area = face_areas(triangles);
  for (Index face = 0; face < triangles.faces.size(); ++face) {
    area[parts.find(face)] += face_area[face];
  }
  std::vector<char> is_flap(triangles.faces.size(), 0); // of each part, likewise
  for_each_edge([&](auto begin, auto end) {
    if (end - begin > 2) {
      double largest = 0;
      std::for_each(begin, end, [&](const Side& s) { largest = std::max(largest, area[parts.find(s.face)]); });
      std::for_each(begin, end, [&](const Side& s) {
        const Index part = parts.find(s.face);
        is_flap[part] = is_flap[part] != 0 || area[part] < max_area * largest ? 1 : 0;
      });
    }
  });
  std::vector<char> result(triangles.faces.size());
  for (Index face = 0; face < triangles.faces.size(); ++face) {
    result[face] = is_flap[parts.find(face)];
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_FIND_FLAPS_H
