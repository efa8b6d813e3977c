// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Complexes of samples of shapes: their topology, sides, sheets that are near each other, noise and defects; what must
// not change them, and points that are no surface.

#include "Points/to_point_cloud.h"
#include "Traits/message_of.h"
#include "support/Shape.h"
#include "support/Similarity.h"
#include "support/sampling.h"
#include "support/shapes.h"
#include <CSCD/Points/build_point_complex.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Point_cloud;
using CSCD::Point_complex;
using CSCD::Vector_3;
using CSCD::internal::build_point_complex;
using CSCD::test::Shape;
using CSCD::test::Shape_maker;
using CSCD::test::to_point_cloud;
using CSCD::test::Triple;

/// What tells whether a complex is a surface, and which.
struct Complex_facts
{
  explicit Complex_facts(const Point_complex& complex)
  {
    std::vector<int> faces_of_side(complex.number_of_halfedges(), 0);
    for (Index f = 0; f < complex.number_of_faces(); ++f) {
      for (const Index h : complex.face_halfedges(f)) {
        ++faces_of_side[h];
      }
      const auto [a, b, c] = complex.face_vertices(f);
      volume += complex.point(a).dot(complex.point(b).cross(complex.point(c))) / 6;
    }
    for (Index h = 0; h < complex.number_of_halfedges(); ++h) {
      incoherent += faces_of_side[h] > 1 ? 1 : 0;
      if (complex.edge(h) == h) {
        ++edges;
        const int number = faces_of_side[h] + faces_of_side[complex.twin(h)];
        border += number == 1 ? 1 : 0;
        bare += number == 0 ? 1 : 0;
      }
    }
    long used = 0;
    for (Index v = 0; v < complex.number_of_vertices(); ++v) {
      used += complex.outgoing(v).empty() ? 0 : 1;
      area += complex.vertex_area(v);
    }
    isolated = complex.number_of_vertices() - used;
    euler_number = used - edges + long(complex.number_of_faces());
  }

  long edges = 0;
  long border = 0;     // edges of one triangle
  long bare = 0;       // edges without
  long incoherent = 0; // halfedges of several triangles
  long isolated = 0;   // vertices without edges
  long euler_number = 0;
  double area = 0;
  double volume = 0;
};

double area(const Shape& shape)
{
  double sum = 0;
  for (const auto& t : shape.triangles) {
    sum += CSCD::test::area(shape, t);
  }
  return sum;
}

double volume(const Shape& shape)
{
  double sum = 0;
  for (const auto& t : shape.triangles) {
    sum += CSCD::test::dot(shape.points[t[0]], CSCD::test::cross(shape.points[t[1]], shape.points[t[2]])) / 6;
  }
  return sum;
}

/// A closed shape, and how many pieces and handles it has.
struct Known_shape
{
  Shape_maker maker;
  long euler_number;
  Index components;
};

void PrintTo(const Known_shape& shape, std::ostream* out)
{
  PrintTo(shape.maker, out);
}

std::string name_of_known_shape(const testing::TestParamInfo<Known_shape>& shape)
{
  return shape.param.maker.name;
}

class Complex_of_shape : public testing::TestWithParam<Known_shape>
{
};

std::vector<Known_shape> known_shapes()
{
  using namespace CSCD::test;
  return {{{"sphere", [] { return sphere(4); }}, 2, 1},
          {{"torus", [] { return torus(3, 1, 24); }}, 0, 1},
          {{"knot", [] { return trefoil_knot(0.4, 16); }}, 0, 1},
          {{"rings", [] { return chain_of_rings(3, 24); }}, 0, 3},
          {{"hollow_sphere", [] { return hollow_sphere(4); }}, 4, 2},
          {{"genus_4", [] { return ladder(4, 0.15); }}, -6, 1}};
}

INSTANTIATE_TEST_SUITE_P(All, Complex_of_shape, testing::ValuesIn(known_shapes()), name_of_known_shape);

void expect_closed(const Known_shape& known, const Shape& shape, const std::vector<Triple>& points)
{
  const Point_cloud cloud = to_point_cloud(points);
  const Point_complex complex = build_point_complex(cloud);
  const Complex_facts facts(complex);
  EXPECT_EQ(0, facts.border);
  EXPECT_EQ(0, facts.bare);
  EXPECT_EQ(0, facts.incoherent);
  EXPECT_EQ(0, facts.isolated);
  EXPECT_EQ(known.euler_number, facts.euler_number);
  EXPECT_EQ(known.components, complex.number_of_components());
  const double unit = cloud.normalization.unit;
  EXPECT_NEAR(1, facts.area * unit * unit / area(shape), 0.02);
  if (known.components != 2) { // the inner wall of a hollow body looks inwards, but nobody told
    EXPECT_NEAR(1, facts.volume * std::pow(unit, 3) / volume(shape), 0.06);
  }
}

TEST_P(Complex_of_shape, is_closed_for_even_samples)
{
  const Shape shape = GetParam().maker.make();
  expect_closed(GetParam(), shape, shape.points);
}

TEST_P(Complex_of_shape, is_closed_for_random_samples)
{
  const Shape shape = GetParam().maker.make();
  expect_closed(GetParam(), shape, CSCD::test::sampled(shape, 8000, 1));
}

TEST_P(Complex_of_shape, has_few_holes_where_there_is_noise)
{
  const Shape shape = GetParam().maker.make();
  constexpr std::size_t number = 4000;
  for (const double deviation : {0.3, 0.6}) {
    SCOPED_TRACE(deviation);
    const double noise = deviation * CSCD::test::mean_spacing(shape, number);
    const Point_cloud cloud = to_point_cloud(CSCD::test::shaken(CSCD::test::sampled(shape, number, 1), noise, 2));
    const Point_complex complex = build_point_complex(cloud);
    const Complex_facts facts(complex);
    EXPECT_LT(double(facts.border), 0.01 * double(facts.edges));
    EXPECT_LT(double(facts.isolated), 0.01 * double(number));
    EXPECT_EQ(0, facts.bare);
    EXPECT_EQ(0, facts.incoherent);
    EXPECT_NEAR(1, facts.area * std::pow(cloud.normalization.unit, 2) / area(shape), 0.08);
  }
}

/// The triangles by the numbers of the points in the input.
std::set<std::array<std::size_t, 3>> triangles_of_input(const std::vector<Triple>& points)
{
  const Point_cloud cloud = to_point_cloud(points);
  std::vector<std::size_t> number(cloud.points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    number[cloud.input_point[i]] = i;
  }
  const Point_complex complex = build_point_complex(cloud);
  std::set<std::array<std::size_t, 3>> result;
  for (Index f = 0; f < complex.number_of_faces(); ++f) {
    const auto [a, b, c] = complex.face_vertices(f);
    std::array<std::size_t, 3> triangle{number[a], number[b], number[c]};
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    result.insert(triangle);
  }
  return result;
}

TEST_P(Complex_of_shape, does_not_depend_on_order_and_pose)
{
  const std::vector<Triple> points = CSCD::test::sampled(GetParam().maker.make(), 3000, 1);
  const auto expected = triangles_of_input(points);
  EXPECT_TRUE(expected == triangles_of_input(points)) << "again";

  std::mt19937_64 random(1);
  const std::vector<std::size_t> order = CSCD::test::random_permutation(points.size(), random);
  std::set<std::array<std::size_t, 3>> renumbered;
  for (std::array<std::size_t, 3> triangle : triangles_of_input(CSCD::test::permuted(points, order))) {
    for (std::size_t& vertex : triangle) {
      vertex = order[vertex];
    }
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    renumbered.insert(triangle);
  }
  EXPECT_TRUE(expected == renumbered);

  const CSCD::test::Similarity similarity = {1e3, CSCD::test::unit({1, 2, 3}), 0.7, {5, -40, 300}};
  std::vector<Triple> moved = points;
  for (Triple& point : moved) {
    point = similarity(point);
  }
  EXPECT_TRUE(expected == triangles_of_input(moved));
}

/// Two parallel square grids of unit spacing, `gap` apart, one of them shifted.
std::vector<Triple> two_sheets(double gap, int size)
{
  std::vector<Triple> result;
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) {
      result.push_back({double(i), double(j), 0});
      result.push_back({i + 0.5, j + 0.3, gap});
    }
  }
  return result;
}

TEST(build_point_complex, keeps_sheets_apart)
{
  constexpr int size = 30;
  for (const double gap : {2., 3.}) {
    SCOPED_TRACE(gap);
    const Point_cloud cloud = to_point_cloud(two_sheets(gap, size));
    const Point_complex complex = build_point_complex(cloud);
    long joints = 0;
    for (Index h = 0; h < complex.number_of_halfedges(); ++h) {
      const Vector_3 a = cloud.normalization.to_input(complex.point(complex.origin(h)));
      const Vector_3 b = cloud.normalization.to_input(complex.point(complex.target(h)));
      // At the rim, the sheets may well be those of one body.
      constexpr double rim = 2;
      const bool is_inside = std::min({a.x(), a.y(), size - a.x(), size - a.y()}) > rim;
      joints += is_inside && std::fabs(a.z() - b.z()) > gap / 2 ? 1 : 0;
    }
    EXPECT_EQ(0, joints);
    EXPECT_NEAR(2. * (size - 1) * (size - 1), Complex_facts(complex).area * std::pow(cloud.normalization.unit, 2),
                4. * size * gap);
  }
}

TEST(build_point_complex, leaves_holes_open)
{
  const std::vector<Triple> points =
      CSCD::test::without_ball(CSCD::test::sampled(CSCD::test::sphere(4), 4000, 1), {0, 0, 1}, 0.5);
  const Complex_facts facts(build_point_complex(to_point_cloud(points)));
  EXPECT_EQ(1, facts.euler_number);
  EXPECT_GT(facts.border, 20);
}

TEST(build_point_complex, of_a_grid_is_a_disc)
{
  std::vector<Triple> points;
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < 20; ++j) {
      points.push_back({double(i), double(j), 0});
    }
  }
  const Point_cloud cloud = to_point_cloud(points);
  const Complex_facts facts(build_point_complex(cloud));
  EXPECT_EQ(1, facts.euler_number);
  EXPECT_EQ(0, facts.isolated);
  EXPECT_NEAR(19 * 19, facts.area * std::pow(cloud.normalization.unit, 2), 1e-6);
}

TEST(build_point_complex, leaves_out_outliers_and_joins_duplicates)
{
  std::vector<Triple> points = CSCD::test::sphere(3).points;
  const std::size_t number = points.size();
  for (std::size_t i = 0; i < number; i += 10) {
    points.push_back(points[i]);
  }
  points.push_back({20, 0, 0});
  const Point_cloud cloud = to_point_cloud(points);
  const Point_complex complex = build_point_complex(cloud);
  EXPECT_EQ(number + 1, complex.number_of_vertices());
  const Complex_facts facts(complex);
  EXPECT_EQ(1, facts.isolated);
  EXPECT_EQ(2, facts.euler_number);
  EXPECT_TRUE(complex.outgoing(cloud.input_point.back()).empty());
}

TEST(build_point_complex, makes_something_sane_of_anything)
{
  std::vector<std::vector<Triple>> clouds{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
                                          {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, 0.5, 1}},
                                          CSCD::test::tetrahedron().points,
                                          CSCD::test::cube().points};
  std::mt19937_64 random(1);
  clouds.emplace_back();
  for (int i = 0; i < 500; ++i) {
    clouds.back().push_back({std::cos(0.05 * i), std::sin(0.05 * i), 0.005 * i});
  }
  clouds.emplace_back();
  for (int i = 0; i < 1000; ++i) {
    clouds.back().push_back({CSCD::test::random_signed_unit(random), CSCD::test::random_signed_unit(random),
                             CSCD::test::random_signed_unit(random)});
  }
  clouds.emplace_back();
  for (int i = 0; i < 300; ++i) {
    clouds.back().push_back({i * 1e-9, (i * i % 7) * 1e-9, 0});
  }
  clouds.back().insert(clouds.back().end(), {{1, 1, 1}, {2, 1, 0}, {0, 1, 0}});
  for (const std::vector<Triple>& points : clouds) {
    SCOPED_TRACE(points.size());
    const std::string message = CSCD::test::message_of([&] {
      const Complex_facts facts(build_point_complex(to_point_cloud(points)));
      EXPECT_EQ(0, facts.bare);
      EXPECT_EQ(0, facts.incoherent);
      EXPECT_TRUE(std::isfinite(facts.area));
    });
    EXPECT_TRUE(message.empty() || CSCD::test::names(message, "no triangle could be made")) << message;
  }
}

} // namespace
