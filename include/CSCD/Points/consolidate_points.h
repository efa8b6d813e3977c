// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Thins point clouds to the points that a skeleton needs, and averages noise away.

#ifndef CSCD_POINTS_CONSOLIDATE_POINTS_H
#define CSCD_POINTS_CONSOLIDATE_POINTS_H

#include <CSCD/Points/Cloud_sampling.h>
#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// How far points deviate from quadrics that are fitted around some places, within a multiple of `radius`.
struct Cloud_probe
{
  double radius = 0;
  bool is_known = false; ///< whether there are points enough to tell
  double quartile = 0;   ///< what most places show
  double median = 0;
  double greatest = 0; ///< what the most bent places show: the quantile of 95 %
  double spread = 0;   ///< what noise alone makes of that, relative to what it makes of the median
};

/// Finds out how much a cloud can be thinned, and thins it.
class Point_consolidation
{
public:
  explicit Point_consolidation(Point_cloud&& cloud) : m_cloud(std::move(cloud)) {}

  Point_cloud operator()()
  {
    // By chance some are near each other; once the others are gone, they stand out.
    for (int round = 0; round < max_number_of_rounds && leave_out(outliers()); ++round) {
    }
    choose_radius();
    std::vector<Index> kept = thin(m_cloud.points, m_radius);
    if (double(kept.size()) > largest_part * double(m_cloud.points.size())) {
      return std::move(m_cloud);
    }
    std::vector<Vector3> points = reordered(m_cloud.points, kept);
    const bool is_averaged = m_noise > max_noise;
    if (is_averaged) {
      average(points);
      average(points);
      // Points that noise had spread through a layer are now in one place.
      const std::vector<Index> chosen = thin(points, averaged_spacing * m_radius);
      points = reordered(points, chosen);
      kept = reordered(kept, chosen);
    }
    const std::vector<Index> representative = nearest(points);
    Point_cloud result = make_cloud(std::move(points), kept, representative);
    result.is_averaged = is_averaged;
    return result;
  }

private:
  /// The numbers of points that are tried, from the first by factors of the root of two. Tubes of the thinnest limbs of
  /// animals have some ten points around with 10,000.
  static constexpr double least_number = 7000;
  static constexpr double greatest_number = 20000;
  /// A cloud is left as it is if more than this part of it would remain.
  static constexpr double largest_part = 0.6;
  /// The number of places that are probed, about.
  static constexpr std::size_t number_of_probes = 1000;
  /// How far quadrics reach at these places, in the unit of the radius: as far as the neighborhoods that triangles are
  /// chosen in.
  static constexpr double probe_reach = 3;
  /// The points of a quadric that show noise and bend, at least in the mean.
  static constexpr double points_of_a_probe = 14;
  /// More points of a quadric show nothing more.
  static constexpr double enough_neighbors = 80;
  /// The greatest deviation by bending, in the unit of the radius.
  static constexpr double max_bend = 0.25;
  /// Noise that hides no bend, in the unit of the least radius.
  static constexpr double negligible_noise = 0.1;
  /// The bend that is expected to remain where the radius shrinks by the root of two: that of animals.
  static constexpr double expected_bend = 0.7;
  /// Points are averaged if their noise in the unit of the radius exceeds this: about the bound of the triangulation.
  static constexpr double max_noise = 0.15;
  /// The mean of this many points has a sixth of their noise; more take time.
  static constexpr double averaged_points = 40;
  /// The points of the mean neighborhood that shows outliers.
  static constexpr double outlier_neighbors = 20;
  /// How often outliers are sought, if some are found.
  static constexpr int max_number_of_rounds = 3;
  /// A point is lonely if it has fewer neighbors than others by this factor.
  static constexpr double loneliness = 4;
  /// How far the neighborhood of an outlier reaches, relative to those of its neighbors.
  static constexpr double outlier_reach = 4;
  /// Deviation from a quadric, relative to the reach of the neighborhood, of points that fill space: points that are
  /// spread evenly in a box have about 0.25.
  static constexpr double deviation_in_space = 0.12;
  /// Lonely points are outliers if the median of their deviations exceeds this. With 0.5 % of stray points around a
  /// surface, it is about 0.1; on sparse parts of a surface, it is at most 0.07.
  static constexpr double outlier_deviation = 0.08;
  /// It must also exceed the median deviation of the other points by this factor: noise deviates everywhere.
  static constexpr double outlier_excess = 3;
  /// Fewer lonely points do not show whether they fill space.
  static constexpr std::size_t least_number_of_outliers = 5;
  /// In a large cloud, some points are tried first; all lonely points are sought if more than this part of these is
  /// lonely.
  static constexpr double part_of_few = 0.002;
  /// The points among which the neighbors of lonely points are sought, about.
  static constexpr std::size_t sample_around_outliers = 50000;
  /// How near to each other averaged points may be, relative to the radius.
  static constexpr double averaged_spacing = 0.9;
  /// The radius that leaves `number` points, about.
  double radius_of(double number) const { return std::sqrt(packing_density * m_area / number); }

  /// The number of points of the sample within `radius` of those at `places`.
  std::vector<Index> numbers_around(const std::vector<Index>& places, double radius) const
  {
    Point_grid grid(radius);
    for (Index place : places) {
      grid.insert(m_cloud.points[place]);
    }
    std::vector<Index> result(places.size(), 0);
    for (std::size_t point = 0; point < m_cloud.points.size(); point += sample_step()) {
      grid.for_each_near(m_cloud.points[point], [&](Index i, double) { ++result[i]; });
    }
    return result;
  }

  /// Of large clouds, outliers are seen by the neighbors in a sample.
  std::size_t sample_step() const { return std::max<std::size_t>(1, m_cloud.points.size() / sample_around_outliers); }

  /// Every so many of the points, and those that are outermost along the axes of the canonical pose.
  std::vector<Index> some_points() const
  {
    const std::vector<Vector3>& points = m_cloud.points;
    std::vector<Index> result;
    const std::size_t step = std::max<std::size_t>(1, points.size() / number_of_probes);
    for (std::size_t point = 0; point < points.size(); point += step) {
      result.push_back(Index(point));
    }
    for (int axis = 0; axis < 3; ++axis) {
      const auto [least, greatest] =
          std::minmax_element(points.begin(), points.end(), [&](const Vector3& a, const Vector3& b) {
            return m_cloud.pose(a)[axis] < m_cloud.pose(b)[axis];
          });
      result.push_back(Index(least - points.begin()));
      result.push_back(Index(greatest - points.begin()));
    }
    return result;
  }

  /// Points that have far fewer others around than most: all, or if they are few in a large cloud, those of a sample.
  std::vector<Index> lonely_points() const
  {
    constexpr int max_number_of_trials = 10; // of radii; stops the search where no radius has the median
    const std::vector<Index> places = some_points();
    double radius = std::sqrt(outlier_neighbors * estimate_area(m_cloud.points) * double(sample_step()) /
                              (3 * double(m_cloud.points.size())));
    double median = 0;
    for (int i = 0; i < max_number_of_trials; ++i) {
      const std::vector<Index> around = numbers_around(places, radius);
      median = quantile({around.begin(), around.end()}, 0.5);
      if (median > outlier_neighbors / 1.3 && median < outlier_neighbors * 1.3) {
        break;
      }
      radius *= std::sqrt(outlier_neighbors / median);
    }
    const auto lonely_of = [&](const std::vector<Index>& points) {
      const std::vector<Index> around = numbers_around(points, radius);
      std::vector<Index> lonely;
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (double(around[i]) * loneliness < median) {
          lonely.push_back(points[i]);
        }
      }
      return lonely;
    };
    std::vector<Index> result = lonely_of(places);
    const bool are_few = double(result.size()) <= part_of_few * double(places.size());
    if (!result.empty() && (!are_few || m_cloud.points.size() <= sample_around_outliers)) {
      result = lonely_of(all_indices(m_cloud.points.size()));
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  /// The points that are far from all others, or spread in space, and not on a sparse part of the surface.
  std::vector<Index> outliers()
  {
    std::vector<Index> lonely = lonely_points();
    if (lonely.empty() || 2 * lonely.size() > m_cloud.points.size()) {
      return {};
    }
    // The lonely points come first.
    std::vector<Vector3> points = reordered(m_cloud.points, lonely);
    std::vector<char> is_lonely(m_cloud.points.size(), 0);
    for (Index point : lonely) {
      is_lonely[point] = 1;
    }
    for (std::size_t point = 0; point < m_cloud.points.size(); point += sample_step()) {
      if (is_lonely[point] == 0) {
        points.push_back(m_cloud.points[point]);
      }
    }
    const Neighbor_table neighbors(points, quadric_neighbors);
    const auto median_deviation = [&](Index begin, Index end) {
      std::vector<double> deviations;
      const Index step = std::max<Index>(1, (end - begin) / Index(number_of_probes));
      for (Index i = begin; i < end; i += step) {
        const double reach = neighbors.reach(i);
        const double deviation = fit_quadric(points, i, neighbors.neighbors(i), reach).deviation;
        deviations.push_back(reach > 0 ? deviation / reach : 0);
      }
      return quantile(std::move(deviations), 0.5);
    };
    const auto number_of_lonely = Index(lonely.size());
    const double deviation = median_deviation(0, number_of_lonely);
    m_is_space_filled =
        m_is_space_filled || (lonely.size() >= least_number_of_outliers && deviation > outlier_deviation &&
                              deviation > outlier_excess * median_deviation(number_of_lonely, Index(points.size())));
    if (m_is_space_filled) {
      return lonely;
    }
    std::vector<Index> result;
    for (Index i = 0; i < lonely.size(); ++i) {
      std::vector<double> reaches;
      for (const Index neighbor : neighbors.neighbors(i)) {
        reaches.push_back(neighbors.reach(neighbor));
      }
      if (neighbors.reach(i) > outlier_reach * quantile(std::move(reaches), 0.5)) {
        result.push_back(lonely[i]);
      }
    }
    return result;
  }

  /// Takes `left_out` from the cloud; they belong to the nearest of the others. \return whether there were any
  bool leave_out(const std::vector<Index>& left_out)
  {
    if (left_out.empty()) {
      return false;
    }
    std::vector<Index> representative(m_cloud.points.size(), 0);
    for (const Index point : left_out) {
      representative[point] = no_index;
    }
    std::vector<Index> kept;
    for (Index point = 0; point < representative.size(); ++point) {
      if (representative[point] != no_index) {
        representative[point] = Index(kept.size());
        kept.push_back(point);
      }
    }
    assign_to_nearest(m_cloud.points, representative);
    m_cloud = make_cloud(reordered(m_cloud.points, kept), kept, representative);
    m_cloud.number_of_outliers += left_out.size();
    return true;
  }

  /// Takes the greatest radius at which the surface is hardly bent.
  void choose_radius()
  {
    m_area = estimate_area(m_cloud.points);
    std::vector<Cloud_probe> probes;
    // Where walls are thin, the greater radii reach through them at most places, and only small ones show the noise;
    // but within less than a few times the noise, points fill space.
    double noise = std::numeric_limits<double>::infinity();
    const double least_noise = negligible_noise * radius_of(greatest_number);
    bool is_known = true;
    for (double number = least_number; number <= greatest_number || (is_known && noise > least_noise);
         number *= std::sqrt(2.)) {
      const Cloud_probe at = probe(radius_of(number));
      is_known = at.is_known;
      if (is_known && at.median < deviation_in_space * probe_reach * at.radius) {
        noise = std::min(noise, at.median);
      }
      if (number <= greatest_number) {
        probes.push_back(at);
      }
    }
    double bend = 0;
    for (const Cloud_probe& at : probes) {
      m_radius = at.radius;
      m_noise = at.is_known ? at.quartile / m_radius : m_noise * std::sqrt(2.);
      const double by_noise = at.spread * noise;
      const double own_bend = std::sqrt(std::max(0., at.greatest * at.greatest - by_noise * by_noise)) / m_radius;
      bend = std::max(at.is_known ? own_bend : 0, expected_bend * bend); // where points are few, chance hides it
      if (bend <= max_bend) {
        break;
      }
    }
  }

  /// The step that leaves about `number` points of the cloud in a ball around a point of the surface.
  std::size_t step_for(double number, double radius) const
  {
    const double in_ball = 3 * radius * radius / m_area * double(m_cloud.points.size()); // 3 for pi
    return std::max<std::size_t>(1, std::size_t(in_ball / number));
  }

  /// Fits quadrics within `probe_reach` times `radius`.
  Cloud_probe probe(double radius) const
  {
    const std::vector<Vector3>& points = m_cloud.points;
    const double reach = probe_reach * radius;
    const std::size_t step = std::max<std::size_t>(1, points.size() / number_of_probes);
    Point_grid grid(reach);
    std::vector<Index> centers;
    for (std::size_t point = 0; point < points.size(); point += step) {
      grid.insert(points[point]);
      centers.push_back(Index(point));
    }
    std::vector<std::vector<Index>> neighborhoods(centers.size());
    std::size_t number_of_neighbors = 0;
    for (std::size_t point = 0; point < points.size(); point += step_for(enough_neighbors, reach)) {
      grid.for_each_near(points[point], [&](Index place, double) {
        if (centers[place] != point) {
          neighborhoods[place].push_back(Index(point));
          ++number_of_neighbors;
        }
      });
    }
    std::vector<double> deviations;
    for (Index place = 0; place < centers.size(); ++place) {
      const std::vector<Index>& around = neighborhoods[place];
      const double deviation =
          fit_quadric(points, centers[place], {around.data(), around.data() + around.size()}, reach).deviation;
      if (deviation > 0) {
        deviations.push_back(deviation);
      }
    }
    if (deviations.empty() || double(number_of_neighbors) < points_of_a_probe * double(centers.size())) {
      return {radius};
    }
    // Deviations by noise spread as estimates of a standard deviation do: 95 % are below the mean and 1.65 of their own
    // standard deviations. Somewhat more, as noise is not the same everywhere.
    constexpr double parameters_of_a_quadric = 6;
    const double freedom = double(number_of_neighbors) / double(centers.size()) - parameters_of_a_quadric;
    return {radius,
            true,
            quantile(deviations, 0.25),
            quantile(deviations, 0.5),
            quantile(deviations, 0.95),
            1.04 + 1.9 / std::sqrt(2 * freedom)};
  }

  /// Moves `points` to the means of the points of the cloud within the radius.
  void average(std::vector<Vector3>& points) const
  {
    const Point_grid grid(m_radius, points);
    std::vector<Vector3> sum(points.size(), Vector3::Zero());
    std::vector<double> number(points.size(), 0);
    const std::size_t step = step_for(averaged_points, m_radius);
    for (std::size_t point = 0; point < m_cloud.points.size(); point += step) {
      grid.for_each_near(m_cloud.points[point], [&](Index i, double) {
        sum[i] += m_cloud.points[point];
        number[i] += 1;
      });
    }
    for (Index i = 0; i < points.size(); ++i) {
      points[i] = number[i] > 0 ? Vector3(sum[i] / number[i]) : points[i];
    }
  }

  /// For every point of the cloud the nearest of `points`.
  std::vector<Index> nearest(const std::vector<Vector3>& points) const
  {
    const Point_grid grid(m_radius, points);
    std::optional<Point_tree> tree; // if averaged points have moved out of the radius
    std::vector<Index> result;
    result.reserve(m_cloud.points.size());
    for (const Vector3& point : m_cloud.points) {
      std::pair<double, Index> least{std::numeric_limits<double>::max(), no_index};
      grid.for_each_near(point, [&](Index i, double squared_distance) {
        least = std::min(least, {squared_distance, i});
      });
      if (least.second == no_index && !tree) {
        tree.emplace(points);
      }
      result.push_back(least.second == no_index ? tree->nearest(point) : least.second);
    }
    return result;
  }

  /// \param kept for every one of `points`, the point of the cloud that it came from
  /// \param representative for every point of the cloud, the number of one in `points`
  Point_cloud make_cloud(std::vector<Vector3>&& points, const std::vector<Index>& kept,
                         const std::vector<Index>& representative) const
  {
    Point_cloud result;
    result.normalization = m_cloud.normalization.then(normalize_extent(points));
    put_in_order(points, reordered(m_cloud.normals, kept), result);
    const std::vector<Index> new_point = std::move(result.input_point);
    result.input_point.reserve(m_cloud.input_point.size());
    for (Index point : m_cloud.input_point) {
      result.input_point.push_back(new_point[representative[point]]);
    }
    result.number_of_thinned_points = m_cloud.number_of_thinned_points + m_cloud.points.size() - result.points.size();
    result.number_of_outliers = m_cloud.number_of_outliers;
    return result;
  }

  Point_cloud m_cloud;
  bool m_is_space_filled = false; // by outliers
  double m_area = 0;
  double m_radius = 0;
  double m_noise = 0;
};

/// Leaves out outliers of `cloud`: points that have far fewer others around than most have, if they fill space, as
/// stray points do and sparse parts of a surface do not, or are far from their neighbors. Then thins it to as few
/// points as show its limbs: no two are nearer to each other than a radius, and no point of the cloud is farther than
/// that from one of them, which stands for it. The radius is the largest, of those for about 7,000, 10,000, 14,000 and
/// 20,000 points, at which the surface within twice the radius is nearly flat in 95 of 100 places. If points deviate
/// much from the surface, relative to the radius, those that are kept are moved to the mean of the points around them,
/// twice. A cloud that is hardly denser than that, and has no outliers, is returned unchanged. Does not depend on the
/// order of the input. O(n) in expectation without outliers.
inline Point_cloud consolidate_points(Point_cloud&& cloud)
{
  return Point_consolidation(std::move(cloud))();
}

} // namespace CSCD::internal

#endif // CSCD_POINTS_CONSOLIDATE_POINTS_H
