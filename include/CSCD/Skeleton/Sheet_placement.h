// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nodes on sheets: in the middle of open curves.

#ifndef CSCD_SKELETON_SHEET_PLACEMENT_H
#define CSCD_SKELETON_SHEET_PLACEMENT_H

#include <CSCD/Separator/Plane_section.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
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
/// \param radius half of the width of the sheet there: what is farther away is another body
template <class Surface>
std::optional<Vector_3> middle_of_sheet(const Surface& surface, const Vector_3& point, double radius)
{
  constexpr double max_shift = 2; // relative to the radius
  const std::optional<Vector_3> middle = surface.middle_behind(point);
  return middle && (*middle - point).norm() <= max_shift * radius ? middle : std::nullopt;
}

/// `point`, if it is between the sides of a sheet, or else the middle between these behind the nearest point; nothing
/// where that is not found.
inline std::optional<Vector_3> point_in_sheet(const Triangulated_solid& solid, const Vector_3& point)
{
  return solid.is_inside(point) ? std::optional<Vector_3>(point) : solid.middle_behind(point);
}

/// Points of the rims of all sheets, as far from each other as their vertices. Linear.
inline std::vector<Vector_3> rim_points(const Triangulated_solid& solid)
{
  const Surface_level& level = solid.query_level();
  const Triangulated_surface& surface = level.surface;
  const auto side = [&](Index vertex) { return solid.side_of_sheet(level.to_finest(vertex)); };
  std::vector<Vector_3> result;
  for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
    if (side(surface.origin(h)) == 1 && side(surface.target(h)) == 2) {
      result.push_back((surface.point(surface.origin(h)) + surface.point(surface.target(h))) / 2);
    }
  }
  return result;
}

/// Places nodes on sheets: those of open separators in their middle, with half of the width as radius, all others
/// between the sides. Does nothing where there are no sheets.
class Sheet_placement
{
public:
  Sheet_placement(const Triangulated_solid& solid, Skeleton_builder& builder) : m_solid(solid), m_builder(builder) {}

  /// Moves `node`, of `separator`, if that is open.
  void place(Index node, const Separator& separator)
  {
    if (m_solid.number_of_sheets() == 0 ||
        m_solid.side_of_sheet(m_solid.triangulation().origin(separator.crossings.front().halfedge)) == 0) {
      return;
    }
    const auto side = [this](Index vertex) { return m_solid.side_of_sheet(vertex); };
    m_builder[node].is_on_sheet = true;
    if (const auto middle = middle_of_open_curve(m_solid.triangulation(), side, separator.crossings)) {
      m_builder[node].position = *middle;
      m_builder[node].radius = separator.length / 4;
    }
  }

  /// Marks all nodes beside nodes of sheets, too, and moves them to the middle between the sides.
  void finish()
  {
    if (m_solid.number_of_sheets() == 0) {
      return;
    }
    for (Index node = 0; node < m_builder.size(); ++node) {
      if (m_builder[node].is_removed || !is_on_sheet(node)) {
        continue;
      }
      m_builder[node].is_on_sheet = true;
      if (const auto middle = middle_of_sheet(m_solid, m_builder[node].position, m_builder[node].radius)) {
        m_builder[node].position = *middle;
      }
    }
  }

private:
  bool is_on_sheet(Index node) const
  {
    if (m_builder[node].is_on_sheet || m_builder[node].is_opening) {
      return m_builder[node].is_on_sheet;
    }
    const std::vector<Index>& neighbors = m_builder[node].neighbors;
    return std::any_of(neighbors.begin(), neighbors.end(),
                       [this](Index neighbor) { return m_builder[neighbor].is_on_sheet; });
  }

  const Triangulated_solid& m_solid;
  Skeleton_builder& m_builder;
};

/// Sections of sheets perpendicular to a branch. Reuse one object.
class Sheet_section
{
public:
  explicit Sheet_section(const Triangulated_solid& solid) : m_solid(solid), m_section(solid.query_surface()) {}

  /// The middle of the open curve in which the plane through `point` perpendicular to `axis` cuts the sheet, if it is
  /// about as wide as expected.
  std::optional<Vector_3> operator()(const Vector_3& point, const Vector_3& axis, double expected_half_width)
  {
    const double expected_length = 4 * expected_half_width; // on both sides
    const Index face = m_solid.closest_point(point).face;
    // Where edges are in the plane, as on grids, it may miss the face beside them.
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

/// Places the nodes of the open ones of the `packed` separators: node i is that of `packed[i]`; all other nodes of
/// sheets follow. Does nothing on surfaces that know no sheets.
template <class Surface>
void place_on_sheets(const Surface& /* surface */, const std::vector<Separator>& /* separators */,
                     const std::vector<Index>& /* packed */, Skeleton_builder& /* builder */)
{
}
inline void place_on_sheets(const Triangulated_solid& solid, const std::vector<Separator>& separators,
                            const std::vector<Index>& packed, Skeleton_builder& builder)
{
  Sheet_placement placement(solid, builder);
  for (Index i = 0; i < packed.size() && i < builder.size(); ++i) {
    placement.place(i, separators[packed[i]]);
  }
  placement.finish();
}

} // namespace CSCD::internal

#endif // CSCD_SKELETON_SHEET_PLACEMENT_H
