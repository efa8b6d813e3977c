// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How near projected points come to the surfaces that were sampled.

#include "Points/to_point_complex.h"
#include "Surface/joined_shell.h"
#include "support/sampling.h"
#include "support/shapes.h"
#include <CSCD/Points/Point_complex.h>
#include <CSCD/Published/Variational_shortening.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Point_complex;
using CSCD::Vector_3;
using CSCD::internal::Moving_least_squares_projection;
using CSCD::internal::Point_neighborhoods;
using CSCD::internal::Projected_point;
using CSCD::test::Shape;
using CSCD::test::Triple;

Triple to_triple(const Vector_3& p)
{
  return {p.x(), p.y(), p.z()};
}

/// The height of `p` above a body of round limbs, or the unit sphere if it has none.
double height_above(const Shape& shape, const Vector_3& p)
{
  if (shape.centreline.empty()) {
    return p.norm() - 1;
  }
  double least = 1e9;
  for (const CSCD::test::Centreline_segment& segment : shape.centreline) {
    least = std::min(least, CSCD::test::distance(segment, to_triple(p)) - segment.source_radius);
  }
  return least;
}

struct Heights
{
  double mean = 0;
  double root_mean_square = 0;
  double largest = 0;
  double max_tilt = 0; // of normals against the gradient of the height, 1 - cosine
};

/// Projects points between neighbors, lifted by `lift` times the length of their edge.
Heights measure(const Shape& shape, const Point_complex& complex, double lift)
{
  const Point_neighborhoods neighborhoods(complex);
  const Moving_least_squares_projection project(complex, neighborhoods);
  Heights result;
  double number = 0;
  for (Index h = 0; h < complex.number_of_halfedges(); h += 7) {
    const Vector_3 middle = (complex.point(complex.origin(h)) + complex.point(complex.target(h))) / 2;
    const Projected_point p =
        project(middle + lift * complex.length(h) * complex.normal(complex.origin(h)), complex.origin(h));
    const double height = height_above(shape, p.point);
    const double step = 1e-4;
    const double rise = height_above(shape, p.point + step * p.normal) - height;
    result.mean += height;
    result.root_mean_square += height * height;
    result.largest = std::max(result.largest, std::abs(height));
    result.max_tilt = std::max(result.max_tilt, 1 - rise / step);
    ++number;
  }
  result.mean /= number;
  result.root_mean_square = std::sqrt(result.root_mean_square / number);
  return result;
}

std::vector<Shape> round_shapes()
{
  return {CSCD::test::sphere(6), CSCD::test::torus(3, 1, 128), CSCD::test::capsule(6, 1, 128)};
}

TEST(Moving_least_squares_projection, comes_to_the_surface_between_the_points)
{
  for (const Shape& shape : round_shapes()) {
    SCOPED_TRACE(shape.name);
    const std::size_t number = 4000;
    const Point_complex complex = CSCD::test::to_point_complex(CSCD::test::sampled(shape, number, 1));
    const double spacing = complex.mean_edge_length();
    for (const double lift : {-0.3, 0., 0.3}) {
      const Heights heights = measure(shape, complex, lift);
      EXPECT_LT(heights.root_mean_square, 0.015 * spacing);
      EXPECT_LT(std::abs(heights.mean), 0.005 * spacing) << "no shape is too small or too large";
      EXPECT_LT(heights.largest, 0.15 * spacing);
      EXPECT_LT(heights.max_tilt, 0.02) << "less than 12 degrees";
    }
  }
}

TEST(Moving_least_squares_projection, smooths_noise)
{
  for (const Shape& shape : round_shapes()) {
    SCOPED_TRACE(shape.name);
    const std::size_t number = 4000;
    const double noise = 0.3 * CSCD::test::mean_spacing(shape, number);
    const Point_complex complex =
        CSCD::test::to_point_complex(CSCD::test::shaken(CSCD::test::sampled(shape, number, 1), noise, 2));
    EXPECT_LT(measure(shape, complex, 0).root_mean_square, 0.5 * noise);
  }
}

TEST(Moving_least_squares_projection, follows_uneven_density)
{
  const Shape shape = CSCD::test::sphere(6);
  std::vector<Triple> points = CSCD::test::sampled(shape, 16000, 1);
  // A sixteenth of the points of the lower half remains, so that the spacing is four times as wide.
  std::size_t number = 0;
  points.erase(std::remove_if(points.begin(), points.end(),
                              [&number](const Triple& p) { return p[2] < 0 && number++ % 16 != 0; }),
               points.end());
  const Point_complex complex = CSCD::test::to_point_complex(points);
  const Heights heights = measure(shape, complex, 0.2);
  EXPECT_LT(heights.root_mean_square, 0.015 * 0.5 * complex.mean_edge_length()) << "the dense half rules the mean";
  EXPECT_LT(heights.max_tilt, 0.02);
}

TEST(Moving_least_squares_projection, stays_on_its_sheet)
{
  // A shell that is thinner than its points are apart.
  const Shape outer = CSCD::test::sphere(3);
  const double gap = 0.5 * CSCD::test::mean_edge_length(outer);
  const Point_complex complex =
      CSCD::test::to_point_complex(CSCD::test::joined_shell(outer, CSCD::test::scaled(outer, 1 - gap), 8));
  const Point_neighborhoods neighborhoods(complex);
  const Moving_least_squares_projection project(complex, neighborhoods);
  const Index size = complex.number_of_vertices() / 2;
  for (Index h = 0; h < complex.number_of_halfedges(); ++h) {
    const Index from = complex.origin(h);
    const bool is_above = from < size;
    if (is_above != (complex.target(h) < size)) {
      continue;
    }
    for (const double depth : {0.1, 0.9}) {
      const Vector_3 between = (1 - depth * gap) * complex.point(complex.target(h)).normalized();
      const Projected_point p = project(between, from);
      EXPECT_EQ(p.site < size, is_above);
      EXPECT_NEAR(p.point.norm(), is_above ? 1 : 1 - gap, 0.1 * gap);
    }
  }
}

TEST(Moving_least_squares_projection, finds_the_nearest_vertex_and_its_own_points_again)
{
  const Point_complex complex = CSCD::test::to_point_complex(CSCD::test::torus(3, 1, 24));
  const Point_neighborhoods neighborhoods(complex);
  const Moving_least_squares_projection project(complex, neighborhoods);
  for (Index vertex = 0; vertex < complex.number_of_vertices(); vertex += 11) {
    const Index near = *complex.outgoing(vertex).begin();
    const Projected_point p = project(complex.point(vertex), complex.target(near));
    EXPECT_EQ(p.site, vertex);
    const Projected_point again = project(p.point, p.site);
    EXPECT_LT((again.point - p.point).norm(), 0.01 * complex.mean_edge_length());
    EXPECT_NEAR(p.normal.norm(), 1, 1e-12);
  }
}

TEST(Moving_least_squares_projection, goes_to_the_nearest_point_where_no_other_is_near)
{
  const Point_complex complex = CSCD::test::to_point_complex(CSCD::test::sphere(3));
  const Point_neighborhoods neighborhoods(complex);
  const Moving_least_squares_projection project(complex, neighborhoods);
  const Projected_point p = project({0, 0, 5}, 0);
  EXPECT_EQ(p.point, complex.point(p.site));
  EXPECT_EQ(p.normal, complex.normal(p.site));
  for (Index vertex = 0; vertex < complex.number_of_vertices(); ++vertex) {
    EXPECT_LE(complex.point(vertex).z(), p.point.z());
  }
}

} // namespace
