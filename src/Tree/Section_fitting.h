// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fits circles to the sections of limbs.

#ifndef CSCD_SRC_TREE_SECTION_FITTING_H
#define CSCD_SRC_TREE_SECTION_FITTING_H

#include "Tree/Limb_finder.h"
#include <CSCD/Points/Cloud_sampling.h>
#include <CSCD/Tree/Tree_report.h>
#include <CSCD/Vector3.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// A circle and how well points determine it.
struct Circle_fit
{
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0;
  double scatter = 0;     ///< root mean square distance of the points from their mean
  double deviation = 0;   ///< of the points near it from it, root mean square
  double inlier_part = 0; ///< of the points near it among all
  double coverage = 0;    ///< all of the circle but its longest arc without points: an angle
};

/// The algebraic fit of Taubin to points, by the method of Chernov, Circular and Linear Regression (2010), 5.9.
/// \return nothing if the points are at one place or on a line
inline std::optional<Circle_fit> fit_circle_algebraically(const std::vector<Eigen::Vector2d>& points)
{
  const double number = double(points.size());
  const Eigen::Vector2d mean =
      std::accumulate(points.begin(), points.end(), Eigen::Vector2d(Eigen::Vector2d::Zero())) / number;
  double mean_square = 0;
  for (const Eigen::Vector2d& point : points) {
    mean_square += (point - mean).squaredNorm() / number;
  }
  Circle_fit result;
  result.scatter = std::sqrt(mean_square);
  if (!(mean_square > 0)) {
    return std::nullopt;
  }
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d p = point - mean;
    const Eigen::Vector3d row((p.squaredNorm() - mean_square) / (2 * result.scatter), p.x(), p.y());
    moments += 1 / number * row * row.transpose();
  }
  const Eigen::Vector3d solution = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments).eigenvectors().col(0);
  const double quadratic = solution[0] / (2 * result.scatter);
  constexpr double straight = 1e-6; // relative to the scatter: the circle would be a line
  if (std::abs(solution[0]) < straight) {
    return std::nullopt;
  }
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
  constexpr double min_deviation = 1e-6;         // relative to the radius: exact points have none
  std::vector<double> deviations(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    deviations[i] = std::abs((points[i] - circle.center).norm() - circle.radius);
  }
  return std::max(deviation_of_median * quantile(std::move(deviations), 0.5), min_deviation * circle.radius);
}

/// The Gauss-Newton step for `circle`, two coordinates and the radius. Points that deviate by more count less, and
/// points beyond `cutoff` do not count (Tukey's biweight).
inline Eigen::Vector3d gauss_newton_step(const std::vector<Eigen::Vector2d>& points, const Circle_fit& circle,
                                         double cutoff)
{
  constexpr double damping = 1e-3; // a short arc hardly determines radius and center separately
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

/// Fits a circle to `points`: algebraically first, then by least squares of the distances from it. Points far from it,
/// compared with the median, count less and less. O(n log n).
/// \return nothing if the points are at one place or on a line
inline std::optional<Circle_fit> fit_circle(const std::vector<Eigen::Vector2d>& points)
{
  constexpr int rounds = 12;   // of reweighting
  constexpr double cutoff = 4; // in standard deviations: weights vanish
  std::optional<Circle_fit> circle = fit_circle_algebraically(points);
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

/// Fits circles to the slices of limbs, across them.
class Section_fitting
{
public:
  Section_fitting(const std::vector<Vector3>& points, const std::vector<Slice>& slices)
      : m_points(points), m_slices(slices), m_sections(slices.size())
  {
  }

  const std::vector<Section>& sections() const { return m_sections; }

  /// Takes the median deviation of the points from the circles of the trunks as noise. To be called when these have
  /// been fitted.
  void estimate_noise()
  {
    if (!m_deviations.empty()) {
      m_noise = quantile(m_deviations, 0.5);
    }
  }

  /// Finds the sections of `limb`; those of its parent are known.
  void fit(const Tree_limb& limb)
  {
    for (Index slice : limb.slices) {
      m_sections[slice].center = m_slices[slice].centroid;
    }
    for (int round = 0; round < rounds; ++round) {
      find_directions(limb);
      for (std::size_t i = 0; i < limb.slices.size(); ++i) {
        fit_section(limb, i);
      }
      place_centers(limb);
    }
    find_directions(limb);
    smooth_radii(limb);
  }

  /// Where no circle gives the radius, the scatter of the points, leaves among them, is an upper bound. By the pipe
  /// model, the area of a section is proportional to the length of all that it carries: so the parent gives a bound.
  void limit_by_pipe_model(const std::vector<Tree_limb>& limbs)
  {
    std::vector<double> carried(m_sections.size(), 0);
    for (auto limb = limbs.rbegin(); limb != limbs.rend(); ++limb) {
      for (std::size_t i = limb->slices.size(); i-- > 0;) {
        const Index slice = limb->slices[i];
        const Index before = i > 0 ? limb->slices[i - 1] : limb->joint;
        if (before != no_index) {
          carried[before] += carried[slice] + (m_sections[slice].center - m_sections[before].center).norm();
        }
      }
    }
    for (const Tree_limb& limb : limbs) {
      if (limb.joint == no_index || !(carried[limb.joint] > 0)) {
        continue;
      }
      const double factor = m_sections[limb.joint].radius / std::sqrt(carried[limb.joint]);
      for (const Index slice : limb.slices) {
        Section& section = m_sections[slice];
        if (section.is_rough) {
          const double scatter = scatter_radius(slice);
          section.radius =
              std::max(std::sqrt(min_part_of_scatter) * scatter, std::min(scatter, factor * std::sqrt(carried[slice])));
        }
      }
      smooth_radii(limb);
    }
  }

private:
  /// A circle is fitted to at least so many points, if there are ...
  static constexpr std::size_t wanted_points = 30;
  static constexpr std::size_t min_points = 8;
  /// ... of at most so many slices to either side.
  static constexpr std::size_t max_slices = 2;
  /// The arc that points must cover, in radians ...
  static constexpr double min_coverage = 1.4;
  /// ... their deviation, relative to the radius, and their part of all.
  static constexpr double max_deviation = 0.25;
  static constexpr double min_inlier_part = 0.6;
  /// The deviation relative to that of trunks: of leaves it is larger.
  static constexpr double noise_limit = 3;
  /// The radius relative to the scatter of the points.
  static constexpr double max_radius = 3.5;
  /// Directions across which circles are fitted are those of the centroids first, then those of the centers.
  static constexpr int rounds = 2;
  /// The slices to either side that give the direction.
  static constexpr std::size_t direction_reach = 2;
  /// The slices to either side whose circles give the radius of one without.
  static constexpr std::size_t radius_reach = 3;
  /// The radius of a limb relative to that of its parent.
  static constexpr double max_of_parent = 1.1;
  /// The least part of the squared scatter of points that remains when the scatter of the noise is subtracted.
  static constexpr double min_part_of_scatter = 0.1;
  static constexpr double min_confidence = 0.02;
  /// The scatter of fewer points does not give a radius.
  static constexpr std::size_t min_scatter_points = 4;

  Section& section(const Tree_limb& limb, std::size_t i) { return m_sections[limb.slices[i]]; }

  /// The first and the last place in a limb that are at most `reach` from `i`.
  static std::pair<std::size_t, std::size_t> window(const Tree_limb& limb, std::size_t i, std::size_t reach)
  {
    return {i - std::min(i, reach), std::min(limb.slices.size() - 1, i + reach)};
  }

  void find_directions(const Tree_limb& limb)
  {
    for (std::size_t i = 0; i < limb.slices.size(); ++i) {
      const auto [first, last] = window(limb, i, direction_reach);
      const Vector3& after = section(limb, last).center;
      Vector3 step = after - section(limb, first).center;
      if (step.norm() == 0 && limb.joint != no_index) {
        step = after - m_sections[limb.joint].center;
      }
      section(limb, i).direction = step.norm() > 0 ? Vector3(step.normalized()) : Vector3::UnitZ();
    }
  }

  /// The points of a slice and of those around it, along the limb into a plane across it. The origin is the centroid.
  std::vector<Eigen::Vector2d> project(const Tree_limb& limb, std::size_t i, const Vector3& u, const Vector3& v) const
  {
    std::vector<Eigen::Vector2d> result;
    const Vector3& origin = m_slices[limb.slices[i]].centroid;
    const auto project_slice = [&](std::size_t j) {
      for (Index point : m_slices[limb.slices[j]].points) {
        const Vector3 d = m_points[point] - origin;
        result.emplace_back(u.dot(d), v.dot(d));
      }
    };
    project_slice(i);
    for (std::size_t reach = 1; reach <= max_slices && result.size() < wanted_points; ++reach) {
      if (i >= reach) {
        project_slice(i - reach);
      }
      if (i + reach < limb.slices.size()) {
        project_slice(i + reach);
      }
    }
    return result;
  }

  /// Whether the section is given by a circle.
  Circle_outcome judge(const Circle_fit& circle, const Tree_limb& limb) const
  {
    if (circle.radius > max_radius * circle.scatter ||
        (limb.joint != no_index && circle.radius > max_of_parent * m_sections[limb.joint].radius)) {
      return Circle_outcome::too_wide;
    }
    if (circle.deviation > max_deviation * circle.radius || circle.inlier_part < min_inlier_part ||
        (m_noise > 0 && circle.deviation > noise_limit * m_noise)) {
      return Circle_outcome::scattered;
    }
    return circle.coverage < min_coverage ? Circle_outcome::short_arc : Circle_outcome::fitted;
  }

  void fit_section(const Tree_limb& limb, std::size_t i)
  {
    Section& section = m_sections[limb.slices[i]];
    const Vector3 u = section.direction.unitOrthogonal();
    const Vector3 v = section.direction.cross(u);
    const std::vector<Eigen::Vector2d> points = project(limb, i, u, v);
    section.outcome = Circle_outcome::few_points;
    const std::optional<Circle_fit> circle = points.size() < min_points ? std::nullopt : fit_circle(points);
    if (!circle) {
      return;
    }
    section.outcome = judge(*circle, limb);
    if (!section.is_circle()) {
      return;
    }
    if (limb.joint == no_index) {
      m_deviations.push_back(circle->deviation);
    }
    section.center = m_slices[limb.slices[i]].centroid + circle->center.x() * u + circle->center.y() * v;
    section.radius = circle->radius;
    const double accuracy = 1 - circle->deviation / circle->radius / max_deviation;
    const double coverage = circle->coverage / boost::math::double_constants::two_pi;
    const double number = std::min(1., double(points.size()) / wanted_points);
    section.confidence = std::max(min_confidence, accuracy * coverage * number * circle->inlier_part);
  }

  /// Centers are averaged with those around; without a circle, the center is the centroid.
  void place_centers(const Tree_limb& limb)
  {
    const std::size_t size = limb.slices.size();
    std::vector<Vector3> centers;
    for (std::size_t i = 0; i < size; ++i) {
      centers.push_back(section(limb, i).is_circle() ? section(limb, i).center : m_slices[limb.slices[i]].centroid);
    }
    for (std::size_t i = 0; i < size; ++i) {
      const bool is_end = i == 0 || i + 1 == size;
      section(limb, i).center = is_end ? centers[i] : centers[i] / 2 + (centers[i - 1] + centers[i + 1]) / 4;
    }
    for (std::size_t i = 0; i < size; ++i) {
      find_rough_radius(limb, i);
    }
  }

  /// Gives a section without a circle the radius of those around it, or of the scatter.
  void find_rough_radius(const Tree_limb& limb, std::size_t i)
  {
    Section& its_section = section(limb, i);
    its_section.is_rough = false;
    if (its_section.is_circle()) {
      return;
    }
    double radius = 0;
    double sum = 0;
    const auto [first, last] = window(limb, i, radius_reach);
    for (std::size_t j = first; j <= last; ++j) {
      const Section& other = section(limb, j);
      if (other.is_circle()) {
        radius += other.confidence * other.radius;
        sum += other.confidence;
      }
    }
    its_section.is_rough = sum == 0;
    its_section.radius = its_section.is_rough ? scatter_radius(limb.slices[i]) : radius / sum;
    its_section.confidence = min_confidence;
  }

  /// The scatter of the points of a slice around its center, across the limb, without the part of the noise.
  double scatter_radius(Index slice) const
  {
    const Section& section = m_sections[slice];
    double sum = 0;
    for (Index point : m_slices[slice].points) {
      sum += (m_points[point] - section.center).cross(section.direction).squaredNorm();
    }
    sum /= double(m_slices[slice].points.size());
    return std::sqrt(std::max(sum - 2 * m_noise * m_noise, min_part_of_scatter * sum));
  }

  /// The weighted least squares fit of radii that do not increase from base to tip.
  void smooth_radii(const Tree_limb& limb)
  {
    // Pools of adjacent violators, each with its mean.
    struct Pool
    {
      double sum;
      double weight;
      std::size_t size;
      double mean() const { return sum / weight; }
    };
    std::vector<Pool> pools;
    for (const Index slice : limb.slices) {
      const Section& section = m_sections[slice];
      if (!pools.empty() && section.is_rough && m_slices[slice].points.size() < min_scatter_points) {
        ++pools.back().size; // nothing is known of it
        continue;
      }
      pools.push_back({section.confidence * section.radius, section.confidence, 1});
      while (pools.size() > 1 && pools[pools.size() - 2].mean() <= pools.back().mean()) {
        const Pool last = pools.back();
        pools.pop_back();
        pools.back().sum += last.sum;
        pools.back().weight += last.weight;
        pools.back().size += last.size;
      }
    }
    std::size_t i = 0;
    for (const Pool& pool : pools) {
      for (std::size_t k = 0; k < pool.size; ++k) {
        double radius = pool.mean();
        if (limb.joint != no_index) {
          radius = std::min(radius, m_sections[limb.joint].radius);
        }
        m_sections[limb.slices[i++]].radius = radius;
      }
    }
  }

  const std::vector<Vector3>& m_points;
  const std::vector<Slice>& m_slices;
  std::vector<Section> m_sections;  // of every slice
  std::vector<double> m_deviations; // of the points from the circles of trunks
  double m_noise = 0;               // deviation of the points from the bark
};

} // namespace CSCD::internal

#endif // CSCD_SRC_TREE_SECTION_FITTING_H
