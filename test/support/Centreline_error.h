// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The distance of a skeleton from a known centerline, and of the centerline from the skeleton.

#ifndef CSCD_TEST_SUPPORT_CENTRELINE_ERROR_H
#define CSCD_TEST_SUPPORT_CENTRELINE_ERROR_H

#include "Shape.h"
#include "convert_shape.h"

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CSCD::test {

/// Distances in units of the body's radius at the nearest point of its centreline.
struct Centreline_error
{
  double mean_of_nodes = 0; ///< distance of a node from the centreline
  double max_of_nodes = 0;  ///< the largest of these
  double max_gap = 0;       ///< distance from a point of the centreline to the skeleton
  double max_of_radii = 0;  ///< error of the radius at nodes of degree 2, relative to the true one
};

namespace internal {

/// The segments of a skeleton; a node without edges counts as a segment without length.
template <class Skeleton>
std::vector<Centreline_segment> segments_of(const Skeleton& skeleton)
{
  std::vector<Centreline_segment> segments;
  const auto range = edges(skeleton);
  for (auto e = range.first; e != range.second; ++e) {
    segments.push_back(
        {to_triple(skeleton[source(*e, skeleton)].point), to_triple(skeleton[target(*e, skeleton)].point), 0, 0});
  }
  for (std::size_t v = 0; v < num_vertices(skeleton); ++v) {
    if (degree(v, skeleton) == 0) {
      const Triple p = to_triple(skeleton[v].point);
      segments.push_back({p, p, 0, 0});
    }
  }
  return segments;
}

inline const Centreline_segment& nearest_segment(const std::vector<Centreline_segment>& segments, const Triple& p)
{
  return *std::min_element(segments.begin(), segments.end(),
                           [&](const auto& a, const auto& b) { return distance(a, p) < distance(b, p); });
}

} // namespace internal

/// \pre the centreline of `shape` is known and `skeleton` has nodes, which carry a radius
template <class Skeleton>
Centreline_error centreline_error(const Shape& shape, const Skeleton& skeleton)
{
  Centreline_error error;
  for (std::size_t v = 0; v < num_vertices(skeleton); ++v) {
    const Triple p = to_triple(skeleton[v].point);
    const Centreline_segment& nearest = internal::nearest_segment(shape.centreline, p);
    const double true_radius = radius_near(nearest, p);
    const double relative_distance = distance(nearest, p) / true_radius;
    error.mean_of_nodes += relative_distance / static_cast<double>(num_vertices(skeleton));
    error.max_of_nodes = std::max(error.max_of_nodes, relative_distance);
    if (degree(v, skeleton) == 2) {
      error.max_of_radii = std::max(error.max_of_radii, std::fabs(skeleton[v].radius - true_radius) / true_radius);
    }
  }
  const std::vector<Centreline_segment> segments = internal::segments_of(skeleton);
  for (const Centreline_segment& piece : shape.centreline) {
    const std::size_t number_of_samples = 20;
    for (std::size_t i = 0; i <= number_of_samples; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(number_of_samples);
      const Triple p = (1 - t) * piece.source + t * piece.target;
      const double gap = distance(internal::nearest_segment(segments, p), p) / radius_near(piece, p);
      error.max_gap = std::max(error.max_gap, gap);
    }
  }
  return error;
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_CENTRELINE_ERROR_H
