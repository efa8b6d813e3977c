// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of classify_shapes.h.

#ifndef CSCD_APPLICATION_CLASSIFY_SHAPES_IMPL_H
#define CSCD_APPLICATION_CLASSIFY_SHAPES_IMPL_H

#include <CSCD/Application/Skeletonized_surface.h>
#include <CSCD/Application/classify_shapes.h>
#include <CSCD/Application/estimate_shape_diameters.h>
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/config.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CSCD {
namespace internal {

/// A value, and how much it counts.
using Weighted_value = std::array<double, 2>;

/// The values below which the parts (i + 1/2) / `number` of all weights are. O(n log n).
inline std::vector<double> quantiles(std::vector<Weighted_value> values, std::size_t number)
{
  std::sort(values.begin(), values.end());
  double sum = 0;
  for (Weighted_value& value : values) {
    sum += value[1];
    value[1] = sum;
  }
  std::vector<double> result(number, 0);
  for (std::size_t i = 0; i < number && !values.empty(); ++i) {
    const double wanted = sum * (double(i) + 0.5) / double(number);
    const auto place =
        std::partition_point(values.begin(), values.end() - 1, [&](const auto& v) { return v[1] < wanted; });
    result[i] = (*place)[0];
  }
  return result;
}

/// Appends `values`, divided so that the sum of their differences is `weight` times the mean difference.
inline void append_part(const std::vector<double>& values, double weight, Shape_description& description)
{
  for (const double value : values) {
    description.push_back(value * weight / double(values.size()));
  }
}

CSCD_INLINE Shape_description describe_diameters(const Indexed_triangles& triangles,
                                                 const std::vector<double>& diameters)
{
  constexpr std::size_t number_of_quantiles = 64;
  // Diameters that are small against this, relative to the unit, are equal: details of the triangles decide on them.
  constexpr double negligible = 0.01;
  const std::vector<double> areas = face_areas(triangles);
  const double unit = std::sqrt(std::accumulate(areas.begin(), areas.end(), 0.));
  std::vector<Weighted_value> values;
  values.reserve(areas.size());
  for (std::size_t f = 0; f < areas.size(); ++f) {
    values.push_back({std::log(negligible + diameters[f] / unit), areas[f]});
  }
  Shape_description result;
  append_part(quantiles(std::move(values), number_of_quantiles), 1, result);
  return result;
}

/// The lengths of the longest branches; 0 where there are fewer.
inline std::vector<double> longest_branches(const Indexed_skeleton& skeleton, double unit)
{
  constexpr std::size_t number = 12; // more than the limbs of most kinds of bodies
  const Skeleton_branches branches = measure_branches(skeleton);
  std::vector<double> lengths;
  lengths.reserve(branches.branches.size());
  for (const Skeleton_branch& branch : branches.branches) {
    lengths.push_back(branch.length / unit);
  }
  std::sort(lengths.begin(), lengths.end(), std::greater<>());
  lengths.resize(number, 0);
  return lengths;
}

/// The distances between tips along the skeleton, all alike.
inline std::vector<Weighted_value> tip_distances(const Indexed_skeleton& skeleton, double unit)
{
  constexpr std::size_t max_tips = 100; // a sample of more tells the same
  const std::vector<std::vector<Index>> neighbors = node_neighbors(skeleton);
  std::vector<Index> tips;
  for (Index v = 0; v < neighbors.size(); ++v) {
    if (neighbors[v].size() == 1) {
      tips.push_back(v);
    }
  }
  const std::size_t step = tips.size() / max_tips + 1;
  std::vector<Weighted_value> values;
  for (std::size_t i = 0; i < tips.size(); i += step) {
    const Skeleton_distances distances = distances_along(skeleton, neighbors, {tips[i]});
    for (std::size_t j = 0; j < i; j += step) {
      if (distances.distance[tips[j]] < Skeleton_distances::unreachable) {
        values.push_back({distances.distance[tips[j]] / unit, 1});
      }
    }
  }
  return values;
}

CSCD_INLINE Shape_description describe_shape(const Skeletonized_surface& surface, Shape_descriptor descriptor)
{
  constexpr std::size_t number_of_distances = 16;
  // Of eight pairs of weights, the best on the odd-numbered meshes of the Princeton segmentation benchmark and on half
  // of TOSCA, as good as others.
  constexpr double branch_weight = 1;
  constexpr double tip_weight = 0.25;
  Shape_description result = describe_diameters(
      surface.triangles,
      face_means(surface, vertex_shape_diameters(surface, default_number_of_diameter_smoothing_steps)));
  if (descriptor == Shape_descriptor::skeleton) {
    const std::vector<double> areas = face_areas(surface.triangles);
    const double unit = std::sqrt(std::accumulate(areas.begin(), areas.end(), 0.));
    append_part(longest_branches(surface.skeleton, unit), branch_weight, result);
    append_part(quantiles(tip_distances(surface.skeleton, unit), number_of_distances), tip_weight, result);
  }
  return result;
}

/// The mean over the classes of the harmonic mean of precision and recall.
inline double macro_f1(const std::vector<std::string>& classes, const std::vector<std::string>& found)
{
  struct Counts
  {
    double right = 0;
    double known = 0;
    double found = 0;
  };
  std::map<std::string, Counts> counts;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    if (!classes[i].empty()) {
      counts[classes[i]].known += 1;
      counts[found[i]].found += 1;
      counts[classes[i]].right += classes[i] == found[i] ? 1 : 0;
    }
  }
  counts.erase(std::string());
  double sum = 0;
  for (const auto& [name, count] : counts) {
    sum += 2 * count.right / (count.known + count.found);
  }
  return sum / double(counts.size());
}

} // namespace internal

CSCD_INLINE double shape_distance(const Shape_description& first, const Shape_description& second)
{
  CGAL_precondition(first.size() == second.size());
  double sum = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    sum += std::abs(first[i] - second[i]);
  }
  return sum;
}

CSCD_INLINE Shape_classification classify_shapes(const std::vector<Shape_description>& descriptions,
                                                 const std::vector<std::string>& classes)
{
  CGAL_precondition(descriptions.size() == classes.size());
  const std::size_t n = descriptions.size();
  Shape_classification result{std::vector<std::size_t>(n, n),
                              std::vector<double>(n, std::numeric_limits<double>::infinity()),
                              std::vector<std::string>(n)};
  double number_of_known = 0;
  double number_of_right = 0;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const double distance =
          i == j || classes[j].empty() ? result.distance[i] : shape_distance(descriptions[i], descriptions[j]);
      if (distance < result.distance[i]) {
        result.distance[i] = distance;
        result.nearest[i] = j;
        result.found[i] = classes[j];
      }
    }
    number_of_known += classes[i].empty() ? 0 : 1;
    number_of_right += !classes[i].empty() && result.found[i] == classes[i] ? 1 : 0;
  }
  if (number_of_known > 0) {
    result.accuracy = number_of_right / number_of_known;
    result.macro_f1 = internal::macro_f1(classes, result.found);
  }
  return result;
}

} // namespace CSCD

#endif // CSCD_APPLICATION_CLASSIFY_SHAPES_IMPL_H
