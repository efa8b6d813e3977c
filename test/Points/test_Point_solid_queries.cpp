// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Winding numbers against their exact sums, and against what meshes hold.

#include "Points/to_point_complex.h"
#include "Surface/to_surface.h"
#include "support/sampling.h"
#include "support/shapes.h"
#include <CSCD/Points/Point_complex.h>
#include <CSCD/Points/Point_solid_queries.h>
#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Point_complex;
using CSCD::Vector_3;
using CSCD::internal::Winding_number;
using CSCD::test::pi;
using CSCD::test::Shape;
using CSCD::test::Triple;

/// Points in the bounding box of `points`, or a little out of it.
std::vector<Vector_3> queries_around(const std::vector<Vector_3>& points, std::size_t number)
{
  Vector_3 lower = points.front();
  Vector_3 upper = points.front();
  for (const Vector_3& p : points) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  std::mt19937_64 random(5);
  std::vector<Vector_3> result(number);
  for (Vector_3& query : result) {
    for (int axis = 0; axis < 3; ++axis) {
      query[axis] = lower[axis] + (1.2 * CSCD::test::random_unit(random) - 0.1) * (upper[axis] - lower[axis]);
    }
  }
  return result;
}

double exact_sum(const std::vector<Vector_3>& points, const std::vector<Vector_3>& area_vectors, const Vector_3& query)
{
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector_3 offset = points[i] - query;
    sum += area_vectors[i].dot(offset) / std::pow(offset.norm(), 3);
  }
  return sum / (4 * pi);
}

TEST(Winding_number, is_the_sum_over_all_points)
{
  const Shape shape = CSCD::test::y_tube(0.15);
  const Point_complex complex = CSCD::test::to_point_complex(CSCD::test::sampled(shape, 5000, 1));
  std::vector<Vector_3> area_vectors;
  for (Index vertex = 0; vertex < complex.number_of_vertices(); ++vertex) {
    area_vectors.emplace_back(complex.vertex_area(vertex) * complex.normal(vertex));
  }
  const Winding_number winding_number(complex);
  double squares = 0;
  const std::vector<Vector_3> queries = queries_around(complex.points(), 2000);
  for (const Vector_3& query : queries) {
    const double error = winding_number(query) - exact_sum(complex.points(), area_vectors, query);
    EXPECT_LT(std::abs(error), 0.03);
    squares += error * error;
  }
  EXPECT_LT(std::sqrt(squares / double(queries.size())), 0.004);
}

TEST(Winding_number, is_wrong_by_the_fifth_power_of_the_distance)
{
  // From far away the polynomial of all points is the answer: of degree two, of a field that falls with the square.
  std::mt19937_64 random(3);
  std::vector<Vector_3> points;
  std::vector<Vector_3> area_vectors;
  const auto random_vector = [&random] {
    Vector_3 result;
    std::generate(result.begin(), result.end(), [&random] { return CSCD::test::random_signed_unit(random); });
    return result;
  };
  for (int i = 0; i < 100; ++i) {
    points.push_back(random_vector());
    area_vectors.push_back(random_vector());
  }
  const Winding_number winding_number(points, area_vectors);
  for (const Vector_3& direction : {Vector_3(1, 0, 0), Vector_3(0.6, 0.8, 0), Vector_3(0.48, -0.6, 0.64)}) {
    const auto error = [&](double distance) {
      return std::abs(winding_number(distance * direction) - exact_sum(points, area_vectors, distance * direction));
    };
    EXPECT_LT(error(100), 1e-7);
    EXPECT_NEAR(error(400) * 1024, error(100), 0.3 * error(100));
  }
}

/// Compares with the mesh of the shape. \return the shares of wrong answers of all, and of those not near the surface
std::pair<double, double> wrong_shares(const Shape& shape, const Point_complex& complex, double near)
{
  const CSCD::Triangulated_surface surface = CSCD::test::to_surface(shape);
  const CSCD::internal::Solid_queries solid(surface);
  const Winding_number winding_number(complex);
  std::size_t wrong = 0;
  std::size_t wrong_off_surface = 0;
  std::size_t off_surface = 0;
  const std::vector<Vector_3> queries = queries_around(surface.points(), 3000);
  for (const Vector_3& query : queries) {
    const bool is_wrong = winding_number.is_inside(query) != solid.is_inside(query);
    wrong += is_wrong ? 1 : 0;
    if ((solid.closest_point(query).point - query).norm() > near) {
      ++off_surface;
      wrong_off_surface += is_wrong ? 1 : 0;
    }
  }
  EXPECT_GT(off_surface, queries.size() / 3);
  return {double(wrong) / double(queries.size()), double(wrong_off_surface) / double(off_surface)};
}

TEST(Winding_number, knows_the_inside_of_sampled_bodies)
{
  for (const Shape& shape : {CSCD::test::torus(3, 1, 48), CSCD::test::capsule(6, 1, 48), CSCD::test::y_tube(0.15),
                             CSCD::test::subdivided_cube(8)}) {
    SCOPED_TRACE(shape.name);
    for (const double noise : {0., 0.3}) {
      const std::size_t number = 4000;
      const double spacing = CSCD::test::mean_spacing(shape, number);
      const Point_complex complex =
          CSCD::test::to_point_complex(CSCD::test::shaken(CSCD::test::sampled(shape, number, 1), noise * spacing, 2));
      const auto [wrong, wrong_off_surface] = wrong_shares(shape, complex, 2 * spacing);
      EXPECT_LT(wrong, 0.02);
      EXPECT_EQ(wrong_off_surface, 0);
    }
  }
}

TEST(Winding_number, knows_the_inside_behind_holes)
{
  const Shape shape = CSCD::test::capsule(6, 1, 48);
  std::vector<Triple> points = CSCD::test::sampled(shape, 4000, 1);
  points = CSCD::test::without_ball(CSCD::test::without_ball(points, {3, 1, 0}, 0.6), {1, 0, -1}, 0.6);
  const auto [wrong, wrong_off_surface] = wrong_shares(shape, CSCD::test::to_point_complex(points), 0.1);
  EXPECT_LT(wrong, 0.03);
  EXPECT_LT(wrong_off_surface, 0.02);
}

TEST(Winding_number, handles_few_points)
{
  EXPECT_EQ(Winding_number({}, {})({1, 2, 3}), 0);
  const Winding_number one({{0, 0, 0}}, {{0, 0, 4 * pi}});
  EXPECT_DOUBLE_EQ(one({0, 0, -2}), 0.25);
  EXPECT_DOUBLE_EQ(one({0, 0, 2}), -0.25);
  EXPECT_EQ(one({0, 0, 0}), 0) << "its own place";
  const Winding_number many(std::vector<Vector_3>(100, {0, 0, 0}), std::vector<Vector_3>(100, {0, 0, 4 * pi / 100}));
  EXPECT_NEAR(many({0, 0, -2}), 0.25, 1e-12);
  EXPECT_EQ(many({0, 0, 0}), 0);
  const Winding_number nothing(std::vector<Vector_3>(100, {1, 0, 0}), std::vector<Vector_3>(100, {0, 0, 0}));
  EXPECT_EQ(nothing({0, 0, 0}), 0);
}

} // namespace
