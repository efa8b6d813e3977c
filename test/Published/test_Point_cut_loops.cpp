// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops of sources on point clouds: around tubes and through holes, simple closed curves along edges.

#include "Points/Measured_cloud.h"
#include "support/sampling.h"
#include "support/shapes.h"
#include <CSCD/Published/Cut_locus_indicators.h>
#include <CSCD/Published/Cut_loop_finder.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

namespace {

using CSCD::Cut_loop_outcome;
using CSCD::Index;
using CSCD::Point_complex;
using CSCD::Target_rule;
using CSCD::Vector_3;
using CSCD::internal::Cut_loop;
using CSCD::internal::Point_cut_locus_indicators;
using CSCD::test::Measured_cloud;
using CSCD::test::pi;
using CSCD::test::Triple;

using Finder = CSCD::internal::Cut_loop_finder<Point_cut_locus_indicators>;

Cut_loop find_loop(const Measured_cloud& cloud, Index source, Target_rule rule, std::vector<Index>& vertices)
{
  Finder finder(cloud.frames(), cloud.complex().points());
  const std::vector<double> distances = cloud.distances(source);
  Cut_loop loop;
  const Point_cut_locus_indicators measures(cloud.derivatives(), distances);
  finder.find(
      measures, source, cloud.complex().point(source), rule,
      [&](Index v) { return measures.is_cut(v, Point_cut_locus_indicators::default_criterion()); }, loop);
  vertices.clear();
  for (const Index h : loop.halfedges) {
    vertices.push_back(cloud.complex().origin(h));
  }
  return loop;
}

void expect_simple(const Point_complex& complex, const Cut_loop& loop, const std::vector<Index>& vertices)
{
  std::set<Index> passed;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    EXPECT_NE(complex.find_halfedge(vertices[i], vertices[(i + 1) % vertices.size()]), CSCD::no_index);
    EXPECT_TRUE(passed.insert(vertices[i]).second) << "a vertex comes twice";
  }
  EXPECT_EQ(vertices.front(), loop.target);
  EXPECT_EQ(passed.count(loop.base), 1u);
}

/// How often the curve through `vertices` goes around the axis through `center` along `axis`.
double winding(const Point_complex& complex, const std::vector<Index>& vertices, const Vector_3& axis,
               const Vector_3& center)
{
  const Vector_3 x = axis.unitOrthogonal();
  const Vector_3 y = axis.cross(x);
  const auto angle = [&](Index v) {
    const Vector_3 p = complex.point(v) - center;
    return std::atan2(p.dot(y), p.dot(x));
  };
  double sum = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    sum += std::remainder(angle(vertices[(i + 1) % vertices.size()]) - angle(vertices[i]), 2 * pi);
  }
  return std::fabs(sum / (2 * pi));
}

/// Points of `shape` as they come, and shaken by 0.3 of their spacing.
std::vector<std::vector<Triple>> clouds(const CSCD::test::Shape& shape, std::size_t number)
{
  const std::vector<Triple> points = CSCD::test::sampled(shape, number, 3);
  return {points, CSCD::test::shaken(points, 0.3 * CSCD::test::mean_spacing(shape, number), 4)};
}

TEST(Cut_loop_finder, goes_around_a_sampled_tube)
{
  // 16 long and 2 wide, in the cube [-1, 1]^3.
  const double radius = 1 / 8.;
  for (const auto& points : clouds(CSCD::test::capsule(14, 1, 48), 5000)) {
    const Measured_cloud tube(points);
    for (const Target_rule rule : {Target_rule::nearest_in_space, Target_rule::nearest_along_surface}) {
      std::size_t number = 0;
      for (Index source = 0; source < tube.size(); source += 101) {
        const Vector_3 from = tube.complex().point(source);
        if (std::fabs(from.x()) > 1 - 3 * radius || tube.complex().outgoing(source).empty()) {
          continue;
        }
        ++number;
        std::vector<Index> vertices;
        const Cut_loop loop = find_loop(tube, source, rule, vertices);
        ASSERT_EQ(loop.outcome, Cut_loop_outcome::found);
        expect_simple(tube.complex(), loop, vertices);
        const Vector_3 opposite(from.x(), -from.y(), -from.z());
        // Cut points may be two edges beside the line opposite; those are as near in space as others three edges along
        // it.
        EXPECT_LT((tube.complex().point(loop.target) - opposite).norm(), 4 * tube.complex().mean_edge_length());
        EXPECT_NEAR(loop.distance, pi * radius, 2.5 * tube.complex().mean_edge_length());
        EXPECT_NEAR(loop.path_separation, 2 / pi, 0.15);
        EXPECT_NEAR(winding(tube.complex(), vertices, {1, 0, 0}, {0, 0, 0}), 1, 1e-6);
      }
      EXPECT_GT(number, 20u);
    }
  }
}

TEST(Cut_loop_finder, goes_around_a_sampled_ring)
{
  const double major_radius = 3. / 4;
  for (const auto& points : clouds(CSCD::test::torus(3, 1, 48), 5000)) {
    const Measured_cloud torus(points);
    for (Index source = 0; source < torus.size(); source += 257) {
      std::vector<Index> vertices;
      const Cut_loop loop = find_loop(torus, source, Target_rule::nearest_in_space, vertices);
      ASSERT_EQ(loop.outcome, Cut_loop_outcome::found);
      expect_simple(torus.complex(), loop, vertices);
      const Vector_3& p = torus.complex().point(source);
      const Vector_3 center = major_radius * Vector_3(p.x(), p.y(), 0).normalized();
      EXPECT_NEAR(winding(torus.complex(), vertices, Vector_3(0, 0, 1).cross(center).normalized(), center), 1, 1e-6);
      EXPECT_NEAR(winding(torus.complex(), vertices, {0, 0, 1}, {0, 0, 0}), 0, 1e-6);
    }
  }
}

TEST(Cut_loop_finder, says_that_an_outlier_has_no_loop)
{
  std::vector<Triple> points = CSCD::test::sampled(CSCD::test::capsule(14, 1, 48), 3000, 3);
  points.push_back({7, 9, 9});
  const Measured_cloud tube(points);
  Index outlier = 0;
  for (Index v = 0; v < tube.size(); ++v) {
    outlier = tube.complex().outgoing(v).empty() ? v : outlier;
  }
  ASSERT_TRUE(tube.complex().outgoing(outlier).empty());
  std::vector<Index> vertices;
  EXPECT_EQ(find_loop(tube, outlier, Target_rule::nearest_in_space, vertices).outcome, Cut_loop_outcome::no_cut_point);
  EXPECT_TRUE(vertices.empty());
}

} // namespace
