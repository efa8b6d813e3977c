// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A skeleton read back from a file.

#ifndef CSCD_TEST_IO_PARSED_SKELETON_H
#define CSCD_TEST_IO_PARSED_SKELETON_H

#include "sample_skeleton.h"
#include <CSCD/Skeleton_graph.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace test_support {

/// The content of a file, nodes counted from 0.
struct Parsed_skeleton
{
  std::vector<Point> points;
  std::vector<double> radii; ///< empty if the file holds none
  std::vector<std::pair<std::size_t, std::size_t>> edges;
};

/// Edges without direction and order.
inline std::vector<std::pair<std::size_t, std::size_t>>
normalized(std::vector<std::pair<std::size_t, std::size_t>> edges)
{
  for (auto& [u, v] : edges) {
    if (v < u) {
      std::swap(u, v);
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Appends the edges of a path.
template <class Path>
void append_path(const Path& path, std::vector<std::pair<std::size_t, std::size_t>>& edges)
{
  for (std::size_t i = 1; i < path.size(); ++i) {
    edges.emplace_back(path[i - 1], path[i]);
  }
}

/// Expects all numbers to be exactly those of the sample.
template <class SampleSkeleton>
void expect_sample(const Parsed_skeleton& parsed)
{
  const SampleSkeleton skeleton = sample_skeleton<SampleSkeleton>();
  ASSERT_EQ(num_vertices(skeleton), parsed.points.size());
  for (std::size_t i = 0; i < parsed.points.size(); ++i) {
    EXPECT_EQ(skeleton[i].point, parsed.points[i]) << "node " << i;
  }
  EXPECT_EQ(normalized(sample_edges()), normalized(parsed.edges));
  if constexpr (CSCD::has_radius_v<SampleSkeleton>) {
    ASSERT_EQ(num_vertices(skeleton), parsed.radii.size());
    for (std::size_t i = 0; i < parsed.radii.size(); ++i) {
      EXPECT_EQ(skeleton[i].radius, parsed.radii[i]) << "node " << i;
    }
  } else {
    EXPECT_TRUE(parsed.radii.empty());
  }
}

} // namespace test_support

#endif // CSCD_TEST_IO_PARSED_SKELETON_H
