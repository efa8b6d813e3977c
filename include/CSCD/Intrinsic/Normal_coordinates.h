// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How often curves that end at vertices cross the sides of a triangle, and the diagonals of a quadrilateral.

#ifndef CSCD_INTRINSIC_NORMAL_COORDINATES_H
#define CSCD_INTRINSIC_NORMAL_COORDINATES_H

#include <algorithm>
#include <cstdint>

namespace CSCD::internal {

/// The normal coordinate of an edge: the number of input edges that cross it, or `along_input_edge`.
using Normal_coordinate = std::int32_t;

/// The normal coordinate of an edge that runs along an edge of the input.
inline constexpr Normal_coordinate along_input_edge = -1;

/// The number of curves that cross an edge.
inline Normal_coordinate crossings_of(Normal_coordinate coordinate)
{
  return std::max(coordinate, Normal_coordinate(0));
}

/// The curves that pass through a triangle, by the corner that they belong to; the corners are the origins of the
/// first, second and third side. Curves are disjoint but for their ends and never cross a side twice in turn, hence
/// those in a triangle either go round a corner, from one of its sides to the other, or emanate from one
/// (Gillespie, Sharp, Crane: Integer coordinates for intrinsic geometry processing, 2021, section 3).
struct Triangle_curves
{
  Normal_coordinate around[3];
  Normal_coordinate from[3];

  /// Sorts the curves that cross the sides of a triangle, whose normal coordinates are given counterclockwise.
  Triangle_curves(Normal_coordinate first, Normal_coordinate second, Normal_coordinate third)
  {
    const Normal_coordinate side[] = {crossings_of(first), crossings_of(second), crossings_of(third)};
    for (int k = 0; k < 3; ++k) {
      from[k] = emanating(side[k], side[(k + 1) % 3], side[(k + 2) % 3]);
    }
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3;
      const int m = (k + 2) % 3;
      around[k] = (side[k] + side[m] - side[l] + from[k] - from[l] - from[m]) / 2;
    }
  }

  /// The number of curves that emanate from the corner between the sides `before` and `after`.
  static Normal_coordinate emanating(Normal_coordinate before, Normal_coordinate opposite, Normal_coordinate after)
  {
    return crossings_of(crossings_of(opposite) - crossings_of(before) - crossings_of(after));
  }
};

/// The normal coordinate of the other diagonal kl of the quadrilateral of the triangles ijk and jil, from those of its
/// sides and of its diagonal ij.
inline Normal_coordinate flipped_coordinate(Normal_coordinate ij, Normal_coordinate jk, Normal_coordinate ki,
                                            Normal_coordinate il, Normal_coordinate lj)
{
  const Triangle_curves left(ij, jk, ki);  // corners i, j, k
  const Triangle_curves right(ij, il, lj); // corners j, i, l
  // Along ij come, from i on and on either side: curves around i, curves that end at the apex, curves around j.
  const Normal_coordinate left_end = left.around[0] + left.from[2];
  const Normal_coordinate right_end = right.around[1] + right.from[2];
  if (std::max(left.around[0], right.around[1]) < std::min(left_end, right_end)) {
    return along_input_edge; // one curve goes from apex to apex
  }
  // Curves from ki across ij to lj, and from il across ij to jk.
  const Normal_coordinate across = crossings_of(left.around[0] - right_end) + crossings_of(right.around[1] - left_end);
  const Normal_coordinate at_ends = left.from[0] + left.from[1] + right.from[0] + right.from[1];
  const Normal_coordinate diagonal = ij == along_input_edge ? 1 : 0;
  return left.around[2] + right.around[2] + across + at_ends + diagonal;
}

} // namespace CSCD::internal

#endif // CSCD_INTRINSIC_NORMAL_COORDINATES_H
