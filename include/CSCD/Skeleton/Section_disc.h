// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The disc that a section of the body spans.

#ifndef CSCD_SKELETON_SECTION_DISC_H
#define CSCD_SKELETON_SECTION_DISC_H

#include <CSCD/Separator/curve_measures.h>
#include <CSCD/internal/Vector_3.h>

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// Whether `point`, projected along `normal`, lies in the closed polygon `outline`: it is wound around.
inline bool is_in_outline(const std::vector<Vector_3>& outline, const Vector_3& point, const Vector_3& normal)
{
  const Vector_3 u = normal.unitOrthogonal();
  const Vector_3 v = normal.cross(u);
  bool is_inside = false;
  double ax = u.dot(outline.back() - point);
  double ay = v.dot(outline.back() - point);
  for (const Vector_3& corner : outline) {
    const double bx = u.dot(corner - point);
    const double by = v.dot(corner - point);
    if ((ay > 0) != (by > 0) && (ax * by - bx * ay > 0) == (by > ay)) {
      is_inside = !is_inside;
    }
    ax = bx;
    ay = by;
  }
  return is_inside;
}

/// Center and size of a section of the body.
struct Section_disc
{
  Vector_3 center = Vector_3::Zero();
  double area = 0;

  /// Radius of the circle of the same area.
  double radius() const { return std::sqrt(area / boost::math::double_constants::pi); }
};

/// The disc that the closed, nearly planar polygon `outline` spans: its area and the centroid of that area; where the
/// centroid is outside of the polygon, the mean of the outline by length.
inline Section_disc section_disc(const std::vector<Vector_3>& outline)
{
  const Polygon_measures measures = measure_polygon(outline);
  Section_disc result{measures.center, measures.vector_area.norm()};
  if (!(result.area > 0)) {
    return result;
  }
  const Vector_3 normal = measures.vector_area / result.area;
  Vector_3 moment = Vector_3::Zero();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector_3 a = outline[i] - measures.center;
    const Vector_3 b = outline[i + 1 < outline.size() ? i + 1 : 0] - measures.center;
    moment += a.cross(b).dot(normal) / 6 * (a + b);
  }
  const Vector_3 centroid = measures.center + moment / result.area;
  if (is_in_outline(outline, centroid, normal)) {
    result.center = centroid;
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_SKELETON_SECTION_DISC_H
