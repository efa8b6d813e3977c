// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shapes swept by a circle along a curve: tubes, capsules, tori, knots, chains. Their centreline is known exactly.

#ifndef CSCD_TEST_SUPPORT_SWEPT_SHAPES_H
#define CSCD_TEST_SUPPORT_SWEPT_SHAPES_H

#include "Shape.h"
#include "shape_operations.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CSCD::test {

inline constexpr double pi = 3.14159265358979323846;

/// The closing of the ends of a tube.
enum class Tube_end
{
  open,  ///< a border
  flat,  ///< a fan of triangles around a center
  round, ///< a hemisphere
  joined ///< last ring joined to the first: a closed curve
};

namespace internal {

/// A curve with a frame at each of its points; all in one plane across the tangent.
struct Framed_curve
{
  std::vector<Triple> points;
  std::vector<Triple> tangents;
  std::vector<Triple> normals;
};

inline Triple any_normal(const Triple& tangent)
{
  const Triple axis = std::fabs(tangent[0]) < 0.9 ? Triple{1, 0, 0} : Triple{0, 1, 0};
  return unit(cross(tangent, axis));
}

/// The angle of the rotation around `axis` from `from` to `to`; all three are unit vectors.
inline double angle_around(const Triple& axis, const Triple& from, const Triple& to)
{
  return std::atan2(dot(cross(from, to), axis), dot(from, to));
}

inline Triple turned_around(const Triple& axis, double angle, const Triple& v)
{
  return std::cos(angle) * v + std::sin(angle) * cross(axis, v);
}

/// Carries a normal along `points` with minimal twist; on a closed curve the rest is spread evenly.
inline Framed_curve framed(const std::vector<Triple>& points, bool is_closed)
{
  Framed_curve curve{points, {}, {}};
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Triple& next = i + 1 < n ? points[i + 1] : (is_closed ? points[0] : points[i]);
    const Triple& previous = i > 0 ? points[i - 1] : (is_closed ? points[n - 1] : points[i]);
    curve.tangents.push_back(unit(next - previous));
  }
  const auto carried = [](const Triple& normal, const Triple& tangent) {
    return unit(normal - dot(normal, tangent) * tangent);
  };
  curve.normals.push_back(any_normal(curve.tangents[0]));
  for (std::size_t i = 1; i < n; ++i) {
    curve.normals.push_back(carried(curve.normals[i - 1], curve.tangents[i]));
  }
  if (is_closed) {
    const Triple returned = carried(curve.normals[n - 1], curve.tangents[0]);
    const double twist = angle_around(curve.tangents[0], returned, curve.normals[0]);
    for (std::size_t i = 1; i < n; ++i) {
      const double angle = twist * static_cast<double>(i) / static_cast<double>(n);
      curve.normals[i] = turned_around(curve.tangents[i], angle, curve.normals[i]);
    }
  }
  return curve;
}

inline void add_ring(Shape& shape, const Triple& center, const Triple& u, const Triple& v, double radius,
                     std::size_t around)
{
  for (std::size_t k = 0; k < around; ++k) {
    const double angle = 2 * pi * static_cast<double>(k) / static_cast<double>(around);
    shape.points.push_back(center + (radius * std::cos(angle)) * u + (radius * std::sin(angle)) * v);
  }
}

/// Joins the rings of `around` vertices that begin at `first` and `second`, the second being further along.
inline void join_rings(Shape& shape, std::size_t first, std::size_t second, std::size_t around)
{
  for (std::size_t k = 0; k < around; ++k) {
    const std::size_t l = (k + 1) % around;
    shape.triangles.push_back({first + k, first + l, second + l});
    shape.triangles.push_back({first + k, second + l, second + k});
  }
}

/// Closes the ring that begins at `ring` by a fan around `apex`; `sign` is the side of the ring that it lies on.
inline void add_fan(Shape& shape, std::size_t ring, const Triple& apex, bool is_front, std::size_t around)
{
  const std::size_t a = shape.points.size();
  shape.points.push_back(apex);
  for (std::size_t k = 0; k < around; ++k) {
    const std::size_t l = (k + 1) % around;
    if (is_front) {
      shape.triangles.push_back({ring + k, ring + l, a});
    } else {
      shape.triangles.push_back({ring + l, ring + k, a});
    }
  }
}

/// Adds a hemisphere to the ring at `ring`, outwards along the frame's tangent (`is_front`) or against it.
inline void add_hemisphere(Shape& shape, std::size_t ring, const Framed_curve& curve, std::size_t i, double radius,
                           bool is_front, std::size_t around)
{
  const std::size_t levels = std::max<std::size_t>(2, around / 4);
  const Triple out = is_front ? curve.tangents[i] : -1.0 * curve.tangents[i];
  const Triple& u = curve.normals[i];
  const Triple v = cross(curve.tangents[i], u);
  for (std::size_t level = 1; level < levels; ++level) {
    const double elevation = pi / 2 * static_cast<double>(level) / static_cast<double>(levels);
    const std::size_t next = shape.points.size();
    add_ring(shape, curve.points[i] + (radius * std::sin(elevation)) * out, u, v, radius * std::cos(elevation), around);
    if (is_front) {
      join_rings(shape, ring, next, around);
    } else {
      join_rings(shape, next, ring, around);
    }
    ring = next;
  }
  add_fan(shape, ring, curve.points[i] + radius * out, is_front, around);
}

} // namespace internal

/// The surface swept along the curve through `points`, `radii[i]` wide at `points[i]`, with `around` vertices a ring.
inline Shape swept_shape(const std::string& name, const std::vector<Triple>& points, const std::vector<double>& radii,
                         std::size_t around, Tube_end end)
{
  const bool is_joined = end == Tube_end::joined;
  const internal::Framed_curve curve = internal::framed(points, is_joined);
  const std::size_t n = points.size();
  Shape shape;
  shape.name = name;
  for (std::size_t i = 0; i < n; ++i) {
    const Triple v = cross(curve.tangents[i], curve.normals[i]);
    internal::add_ring(shape, points[i], curve.normals[i], v, radii[i], around);
  }
  for (std::size_t i = 0; i + 1 < n; ++i) {
    internal::join_rings(shape, i * around, (i + 1) * around, around);
    shape.centreline.push_back({points[i], points[i + 1], radii[i], radii[i + 1]});
  }
  const std::size_t last = (n - 1) * around;
  if (end == Tube_end::flat) {
    internal::add_fan(shape, 0, points[0], false, around);
    internal::add_fan(shape, last, points[n - 1], true, around);
  } else if (end == Tube_end::round) {
    internal::add_hemisphere(shape, 0, curve, 0, radii[0], false, around);
    internal::add_hemisphere(shape, last, curve, n - 1, radii[n - 1], true, around);
  } else if (is_joined) {
    internal::join_rings(shape, last, 0, around);
    shape.centreline.push_back({points[n - 1], points[0], radii[n - 1], radii[0]});
  }
  shape.genus = is_joined ? 1 : 0;
  shape.number_of_border_cycles = end == Tube_end::open ? 2 : 0;
  shape.number_of_tips = is_joined ? 0 : 2;
  shape.number_of_junctions = 0;
  return shape;
}

/// `n` points on the segment from `a` to `b`, both included.
inline std::vector<Triple> sampled_segment(const Triple& a, const Triple& b, std::size_t n)
{
  std::vector<Triple> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(n - 1);
    points.push_back((1 - t) * a + t * b);
  }
  return points;
}

/// `n` points of `curve(t)`, t from 0 (included) to 2 pi (not included).
template <class Curve>
std::vector<Triple> sampled_closed_curve(const Curve& curve, std::size_t n)
{
  std::vector<Triple> points;
  for (std::size_t i = 0; i < n; ++i) {
    points.push_back(curve(2 * pi * static_cast<double>(i) / static_cast<double>(n)));
  }
  return points;
}

/// The number of rings that makes the triangles of a tube of this length and radius about as long as wide.
inline std::size_t rings_for(double length, double radius, std::size_t around)
{
  return 2 + static_cast<std::size_t>(length * static_cast<double>(around) / (2 * pi * radius));
}

/// A straight tube along the x axis from the origin.
inline Shape tube(double length, double radius, std::size_t around, Tube_end end)
{
  const std::size_t n = rings_for(length, radius, around);
  return swept_shape(end == Tube_end::open ? "open tube" : "tube", sampled_segment({0, 0, 0}, {length, 0, 0}, n),
                     std::vector<double>(n, radius), around, end);
}

/// A straight tube with hemispheres at its ends.
inline Shape capsule(double length, double radius, std::size_t around)
{
  Shape shape = tube(length, radius, around, Tube_end::round);
  shape.name = "capsule";
  return shape;
}

/// A closed tube that grows evenly from one radius to another.
inline Shape tapered_tube(double length, double radius_0, double radius_1, std::size_t around)
{
  const std::size_t n = rings_for(length, (radius_0 + radius_1) / 2, around);
  std::vector<double> radii;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(n - 1);
    radii.push_back((1 - t) * radius_0 + t * radius_1);
  }
  return swept_shape("tapered tube", sampled_segment({0, 0, 0}, {length, 0, 0}, n), radii, around, Tube_end::round);
}

/// A closed tube bent into the arc of a circle.
inline Shape bent_tube(double bend_radius, double angle, double radius, std::size_t around)
{
  const std::size_t n = rings_for(bend_radius * angle, radius, around);
  std::vector<Triple> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double a = angle * static_cast<double>(i) / static_cast<double>(n - 1);
    points.push_back({bend_radius * std::cos(a), bend_radius * std::sin(a), 0});
  }
  return swept_shape("bent tube", points, std::vector<double>(n, radius), around, Tube_end::round);
}

/// A tube of `rings` rings only, so that its triangles are long and thin.
inline Shape anisotropic_tube(double length, double radius, std::size_t around, std::size_t rings)
{
  Shape shape = swept_shape("anisotropic tube", sampled_segment({0, 0, 0}, {length, 0, 0}, rings),
                            std::vector<double>(rings, radius), around, Tube_end::flat);
  shape.number_of_tips.reset();
  return shape;
}

/// A torus around the z axis.
inline Shape torus(double major_radius, double minor_radius, std::size_t around)
{
  const std::size_t n = rings_for(2 * pi * major_radius, minor_radius, around);
  const auto circle = [&](double t) { return Triple{major_radius * std::cos(t), major_radius * std::sin(t), 0}; };
  return swept_shape("torus", sampled_closed_curve(circle, n), std::vector<double>(n, minor_radius), around,
                     Tube_end::joined);
}

/// A trefoil knot, about 6 wide.
inline Shape trefoil_knot(double radius, std::size_t around)
{
  const double length = 32; // of the curve below, rounded up
  const std::size_t n = rings_for(length, radius, around);
  const auto curve = [](double t) {
    return Triple{std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t), -std::sin(3 * t)};
  };
  return swept_shape("trefoil knot", sampled_closed_curve(curve, n), std::vector<double>(n, radius), around,
                     Tube_end::joined);
}

/// A chain of `number_of_rings` rings, each through the next and none touching.
inline Shape chain_of_rings(std::size_t number_of_rings, std::size_t around)
{
  const double major_radius = 1;
  const double minor_radius = 0.2;
  const std::size_t n = rings_for(2 * pi * major_radius, minor_radius, around);
  std::vector<Shape> rings;
  for (std::size_t i = 0; i < number_of_rings; ++i) {
    const double x = 1.4 * static_cast<double>(i);
    const bool is_upright = i % 2 == 1;
    const auto circle = [&](double t) {
      const double a = major_radius * std::cos(t);
      const double b = major_radius * std::sin(t);
      return is_upright ? Triple{x + a, 0, b} : Triple{x + a, b, 0};
    };
    rings.push_back(swept_shape("ring", sampled_closed_curve(circle, n), std::vector<double>(n, minor_radius), around,
                                Tube_end::joined));
  }
  return merged("chain of rings", rings);
}

/// A closed tube without a strip of faces along its middle part: one long border.
inline Shape slit_tube(double length, double radius, std::size_t around)
{
  Shape shape = tube(length, radius, around, Tube_end::flat);
  shape.name = "slit tube";
  const std::size_t rings = rings_for(length, radius, around);
  const std::size_t triangles_of_a_ring = 2 * around;
  std::vector<bool> is_removed(shape.triangles.size(), false);
  for (std::size_t ring = rings / 4; ring < 3 * rings / 4; ++ring) {
    is_removed[ring * triangles_of_a_ring] = true;
    is_removed[ring * triangles_of_a_ring + 1] = true;
  }
  remove_triangles(shape, is_removed);
  shape.number_of_border_cycles = 1;
  return shape;
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_SWEPT_SHAPES_H
