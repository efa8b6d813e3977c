// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles laid out in the plane by the lengths of their sides.

#ifndef CSCD_PUBLISHED_FLAT_TRIANGLE_H
#define CSCD_PUBLISHED_FLAT_TRIANGLE_H

#include <CSCD/Vector_3.h>

#include <algorithm>
#include <cmath>

namespace CSCD::internal {

/// A triangle given by the lengths of its sides, counterclockwise.
/// Where they break the triangle inequality, it is as if the apex lay on the line of the longest side.
struct Flat_triangle
{
  double base;  ///< from the given corner
  double next;  ///< the opposite side of that corner
  double right; ///< back to the corner

  /// Area by Heron's formula in the form of Kahan (Miscalculating area and angles of a needle-like triangle, 2014),
  /// which is exact up to rounding also where the triangle is a needle.
  double area() const
  {
    double a = base;
    double b = next;
    double c = right;
    if (a < b) {
      std::swap(a, b);
    }
    if (b < c) {
      std::swap(b, c);
    }
    if (a < b) {
      std::swap(a, b);
    }
    const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
    return product > 0 ? std::sqrt(product) / 4 : 0.;
  }

  /// The angle between `right` and `base`, in [0, pi].
  double angle() const { return std::atan2(4 * area(), base * base + right * right - next * next); }

  /// Where the foot of the height over `base` lies, from the corner on.
  double foot() const { return (base * base + (right - next) * (right + next)) / (2 * base); }
  /// The height over `base`.
  double height() const { return 2 * area() / base; }
};

/// The face of `halfedge`, seen from its origin.
/// \tparam Triangulation has halfedges in the layout of `Triangulated_surface` and their lengths
template <class Triangulation>
Flat_triangle flat_triangle(const Triangulation& triangulation, Index halfedge)
{
  return {triangulation.length(halfedge), triangulation.length(Triangulation::next(halfedge)),
          triangulation.length(Triangulation::previous(halfedge))};
}

/// The angle of the face of `halfedge` at its origin, by lengths alone.
template <class Triangulation>
double corner_angle(const Triangulation& triangulation, Index halfedge)
{
  return flat_triangle(triangulation, halfedge).angle();
}

/// By how much two sides of a triangle have to be longer, at least, than the third one, relative to the mean length of
/// edges (Sharp, Crane: A Laplacian for nonmanifold triangle meshes, 2020, section 4.5).
inline constexpr double min_slack = 1e-5;

/// The minimal length that, added to all edges of the first `number_of_faces` faces of `triangulation`, keeps their
/// triangles clear of the degenerate by `min_slack`; 0 for all but degenerate input. Linear.
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
  const double needed = number_of_faces == 0 ? 0. : min_slack * sum / (3. * double(number_of_faces));
  return std::max(0., needed - least);
}

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_FLAT_TRIANGLE_H
