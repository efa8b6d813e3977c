// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a skeleton lies in the body.

#ifndef CSCD_SRC_MEASURE_POSITION_MEASUREMENT_H
#define CSCD_SRC_MEASURE_POSITION_MEASUREMENT_H

#include <CSCD/Measure/Skeleton_measures.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Vector_3.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CSCD::internal {

/// A point of a skeleton, and the unit direction of its edge.
struct Edge_sample
{
  Vector_3 point = Vector_3::Zero();
  Vector_3 tangent = Vector_3::Zero();
};

/// Samples the edges of `skeleton` evenly: they are laid end to end in their order, and every piece of length `spacing`
/// gets a sample at its middle. So each sample stands for the same length, however the skeleton is cut into edges.
/// O(e + l / spacing) for e edges of total length l.
/// \pre `spacing` is positive
inline std::vector<Edge_sample> sample_edges(const Skeleton& skeleton, double spacing)
{
  std::vector<Edge_sample> samples;
  double to_next = spacing / 2;
  for (const std::array<Index, 2>& edge : skeleton.edges) {
    const double length = skeleton.length(edge);
    if (!(length > 0)) {
      continue;
    }
    const Vector_3& source = skeleton.points[edge[0]];
    const Vector_3 tangent = (skeleton.points[edge[1]] - source) / length;
    while (to_next <= length) {
      samples.push_back({source + to_next * tangent, tangent});
      to_next += spacing;
    }
    to_next -= length;
  }
  return samples;
}

/// The distance at which samples of the edges of `skeleton` are at least `spacing` apart, and no more than
/// `max_number`. \pre `spacing` is positive
inline double bounded_spacing(const Skeleton& skeleton, double spacing, std::size_t max_number)
{
  double length = 0;
  for (const std::array<Index, 2>& edge : skeleton.edges) {
    length += skeleton.length(edge);
  }
  return std::max(spacing, length / double(max_number));
}

/// What is measured by rays from a point across a skeleton.
struct Ray_star
{
  double deviation = 0; ///< standard deviation of the rays' lengths over their mean
  double offset = 0;    ///< length of the mean of the rays as vectors, over their mean length
};

/// Casts rays from `point`, evenly spread in the plane across `tangent`, to where they first meet the surface.
/// \return nothing if less than half of them meet it
/// \pre `tangent` has unit length
inline std::optional<Ray_star> cast_ray_star(const Solid_queries& queries, const Vector_3& point,
                                             const Vector_3& tangent)
{
  constexpr int number_of_rays = 32; // twice as many change means over a skeleton by less than one percent
  const Vector_3 u = tangent.unitOrthogonal();
  const Vector_3 v = tangent.cross(u);
  double sum = 0;
  double sum_of_squares = 0;
  Vector_3 moment = Vector_3::Zero();
  int number_of_hits = 0;
  for (int i = 0; i < number_of_rays; ++i) {
    const double angle = boost::math::double_constants::two_pi * i / number_of_rays;
    const Vector_3 direction = std::cos(angle) * u + std::sin(angle) * v;
    if (const std::optional<Surface_hit> hit = queries.first_hit(point, direction)) {
      sum += hit->distance;
      sum_of_squares += hit->distance * hit->distance;
      moment += hit->distance * direction;
      ++number_of_hits;
    }
  }
  if (2 * number_of_hits < number_of_rays || !(sum > 0)) {
    return std::nullopt;
  }
  const double mean = sum / number_of_hits;
  const double variance = std::max(sum_of_squares / number_of_hits - mean * mean, 0.);
  return Ray_star{std::sqrt(variance) / mean, moment.norm() / sum};
}

/// Measures a skeleton against a body in whose coordinates it is given.
class Position_measurement
{
public:
  /// Both are referred to.
  Position_measurement(const Solid_queries& queries, const Skeleton& skeleton)
      : m_queries(queries), m_skeleton(skeleton)
  {
    m_result.max_distance_outside = 0;
  }

  /// All but what is known of the surface alone.
  Position_measures operator()()
  {
    measure_nodes();
    measure_length();
    return m_result;
  }

private:
  /// Means over the stars that could be cast.
  struct Means
  {
    double deviation = 0, offset = 0;
    std::size_t number = 0;

    void add(const std::optional<Ray_star>& star)
    {
      if (star) {
        deviation += star->deviation;
        offset += star->offset;
        ++number;
      }
    }
    double mean(double sum) const { return number > 0 ? sum / double(number) : undefined_measure; }
  };

  bool is_inside(const Vector_3& point)
  {
    if (m_queries.is_inside(point)) {
      return true;
    }
    const double distance = (m_queries.closest_point(point).point - point).norm();
    m_result.max_distance_outside = std::max(m_result.max_distance_outside, distance);
    return false;
  }

  /// The direction of the skeleton at a node of one or two edges; nothing at others and where it turns back.
  std::optional<Vector_3> tangent(Index v, const std::vector<Index>& neighbors) const
  {
    // Of the sum of two unit vectors: the angle, in radians, by which they differ from opposite ones.
    constexpr double min_norm = 1e-6;
    if (neighbors.empty() || neighbors.size() > 2) {
      return std::nullopt;
    }
    Vector_3 result = (m_skeleton.points[neighbors[0]] - m_skeleton.points[v]).stableNormalized();
    if (neighbors.size() == 2) {
      result -= (m_skeleton.points[neighbors[1]] - m_skeleton.points[v]).stableNormalized();
    }
    return result.norm() > min_norm ? std::optional<Vector_3>(result.normalized()) : std::nullopt;
  }

  void measure_nodes()
  {
    const std::vector<std::vector<Index>> neighbors = node_neighbors(m_skeleton);
    std::size_t number_inside = 0;
    Means means;
    const std::size_t step = neighbors.size() / max_number_of_stars + 1; // between the nodes from which rays are cast
    for (Index v = 0; v < neighbors.size(); ++v) {
      if (!is_inside(m_skeleton.points[v])) {
        continue;
      }
      ++number_inside;
      if (v % step != 0) {
        continue;
      }
      if (const std::optional<Vector_3> direction = tangent(v, neighbors[v])) {
        means.add(cast_ray_star(m_queries, m_skeleton.points[v], *direction));
      }
    }
    m_result.fraction_of_nodes_inside = double(number_inside) / double(neighbors.size());
    m_result.deviation_at_nodes = means.mean(means.deviation);
    m_result.offset_at_nodes = means.mean(means.offset);
  }

  void measure_length()
  {
    constexpr double spacing = 1. / 300; // of the samples, in diagonals: some ten of them in the radius of a thin limb
    const std::vector<Edge_sample> samples =
        sample_edges(m_skeleton, bounded_spacing(m_skeleton, spacing, max_number_of_stars));
    std::size_t number_inside = 0;
    Means means;
    for (const Edge_sample& sample : samples) {
      if (is_inside(sample.point)) {
        ++number_inside;
        means.add(cast_ray_star(m_queries, sample.point, sample.tangent));
      }
    }
    if (!samples.empty()) {
      m_result.fraction_of_length_inside = double(number_inside) / double(samples.size());
    }
    m_result.deviation_by_length = means.mean(means.deviation);
    m_result.offset_by_length = means.mean(means.offset);
  }

  /// Means over more would be no better, and take minutes. Skeletons of bodies have fewer nodes and samples.
  static constexpr std::size_t max_number_of_stars = 1 << 16;

  const Solid_queries& m_queries;
  const Skeleton& m_skeleton;
  Position_measures m_result;
};

} // namespace CSCD::internal

#endif // CSCD_SRC_MEASURE_POSITION_MEASUREMENT_H
