// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances between two skeletons, and their features at the same place.

#include "Measure/skeleton_tools.h"
#include <CSCD/Measure/compare_skeletons.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/Box_tree.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {
namespace {

/// Matches points that are not farther apart than `match_distance`, each at most once: the nearest first, on ties those
/// of least numbers. \throw Input_error if too many are near each other
Match_count match(const std::vector<Vector3>& first, const std::vector<Vector3>& second, double match_distance)
{
  constexpr std::size_t most = std::size_t(1) << 22; // some seconds; skeletons of bodies have some thousand
  std::vector<Bounding_box> boxes(second.size());
  for (std::size_t j = 0; j < second.size(); ++j) {
    boxes[j].extend(second[j]);
  }
  const Box_tree tree(boxes);
  std::vector<std::tuple<double, Index, Index>> pairs;
  for (Index i = 0; i < first.size(); ++i) {
    const auto is_near = [&](const Bounding_box& box) {
      return std::sqrt(box.squared_distance(first[i])) <= match_distance;
    };
    tree.visit(is_near, [&](Index j) {
      const double distance = (first[i] - second[j]).norm();
      if (distance <= match_distance) {
        pairs.emplace_back(distance, i, j);
      }
      if (pairs.size() > most) {
        throw Input_error("too many tips or junctions of the skeletons are near each other to be matched: choose a "
                          "smaller match distance or simplify the skeletons first");
      }
    });
  }
  return {first.size(), second.size(), take_nearest_pairs(std::move(pairs)).size()};
}

/// A skeleton prepared for comparison; lengths are relative to the common diagonal.
struct Compared_skeleton
{
  /// \pre the skeleton has nodes
  explicit Compared_skeleton(Skeleton&& its_skeleton) : skeleton(std::move(its_skeleton)), tree(skeleton)
  {
    const std::vector<std::vector<Index>> neighbors = node_neighbors(skeleton);
    for (std::size_t v = 0; v < neighbors.size(); ++v) {
      if (neighbors[v].size() == 1) {
        tips.push_back(skeleton.points[v]);
      } else if (neighbors[v].size() > 2) {
        junctions.push_back(skeleton.points[v]);
      }
    }
  }

  /// Measures how far this skeleton is from `other`.
  /// \throw Input_error if there are too many edges near each other
  Skeleton_distance distance(const Compared_skeleton& other, double match_distance) const
  {
    constexpr double spacing = 1. / 1000;
    constexpr std::size_t max_number_of_samples = 1 << 16; // a mean over more would not be better
    std::vector<Vector3> samples;                          // of the edges; the nodes if these have no length
    for (const Edge_sample& sample : sample_edges(skeleton, spacing, max_number_of_samples)) {
      samples.push_back(sample.point);
    }
    if (samples.empty()) {
      samples = skeleton.points;
    }
    Skeleton_distance result;
    std::size_t number_matched = 0;
    for (const Vector3& sample : samples) {
      const double d = other.tree.nearest(sample).distance;
      result.mean += d;
      result.maximum = std::max(result.maximum, d);
      number_matched += d <= match_distance ? 1 : 0;
    }
    result.mean /= double(samples.size());
    result.fraction_matched = double(number_matched) / double(samples.size());
    for (const Vector3& point : skeleton.points) {
      result.maximum = std::max(result.maximum, other.tree.nearest(point).distance);
    }
    return result;
  }

  Skeleton skeleton;
  Segment_tree tree;
  std::vector<Vector3> tips;
  std::vector<Vector3> junctions;
};

/// \throw Input_error if `skeleton`, called `name`, has no nodes or one that is not finite
void check_skeleton(const Skeleton& skeleton, const std::string& name)
{
  if (skeleton.number_of_nodes() == 0) {
    throw Input_error("the " + name + " skeleton has no nodes: there is nothing to compare");
  }
  for (std::size_t v = 0; v < skeleton.number_of_nodes(); ++v) {
    check_finite(skeleton, v, name + ' ');
  }
}

/// The coordinates where the bounding box of both skeletons has a diagonal of 1; any, if it is a point.
/// \throw Input_error if the coordinates are too large
Normalization common_normalization(const Skeleton& a, const Skeleton& b)
{
  Bounding_box box(a.points);
  box.extend(Bounding_box(b.points));
  const Vector3 extent = box.max() - box.min();
  const double diagonal = std::hypot(extent.x(), extent.y(), extent.z());
  if (!std::isfinite(diagonal)) {
    throw Input_error("the skeletons are too large to be measured: scale the coordinates");
  }
  return {box.min(), diagonal > 0 ? diagonal : 1};
}

} // namespace

Skeleton_comparison compare_skeletons(Skeleton&& first, Skeleton&& second, double match_distance)
{
  if (!(match_distance >= 0)) {
    throw Input_error("the match distance is negative or no number: 0.02 will do in most cases");
  }
  check_skeleton(first, "first");
  check_skeleton(second, "second");
  const Normalization normalization = common_normalization(first, second);
  normalize(first.points, normalization);
  normalize(second.points, normalization);
  const Compared_skeleton a(std::move(first));
  const Compared_skeleton b(std::move(second));
  Skeleton_comparison result;
  result.diagonal = normalization.unit;
  result.match_distance = match_distance;
  result.from_first_to_second = a.distance(b, match_distance);
  result.from_second_to_first = b.distance(a, match_distance);
  result.tips = match(a.tips, b.tips, match_distance);
  result.junctions = match(a.junctions, b.junctions, match_distance);
  return result;
}

} // namespace CSCD::internal
