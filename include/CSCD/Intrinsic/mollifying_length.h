// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much longer edges have to be for no triangle to be degenerate.

#ifndef CSCD_INTRINSIC_MOLLIFYING_LENGTH_H
#define CSCD_INTRINSIC_MOLLIFYING_LENGTH_H

#include <CSCD/Intrinsic/Flat_triangle.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>

namespace CSCD::internal {

/// By how much two sides of a triangle shall at least be longer than the third one, relative to the mean length of
/// edges (Sharp, Crane: A Laplacian for nonmanifold triangle meshes, 2020, section 4.5).
inline constexpr double least_slack = 1e-5;

/// The least length that, added to all edges of the first `number_of_faces` faces of `triangulation`, keeps their
/// triangles clear of the degenerate by `least_slack`; 0 for all but degenerate input. Linear.
template <class Triangulation>
double mollifying_length(const Triangulation& triangulation, Index number_of_faces)
{
  double sum = 0;
  double least = 0; // of how much two sides are longer than the third one
  for (Index h = 0; h < 3 * number_of_faces; ++h) {
    const Flat_triangle triangle = flat_triangle(triangulation, h);
    const double slack = triangle.next + triangle.right - triangle.base;
    sum += triangle.base;
    least = h == 0 ? slack : std::min(least, slack);
  }
  const double needed = number_of_faces == 0 ? 0. : least_slack * sum / (3. * double(number_of_faces));
  return std::max(0., needed - least);
}

} // namespace CSCD::internal

#endif // CSCD_INTRINSIC_MOLLIFYING_LENGTH_H
