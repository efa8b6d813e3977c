// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keeps the parts of a point complex that can be surfaces of bodies.

#ifndef CSCD_POINT_CLOUD_DROP_FRAGMENTS_H
#define CSCD_POINT_CLOUD_DROP_FRAGMENTS_H

#include <CSCD/Point_cloud/Point_complex.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// A part with fewer of the points than this, relative to the largest part, is a fragment: noise, or the tip of a limb
/// that lost its connection.
inline constexpr double least_part_of_points = 0.02;

/// Makes the complex of the components of `complex` that are no fragments; linear.
/// \param number gets for each vertex of `complex` its number in the result, `no_index` if it was dropped
/// \pre `complex` has a triangle
inline Point_complex drop_fragments(Point_complex&& complex, std::vector<Index>& number)
{
  std::vector<std::size_t> size(complex.number_of_components(), 0);
  for (Index v = 0; v < complex.number_of_vertices(); ++v) {
    ++size[complex.component(v)];
  }
  const double least_size = least_part_of_points * double(*std::max_element(size.begin(), size.end()));
  number.assign(complex.number_of_vertices(), no_index);
  std::vector<Vector_3> points;
  std::vector<Vector_3> normals;
  for (Index v = 0; v < complex.number_of_vertices(); ++v) {
    if (double(size[complex.component(v)]) >= least_size && !complex.outgoing(v).empty()) {
      number[v] = Index(points.size());
      points.push_back(complex.point(v));
      normals.push_back(complex.normal(v));
    }
  }
  if (points.size() == number.size()) {
    return std::move(complex);
  }
  std::vector<std::array<Index, 3>> triangles;
  for (Index face = 0; face < complex.number_of_faces(); ++face) {
    const auto [a, b, c] = complex.face_vertices(face);
    if (number[a] != no_index) {
      triangles.push_back({number[a], number[b], number[c]});
    }
  }
  return {std::move(points), std::move(normals), triangles};
}

} // namespace CSCD::internal

#endif // CSCD_POINT_CLOUD_DROP_FRAGMENTS_H
