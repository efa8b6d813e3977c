// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a point is from a segment, and from the skeleton around a node.

#ifndef CSCD_MEASURE_DISTANCE_TO_EDGES_H
#define CSCD_MEASURE_DISTANCE_TO_EDGES_H

#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Vector3.h>

#include <algorithm>
#include <vector>

namespace CSCD::internal {

/// Where on the segment between two points the point nearest to `point` is: 0 at the source, 1 at the target.
inline double nearest_parameter(const Vector3& point, const Vector3& source, const Vector3& target)
{
  const Vector3 along = target - source;
  const double squared_length = along.squaredNorm();
  return squared_length > 0 ? std::clamp((point - source).dot(along) / squared_length, 0., 1.) : 0;
}

/// The distance of `point` from the segment between two points.
inline double distance_to_segment(const Vector3& point, const Vector3& source, const Vector3& target)
{
  return (source + nearest_parameter(point, source, target) * (target - source) - point).norm();
}

/// The distance of `point` from `node` and the edges there. \param neighbors as `node_neighbors()` gives them
inline double distance_to_edges(const Skeleton& skeleton, const std::vector<std::vector<Index>>& neighbors, Index node,
                                const Vector3& point)
{
  double distance = (point - skeleton.points[node]).norm();
  for (const Index neighbor : neighbors[node]) {
    distance = std::min(distance, distance_to_segment(point, skeleton.points[node], skeleton.points[neighbor]));
  }
  return distance;
}

} // namespace CSCD::internal

#endif // CSCD_MEASURE_DISTANCE_TO_EDGES_H
