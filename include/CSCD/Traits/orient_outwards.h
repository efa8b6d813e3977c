// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Turns components inside out whose faces look inwards.

#ifndef CSCD_TRAITS_ORIENT_OUTWARDS_H
#define CSCD_TRAITS_ORIENT_OUTWARDS_H

#include <CSCD/Traits/Halfedge_pairing.h>
#include <CSCD/Traits/Indexed_triangles.h>
#include <CSCD/Traits/Surface_components.h>
#include <CSCD/internal/Vector_3.h>

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
/// \pre `pairing` and `components` are those of `triangles`, and are kept so
inline std::size_t orient_outwards(Indexed_triangles& triangles, Halfedge_pairing& pairing,
                                   Surface_components& components)
{
  std::size_t number_of_reversed = 0;
  std::vector<char> is_reversed(components.number(), 0);
  for (Index c = 0; c < components.number(); ++c) {
    Surface_components::Measure& measure = components.measures[c];
    if (measure.volume < -smallest_signed_volume * measure.area * std::sqrt(measure.area)) {
      measure.volume = -measure.volume;
      is_reversed[c] = 1;
      ++number_of_reversed;
    }
  }
  if (number_of_reversed > 0) {
    for (std::size_t f = 0; f < triangles.faces.size(); ++f) {
      if (is_reversed[components.component[f]]) {
        std::swap(triangles.faces[f][1], triangles.faces[f][2]);
      }
    }
    pairing = Halfedge_pairing(triangles.faces, triangles.points.size());
  }
  return number_of_reversed;
}

} // namespace CSCD::internal

#endif // CSCD_TRAITS_ORIENT_OUTWARDS_H
