// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spacing, noise and outliers of a point cloud, by local fits of quadrics, also where other sheets are near.

#ifndef CSCD_POINTS_CLOUD_SAMPLING_H
#define CSCD_POINTS_CLOUD_SAMPLING_H

#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/principal_axes.h>

#include <CGAL/Iterator_range.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CSCD::internal {

/// The neighbors that show the direction of a surface that is sampled at random: more reach over to the next limb.
inline constexpr Index quadric_neighbors = 16;

/// The covariance of `offsets`, and their principal axes.
/// \pre there are offsets
inline Principal_axes axes_of(const std::vector<Vector3>& offsets)
{
  Vector3 mean = Vector3::Zero();
  Moment_matrix moments{};
  for (const Vector3& offset : offsets) {
    mean += offset / double(offsets.size());
    moments += Moment_matrix::product(offset, offset) / double(offsets.size());
  }
  return principal_axes(moments - Moment_matrix::product(mean, mean));
}

/// A quadratic height field, fitted by least squares over the plane of a neighborhood, at its central point.
struct Quadric_fit
{
  Vector3 normal = Vector3::Zero();         ///< of the plane: of unit length and either orientation
  Vector3 projection = Vector3::Zero();     ///< the point, moved along the normal to the fitted surface
  Vector3 surface_normal = Vector3::Zero(); ///< of the fitted surface next to the point, to the side of `normal`
  double deviation = 0; ///< root mean square distance of the points from that surface, free of bias; 0 if undetermined
};

/// Fits the plane and the height field through `point` and `neighbors`.
/// \param neighbors indices of points, none of them `point`
/// \param reach the distance of the farthest of them
inline Quadric_fit fit_quadric(const std::vector<Vector3>& points, Index point,
                               const CGAL::Iterator_range<const Index*>& neighbors, double reach)
{
  using Coefficients = Eigen::Matrix<double, 6, 1>;
  constexpr std::size_t number_of_coefficients = 6;
  // Relative to the point and the reach, so that nothing is lost by cancellation.
  const double unit = reach;
  std::vector<Vector3> offsets{Vector3::Zero()};
  for (const Index neighbor : neighbors) {
    offsets.push_back((points[neighbor] - points[point]) / unit);
  }
  const std::array<Vector3, 3> axes = axes_of(offsets).vectors;
  Quadric_fit result{axes[0], points[point], axes[0], 0};
  if (neighbors.size() < 2 * number_of_coefficients) {
    return result;
  }
  Eigen::Matrix<double, 6, 6> normal_matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Coefficients right_side = Coefficients::Zero();
  double squared_heights = 0;
  for (const Vector3& offset : offsets) {
    const double x = offset.dot(axes[1]);
    const double y = offset.dot(axes[2]);
    const double height = offset.dot(result.normal);
    Coefficients row;
    row << 1, x, y, x * x, x * y, y * y;
    normal_matrix += row * row.transpose();
    right_side += height * row;
    squared_heights += height * height;
  }
  const Coefficients coefficients = normal_matrix.ldlt().solve(right_side);
  const double squared_error = squared_heights - coefficients.dot(right_side);
  if (std::isfinite(squared_error) && std::abs(coefficients[0]) <= 1) {
    result.projection += unit * coefficients[0] * result.normal;
    result.surface_normal = (result.normal - coefficients[1] * axes[1] - coefficients[2] * axes[2]).normalized();
    result.deviation = unit * std::sqrt(std::max(0., squared_error) / double(offsets.size() - number_of_coefficients));
  }
  return result;
}

/// The value that the part `fraction` of `values` does not exceed; linear.
/// \pre there are values, and `fraction` is less than 1
inline double quantile(std::vector<double> values, double fraction)
{
  const auto place = values.begin() + std::ptrdiff_t(fraction * double(values.size()));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// The normal of the plane through as many of the nearest neighbors of `point` as are the thinnest in relation to their
/// width.
inline Vector3 flattest_normal(const std::vector<Vector3>& points, const Neighbor_table& table, Index point)
{
  // The sizes of neighborhoods that are compared: the immediate neighbors, and more for points with noise.
  constexpr std::array<Index, 3> sizes{7, 10, 16};
  const auto neighbors = table.neighbors(point);
  const double unit = table.reach(point);
  Vector3 sum = Vector3::Zero();
  Moment_matrix moments;
  Vector3 result = Vector3::UnitZ();
  double min_thickness = std::numeric_limits<double>::infinity();
  auto neighbor = neighbors.begin();
  for (const Index size : sizes) {
    for (; neighbor != neighbors.end() && neighbor - neighbors.begin() < std::ptrdiff_t(size); ++neighbor) {
      const Vector3 offset = (points[*neighbor] - points[point]) / unit;
      sum += offset;
      moments += Moment_matrix::product(offset, offset);
    }
    const Principal_axes axes =
        principal_axes(moments - Moment_matrix::product(sum, sum) / double(neighbor - neighbors.begin() + 1));
    const double thickness = std::max(0., axes.values[0]) / axes.values[1];
    if (thickness < min_thickness) {
      min_thickness = thickness;
      result = axes.vectors[0];
    }
  }
  return result;
}

/// Fits a quadric to the neighbors of `point` that are not far off its flattest plane: not to those on another sheet.
/// If too few are left for a quadric, the fit is the plane, which takes the point where it is.
inline Quadric_fit fit_sheet(const std::vector<Vector3>& points, const Neighbor_table& table, Index point)
{
  constexpr double max_slope = 0.5; // the sine of the angle between the plane and the edges to neighbors on the sheet
  constexpr std::size_t min_sheet = 5; // fewer neighbors do not determine more than a plane
  const Vector3 normal = flattest_normal(points, table, point);
  std::vector<Index> sheet;
  double reach = 0;
  for (const Index neighbor : table.neighbors(point)) {
    const Vector3 edge = points[neighbor] - points[point];
    if (std::abs(edge.dot(normal)) <= max_slope * edge.norm()) {
      sheet.push_back(neighbor);
      reach = std::max(reach, edge.norm());
    }
  }
  return sheet.size() < min_sheet ? Quadric_fit{normal, points[point], normal, 0}
                                  : fit_quadric(points, point, {sheet.data(), sheet.data() + sheet.size()}, reach);
}

} // namespace CSCD::internal

#endif // CSCD_POINTS_CLOUD_SAMPLING_H
