// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two triangles with a common side, unfolded into the plane, and the other diagonal of the quadrilateral.

#ifndef CSCD_INTRINSIC_FLAT_DIAMOND_H
#define CSCD_INTRINSIC_FLAT_DIAMOND_H

#include <CSCD/Intrinsic/Flat_triangle.h>
#include <CSCD/internal/Vector_3.h>

#include <cmath>

namespace CSCD::internal {

/// Two triangles on both sides of a common base.
class Flat_diamond
{
public:
  /// Unfolds `left`, and `right`, whose base is that of `left` in the other direction.
  Flat_diamond(const Flat_triangle& left, const Flat_triangle& right)
      : m_base(left.base), m_left_foot(left.foot()), m_left_height(left.height()),
        m_right_foot(left.base - right.foot()), m_right_height(right.height())
  {
  }

  /// Whether the other diagonal runs strictly inside, leaving on either side at least the part `margin` of the area.
  bool is_convex(double margin) const
  {
    const double height = m_left_height + m_right_height;
    if (!(height > 0)) {
      return false;
    }
    const double crossing = (m_left_foot * m_right_height + m_right_foot * m_left_height) / height;
    return crossing > margin * m_base && crossing < (1 - margin) * m_base;
  }

  /// The length of the other diagonal, if the diamond is convex.
  double other_diagonal() const
  {
    const double along = m_left_foot - m_right_foot;
    const double across = m_left_height + m_right_height;
    return std::sqrt(along * along + across * across);
  }

private:
  double m_base;
  double m_left_foot;
  double m_left_height;
  double m_right_foot;
  double m_right_height;
};

/// The two faces of the edge of `halfedge`, which must have two.
template <class Triangulation>
Flat_diamond flat_diamond(const Triangulation& triangulation, Index halfedge)
{
  return {flat_triangle(triangulation, halfedge), flat_triangle(triangulation, triangulation.twin(halfedge))};
}

} // namespace CSCD::internal

#endif // CSCD_INTRINSIC_FLAT_DIAMOND_H
