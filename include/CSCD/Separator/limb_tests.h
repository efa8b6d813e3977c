// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether a closed curve surrounds a limb, a bump or a hollow, and how small a limb may be.

#ifndef CSCD_SEPARATOR_LIMB_TESTS_H
#define CSCD_SEPARATOR_LIMB_TESTS_H

#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/flat_arrays.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CSCD {

/// The detail of a skeleton: a number from 0 to 1 without unit, which sets the length, relative to its radius, that a
/// limb needs to get a branch. At 0 no limb is long enough, at 1 every bump is. Handles do not depend on it.
class Detail
{
public:
  /// Draws blunt limbs, such as muzzles and heads on a short neck.
  static constexpr double default_value = 0.5;

  /// \param value from 0 to 1 \throw Input_error if it is not
  explicit Detail(double value = default_value) : m_value(value)
  {
    if (!(value >= 0 && value <= 1)) {
      throw Input_error("the detail is " + std::to_string(value) + ", and should be from 0 to 1");
    }
  }

  /// The number.
  double value() const { return m_value; }

  /// The length that a limb with a flat end needs, relative to its radius: it falls from infinity at detail 0 to 0
  /// at 1.
  double min_limb_length() const { return default_limb_length * (1 - m_value) / m_value; }

  /// The area that some separator of a branch has to cut off, relative to the squared length of the separator. The limb
  /// above has the side `2 pi r l` and the end `pi r^2`, and the separator around it is `2 pi r` long.
  double min_branch_area_ratio() const { return (1 + 2 * min_limb_length()) / (4 * boost::math::double_constants::pi); }

  /// The same of a loop that has not been shortened yet. \see max_loop_area_ratio
  double min_loop_area_ratio() const { return std::min(loop_share * min_branch_area_ratio(), max_loop_area_ratio); }

  /// Between a flat disc, 1 / (4 pi), and a hemisphere, 1 / (2 pi). Loops that cut off more are not treated as bumps
  /// even at the lowest detail: else many good loops near tips would go.
  static constexpr double max_loop_area_ratio = 0.11;

private:
  /// The area ratio of a branch is 0.10 with it: of 0.06 to 0.15, errors on meshes of animals were least from there
  /// down, and lower ones only added branches.
  static constexpr double default_limb_length = 0.13;
  /// A loop that is not shortened yet is longer than the separator that it becomes: 0.09 was measured with 0.10.
  static constexpr double loop_share = 0.9;

  double m_value;
};

} // namespace CSCD

namespace CSCD::internal {

/// The area that an open separator has to cut off, on both sides of its sheet, relative to a closed one: by default,
/// 0.19 of its squared length. A corner at a right angle has 1 / 8, and is not a limb; a half disc has pi / 16.
inline constexpr double open_area_factor = 1.9;

/// Measures how much surface a loop cuts off, relative to the square of its length.
/// A flat disc gives 1 / (4 pi) = 0.080, a hemisphere 1 / (2 pi) = 0.159, the end of a limb of length l and radius R
/// about (l / R + 1) / (2 pi). Work is bounded by the limit on the area, not by the surface. Reuse one object.
class Enclosed_area_test
{
public:
  explicit Enclosed_area_test(const Triangulated_surface& surface)
      : m_surface(surface), m_edges(surface.number_of_halfedges()), m_faces(surface.number_of_faces())
  {
  }

  /// The area on the smaller side of `loop` over the square of its length, or something above `limit` if it is larger;
  /// 0 if the loop has no length, or an edge that the surface has not.
  double area_ratio(const Vertex_loop& loop, double limit)
  {
    m_edges.clear();
    m_sides.clear();
    double length = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index h = m_surface.find_halfedge(loop[i], loop[i + 1 < loop.size() ? i + 1 : 0]);
      if (h == no_index) {
        return 0;
      }
      m_edges.mark(m_surface.edge(h));
      m_sides.push_back(h);
      length += m_surface.length(h);
    }
    if (length == 0) {
      return 0;
    }
    const double left = flood([this](std::size_t i) { return m_sides[i]; }, limit * length * length);
    const double right = flood([this](std::size_t i) { return m_surface.twin(m_sides[i]); }, limit * length * length);
    return std::min(left, right) / (length * length);
  }

private:
  /// The area of the faces that can be reached from the faces of the halfedges `side(i)` without crossing the loop;
  /// stops above `limit`.
  template <class Side>
  double flood(const Side& side, double limit)
  {
    m_faces.clear();
    m_stack.clear();
    double area = 0;
    const auto visit = [&](Index face) {
      if (m_faces.mark(face)) {
        area += double(m_surface.face_area(face));
        m_stack.push_back(face);
      }
    };
    for (std::size_t i = 0; i < m_sides.size(); ++i) {
      visit(Triangulated_surface::face(side(i)));
    }
    while (!m_stack.empty() && area < limit) {
      const Index face = m_stack.back();
      m_stack.pop_back();
      for (Index h = 3 * face; h < 3 * face + 3; ++h) {
        if (!m_edges.is_marked(m_surface.edge(h))) {
          visit(Triangulated_surface::face(m_surface.twin(h)));
        }
      }
    }
    return area;
  }

  const Triangulated_surface& m_surface;
  Epoch_marks m_edges;
  Epoch_marks m_faces;
  std::vector<Index> m_sides;
  std::vector<Index> m_stack;
};

/// The share of the cone from the center of a closed polygon to its points that lies inside the body: nearly 1 for a
/// curve around a limb, nearly 0 for one around a hole, which bounds no disc in the body (section 3.2.2). Sampled.
/// \tparam Body has `is_inside(point)`
template <class Body>
double span_inside_share(const Body& body, const std::vector<Vector3>& points, const Vector3& center)
{
  constexpr std::size_t max_directions = 8;
  constexpr double parts[] = {0.25, 0.5, 0.75}; // of the way from the center to the curve
  const std::size_t directions = std::min(points.size(), max_directions);
  std::size_t inside = body.is_inside(center) ? 1 : 0;
  std::size_t samples = 1;
  for (std::size_t i = 0; i < directions; ++i) {
    const Vector3& point = points[i * points.size() / directions];
    for (double part : parts) {
      inside += body.is_inside(center + part * (point - center)) ? 1 : 0;
      ++samples;
    }
  }
  return double(inside) / double(samples);
}

/// Whether `separator` leads around something hollow, such as the wall of a cup: it is as round as the section of a
/// limb, but its center, and most of the cone from there, lie outside of the body.
/// \param min_roundness isoperimetric quotient; from 0.65 to 0.85, few cups and vases change
inline bool is_around_hollow(const Triangulated_solid& solid, const Separator& separator, double min_roundness = 0.75)
{
  constexpr double max_inside_share = 0.35; // in walls of cups up to 0.32, in hollow ears 0.4
  const Solid_queries& body = solid.queries(solid.component(separator.source));
  if (separator.is_open || separator.roundness() < min_roundness || body.is_inside(separator.center)) {
    return false;
  }
  std::vector<Vector3> points;
  curve_points(solid.triangulation(), separator, points);
  return span_inside_share(body, points, separator.center) < max_inside_share;
}

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_LIMB_TESTS_H
