// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Derivatives on a point complex, and what they say of fronts: exact for linear functions, large where fronts meet, of
// no scale, at one place on a sampled sphere.

#include "Points/Measured_cloud.h"
#include "Published/to_surface_with_borders.h"
#include "support/sampling.h"
#include "support/shapes.h"
#include <CSCD/Published/Cut_locus_indicators.h>
#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Vector_3;
using CSCD::internal::Point_cut_locus_indicators;
using CSCD::test::Measured_cloud;
using CSCD::test::pi;
using CSCD::test::Triple;

TEST(Point_derivatives, of_a_linear_function)
{
  for (const double size : {1e-6, 1., 1e6}) {
    const Measured_cloud cloud(CSCD::test::flat_grid(8, 8, size));
    const std::vector<double> values = cloud.values([](const Vector_3& p) { return 0.6 * p.x() + 0.8 * p.y(); });
    for (Index v = 0; v < cloud.size(); ++v) {
      const auto gradient = cloud.derivatives().gradient(v, values);
      EXPECT_LT((cloud.frames().in_space(v, gradient) - Vector_3(0.6, 0.8, 0)).norm(), 1e-9);
      const Vector_3 p = cloud.complex().point(v) / size;
      if (p.x() > 0.5 && p.x() < 7.5 && p.y() > 0.5 && p.y() < 7.5) {
        EXPECT_NEAR(cloud.derivatives().laplacian(v, values), 0, 1e-9);
      }
    }
  }
}

TEST(Point_derivatives, of_a_square)
{
  // The Laplacian of x^2 is 2, and the spacing the mean edge length.
  const Measured_cloud cloud(CSCD::test::flat_grid(8, 8, 1));
  const std::vector<double> values = cloud.values([](const Vector_3& p) { return p.x() * p.x(); });
  const Index middle = cloud.nearest({4, 4, 0});
  EXPECT_NEAR(cloud.derivatives().laplacian(middle, values), 2 * cloud.complex().mean_edge_length(), 1e-9);
}

TEST(Point_derivatives, of_points_in_a_row)
{
  // Across a row of edges nothing is known.
  std::vector<Vector_3> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 9}};
  std::vector<Vector_3> normals(4, Vector_3(0, 0, 1));
  const CSCD::Point_complex complex(std::move(points), std::move(normals), {{0, 1, 2}});
  const CSCD::internal::Point_frames frames(complex);
  const CSCD::internal::Tufted_cover cover(complex);
  const CSCD::internal::Point_derivatives derivatives(
      frames, CSCD::internal::Cotangent_elements(CSCD::internal::make_intrinsic_delaunay(cover)));
  const std::vector<double> values{0, 1, 2, 7};
  for (Index v = 0; v < complex.number_of_vertices(); ++v) {
    EXPECT_EQ(derivatives.gradient(v, values), 0.);
    EXPECT_TRUE(std::isfinite(derivatives.laplacian(v, values)));
  }
  EXPECT_EQ(derivatives.laplacian(3, values), 0) << "it has no neighbors";
}

TEST(Point_cut_locus_indicators, where_two_fronts_meet_or_part)
{
  // Gradients that make the angle a with the ridge converge by 2 a. Means over the ring round the ridge off: in the
  // next row they lean less.
  for (const double a : {pi / 2, pi / 4, pi / 8}) {
    for (const double size : {1e-6, 1., 1e6}) {
      const Measured_cloud cloud(CSCD::test::flat_grid(12, 12, size));
      const Index on_ridge = cloud.nearest(size * Vector_3(6, 6, 0));
      const auto distance = [&](double sign) {
        return cloud.values([&](const Vector_3& p) {
          return 100 * size + std::cos(a) * p.x() - sign * std::sin(a) * std::fabs(p.y() - 6 * size);
        });
      };
      const std::vector<double> ridge = distance(1);
      const Point_cut_locus_indicators on(cloud.derivatives(), ridge);
      EXPECT_LE(on.convergence(on_ridge), 2 * a + 1e-6);
      EXPECT_GE(on.convergence(on_ridge), a);
      EXPECT_DOUBLE_EQ(on.convergence(on_ridge, on.gradients()), on.convergence(on_ridge));
      EXPECT_LT(on.laplacian(on_ridge), -2 * std::sin(a));
      EXPECT_EQ(on.is_cut(on_ridge, Point_cut_locus_indicators::default_criterion()), a >= pi / 4);
      const std::vector<double> valley = distance(-1);
      const Point_cut_locus_indicators off(cloud.derivatives(), valley);
      EXPECT_NEAR(off.convergence(on_ridge), 0, 1e-6);
      EXPECT_GT(off.laplacian(on_ridge), 0);
    }
  }
}

TEST(Point_cut_locus_indicators, of_distances_that_are_not_known)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const Measured_cloud cloud(CSCD::test::flat_grid(4, 4, 1));
  const std::vector<double> distances =
      cloud.values([&](const Vector_3& p) { return p.x() > 2.5 ? infinity : -std::fabs(p.x() - 1); });
  const Point_cut_locus_indicators measures(cloud.derivatives(), distances);
  const auto gradients = measures.gradients();
  for (Index v = 0; v < cloud.size(); ++v) {
    EXPECT_TRUE(std::isfinite(measures.laplacian(v)));
    EXPECT_TRUE(std::isfinite(measures.convergence(v)));
    EXPECT_TRUE(std::isfinite(measures.convergence(v, gradients)));
    EXPECT_TRUE(measures.is_reached(v) || !measures.is_cut(v, Point_cut_locus_indicators::default_criterion()));
  }
}

/// Cut points on the sampled unit sphere, and how many of them are near the antipode of the source.
void expect_antipode(const std::vector<Triple>& points)
{
  const Measured_cloud sphere(points);
  for (const Vector_3& from : {Vector_3(0, 0, 1), Vector_3(0.6, -0.8, 0)}) {
    const Index source = sphere.nearest(from);
    const std::vector<double> distances = sphere.distances(source);
    const Point_cut_locus_indicators measures(sphere.derivatives(), distances);
    const double edge = sphere.complex().mean_edge_length();
    double number = 0;
    double number_near = 0;
    for (Index v = 0; v < sphere.size(); ++v) {
      // Near the source itself the heat method's field is wrong.
      if (distances[v] > 4 * edge && measures.is_cut(v, Point_cut_locus_indicators::default_criterion())) {
        number += 1;
        number_near += (sphere.complex().point(v) + sphere.complex().point(source)).norm() < 4 * edge ? 1 : 0;
      }
    }
    EXPECT_GE(number_near, 3);
    EXPECT_GE(number_near, 0.9 * number);
  }
}

TEST(Point_cut_locus_indicators, find_the_antipode_on_a_sampled_sphere)
{
  const CSCD::test::Shape sphere = CSCD::test::sphere(5);
  const std::size_t number = 4000;
  const std::vector<Triple> points = CSCD::test::sampled(sphere, number, 1);
  expect_antipode(points);
  expect_antipode(CSCD::test::shaken(points, 0.3 * CSCD::test::mean_spacing(sphere, number), 2));
}

} // namespace
