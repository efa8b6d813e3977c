// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Narrow holes through thick blocks: the cycles of the skeleton lead around them.

#include <CSCD/Options.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Vector3.h>
#include <CSCD/skeletonize.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Vector3;

/// A block with square holes in the direction of z.
struct Block
{
  double height;
  double hole_width;
  std::vector<std::pair<double, double>> holes = {{0.25, 0.35}, {0.55, 0.35}, {0.75, 0.35}};
  double length = 1;
  double width = 0.7;
};

/// Multiples of `cell` up to `end`, with the two sides of each hole in place of lines in or next to it.
std::vector<double> grid_lines(double end, double cell, double hole_width, const std::set<double>& holes)
{
  std::set<double> result;
  for (int i = 0; i <= int(std::lround(end / cell)); ++i) {
    result.insert(std::min(i * cell, end));
  }
  for (const double center : holes) {
    const auto is_near = [&](double line) { return std::abs(line - center) <= hole_width; };
    for (auto line = result.begin(); line != result.end();) {
      line = is_near(*line) ? result.erase(line) : std::next(line);
    }
    result.insert({center - hole_width / 2, center + hole_width / 2});
  }
  return {result.begin(), result.end()};
}

struct Soup
{
  std::vector<Vector3> points;
  std::vector<std::array<Index, 3>> faces;
};

/// The surface of `block`, of right triangles of about `cell`.
Soup triangulated(const Block& block, double cell)
{
  std::set<double> x_of_holes;
  std::set<double> y_of_holes;
  for (const auto& [x, y] : block.holes) {
    x_of_holes.insert(x);
    y_of_holes.insert(y);
  }
  const std::vector<double> xs = grid_lines(block.length, cell, block.hole_width, x_of_holes);
  const std::vector<double> ys = grid_lines(block.width, cell, block.hole_width, y_of_holes);
  const auto is_hole = [&](std::size_t i, std::size_t j) {
    return std::any_of(block.holes.begin(), block.holes.end(), [&](const auto& hole) {
      return std::abs((xs[i] + xs[i + 1]) / 2 - hole.first) < block.hole_width / 2 &&
             std::abs((ys[j] + ys[j + 1]) / 2 - hole.second) < block.hole_width / 2;
    });
  };
  const auto layers = Index(std::lround(block.height / cell));
  const auto layer_size = Index(xs.size() * ys.size());
  Soup result;
  for (Index layer = 0; layer <= layers; ++layer) {
    for (const double x : xs) {
      for (const double y : ys) {
        result.points.emplace_back(x, y, block.height * layer / layers);
      }
    }
  }
  std::set<std::pair<Index, Index>> edges;
  const auto add_face = [&](Index a, Index b, Index c) {
    const Index top = layers * layer_size;
    result.faces.push_back({a, c, b});
    result.faces.push_back({top + a, top + b, top + c});
    edges.insert({{a, b}, {b, c}, {c, a}});
  };
  for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
    for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
      if (!is_hole(i, j)) {
        const auto corner = Index(i * ys.size() + j);
        const auto next = Index(corner + ys.size());
        add_face(corner, next, next + 1);
        add_face(corner, next + 1, corner + 1);
      }
    }
  }
  for (const auto& [a, b] : edges) {
    for (Index below = 0; edges.count({b, a}) == 0 && below < layers * layer_size; below += layer_size) {
      result.faces.push_back({below + a, below + b, below + layer_size + b});
      result.faces.push_back({below + a, below + layer_size + b, below + layer_size + a});
    }
  }
  return result;
}

/// For each independent cycle of `skeleton`, which is connected, a row of how often it leads around each hole.
Eigen::MatrixXd windings(const CSCD::Skeleton& skeleton, const Block& block)
{
  const auto turn = [&](Index from, Index to) {
    Eigen::RowVectorXd result(block.holes.size());
    for (std::size_t i = 0; i < block.holes.size(); ++i) {
      const Vector3 center(block.holes[i].first, block.holes[i].second, 0);
      const Vector3 a = skeleton.points[from] - center;
      const Vector3 b = skeleton.points[to] - center;
      result[Eigen::Index(i)] = std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y());
    }
    return result;
  };
  std::vector<Eigen::RowVectorXd> angle(skeleton.points.size()); // from the first node, along a tree
  angle[0] = Eigen::RowVectorXd::Zero(Eigen::Index(block.holes.size()));
  std::vector<std::array<Index, 2>> others;
  std::vector<std::array<Index, 2>> edges(skeleton.edges.begin(), skeleton.edges.end());
  for (bool grows = true; grows;) {
    grows = false;
    others.clear();
    for (const auto& [a, b] : edges) {
      if ((angle[a].size() == 0) != (angle[b].size() == 0)) {
        const auto [known, next] = angle[a].size() == 0 ? std::pair(b, a) : std::pair(a, b);
        angle[next] = angle[known] + turn(known, next);
        grows = true;
      } else {
        others.push_back({a, b});
      }
    }
    edges = others;
  }
  Eigen::MatrixXd result(edges.size(), block.holes.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto& [a, b] = edges[i];
    result.row(Eigen::Index(i)) = (angle[a] + turn(a, b) - angle[b]) / (2 * std::acos(-1.));
  }
  return result;
}

class Drilled_blocks : public testing::TestWithParam<Block>
{
};

TEST_P(Drilled_blocks, have_cycles_around_their_holes)
{
  const Soup soup = triangulated(GetParam(), 0.2);
  CSCD::Skeleton skeleton;
  const CSCD::Skeletonization_report report = CSCD::skeletonize(soup.points, soup.faces, CSCD::Options(), skeleton);
  EXPECT_EQ(report.number_of_nodes_outside, 0U);
  EXPECT_EQ(report.number_of_edges_outside, 0U);
  ASSERT_EQ(report.betti_number, GetParam().holes.size());
  const Eigen::MatrixXd around = windings(skeleton, GetParam());
  ASSERT_EQ(around.rows(), around.cols());
  // The cycles are a basis of all ways around the holes.
  EXPECT_NEAR(std::abs(around.determinant()), 1, 1e-6) << around;
}

INSTANTIATE_TEST_SUITE_P(Sizes, Drilled_blocks,
                         testing::Values(Block{0.4, 0.02}, Block{0.4, 0.04}, Block{0.7, 0.02}, Block{0.7, 0.04}));

} // namespace
