// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A smooth surface through the neighborhood of every point of a cloud.

#ifndef CSCD_POINT_CLOUD_FIT_QUADRICS_H
#define CSCD_POINT_CLOUD_FIT_QUADRICS_H

#include <CSCD/Point_cloud/Neighbor_table.h>
#include <CSCD/internal/Vector_3.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// What a quadratic height field, fitted by least squares over the plane of a neighborhood, says of its central point.
struct Quadric_fit
{
  Vector_3 normal = Vector_3::Zero();         ///< of the plane: of unit length and either orientation
  Vector_3 projection = Vector_3::Zero();     ///< the point, moved along the normal to the fitted surface
  Vector_3 surface_normal = Vector_3::Zero(); ///< of the fitted surface next to the point, to the side of `normal`
  double deviation = 0; ///< root mean square distance of the points from that surface, free of bias; 0 if undetermined
};

/// The principal axes of `neighbors` around their mean with that of least extent, the normal of their plane, first.
/// \param unit what offsets are measured in
template <class Neighbors>
Eigen::Matrix3d principal_axes(const std::vector<Vector_3>& points, Index point, const Neighbors& neighbors,
                               double unit)
{
  const double size = double(neighbors.size()) + 1;
  Vector_3 mean = Vector_3::Zero();
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Index neighbor : neighbors) {
    const Vector_3 offset = (points[neighbor] - points[point]) / unit;
    mean += offset / size;
    moments += offset * offset.transpose() / size;
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(moments - mean * mean.transpose());
  return solver.eigenvectors();
}

/// Fits the plane and the height field through `point` and `neighbors`.
/// \param neighbors a range of indices of points, none of them `point`
/// \param reach the distance of the farthest of them
template <class Neighbors>
Quadric_fit fit_quadric(const std::vector<Vector_3>& points, Index point, const Neighbors& neighbors, double reach)
{
  using Coefficients = Eigen::Matrix<double, 6, 1>;
  constexpr std::size_t number_of_coefficients = 6;
  // Relative to the point and the reach, so that nothing is lost by cancellation.
  const double unit = reach;
  const Eigen::Matrix3d axes = principal_axes(points, point, neighbors, unit);
  Quadric_fit result;
  result.normal = axes.col(0);
  result.surface_normal = result.normal;
  result.projection = points[point];
  if (neighbors.size() < 2 * number_of_coefficients) {
    return result;
  }
  Eigen::Matrix<double, 6, 6> normal_matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Coefficients right_side = Coefficients::Zero();
  double squared_heights = 0;
  const auto add = [&](const Vector_3& offset) {
    const double x = offset.dot(axes.col(1));
    const double y = offset.dot(axes.col(2));
    const double height = offset.dot(result.normal);
    Coefficients row;
    row << 1, x, y, x * x, x * y, y * y;
    normal_matrix += row * row.transpose();
    right_side += height * row;
    squared_heights += height * height;
  };
  add(Vector_3::Zero());
  for (const Index neighbor : neighbors) {
    add((points[neighbor] - points[point]) / unit);
  }
  const Coefficients coefficients = normal_matrix.ldlt().solve(right_side);
  const double squared_error = squared_heights - coefficients.dot(right_side);
  if (std::isfinite(squared_error) && std::abs(coefficients[0]) <= 1) {
    result.projection += unit * coefficients[0] * result.normal;
    result.surface_normal =
        (result.normal - coefficients[1] * axes.col(1) - coefficients[2] * axes.col(2)).normalized();
    const double size = double(neighbors.size()) + 1;
    result.deviation = unit * std::sqrt(std::max(0., squared_error) / (size - double(number_of_coefficients)));
  }
  return result;
}

/// Fits a quadric around each of `points`; linear in the number of neighbors.
inline std::vector<Quadric_fit> fit_quadrics(const std::vector<Vector_3>& points, const Neighbor_table& neighbors)
{
  std::vector<Quadric_fit> result;
  result.reserve(points.size());
  for (Index point = 0; point < points.size(); ++point) {
    result.push_back(fit_quadric(points, point, neighbors.neighbors(point), neighbors.reach(point)));
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_POINT_CLOUD_FIT_QUADRICS_H
