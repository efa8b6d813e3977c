// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The closed curve where a plane cuts the surface, and the disc that it spans.

#ifndef CSCD_SEPARATOR_PLANE_SECTION_H
#define CSCD_SEPARATOR_PLANE_SECTION_H

#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/principal_axes.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// Walks the section of a surface with a plane. Every vertex is on one of the two sides, vertices in the plane on the
/// upper one: so the walk is decided by the sides of vertices alone, passes no vertex, and closes for every plane. Its
/// cost is that of the section. Reuse one object.
class Plane_section
{
public:
  explicit Plane_section(const Triangulated_surface& surface) : m_surface(surface) {}

  /// Walks the section with the plane through `vertex` normal to `axis` along the cycle that passes just below
  /// `vertex`.
  /// \return false if the vertex is a local minimum along `axis`, or if the section is longer than `max_length`
  bool cut_at_vertex(Index vertex, const Vector3& axis, double max_length)
  {
    set_plane(axis, axis.dot(m_surface.point(vertex)));
    for (Index h : m_surface.outgoing(vertex)) {
      if (!is_above(m_surface.target(h))) {
        return walk(h, max_length);
      }
    }
    return false;
  }

  /// Walks the section with the plane through `point` normal to `axis` along the cycle that passes through `face`.
  /// \return false if the plane misses the face, or if the section is longer than `max_length`
  bool cut_at_face(Index face, const Vector3& axis, const Vector3& point, double max_length)
  {
    set_plane(axis, axis.dot(point));
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      if (is_above(m_surface.origin(h)) && !is_above(m_surface.target(h))) {
        return walk(h, max_length);
      }
    }
    return false;
  }

  const std::vector<Edge_crossing>& crossings() const { return m_crossings; }
  const std::vector<Vector3>& points() const { return m_points; }
  double length() const { return m_length; }

  /// The direction that is most nearly perpendicular to the normals of the crossed faces, up to sign: the axis of the
  /// limb around the section (the rotational symmetry axis of Tagliasacchi et al. 2009, with centered normals).
  Vector3 symmetry_axis() const
  {
    Moment_matrix moment;
    Vector3 mean = Vector3::Zero();
    double weight = 0;
    for (std::size_t i = 0; i < m_crossings.size(); ++i) {
      const Vector3& before = m_points[i > 0 ? i - 1 : m_points.size() - 1];
      const double length = (m_points[i] - before).norm();
      const Vector3 normal = m_surface.face_normal(Triangulated_surface::face(m_crossings[i].halfedge));
      moment += Moment_matrix::product(length * normal, normal);
      mean += length * normal;
      weight += length;
    }
    return principal_axes(moment / weight - Moment_matrix::product(mean, mean) / (weight * weight)).vectors[0];
  }

private:
  /// Crossings keep this distance from the ends of their edge, relative to its length.
  static constexpr double end_margin = 1e-3;
  /// Vertices at most this far below the plane are in it: rounding does not decide the side. Relative to the square
  /// root of the area of the surface.
  static constexpr double max_depth = 1e-12;

  void set_plane(const Vector3& axis, double offset)
  {
    m_axis = axis;
    m_offset = offset;
  }

  /// An end of a crossed edge.
  struct Edge_end
  {
    Vector3 point;
    double height; ///< above the plane
  };

  Edge_end end_at(Index vertex) const
  {
    const Vector3& point = m_surface.point(vertex);
    return {point, m_axis.dot(point) - m_offset};
  }
  static bool is_above(const Edge_end& end) { return end.height >= -max_depth; }
  bool is_above(Index vertex) const { return is_above(end_at(vertex)); }

  /// Follows the section from halfedge `first`, whose origin is above the plane and whose target is below.
  bool walk(Index first, double max_length)
  {
    m_crossings.clear();
    m_points.clear();
    m_length = 0;
    Index h = first;
    Edge_end above = end_at(m_surface.origin(h));
    Edge_end below = end_at(m_surface.target(h));
    do {
      append(h, above, below);
      if (m_length > max_length) {
        return false;
      }
      const Index entry = m_surface.twin(h);
      const Edge_end apex = end_at(m_surface.opposite_vertex(entry));
      // Leave the face by the other side that runs from above to below.
      if (is_above(apex)) {
        h = Triangulated_surface::previous(entry);
        above = apex;
      } else {
        h = Triangulated_surface::next(entry);
        below = apex;
      }
    } while (h != first);
    m_length += (m_points.front() - m_points.back()).norm();
    return m_crossings.size() >= 3;
  }

  void append(Index h, const Edge_end& above, const Edge_end& below)
  {
    const double position = std::clamp(above.height / (above.height - below.height), end_margin, 1 - end_margin);
    m_crossings.push_back({h, position});
    m_points.push_back((1 - position) * above.point + position * below.point);
    if (m_points.size() > 1) {
      m_length += (m_points.back() - m_points[m_points.size() - 2]).norm();
    }
  }

  const Triangulated_surface& m_surface;
  Vector3 m_axis = Vector3::UnitZ();
  double m_offset = 0;
  std::vector<Edge_crossing> m_crossings;
  std::vector<Vector3> m_points;
  double m_length = 0;
};

/// Whether `point`, projected along `normal`, lies in the closed polygon `outline`: it is wound around.
inline bool is_in_outline(const std::vector<Vector3>& outline, const Vector3& point, const Vector3& normal)
{
  const Vector3 u = normal.unitOrthogonal();
  const Vector3 v = normal.cross(u);
  bool is_inside = false;
  double ax = u.dot(outline.back() - point);
  double ay = v.dot(outline.back() - point);
  for (const Vector3& corner : outline) {
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
  Vector3 center = Vector3::Zero();
  double area = 0;

  /// Radius of the circle of the same area.
  double radius() const { return std::sqrt(area / boost::math::double_constants::pi); }
};

/// The disc that the closed, nearly planar polygon `outline` spans: its area and the centroid of that area; where the
/// centroid is outside of the polygon, the mean of the outline by length.
inline Section_disc section_disc(const std::vector<Vector3>& outline)
{
  const Polygon_measures measures = measure_polygon(outline);
  Section_disc result{measures.center, measures.vector_area.norm()};
  if (!(result.area > 0)) {
    return result;
  }
  const Vector3 normal = measures.vector_area / result.area;
  Vector3 moment = Vector3::Zero();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector3 a = outline[i] - measures.center;
    const Vector3 b = outline[i + 1 < outline.size() ? i + 1 : 0] - measures.center;
    moment += a.cross(b).dot(normal) / 6 * (a + b);
  }
  const Vector3 centroid = measures.center + moment / result.area;
  if (is_in_outline(outline, centroid, normal)) {
    result.center = centroid;
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_PLANE_SECTION_H
