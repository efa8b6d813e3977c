// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of consolidate_points.h.

#ifndef CSCD_RECONSTRUCTION_CONSOLIDATE_POINTS_IMPL_H
#define CSCD_RECONSTRUCTION_CONSOLIDATE_POINTS_IMPL_H

#include <CSCD/Reconstruction/Point_grid.h>
#include <CSCD/Reconstruction/consolidate_points.h>
#include <CSCD/Surface/Cloud_sampling.h>
#include <CSCD/Surface/Neighbor_table.h>
#include <CSCD/Surface/Point_cloud.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Those of `points`, in their order, that are farther than `radius` from all that were chosen before.
/// \param step only every so many of the points are looked at
inline std::vector<Index> thin(const std::vector<Vector_3>& points, double radius, std::size_t step = 1)
{
  std::vector<Index> result;
  Point_grid grid(radius);
  for (std::size_t point = 0; point < points.size(); point += step) {
    bool is_free = true;
    grid.for_each_near(points[point], [&](Index, double) { is_free = false; });
    if (is_free) {
      grid.insert(points[point]);
      result.push_back(Index(point));
    }
  }
  return result;
}

/// How far points deviate from quadrics that are fitted within twice a radius, relative to the radius, at some places.
struct Cloud_probe
{
  double noise = 0;     ///< what most places show: the lower quartile
  double bend = 0;      ///< what the most bent places show beyond noise: the quantile of 95 %
  bool is_known = true; ///< whether there are points enough to tell
};

/// Finds out how much a cloud can be thinned, and thins it.
class Point_consolidation
{
public:
  explicit Point_consolidation(Point_cloud&& cloud) : m_cloud(std::move(cloud)) {}

  Point_cloud operator()()
  {
    choose_radius();
    std::vector<Index> kept = thin(m_cloud.points, m_radius);
    if (double(kept.size()) > largest_part * double(m_cloud.points.size())) {
      return std::move(m_cloud);
    }
    std::vector<Vector_3> points;
    for (Index point : kept) {
      points.push_back(m_cloud.points[point]);
    }
    const bool is_averaged = m_noise > max_noise;
    if (is_averaged) {
      average(points);
      average(points);
      // What noise had spread through a layer is now in one place.
      const std::vector<Index> chosen = thin(points, averaged_spacing * m_radius);
      for (Index i = 0; i < chosen.size(); ++i) {
        points[i] = points[chosen[i]];
        kept[i] = kept[chosen[i]];
      }
      points.resize(chosen.size());
      kept.resize(chosen.size());
    }
    return make_cloud(std::move(points), kept, is_averaged);
  }

private:
  /// The numbers of points that are tried, from the first by factors of the root of two. Tubes of the thinnest limbs of
  /// animals have some ten points around with 10,000.
  static constexpr double least_number = 7000;
  static constexpr double greatest_number = 20000;
  /// The number of points that are no nearer to each other than a radius, times its square, relative to the area: that
  /// of a random sequential choice.
  static constexpr double packing_density = 0.69;
  /// A cloud of which more than this would remain is left as it is.
  static constexpr double largest_part = 0.6;
  /// The number of places that are probed, about.
  static constexpr std::size_t number_of_probes = 1000;
  /// The points within twice the radius that show noise and bend, at least in the mean.
  static constexpr double points_of_a_probe = 14;
  /// More points within twice the radius show nothing more.
  static constexpr double enough_neighbors = 80;
  /// The greatest deviation by bending, in the unit of the radius.
  static constexpr double max_bend = 0.15;
  /// The bend that is expected to remain where the radius shrinks by the root of two: that of animals.
  static constexpr double expected_bend = 0.7;
  /// Noise from which on points are averaged, in the unit of the radius: about that of Cloud_sampling.
  static constexpr double max_noise = 0.15;
  /// Noise in the unit of the radius that is too large for an average over the radius.
  static constexpr double excessive_noise = 0.45;
  /// The number of points to which excessive noise may thin a cloud.
  static constexpr double number_in_noise = 2000;
  /// How near to each other averaged points may be, relative to the radius.
  static constexpr double averaged_spacing = 0.9;
  /// The number of points of which the area is estimated.
  static constexpr double number_of_the_area = 2000;
  /// The points from which it is estimated, about.
  static constexpr std::size_t sample_of_the_area = 50000;

  /// The radius by which `number` points remain, about.
  double radius_of(double number) const { return std::sqrt(packing_density * m_area / number); }

  /// Estimates the area as that of a covering by few balls: noise that is less than their radius, and points that are
  /// far away, hardly count.
  void estimate_area()
  {
    constexpr int max_number_of_trials = 40;
    const double target = std::min(number_of_the_area, double(m_cloud.points.size()) / 4);
    const std::size_t step = std::max<std::size_t>(1, m_cloud.points.size() / sample_of_the_area);
    double radius = 0.05; // of a cube with sides of 2
    for (int i = 0; i < max_number_of_trials; ++i) {
      const auto number = double(thin(m_cloud.points, radius, step).size());
      m_area = number * radius * radius / packing_density;
      if (number > target / 1.5 && number < target * 1.5) {
        return;
      }
      radius *= std::sqrt(number / target);
    }
  }

  void choose_radius()
  {
    estimate_area();
    double number = least_number;
    m_radius = radius_of(number);
    Cloud_probe result = probe();
    m_noise = result.noise;
    while (result.is_known && result.noise > excessive_noise && number > number_in_noise) {
      number /= std::sqrt(2.);
      m_radius = radius_of(number);
      result = probe();
      m_noise = result.noise;
    }
    double bend = result.bend;
    while (bend > max_bend && number < greatest_number) {
      number = std::min(greatest_number, std::sqrt(2.) * number);
      m_radius = radius_of(number);
      result = probe();
      m_noise = result.is_known ? result.noise : m_noise * std::sqrt(2.);
      bend = std::max(result.bend, expected_bend * bend); // where points are few, chance hides it
    }
  }

  /// Fits quadrics within twice the radius.
  Cloud_probe probe() const
  {
    const std::vector<Vector_3>& points = m_cloud.points;
    const std::size_t step = std::max<std::size_t>(1, points.size() / number_of_probes);
    Point_grid grid(2 * m_radius);
    std::vector<Index> centers;
    for (std::size_t point = 0; point < points.size(); point += step) {
      grid.insert(points[point]);
      centers.push_back(Index(point));
    }
    std::vector<std::vector<Index>> neighborhoods(centers.size());
    std::size_t number_of_neighbors = 0;
    // The ball has about 12 r^2 of the area.
    const double expected_neighbors = 12 * m_radius * m_radius / m_area * double(points.size());
    const std::size_t stride = std::max<std::size_t>(1, std::size_t(expected_neighbors / enough_neighbors));
    for (std::size_t point = 0; point < points.size(); point += stride) {
      grid.for_each_near(points[point], [&](Index place, double) {
        if (centers[place] != point) {
          neighborhoods[place].push_back(Index(point));
          ++number_of_neighbors;
        }
      });
    }
    std::vector<double> deviations;
    for (Index place = 0; place < centers.size(); ++place) {
      const double deviation = fit_quadric(points, centers[place], neighborhoods[place], 2 * m_radius).deviation;
      if (deviation > 0) {
        deviations.push_back(deviation / m_radius);
      }
    }
    if (deviations.empty() || double(number_of_neighbors) < points_of_a_probe * double(centers.size())) {
      return {0, 0, false};
    }
    // Deviations by noise spread as estimates of a standard deviation do: 95 % are below the mean and 1.65 of their own
    // standard deviations. Somewhat more, as noise is not the same everywhere.
    constexpr double parameters_of_a_quadric = 6;
    const double freedom = double(number_of_neighbors) / double(centers.size()) - parameters_of_a_quadric;
    const double by_noise = quantile(deviations, 0.5) * (1.04 + 1.9 / std::sqrt(2 * freedom));
    const double greatest = quantile(deviations, 0.95);
    return {quantile(deviations, 0.25), std::sqrt(std::max(0., greatest * greatest - by_noise * by_noise)), true};
  }

  /// Moves `points` to the means of the points of the cloud within the radius.
  void average(std::vector<Vector_3>& points) const
  {
    const Point_grid grid(m_radius, points);
    std::vector<Vector_3> sum(points.size(), Vector_3::Zero());
    std::vector<double> number(points.size(), 0);
    for (const Vector_3& point : m_cloud.points) {
      grid.for_each_near(point, [&](Index i, double) {
        sum[i] += point;
        number[i] += 1;
      });
    }
    for (Index i = 0; i < points.size(); ++i) {
      points[i] = number[i] > 0 ? Vector_3(sum[i] / number[i]) : points[i];
    }
  }

  /// For every point of the cloud the nearest of `points`.
  std::vector<Index> nearest(const std::vector<Vector_3>& points) const
  {
    const Point_grid grid(2 * m_radius, points); // wider than the radius: points may have moved
    std::vector<Index> result(m_cloud.points.size(), no_index);
    bool are_all_found = true;
    for (Index point = 0; point < result.size(); ++point) {
      double least = std::numeric_limits<double>::max();
      grid.for_each_near(m_cloud.points[point], [&](Index i, double squared_distance) {
        if (squared_distance < least || (squared_distance == least && i < result[point])) {
          least = squared_distance;
          result[point] = i;
        }
      });
      are_all_found = are_all_found && result[point] != no_index;
    }
    if (!are_all_found) {
      const Point_tree tree(points);
      for (Index point = 0; point < result.size(); ++point) {
        result[point] = result[point] == no_index ? tree.nearest(m_cloud.points[point]) : result[point];
      }
    }
    return result;
  }

  /// \param kept for every one of `points`, of which of the cloud it came
  Point_cloud make_cloud(std::vector<Vector_3>&& points, const std::vector<Index>& kept, bool is_averaged) const
  {
    const std::vector<Index> representative = nearest(points);
    std::vector<Vector_3> normals;
    if (!m_cloud.normals.empty()) {
      for (Index point : kept) {
        normals.push_back(m_cloud.normals[point]);
      }
    }
    Point_cloud result;
    merge_and_sort(std::move(points), std::move(normals), result);
    sort_canonically(result);
    const std::vector<Index> new_point = std::move(result.input_point);
    result.input_point.reserve(m_cloud.input_point.size());
    for (Index point : m_cloud.input_point) {
      result.input_point.push_back(new_point[representative[point]]);
    }
    result.normalization = m_cloud.normalization;
    result.number_of_thinned_points = m_cloud.points.size() - result.points.size();
    result.is_averaged = is_averaged;
    return result;
  }

  Point_cloud m_cloud;
  double m_area = 0;
  double m_radius = 0;
  double m_noise = 0;
};

CSCD_INLINE Point_cloud consolidate_points(Point_cloud&& cloud)
{
  return Point_consolidation(std::move(cloud))();
}

} // namespace CSCD::internal

#endif // CSCD_RECONSTRUCTION_CONSOLIDATE_POINTS_IMPL_H
