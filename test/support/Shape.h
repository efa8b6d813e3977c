// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An indexed triangle mesh with its known properties: the common currency of the tests.

#ifndef CSCD_TEST_SUPPORT_SHAPE_H
#define CSCD_TEST_SUPPORT_SHAPE_H

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CSCD::test {

/// Coordinates of a point or a vector.
using Triple = std::array<double, 3>;

/// Vertex numbers of a triangle.
using Triangle = std::array<std::size_t, 3>;

inline Triple operator+(const Triple& a, const Triple& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

inline Triple operator-(const Triple& a, const Triple& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Triple operator*(double s, const Triple& a)
{
  return {s * a[0], s * a[1], s * a[2]};
}

inline double dot(const Triple& a, const Triple& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Triple cross(const Triple& a, const Triple& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double norm(const Triple& a)
{
  return std::sqrt(dot(a, a));
}

inline Triple unit(const Triple& a)
{
  return (1 / norm(a)) * a;
}

/// A straight piece of a body's true centreline, with the body's radius at both ends.
struct Centreline_segment
{
  Triple source{};
  Triple target{};
  double source_radius = 0;
  double target_radius = 0;
};

/// A triangle mesh and its known properties.
struct Shape
{
  std::string name;
  std::vector<Triple> points;
  std::vector<Triangle> triangles;

  std::size_t number_of_components = 1;
  /// Summed over the components; borders count as closed by a disc each.
  std::size_t genus = 0;
  std::size_t number_of_border_cycles = 0;
  /// Empty where the shape has no obvious centreline.
  std::vector<Centreline_segment> centreline;
  /// Counts of a good skeleton, where they are unambiguous.
  std::optional<std::size_t> number_of_tips;
  std::optional<std::size_t> number_of_junctions;
};

/// The length of the diagonal of the bounding box of `shape`.
inline double diagonal(const Shape& shape)
{
  Triple lower = shape.points.front();
  Triple upper = shape.points.front();
  for (const Triple& p : shape.points) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lower[axis] = std::fmin(lower[axis], p[axis]);
      upper[axis] = std::fmax(upper[axis], p[axis]);
    }
  }
  return norm(upper - lower);
}

/// The parameter in [0, 1] of the point of `segment` that is nearest to `p`.
inline double nearest_parameter(const Centreline_segment& segment, const Triple& p)
{
  const Triple along = segment.target - segment.source;
  const double squared_length = dot(along, along);
  if (squared_length == 0) {
    return 0;
  }
  return std::fmin(1.0, std::fmax(0.0, dot(p - segment.source, along) / squared_length));
}

/// Distance from `p` to `segment`.
inline double distance(const Centreline_segment& segment, const Triple& p)
{
  const double t = nearest_parameter(segment, p);
  return norm(p - ((1 - t) * segment.source + t * segment.target));
}

/// The radius of `segment` at its point nearest to `p`.
inline double radius_near(const Centreline_segment& segment, const Triple& p)
{
  const double t = nearest_parameter(segment, p);
  return (1 - t) * segment.source_radius + t * segment.target_radius;
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_SHAPE_H
