// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A triangle laid out in the plane by the lengths of its sides.

#ifndef CSCD_GEODESIC_FACE_LAYOUT_H
#define CSCD_GEODESIC_FACE_LAYOUT_H

#include <CSCD/Intrinsic/Flat_triangle.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CSCD::internal {

/// A triangle in the plane, counterclockwise: corner 0 at the origin, corner 1 at (`base`, 0), corner 2 at (`apex_x`,
/// `apex_y`). This is the frame in which vectors in a face are given, so that a face needs no points in space.
struct Face_layout
{
  double base = 0;   ///< positive
  double apex_x = 0; ///< of any sign
  double apex_y = 0; ///< positive

  double area() const { return base * apex_y / 2; }

  /// For each corner, the entry of the face's stiffness matrix for the two other corners: minus half the cotangent of
  /// the angle at the corner.
  std::array<double, 3> couplings() const
  {
    const double scale = -1 / (2 * base * apex_y);
    return {scale * base * apex_x, scale * base * (base - apex_x),
            scale * (apex_y * apex_y - apex_x * (base - apex_x))};
  }

  /// The position of the point with these barycentric coordinates.
  std::array<double, 2> point(const std::array<double, 3>& coordinates) const
  {
    return {coordinates[1] * base + coordinates[2] * apex_x, coordinates[2] * apex_y};
  }

  std::array<double, 2> corner(std::size_t i) const
  {
    return i == 0 ? std::array<double, 2>{0, 0}
                  : (i == 1 ? std::array<double, 2>{base, 0} : std::array<double, 2>{apex_x, apex_y});
  }
};

/// In every laid out triangle, two sides together are longer than the third by at least this, relative to the longest:
/// as in geometry-central's mollification. Heights are then at least a thousandth of the longest side, and cotangents
/// at most some hundreds.
inline constexpr double least_excess_length = 1e-5;

/// Lays out the triangle whose sides from corner 0 to 1, 1 to 2 and 2 to 0 have these lengths.
/// A triangle that is degenerate, or that does not exist, is laid out with all sides lengthened by as little as makes
/// it one. This changes no other face: the matrices of the method are sums over faces, each positive semidefinite.
/// \param unit a typical length of the surface, positive: a triangle that is a single point becomes a tiny one
inline Face_layout lay_out_face(std::array<double, 3> lengths, double unit)
{
  // Extent, relative to the unit, below which a triangle counts as a point.
  constexpr double least_extent = 1e-6;
  const double longest = *std::max_element(lengths.begin(), lengths.end());
  const double excess = lengths[0] + lengths[1] + lengths[2] - 2 * longest;
  const double missing = least_excess_length * std::max(longest, least_extent * unit) - excess;
  for (double& length : lengths) {
    length += std::max(missing, 0.);
  }
  const Flat_triangle triangle{lengths[0], lengths[1], lengths[2]};
  return {triangle.base, triangle.foot(), triangle.height()};
}

} // namespace CSCD::internal

#endif // CSCD_GEODESIC_FACE_LAYOUT_H
