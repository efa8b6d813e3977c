// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons of points that are known by their numbers.

#ifndef CSCD_TEST_SUPPORT_POINT_SKELETONS_H
#define CSCD_TEST_SUPPORT_POINT_SKELETONS_H

#include "Shape.h"
#include "Skeleton_comparison.h"
#include "convert_shape.h"
#include "sampling.h"
#include <CSCD/Skeleton_graph.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CSCD::test {

template <class Skeleton>
Plain_skeleton plain(const Skeleton& skeleton)
{
  Plain_skeleton result;
  for (std::size_t node = 0; node < num_vertices(skeleton); ++node) {
    result.points.push_back(to_triple(skeleton[node].point));
    result.sites.push_back(skeleton[node].vertices);
    std::sort(result.sites.back().begin(), result.sites.back().end());
  }
  result.edges = plain_edges(skeleton);
  return result;
}

/// Expects that every number below `number_of_points` stands at exactly one node.
template <class Point>
void expect_partition(const Skeleton_graph<Point, std::size_t>& skeleton, std::size_t number_of_points)
{
  std::vector<std::size_t> numbers;
  for (std::size_t node = 0; node < num_vertices(skeleton); ++node) {
    numbers.insert(numbers.end(), skeleton[node].vertices.begin(), skeleton[node].vertices.end());
  }
  std::sort(numbers.begin(), numbers.end());
  ASSERT_EQ(number_of_points, numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    ASSERT_EQ(i, numbers[i]);
  }
}

/// The distance from each of `a` to the nearest of `b`, on average.
inline double mean_distance(const std::vector<Triple>& a, const std::vector<Triple>& b)
{
  double sum = 0;
  for (const Triple& p : a) {
    double least = std::numeric_limits<double>::max();
    for (const Triple& q : b) {
      least = std::min(least, norm(p - q));
    }
    sum += least;
  }
  return sum / static_cast<double>(a.size());
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_POINT_SKELETONS_H
