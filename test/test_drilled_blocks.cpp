// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A narrow hole through a thick block: the cycle of the skeleton leads around it.

#include "support/simple_shapes.h"
#include <CSCD/Options.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Vector3.h>
#include <CSCD/skeletonize.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Vector3;
using CSCD::test::Shape;

/// A block of height 1 with a square hole.
struct Block
{
  double length;
  double width;
  double cell; ///< the size of triangles
  double hole_width;
  double x; ///< of the center of the hole
  double y;
};

/// Multiples of `cell` up to `end`, with the two sides of the hole in place of lines in it or next to it.
std::vector<double> grid_lines(double end, double cell, double center, double hole_width)
{
  std::set<double> result{center - hole_width / 2, center + hole_width / 2};
  for (int i = 0; i <= int(std::lround(end / cell)); ++i) {
    if (std::abs(i * cell - center) > hole_width) {
      result.insert(i * cell);
    }
  }
  return {result.begin(), result.end()};
}

Shape triangulated(const Block& block)
{
  const std::vector<double> xs = grid_lines(block.length, block.cell, block.x, block.hole_width);
  const std::vector<double> ys = grid_lines(block.width, block.cell, block.y, block.hole_width);
  std::vector<CSCD::test::Triple> points;
  std::vector<CSCD::test::Triangle> triangles;
  for (std::size_t i = 0; i < xs.size(); ++i) {
    for (std::size_t j = 0; j < ys.size(); ++j) {
      const std::size_t corner = points.size();
      points.push_back({xs[i], ys[j], 0});
      const bool is_hole = std::abs(xs[i] - block.x + block.hole_width / 2) < block.hole_width / 2 &&
                           std::abs(ys[j] - block.y + block.hole_width / 2) < block.hole_width / 2;
      if (i + 1 < xs.size() && j + 1 < ys.size() && !is_hole) {
        triangles.push_back({corner, corner + ys.size(), corner + ys.size() + 1});
        triangles.push_back({corner, corner + ys.size() + 1, corner + 1});
      }
    }
  }
  return CSCD::test::prism("drilled block", points, triangles);
}

/// The nodes of the only cycle of `skeleton`, in order: its edges are never cut, and infinitely significant.
std::vector<Vector3> cycle_of(const CSCD::Skeleton& skeleton)
{
  std::vector<std::vector<Index>> neighbors(skeleton.points.size());
  for (std::size_t edge = 0; edge < skeleton.edges.size(); ++edge) {
    const auto& [a, b] = skeleton.edges[edge];
    if (std::isinf(skeleton.significance[edge])) {
      neighbors[a].push_back(b);
      neighbors[b].push_back(a);
    }
  }
  Index first = 0;
  while (neighbors[first].empty()) {
    ++first;
  }
  std::vector<Vector3> cycle{skeleton.points[first]};
  Index last = first;
  for (Index node = neighbors[first].front(); node != first;) {
    cycle.push_back(skeleton.points[node]);
    const Index next = neighbors[node].front() == last ? neighbors[node].back() : neighbors[node].front();
    last = node;
    node = next;
  }
  return cycle;
}

/// Whether the cycle leads around the hole of `block`, half way through it.
bool has_cycle_around_hole(const Block& block)
{
  const Shape shape = triangulated(block);
  std::vector<Vector3> points;
  for (const auto& [x, y, z] : shape.points) {
    points.emplace_back(x, y, z);
  }
  std::vector<std::array<Index, 3>> faces;
  for (const auto& [a, b, c] : shape.triangles) {
    faces.push_back({Index(a), Index(b), Index(c)});
  }
  CSCD::Skeleton skeleton;
  const CSCD::Skeletonization_report report = CSCD::skeletonize(points, faces, CSCD::Options(), skeleton);
  EXPECT_EQ(report.betti_number, 1u);
  EXPECT_EQ(report.number_of_edges_outside, 0u);
  const std::vector<Vector3> cycle = cycle_of(skeleton);
  const Vector3 foot(block.x, block.y, 0);
  double angle = 0;
  double height = 0;
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const Vector3 a = cycle[i] - foot;
    const Vector3 b = cycle[(i + 1) % cycle.size()] - foot;
    angle += std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y());
    height += a.z() / double(cycle.size());
  }
  return std::lround(std::abs(angle) / 6.28) == 1 && std::abs(height - 0.5) < 0.1;
}

TEST(Drilled_blocks, have_a_cycle_around_the_hole)
{
  std::size_t number = 0;
  std::size_t number_right = 0;
  for (const double length : {1., 1.5, 2.}) {
    for (const double width : {0.4, 0.5, 0.7}) {
      for (const double cell : {0.1, 0.2}) {
        for (const double hole_width : {0.02, 0.04, 0.08}) {
          ++number;
          number_right += has_cycle_around_hole({length, width, cell, hole_width, 0.5, 0.3}) ? 1 : 0;
        }
      }
    }
  }
  // A separator around the block that the hole passes is not always recognized: 49 are right.
  EXPECT_GE(number_right, 48u) << "of " << number;
}

} // namespace
