// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The vector type and the index type of the flat arrays.

#ifndef CSCD_VECTOR3_H
#define CSCD_VECTOR3_H

#include <CGAL/double.h>
#include <CGAL/float.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

namespace CSCD {

// NOLINTBEGIN(readability-identifier-naming): the names of Eigen, see below
/// Points and vectors of the normalized surface. Members are named as those of `Eigen::Vector3d`, whose expression
/// templates would be a third of the functions that are compiled for a file that calls the library.
class Vector3 : public std::array<double, 3>
{
public:
  /// The zero vector.
  constexpr Vector3() : array{} {}
  /// The vector of these coordinates.
  constexpr Vector3(double x, double y, double z) : array{x, y, z} {}

  /// The vector whose coordinates are all `value`.
  static constexpr Vector3 Constant(double value) { return {value, value, value}; }
  /// The zero vector.
  static constexpr Vector3 Zero() { return {}; }
  /// The direction of the x axis.
  static constexpr Vector3 UnitX() { return {1, 0, 0}; }
  /// The direction of the y axis.
  static constexpr Vector3 UnitY() { return {0, 1, 0}; }
  /// The direction of the z axis.
  static constexpr Vector3 UnitZ() { return {0, 0, 1}; }

  /// The coordinate along an axis, 0 to 2, of any integral type.
  template <class Axis>
  constexpr double operator[](Axis axis) const
  {
    return array::operator[](std::size_t(axis));
  }
  /// The coordinate along an axis, likewise.
  template <class Axis>
  constexpr double& operator[](Axis axis)
  {
    return array::operator[](std::size_t(axis));
  }

  /// The x coordinate.
  constexpr double x() const { return (*this)[0]; }
  /// The y coordinate.
  constexpr double y() const { return (*this)[1]; }
  /// The z coordinate.
  constexpr double z() const { return (*this)[2]; }
  /// The x coordinate.
  constexpr double& x() { return (*this)[0]; }
  /// The y coordinate.
  constexpr double& y() { return (*this)[1]; }
  /// The z coordinate.
  constexpr double& z() { return (*this)[2]; }

  /// Adds `v`.
  constexpr Vector3& operator+=(const Vector3& v) { return *this = *this + v; }
  /// Subtracts `v`.
  constexpr Vector3& operator-=(const Vector3& v) { return *this = *this - v; }
  /// Multiplies by `factor`.
  constexpr Vector3& operator*=(double factor) { return *this = *this * factor; }
  /// Divides by `divisor`.
  constexpr Vector3& operator/=(double divisor) { return *this = *this / divisor; }

  /// The opposite vector.
  friend constexpr Vector3 operator-(const Vector3& v) { return {-v.x(), -v.y(), -v.z()}; }
  /// The sum.
  friend constexpr Vector3 operator+(const Vector3& a, const Vector3& b)
  {
    return {a.x() + b.x(), a.y() + b.y(), a.z() + b.z()};
  }
  /// The difference.
  friend constexpr Vector3 operator-(const Vector3& a, const Vector3& b)
  {
    return {a.x() - b.x(), a.y() - b.y(), a.z() - b.z()};
  }
  /// The product.
  friend constexpr Vector3 operator*(const Vector3& v, double factor)
  {
    return {v.x() * factor, v.y() * factor, v.z() * factor};
  }
  /// The product.
  friend constexpr Vector3 operator*(double factor, const Vector3& v) { return v * factor; }
  /// The quotient.
  friend constexpr Vector3 operator/(const Vector3& v, double divisor)
  {
    return {v.x() / divisor, v.y() / divisor, v.z() / divisor};
  }

  /// The scalar product.
  constexpr double dot(const Vector3& v) const { return x() * v.x() + y() * v.y() + z() * v.z(); }
  /// The vector product.
  constexpr Vector3 cross(const Vector3& v) const
  {
    return {y() * v.z() - z() * v.y(), z() * v.x() - x() * v.z(), x() * v.y() - y() * v.x()};
  }
  /// The squared length.
  constexpr double squaredNorm() const { return dot(*this); }
  /// The length.
  double norm() const { return std::sqrt(squaredNorm()); }
  /// This vector scaled to unit length; unchanged if it is too short to have a direction.
  Vector3 normalized() const
  {
    const double squared_norm = squaredNorm();
    return squared_norm > 0 ? *this / std::sqrt(squared_norm) : *this;
  }
  /// Makes the length 1. \see normalized()
  void normalize() { *this = normalized(); }
  /// `normalized()` without overflow or underflow.
  Vector3 stableNormalized() const
  {
    const double greatest = cwiseAbs().maxCoeff();
    const double squared_norm = (*this / greatest).squaredNorm();
    return squared_norm > 0 ? *this / (std::sqrt(squared_norm) * greatest) : *this;
  }
  /// A vector of unit length perpendicular to this one.
  Vector3 unitOrthogonal() const
  {
    constexpr double negligible = 1e-12; // relative to the third coordinate
    if (std::abs(x()) > std::abs(z()) * negligible || std::abs(y()) > std::abs(z()) * negligible) {
      const double inverse = 1 / std::sqrt(x() * x() + y() * y());
      return {-y() * inverse, x() * inverse, 0};
    }
    const double inverse = 1 / std::sqrt(y() * y() + z() * z());
    return {0, -z() * inverse, y() * inverse};
  }

  /// The absolute values of the coordinates.
  Vector3 cwiseAbs() const { return {std::abs(x()), std::abs(y()), std::abs(z())}; }
  /// The lesser ones of the coordinates of both.
  constexpr Vector3 cwiseMin(const Vector3& v) const
  {
    return {std::min(x(), v.x()), std::min(y(), v.y()), std::min(z(), v.z())};
  }
  /// The greater ones of the coordinates of both.
  constexpr Vector3 cwiseMax(const Vector3& v) const
  {
    return {std::max(x(), v.x()), std::max(y(), v.y()), std::max(z(), v.z())};
  }
  /// The least coordinate.
  constexpr double minCoeff() const { return std::min(x(), std::min(y(), z())); }
  /// The greatest coordinate.
  constexpr double maxCoeff() const { return std::max(x(), std::max(y(), z())); }
  /// Whether all coordinates are finite.
  bool allFinite() const { return std::isfinite(x()) && std::isfinite(y()) && std::isfinite(z()); }
};

// NOLINTEND(readability-identifier-naming)

/// The order by x, then by y, then by z.
inline bool is_lexicographically_less(const Vector3& a, const Vector3& b)
{
  return a < b;
}

namespace internal {

/// Twice the area of the triangle of three points times its normal, from where these are counterclockwise.
constexpr Vector3 triangle_vector(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return (b - a).cross(c - a);
}

/// The area of the triangle of three points.
inline double triangle_area(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return triangle_vector(a, b, c).norm() / 2;
}

/// The coordinates of a point or vector of any type.
template <class Triple>
Vector3 to_vector_3(const Triple& triple)
{
  return {CGAL::to_double(triple.x()), CGAL::to_double(triple.y()), CGAL::to_double(triple.z())};
}

/// `v` as a point of any type that is constructible from three coordinates.
template <class Point>
Point make_point(const Vector3& v)
{
  using Coordinate = std::decay_t<decltype(std::declval<const Point&>().x())>;
  return Point(Coordinate(v.x()), Coordinate(v.y()), Coordinate(v.z()));
}

} // namespace internal

/// Index of a vertex, halfedge, face, separator or piece.
using Index = std::uint32_t;

/// The index of nothing.
inline constexpr Index no_index = std::numeric_limits<Index>::max();

} // namespace CSCD

#endif // CSCD_VECTOR3_H
