// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sections of sheets: open curves, and their middles.

#ifndef CSCD_SKELETON_SHEET_SECTION_H
#define CSCD_SKELETON_SHEET_SECTION_H

#include <CSCD/Separator/Plane_section.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CSCD::internal {

/// A part of a curve, by the positions of its first and last point.
struct Curve_part
{
  std::size_t first = 0;
  std::size_t last = 0;
  double length = 0;
};

/// The longest part of the closed curve `points` on side `side` of a sheet, where `sides` has the sides of each crossed
/// edge. \pre some edge is not on that side
inline std::optional<Curve_part> longest_part(const std::vector<Vector_3>& points, const std::vector<unsigned>& sides,
                                              unsigned side)
{
  const std::size_t n = points.size();
  std::size_t start = 0;
  while (sides[start] == side) {
    ++start;
  }
  std::optional<Curve_part> longest;
  std::optional<Curve_part> part;
  for (std::size_t i = start; i < start + n; ++i) {
    if (sides[i % n] != side) {
      part.reset();
    } else if (!part) {
      part = Curve_part{i, i, 0};
    } else {
      part->length += (points[i % n] - points[part->last % n]).norm();
      part->last = i;
    }
    if (part && (!longest || part->length >= longest->length)) {
      longest = part;
    }
  }
  return longest;
}

/// The point halfway along `part` of the closed curve `points`.
inline Vector_3 middle_of_part(const std::vector<Vector_3>& points, const Curve_part& part)
{
  const std::size_t n = points.size();
  double left = part.length / 2;
  for (std::size_t i = part.first; i < part.last; ++i) {
    const Vector_3& a = points[i % n];
    const Vector_3& b = points[(i + 1) % n];
    const double length = (b - a).norm();
    if (length > 0 && left <= length) {
      return a + left / length * (b - a);
    }
    left -= length;
  }
  return points[part.last % n];
}

/// The middle of the open curve that the closed one of `crossings` follows on both sides of a sheet; nothing where it
/// stays on one. Linear. \param side_of_sheet as for `sides_of_sheet()`
template <class Sides>
std::optional<Vector_3> middle_of_open_curve(const Triangulated_surface& surface, const Sides& side_of_sheet,
                                             const std::vector<Edge_crossing>& crossings)
{
  if (sides_of_sheet(surface, side_of_sheet, crossings) != 3) {
    return std::nullopt;
  }
  std::vector<Vector_3> points;
  crossing_points(surface, crossings, points);
  std::vector<unsigned> sides;
  sides.reserve(crossings.size());
  for (const Edge_crossing& crossing : crossings) {
    sides.push_back(sides_of_sheet(surface, side_of_sheet, {crossing}));
  }
  const std::optional<Curve_part> first = longest_part(points, sides, 1);
  const std::optional<Curve_part> second = longest_part(points, sides, 2);
  if (!first || !second) {
    return std::nullopt;
  }
  return Vector_3((middle_of_part(points, *first) + middle_of_part(points, *second)) / 2);
}

/// The middle between the sides of a sheet behind the surface that is nearest to `point`.
/// \param radius half of the width of the sheet there: a middle farther away is that of another body
template <class Surface>
std::optional<Vector_3> middle_of_sheet(const Surface& surface, const Vector_3& point, double radius)
{
  constexpr double max_shift = 2; // relative to the radius
  const std::optional<Vector_3> middle = surface.middle_behind(point);
  return middle && (*middle - point).norm() <= max_shift * radius ? middle : std::nullopt;
}

/// Sections of sheets perpendicular to a branch. Reuse one object.
class Sheet_section
{
public:
  explicit Sheet_section(const Triangulated_solid& solid) : m_solid(solid), m_section(solid.query_surface()) {}

  /// The middle of the open section of the sheet with the plane through `point` perpendicular to `axis`, if it is
  /// about as wide as expected.
  std::optional<Vector_3> operator()(const Vector_3& point, const Vector_3& axis, double expected_half_width)
  {
    const double expected_length = 4 * expected_half_width; // on both sides
    const Index face = m_solid.closest_point(point).face;
    // Where edges are in the plane, as on grids, it may miss the face next to them.
    const bool is_cut = m_section.cut_at_face(face, axis, point, max_length * expected_length) ||
                        m_section.cut_at_vertex(nearest_corner(face, point, axis), axis, max_length * expected_length);
    if (!is_cut || m_section.length() < min_length * expected_length) {
      return std::nullopt;
    }
    const Surface_level& level = m_solid.query_level();
    const auto side = [this, &level](Index vertex) { return m_solid.side_of_sheet(level.to_finest(vertex)); };
    return middle_of_open_curve(level.surface, side, m_section.crossings());
  }

  /// Half of the width of the sheet along the last section.
  double half_width() const { return m_section.length() / 4; }

private:
  /// Bounds for the length of an accepted section, relative to the expected one: as for radii in `Branch_section`.
  static constexpr double min_length = 0.6;
  static constexpr double max_length = 1.5;

  /// The corner of `face` that is nearest to the plane through `point` perpendicular to `axis`.
  Index nearest_corner(Index face, const Vector_3& point, const Vector_3& axis) const
  {
    const Triangulated_surface& surface = m_solid.query_surface();
    const auto distance = [&](Index h) { return std::fabs(axis.dot(surface.point(surface.origin(h)) - point)); };
    const auto sides = Triangulated_surface::face_halfedges(face);
    return surface.origin(
        *std::min_element(sides.begin(), sides.end(), [&](Index a, Index b) { return distance(a) < distance(b); }));
  }

  const Triangulated_solid& m_solid;
  Plane_section m_section;
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_SHEET_SECTION_H
