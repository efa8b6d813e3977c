// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Matrices of second moments, and their eigenvectors.

#ifndef CSCD_INTERNAL_PRINCIPAL_AXES_H
#define CSCD_INTERNAL_PRINCIPAL_AXES_H

#include <CSCD/Vector3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

namespace CSCD::internal {

/// A symmetric matrix, as its columns.
struct Moment_matrix
{
  std::array<Vector3, 3> columns;

  /// The matrix a b<sup>T</sup>, for parallel vectors: of it the lower half, and its mirror image.
  static Moment_matrix product(const Vector3& a, const Vector3& b)
  {
    return {{a * b.x(), Vector3(a.y() * b.x(), a.y() * b.y(), a.z() * b.y()),
             Vector3(a.z() * b.x(), a.z() * b.y(), a.z() * b.z())}};
  }

  Moment_matrix& operator+=(const Moment_matrix& other)
  {
    for (std::size_t i = 0; i < 3; ++i) {
      columns[i] += other.columns[i];
    }
    return *this;
  }
  friend Moment_matrix operator-(const Moment_matrix& a, const Moment_matrix& b)
  {
    return {{a.columns[0] - b.columns[0], a.columns[1] - b.columns[1], a.columns[2] - b.columns[2]}};
  }
  friend Moment_matrix operator/(const Moment_matrix& matrix, double divisor)
  {
    return {{matrix.columns[0] / divisor, matrix.columns[1] / divisor, matrix.columns[2] / divisor}};
  }
  /// The matrix less `value` times the identity.
  Moment_matrix shifted(double value) const
  {
    return *this - Moment_matrix{{Vector3(value, 0, 0), Vector3(0, value, 0), Vector3(0, 0, value)}};
  }
};

/// Eigenvalues in ascending order, and an eigenvector of unit length and either orientation for each.
struct Principal_axes
{
  std::array<double, 3> values;
  std::array<Vector3, 3> vectors;
};

/// The roots of the characteristic polynomial of `m`, ascending, by the trigonometric formula.
/// \pre the trace is about zero and the coefficients are at most 1
inline std::array<double, 3> eigenvalues(const Moment_matrix& m)
{
  const double xx = m.columns[0].x(), yx = m.columns[0].y(), zx = m.columns[0].z();
  const double yy = m.columns[1].y(), zy = m.columns[1].z(), zz = m.columns[2].z();
  constexpr double third = 1. / 3;
  // lambda^3 - c2 lambda^2 + c1 lambda - c0 = 0
  const double c0 = xx * yy * zz + 2 * yx * zx * zy - xx * zy * zy - yy * zx * zx - zz * yx * yx;
  const double c1 = xx * yy - yx * yx + xx * zz - zx * zx + yy * zz - zy * zy;
  const double c2 = xx + yy + zz;
  const double mean = c2 * third;
  const double a = std::max((c2 * mean - c1) * third, 0.);
  const double b = 0.5 * (c0 + mean * (2 * mean * mean - c1));
  const double rho = std::sqrt(a);
  const double theta = std::atan2(std::sqrt(std::max(a * a * a - b * b, 0.)), b) * third;
  const double cosine = std::cos(theta);
  const double sine = std::sqrt(3.) * std::sin(theta);
  return {mean - rho * (cosine + sine), mean - rho * (cosine - sine), mean + 2 * rho * cosine};
}

/// The kernel of a symmetric matrix of rank 2, of unit length, and a vector perpendicular to it.
inline std::pair<Vector3, Vector3> kernel(const Moment_matrix& m)
{
  const std::array<double, 3> diagonal{std::abs(m.columns[0].x()), std::abs(m.columns[1].y()),
                                       std::abs(m.columns[2].z())};
  const auto i = std::size_t(std::max_element(diagonal.begin(), diagonal.end()) - diagonal.begin());
  const Vector3 a = m.columns[i].cross(m.columns[(i + 1) % 3]);
  const Vector3 b = m.columns[i].cross(m.columns[(i + 2) % 3]);
  return {a.squaredNorm() > b.squaredNorm() ? a / a.norm() : b / b.norm(), m.columns[i]};
}

/// Eigenvalues and eigenvectors in closed form: less exact than by iteration, but in a fixed time. The algorithm is
/// that of Eigen's `SelfAdjointEigenSolver::computeDirect()`, which would be a tenth of the compile time of a file that
/// calls the library.
inline Principal_axes principal_axes(const Moment_matrix& matrix)
{
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double mean = (matrix.columns[0].x() + (matrix.columns[1].y() + matrix.columns[2].z())) / 3;
  Moment_matrix scaled = matrix.shifted(mean);
  double scale = 0;
  for (const Vector3& column : scaled.columns) {
    scale = std::max(scale, column.cwiseAbs().maxCoeff());
  }
  if (scale > 0) {
    scaled = scaled / scale;
  }
  Principal_axes result{eigenvalues(scaled), {Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()}};
  auto& [values, vectors] = result;
  if (values[2] - values[0] > epsilon) {
    // First the vector of the value that is farthest from both others, `distinct`, then of the other extreme one.
    const double gap_above = values[2] - values[1];
    const double gap_below = values[1] - values[0];
    const std::size_t distinct = gap_above > gap_below ? 2 : 0;
    const std::size_t other = 2 - distinct;
    std::tie(vectors[distinct], vectors[other]) = kernel(scaled.shifted(values[distinct]));
    if (std::min(gap_above, gap_below) <= 2 * epsilon * std::max(gap_above, gap_below)) {
      vectors[other] -= vectors[distinct].dot(vectors[other]) * vectors[distinct];
      vectors[other].normalize();
    } else {
      vectors[other] = kernel(scaled.shifted(values[other])).first;
    }
    vectors[1] = vectors[2].cross(vectors[0]).normalized();
  }
  for (double& value : values) {
    value = value * scale + mean;
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_INTERNAL_PRINCIPAL_AXES_H
