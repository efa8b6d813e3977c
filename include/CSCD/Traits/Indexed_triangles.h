// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A surface as points and index triples, the form in which the input is checked and completed before it is compiled.

#ifndef CSCD_TRAITS_INDEXED_TRIANGLES_H
#define CSCD_TRAITS_INDEXED_TRIANGLES_H

#include <CSCD/internal/Vector_3.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// Points and triangles, counterclockwise seen from outside.
struct Indexed_triangles
{
  std::vector<Vector_3> points;
  std::vector<std::array<Index, 3>> faces;
  /// The faces from this one on only bridge borders: they close the surface but carry no area.
  std::size_t first_bridging_face = 0;
};

} // namespace CSCD::internal

#endif // CSCD_TRAITS_INDEXED_TRIANGLES_H
