// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cycles of the skeleton lead around holes: narrow ones through thick blocks, and hollows of pipes.

#include "Surface/to_surface.h"
#include "support/simple_shapes.h"
#include <CSCD/Options.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Vector3.h>
#include <CSCD/Volume/Voxel_surface.h>
#include <CSCD/skeletonize.h>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace {

using CSCD::Index, CSCD::Vector3, CSCD::test::Shape;

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

/// Where a hole is: a way through it from far away to far away.
using Hole = std::array<Vector3, 3>;

/// The part of a full turn that the segment from `a` to `b` winds around the segment from `c` to `d`: the integral of
/// Gauss, by the solid angle of their differences.
double winding(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  const std::array<Vector3, 4> corners{c - a, c - b, d - b, d - a};
  const auto normal = [&](std::size_t i) { return corners[i % 4].cross(corners[(i + 1) % 4]).normalized(); };
  double angle = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    angle += std::asin(std::clamp(normal(i).dot(normal(i + 1)), -1., 1.));
  }
  return std::copysign(angle / 12.566370614, (b - a).cross(d - c).dot(c - a));
}

/// How often the cycles of a connected skeleton, one for each edge that closes one, wind around each of `holes`.
Eigen::MatrixXd windings(const CSCD::Skeleton& skeleton, const std::vector<Hole>& holes)
{
  const auto along = [&](Index a, Index b) {
    Eigen::VectorXd result(holes.size());
    for (std::size_t i = 0; i < holes.size(); ++i) {
      const auto& [begin, middle, end] = holes[i];
      result[Eigen::Index(i)] = winding(skeleton.points[a], skeleton.points[b], begin, middle) +
                                winding(skeleton.points[a], skeleton.points[b], middle, end);
    }
    return result;
  };
  std::vector<Eigen::VectorXd> sums(skeleton.points.size()); // from the first node, along a tree
  sums[0].setZero(Eigen::Index(holes.size()));
  std::vector<std::array<Index, 2>> left = skeleton.edges;
  for (std::size_t size = 0; size != left.size();) {
    size = left.size();
    left.erase(std::remove_if(left.begin(), left.end(),
                              [&](std::array<Index, 2> edge) {
                                if (sums[edge[0]].size() == 0) {
                                  std::swap(edge[0], edge[1]);
                                }
                                if (sums[edge[0]].size() == 0 || sums[edge[1]].size() > 0) {
                                  return false;
                                }
                                sums[edge[1]] = sums[edge[0]] + along(edge[0], edge[1]);
                                return true;
                              }),
               left.end());
  }
  Eigen::MatrixXd result(left.size(), holes.size());
  for (std::size_t i = 0; i < left.size(); ++i) {
    result.row(Eigen::Index(i)) = (sums[left[i][0]] + along(left[i][0], left[i][1]) - sums[left[i][1]]).transpose();
  }
  return result.array().round();
}

// Each shape is skeletonized with these seeds. A separator around the body that a hole passes is not always recognized,
// and which one is not depends on chance: the bounds below are three standard deviations (measured with twelve seeds)
// less than the mean.
constexpr unsigned number_of_seeds = 3;

/// Whether the cycles of the skeleton of `body` are as many as `holes`, and generate the loops around these. Sets
/// `skeleton`.
bool has_cycles_around(const std::vector<Hole>& holes, const CSCD::Indexed_triangles& body, unsigned seed,
                       CSCD::Skeleton& skeleton)
{
  CSCD::Options options;
  options.random_seed = seed;
  const CSCD::Skeletonization_report report = CSCD::skeletonize(body.points, body.faces, options, skeleton);
  EXPECT_EQ(report.betti_number, holes.size());
  EXPECT_EQ(report.number_of_edges_outside, 0u);
  const Eigen::MatrixXd matrix = windings(skeleton, holes);
  return matrix.rows() == matrix.cols() && std::lround(std::abs(matrix.determinant())) == 1;
}

/// With how many seeds the cycle leads around the hole of `block`, half way through it.
unsigned number_with_cycle_around_hole(const Block& block)
{
  const Hole hole{Vector3(block.x, block.y, -1e4), Vector3(block.x, block.y, 0), Vector3(block.x, block.y, 1e4)};
  const CSCD::Indexed_triangles body = CSCD::test::to_indexed_triangles(triangulated(block));
  unsigned result = 0;
  for (unsigned seed = 0; seed < number_of_seeds; ++seed) {
    CSCD::Skeleton skeleton;
    const bool leads_around = has_cycles_around({hole}, body, seed, skeleton);
    double height = 0;
    double number = 0;
    for (std::size_t edge = 0; edge < skeleton.edges.size(); ++edge) {
      if (std::isinf(skeleton.significance[edge])) { // only edges of cycles are
        height += skeleton.points[skeleton.edges[edge][0]].z() + skeleton.points[skeleton.edges[edge][1]].z();
        number += 2;
      }
    }
    result += leads_around && std::abs(height / number - 0.5) < 0.1 ? 1 : 0;
  }
  return result;
}

TEST(Holes, through_blocks_have_cycles_around_them)
{
  unsigned number_right = 0;
  for (const double length : {1., 1.5, 2.}) {
    for (const double width : {0.4, 0.7}) {
      for (const double cell : {0.1, 0.2}) {
        for (const double hole_width : {0.02, 0.08}) {
          number_right += number_with_cycle_around_hole({length, width, cell, hole_width, 0.5, 0.3});
        }
      }
    }
  }
  EXPECT_GE(number_right, 63u) << "of 72";
}

/// A pipe with a wall, of straight parts from a joint to open ends.
struct Pipe
{
  double radius;
  double wall;
  Vector3 joint;
  std::vector<Vector3> ends;
};

double distance_to_axis(const Pipe& pipe, const Vector3& point, double extra_length)
{
  double result = (point - pipe.joint).norm();
  for (const Vector3& end : pipe.ends) {
    const Vector3 way = end - pipe.joint;
    const double part = (point - pipe.joint).dot(way) / way.squaredNorm();
    if (part > 0 && part < 1 + extra_length) {
      result = std::min(result, (point - pipe.joint - part * way).norm());
    }
  }
  return result;
}

CSCD::Indexed_triangles surface_of(const Pipe& pipe)
{
  CSCD::Volume volume;
  volume.grid.size = {60, 60, 60};
  volume.grid.origin = {-1.2, -1.2, -1.2};
  volume.grid.axes = {Vector3(0.04, 0, 0), Vector3(0, 0.04, 0), Vector3(0, 0, 0.04)};
  for (std::size_t i = 0; i < volume.grid.number_of_voxels(); ++i) {
    const Vector3 point = volume.grid.point({double(i % 60), double(i / 60 % 60), double(i / 3600)});
    const bool is_inside =
        distance_to_axis(pipe, point, 0) < pipe.radius && distance_to_axis(pipe, point, 1) > pipe.radius - pipe.wall;
    volume.labels.push_back(is_inside ? 1 : 0);
  }
  return CSCD::make_voxel_surfaces(volume).front().triangles;
}

/// With how many seeds the cycles lead around the hollow of `pipe`.
unsigned number_with_cycles_around_hollow(const Pipe& pipe)
{
  std::vector<Hole> holes;
  const auto far_end = [&](std::size_t i) { return Vector3(pipe.joint + 1e4 * (pipe.ends[i] - pipe.joint)); };
  for (std::size_t i = 1; i < pipe.ends.size(); ++i) {
    holes.push_back({far_end(0), pipe.joint, far_end(i)});
  }
  const CSCD::Indexed_triangles body = surface_of(pipe);
  unsigned result = 0;
  for (unsigned seed = 0; seed < number_of_seeds; ++seed) {
    CSCD::Skeleton skeleton;
    result += has_cycles_around(holes, body, seed, skeleton) ? 1 : 0;
  }
  return result;
}

TEST(Holes, of_pipes_have_cycles_around_them)
{
  const Vector3 center(0, 0, 0);
  const Vector3 corner(-0.3, -0.3, -0.3);
  const Vector3 x(1, 0, 0);
  const Vector3 z(0, 0, 1);
  unsigned number_right = 0;
  for (const auto& [radius, wall] : {std::pair(0.3, 0.12), std::pair(0.4, 0.24)}) {
    number_right += number_with_cycles_around_hollow({radius, wall, center, {x, -x}});
    number_right += number_with_cycles_around_hollow({radius, wall, corner, {{1, -0.3, -0.3}, {-0.3, -0.3, 1}}});
    number_right += number_with_cycles_around_hollow({radius, wall, center, {x, -x, z}});
    number_right += number_with_cycles_around_hollow({radius, wall, center, {-z, {0.8, 0, 0.7}, {-0.8, 0, 0.7}}});
    number_right += number_with_cycles_around_hollow({radius, wall, center, {x, -x, z, -z}});
  }
  // Those that are not right have separators through the wall next to separators along it.
  EXPECT_GE(number_right, 24u) << "of 30";
}

} // namespace
