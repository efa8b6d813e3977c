// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The circle through points of a section, some of which may be of other things.

#ifndef CSCD_TREE_FIT_CIRCLE_H
#define CSCD_TREE_FIT_CIRCLE_H

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CSCD::internal {

/// A circle and how well points determine it.
struct Circle_fit
{
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0;
  double deviation = 0;   ///< of the points near it from it, root mean square
  double inlier_part = 0; ///< of the points near it among all
  double coverage = 0;    ///< all of the circle but its longest arc without points: an angle
};

/// The algebraic fit of Taubin to weighted points, by the method of Chernov, Circular and Linear Regression
/// (2010), 5.9. \return nothing if the points are at one place or on a line
inline std::optional<Circle_fit> fit_circle_algebraically(const std::vector<Eigen::Vector2d>& points,
                                                          const std::vector<double>& weights)
{
  double sum = 0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum += weights[i];
    mean += weights[i] * points[i];
  }
  mean /= sum;
  double mean_square = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    mean_square += weights[i] * (points[i] - mean).squaredNorm() / sum;
  }
  if (!(mean_square > 0)) {
    return std::nullopt;
  }
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d p = points[i] - mean;
    const Eigen::Vector3d row((p.squaredNorm() - mean_square) / (2 * std::sqrt(mean_square)), p.x(), p.y());
    moments += weights[i] / sum * row * row.transpose();
  }
  const Eigen::Vector3d solution = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments).eigenvectors().col(0);
  const double quadratic = solution[0] / (2 * std::sqrt(mean_square));
  constexpr double straight = 1e-6; // relative to the scatter: the circle would be a line
  if (std::abs(solution[0]) < straight) {
    return std::nullopt;
  }
  Circle_fit result;
  const Eigen::Vector2d offset = -solution.tail<2>() / (2 * quadratic);
  result.center = mean + offset;
  result.radius = std::sqrt(offset.squaredNorm() + mean_square);
  return result;
}

/// Measures how well `points` determine `circle`: those count that deviate by at most `tolerance`.
inline void measure_fit(const std::vector<Eigen::Vector2d>& points, double tolerance, Circle_fit& circle)
{
  std::vector<double> angles;
  double sum = 0;
  for (const Eigen::Vector2d& p : points) {
    const Eigen::Vector2d d = p - circle.center;
    const double deviation = d.norm() - circle.radius;
    if (std::abs(deviation) <= tolerance) {
      angles.push_back(std::atan2(d.y(), d.x()));
      sum += deviation * deviation;
    }
  }
  if (angles.empty()) {
    return;
  }
  constexpr double full = boost::math::double_constants::two_pi;
  std::sort(angles.begin(), angles.end());
  double longest_gap = angles.front() + full - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) {
    longest_gap = std::max(longest_gap, angles[i] - angles[i - 1]);
  }
  circle.coverage = full - longest_gap;
  circle.deviation = std::sqrt(sum / double(angles.size()));
  circle.inlier_part = double(angles.size()) / double(points.size());
}

/// The standard deviation of the distances of `points` from `circle`, by their median, which outliers hardly move.
inline double robust_deviation(const std::vector<Eigen::Vector2d>& points, const Circle_fit& circle)
{
  constexpr double deviation_of_median = 1.4826; // a normal distribution's standard deviation, relative to its median
  constexpr double least_deviation = 1e-6;       // relative to the radius: exact points have none
  std::vector<double> deviations(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    deviations[i] = std::abs((points[i] - circle.center).norm() - circle.radius);
  }
  const auto middle = deviations.begin() + std::ptrdiff_t(deviations.size() / 2);
  std::nth_element(deviations.begin(), middle, deviations.end());
  return std::max(deviation_of_median * *middle, least_deviation * circle.radius);
}

/// The step of a Gauss-Newton iteration for `circle`, two coordinates and the radius, in which points that deviate by
/// more count less and those beyond `cutoff` do not (Tukey's biweight).
inline Eigen::Vector3d gauss_newton_step(const std::vector<Eigen::Vector2d>& points, const Circle_fit& circle,
                                         double cutoff)
{
  constexpr double damping = 1e-3; // a short arc hardly tells the radius from the center
  Eigen::Matrix3d normal_matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_side = Eigen::Vector3d::Zero();
  for (const Eigen::Vector2d& p : points) {
    const Eigen::Vector2d d = p - circle.center;
    const double distance = d.norm();
    const double relative = (distance - circle.radius) / cutoff;
    if (std::abs(relative) >= 1 || distance == 0) {
      continue;
    }
    const double weight = (1 - relative * relative) * (1 - relative * relative);
    const Eigen::Vector3d row(d.x() / distance, d.y() / distance, 1);
    normal_matrix += weight * row * row.transpose();
    right_side += weight * (distance - circle.radius) * row;
  }
  normal_matrix.diagonal() *= 1 + damping;
  return normal_matrix.ldlt().solve(right_side);
}

/// Fits a circle to `points`: algebraically first, then by least squares of the distances from it, in which points far
/// from it, compared with the median, count less and less. O(n log n).
/// \return nothing if the points are at one place or on a line
inline std::optional<Circle_fit> fit_circle(const std::vector<Eigen::Vector2d>& points)
{
  constexpr int rounds = 12;
  constexpr double cutoff = 4; // in standard deviations: weights vanish
  std::optional<Circle_fit> circle = fit_circle_algebraically(points, std::vector<double>(points.size(), 1.));
  if (!circle) {
    return std::nullopt;
  }
  double deviation = 0;
  for (int round = 0; round < rounds; ++round) {
    deviation = robust_deviation(points, *circle);
    const Eigen::Vector3d step = gauss_newton_step(points, *circle, cutoff * deviation);
    if (!step.allFinite()) {
      break;
    }
    circle->center += step.head<2>();
    circle->radius += step[2];
    if (circle->radius <= 0) {
      return std::nullopt;
    }
  }
  measure_fit(points, cutoff / 2 * deviation, *circle);
  return circle;
}

} // namespace CSCD::internal

#endif // CSCD_TREE_FIT_CIRCLE_H
