// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Turns components inside out whose faces look inwards.

#ifndef CSCD_TRAITS_ORIENT_OUTWARDS_H
#define CSCD_TRAITS_ORIENT_OUTWARDS_H

#include <CSCD/Traits/Halfedge_pairing.h>
#include <CSCD/Traits/Indexed_triangles.h>
#include <CSCD/Traits/label_components.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Volumes below this, relative to the area to the power 3/2, have no reliable sign: a ball has about 0.1.
inline constexpr double smallest_signed_volume = 1e-9;

/// Reverses the faces of all components that enclose a negative volume: each component is then a body of its own.
/// Linear.
/// \return the number of components that were reversed
/// \pre `triangles` is closed; `pairing` and `components` are those of its faces
inline std::size_t orient_outwards(Indexed_triangles& triangles, Halfedge_pairing& pairing,
                                   const Face_components& components)
{
  std::vector<double> volume(components.number, 0.);
  std::vector<double> area(components.number, 0.);
  for (std::size_t f = 0; f < triangles.faces.size(); ++f) {
    const std::array<Index, 3>& face = triangles.faces[f];
    const Vector_3& a = triangles.points[face[0]];
    const Vector_3& b = triangles.points[face[1]];
    const Vector_3& c = triangles.points[face[2]];
    volume[components.component[f]] += a.dot(b.cross(c)) / 6;
    area[components.component[f]] += (b - a).cross(c - a).norm() / 2;
  }
  std::vector<char> is_reversed(components.number, 0);
  for (Index c = 0; c < components.number; ++c) {
    is_reversed[c] = volume[c] < -smallest_signed_volume * area[c] * std::sqrt(area[c]);
  }
  const auto number = std::count(is_reversed.begin(), is_reversed.end(), 1);
  if (number > 0) {
    for (std::size_t f = 0; f < triangles.faces.size(); ++f) {
      if (is_reversed[components.component[f]]) {
        std::swap(triangles.faces[f][1], triangles.faces[f][2]);
      }
    }
    pairing = Halfedge_pairing(triangles.faces, triangles.points.size());
  }
  return std::size_t(number);
}

} // namespace CSCD::internal

#endif // CSCD_TRAITS_ORIENT_OUTWARDS_H
