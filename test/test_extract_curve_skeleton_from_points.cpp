// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons of point sets: their topology on generated shapes of several densities and noise levels, their invariance,
// and input without a possible surface.

#include "support/Shape.h"
#include "support/Similarity.h"
#include "support/Skeleton_comparison.h"
#include "support/invariants.h"
#include "support/message_of.h"
#include "support/point_skeletons.h"
#include "support/sampling.h"
#include "support/shapes.h"
#include <CSCD/exceptions.h>
#include <CSCD/extract_curve_skeleton_from_points.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Points = std::vector<Point>;
using Skeleton = CSCD::Skeleton_graph<Point, std::size_t>;
using CSCD::test::mean_distance, CSCD::test::plain, CSCD::test::Plain_skeleton, CSCD::test::renamed, CSCD::test::Shape,
    CSCD::test::Shape_maker, CSCD::test::Similarity, CSCD::test::Triple;
using CSCD::test::operator*;

Points to_points(const std::vector<Triple>& triples)
{
  return CSCD::test::to_points<Point>(triples);
}

struct Outcome
{
  Skeleton skeleton;
  CSCD::Skeletonization_report report;
};

/// Skeletonizes and checks properties that hold for every point set.
Outcome skeletonize(const std::vector<Triple>& triples)
{
  const Points points = to_points(triples);
  Outcome outcome;
  outcome.report = CSCD::extract_curve_skeleton(points, outcome.skeleton);
  CSCD::test::expect_partition(outcome.skeleton, points.size());
  const CSCD::test::Skeleton_facts facts = CSCD::test::skeleton_facts(outcome.skeleton);
  EXPECT_EQ(points.size(), outcome.report.number_of_input_vertices);
  EXPECT_EQ(facts.number_of_components, outcome.report.number_of_surface_components);
  EXPECT_EQ(facts.betti_number, outcome.report.genus);
  EXPECT_EQ(CSCD::test::Violations{}, CSCD::test::violations_of_graph(outcome.skeleton));
  EXPECT_TRUE(outcome.report.reconstruction.has_value());
  return outcome;
}

void expect_topology(const Shape& shape, const Outcome& outcome)
{
  EXPECT_EQ(shape.number_of_components, outcome.report.number_of_skeleton_components);
  EXPECT_EQ(shape.genus, outcome.report.betti_number);
}

std::vector<Shape_maker> shapes()
{
  using namespace CSCD::test;
  return {{"capsule", [] { return capsule(8, 1, 24); }},
          {"torus", [] { return torus(3, 1, 24); }},
          {"trefoil_knot", [] { return trefoil_knot(0.4, 16); }},
          {"chain_of_rings", [] { return chain_of_rings(3, 16); }},
          {"y_tube", [] { return y_tube(0.15); }},
          {"hand", [] { return hand(0.12); }},
          {"double_torus", [] { return double_torus(0.12); }},
          {"genus_4", [] { return ladder(4, 0.15); }},
          {"sphere", [] { return sphere(4); }},
          {"two_components", [] {
             return merged("", {capsule(8, 1, 16), translated(torus(3, 1, 16), {0, 10, 0})});
           }}};
}

class Sampled_shape : public testing::TestWithParam<Shape_maker>
{
protected:
  static constexpr std::size_t number = 6000;
  Shape m_shape = GetParam().make();
};

INSTANTIATE_TEST_SUITE_P(All, Sampled_shape, testing::ValuesIn(shapes()), testing::PrintToStringParamName());

TEST_P(Sampled_shape, has_the_topology_of_the_shape)
{
  for (const std::size_t n : {3000u, 8000u}) {
    for (const unsigned seed : {1u, 2u, 3u}) {
      SCOPED_TRACE(std::to_string(n) + " points, seed " + std::to_string(seed));
      expect_topology(m_shape, skeletonize(sampled(m_shape, n, seed)));
    }
  }
}

TEST_P(Sampled_shape, has_it_under_noise)
{
  const double spacing = mean_spacing(m_shape, number);
  const std::vector<Triple> clean = sampled(m_shape, number, 1);
  double noise = skeletonize(clean).report.reconstruction->noise;
  for (const double deviation : {0.3, 0.6, 1.0}) {
    SCOPED_TRACE(deviation);
    const Outcome outcome = skeletonize(CSCD::test::shaken(clean, deviation * spacing, 2));
    // With noise as large as the spacing, thin limbs and bodies that nearly touch cannot be distinguished.
    if (deviation < 1) {
      expect_topology(m_shape, outcome);
    }
    EXPECT_LT(noise, outcome.report.reconstruction->noise);
    noise = outcome.report.reconstruction->noise;
    EXPECT_EQ(deviation > 0.5, outcome.report.reconstruction->is_smoothed);
  }
}

TEST_P(Sampled_shape, handles_missing_data)
{
  std::vector<Triple> points = sampled(m_shape, number, 1);
  const double radius = 0.02 * diagonal(m_shape);
  for (const std::size_t i : {0u, 1000u, 2000u, 3000u}) {
    points = CSCD::test::without_ball(std::move(points), Triple(points[i]), radius);
  }
  expect_topology(m_shape, skeletonize(points));
}

TEST_P(Sampled_shape, handles_duplicates_and_outliers)
{
  std::vector<Triple> points = sampled(m_shape, number, 1);
  const Outcome clean = skeletonize(points);
  const std::vector<Triple> twice(points.begin(), points.begin() + 500);
  points.insert(points.end(), twice.begin(), twice.end());
  std::mt19937_64 random(1);
  const double far = diagonal(m_shape);
  for (int i = 0; i < 10; ++i) {
    const Triple direction =
        CSCD::test::unit({CSCD::test::random_signed_unit(random), CSCD::test::random_signed_unit(random),
                          CSCD::test::random_signed_unit(random)});
    points.push_back((2 + i) * far * direction);
  }
  const Outcome outcome = skeletonize(points);
  expect_topology(m_shape, outcome);
  EXPECT_EQ(500u, outcome.report.reconstruction->number_of_duplicates);
  EXPECT_EQ(10u, outcome.report.reconstruction->number_of_outliers);
  EXPECT_LE(10u, outcome.report.reconstruction->number_of_unused_points);
}

TEST_P(Sampled_shape, handles_stray_points_around_it)
{
  std::vector<Triple> points = sampled(m_shape, number, 1);
  const Outcome clean = skeletonize(points);
  const Triple center = points.front();
  std::mt19937_64 random(1);
  for (std::size_t i = 0; i < number / 50; ++i) {
    Triple& point = points.emplace_back(center);
    for (double& coordinate : point) {
      coordinate += 0.5 * diagonal(m_shape) * CSCD::test::random_signed_unit(random);
    }
  }
  const Outcome outcome = skeletonize(points);
  expect_topology(m_shape, outcome);
  EXPECT_EQ(clean.report.number_of_tips, outcome.report.number_of_tips);
  EXPECT_EQ(0u, outcome.report.number_of_edges_outside);
}

TEST_P(Sampled_shape, has_nearly_the_skeleton_of_the_mesh)
{
  if (m_shape.name == CSCD::test::sphere(4).name) {
    GTEST_SKIP() << "a ball has no natural curve skeleton";
  }
  using Mesh = CGAL::Surface_mesh<Point>;
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(m_shape);
  CSCD::Skeleton_graph<Point, Mesh::Vertex_index> expected;
  CSCD::extract_curve_skeleton(mesh, expected);
  const std::vector<Triple> of_mesh = CSCD::test::plain(mesh, expected).points;
  const std::vector<Triple> of_points = plain(skeletonize(sampled(m_shape, number, 1)).skeleton).points;
  // The sites of nodes differ; ends may be a radius apart.
  const double tolerance = 0.02 * diagonal(m_shape);
  EXPECT_LT(mean_distance(of_points, of_mesh), tolerance);
  EXPECT_LT(mean_distance(of_mesh, of_points), tolerance);
}

std::vector<Triple> some_points()
{
  return sampled(CSCD::test::double_torus(0.2), 8000, 1);
}

TEST(Point_skeleton, does_not_depend_on_the_order_of_the_points)
{
  const std::vector<Triple> points = some_points();
  std::mt19937_64 random(1);
  const std::vector<std::size_t> order = CSCD::test::random_permutation(points.size(), random);
  EXPECT_EQ(plain(skeletonize(points).skeleton),
            renamed(plain(skeletonize(CSCD::test::permuted(points, order)).skeleton), order));
}

/// Where holes are closed by faces without area, too: rounding must not decide.
TEST(Point_skeleton, moves_with_the_points)
{
  const Similarity motion{1.7, CSCD::test::unit({1, 2, 3}), 2, {1, 2, 3}};
  const Shape chain = CSCD::test::chain_of_rings(3, 16);
  for (const auto& [shape, number, seed] :
       {std::tuple(CSCD::test::hand(0.12), 1000, 2), std::tuple(chain, 1000, 3), std::tuple(chain, 800, 2),
        std::tuple(CSCD::test::ladder(4, 0.15), 2000, 3)}) {
    SCOPED_TRACE(shape.name);
    const std::vector<Triple> points = sampled(shape, std::size_t(number), unsigned(seed));
    const Plain_skeleton expected = moved(plain(skeletonize(points).skeleton), motion);
    EXPECT_EQ(difference(expected, plain(skeletonize(moved(points, motion)).skeleton), 1e-6 * diagonal(shape)), "");
  }
}

TEST(Point_skeleton, does_not_depend_on_the_number_of_threads)
{
  const Points points = to_points(some_points());
  Skeleton expected;
  CSCD::extract_curve_skeleton(points, expected);
  for (const unsigned number_of_threads : {1u, 2u, 4u}) {
    Skeleton skeleton;
    CSCD::extract_curve_skeleton<CGAL::Parallel_if_available_tag>(
        points, skeleton, CSCD::parameters::number_of_threads(number_of_threads));
    EXPECT_EQ(plain(expected), plain(skeleton));
  }
}

TEST(Point_skeleton, is_the_same_for_all_ranges)
{
  const Points points = to_points(some_points());
  Skeleton expected;
  CSCD::extract_curve_skeleton(points, expected);

  CGAL::Point_set_3<Point> point_set;
  std::vector<std::pair<int, Point>> pairs;
  for (const Point& p : points) {
    point_set.insert(p);
    pairs.emplace_back(0, p);
  }
  Skeleton of_pairs;
  CSCD::extract_curve_skeleton(
      pairs, of_pairs,
      CSCD::parameters::point_map(CGAL::Second_of_pair_property_map<std::pair<int, Point>>()).random_seed(0));
  EXPECT_EQ(plain(expected), plain(of_pairs));

  CSCD::Skeleton_graph<Point, CGAL::Point_set_3<Point>::Index> of_point_set;
  CSCD::extract_curve_skeleton(point_set, of_point_set);
  ASSERT_EQ(num_vertices(expected), num_vertices(of_point_set));
  for (std::size_t node = 0; node < num_vertices(expected); ++node) {
    EXPECT_EQ(expected[node].point, of_point_set[node].point);
    ASSERT_EQ(expected[node].vertices.size(), of_point_set[node].vertices.size());
    EXPECT_TRUE(std::equal(expected[node].vertices.begin(), expected[node].vertices.end(),
                           of_point_set[node].vertices.begin()));
  }
}

/// Triangles across the given normals are refused.
TEST(Point_skeleton, uses_normals)
{
  const Shape ball = CSCD::test::sphere(4);
  const std::vector<Triple> inner = sampled(ball, 3000, 1);
  CGAL::Point_set_3<Point> points;
  points.add_normal_map();
  for (const Triple& p : inner) {
    const Triple n = CSCD::test::unit(p);
    points.insert(Point(p[0], p[1], p[2]), Vector(n[0], n[1], n[2]));
  }
  CSCD::Skeleton_graph<Point, CGAL::Point_set_3<Point>::Index> skeleton;
  const auto report = CSCD::extract_curve_skeleton(points, skeleton);
  EXPECT_EQ(0u, report.reconstruction->number_of_border_edges);
  // Normals along the surface contradict its triangles.
  for (const auto& index : points) {
    const Point& p = points.point(index);
    const Triple tangent = CSCD::test::unit(CSCD::test::cross({p.x(), p.y(), p.z()}, {0, 0, 1}));
    points.normal(index) = Vector(tangent[0], tangent[1], tangent[2]);
  }
  EXPECT_THROW(CSCD::extract_curve_skeleton(points, skeleton), CSCD::Input_error);
}

TEST(Point_skeleton, ignores_normals_that_are_all_zero)
{
  CGAL::Point_set_3<Point> points;
  points.add_normal_map(); // filled with zeros
  for (int i = 0; i < 8; ++i) {
    points.insert(Point(i & 1, i >> 1 & 1, i >> 2));
  }
  CSCD::Skeleton_graph<Point, CGAL::Point_set_3<Point>::Index> skeleton;
  EXPECT_EQ(0u, CSCD::extract_curve_skeleton(points, skeleton).reconstruction->number_of_border_edges);
}

/// A disc with two holes, as thick as its points are far apart.
TEST(Point_skeleton, of_a_thin_plate_is_that_of_a_sheet)
{
  std::mt19937 generator;
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::bernoulli_distribution is_upper;
  std::vector<Triple> points;
  while (points.size() < 10000) {
    const double x = coordinate(generator), y = coordinate(generator);
    if (std::hypot(x, y) < 1 && std::hypot(x - 0.5, y) > 0.3 && std::hypot(x + 0.5, y) > 0.3) {
      points.push_back({x, y, is_upper(generator) ? 0.01 : -0.01});
    }
  }
  const Outcome outcome = skeletonize(points);
  EXPECT_EQ(2u, outcome.report.betti_number);
  EXPECT_EQ(0u, outcome.report.number_of_tips);
  EXPECT_EQ(3u, outcome.report.number_of_wide_borders);
  EXPECT_FALSE(outcome.report.warnings.empty());
}

TEST(Point_skeleton, keeps_interlocked_rings_apart)
{
  using namespace CSCD::test;
  Shape other = torus(3, 0.8, 24);
  for (Triple& p : other.points) {
    p = Triple{p[0] + 3, p[2], p[1]};
  }
  const Shape rings = merged("", {torus(3, 0.8, 24), other});
  const Outcome outcome = skeletonize(sampled(rings, 8000, 1));
  EXPECT_EQ(2u, outcome.report.number_of_skeleton_components);
  EXPECT_EQ(2u, outcome.report.betti_number);
}

TEST(Point_skeleton, keeps_close_sheets_apart)
{
  using namespace CSCD::test;
  // Two balls, five mean distances apart.
  const Shape balls = merged("", {sphere(4), translated(sphere(4), {2.15, 0, 0})});
  EXPECT_EQ(2u, skeletonize(sampled(balls, 8000, 1)).report.number_of_skeleton_components);
}

TEST(Point_skeleton, keeps_the_sides_of_a_thin_wall_apart)
{
  for (const auto& [wall, number] : {std::pair(0.06, 20000), std::pair(0.05, 40000)}) {
    Shape pipe = CSCD::test::plate_with_hole(); // from 0 to 10, with a hole from 3 to 7
    for (Triple& point : pipe.points) {
      for (double* x : {&point[0], &point[1]}) {
        *x = *x == 3 ? wall : *x == 7 ? 1 - wall : *x / 10;
      }
    }
    for (const unsigned seed : {1, 2}) {
      const auto report = skeletonize(sampled(pipe, std::size_t(number), seed)).report;
      EXPECT_EQ(report.betti_number, 1u) << wall << ' ' << seed;
      EXPECT_EQ(report.number_of_tips, 0u) << wall << ' ' << seed;
    }
  }
}

TEST(Point_skeleton, joins_the_stumps_of_a_severed_limb)
{
  using namespace CSCD::test;
  std::vector<Triple> points = sampled(tube(10, 1, 24, Tube_end::flat), 6000, 1);
  points.erase(std::remove_if(points.begin(), points.end(), [](const Triple& p) { return std::abs(p[0] - 5) < 0.15; }),
               points.end());
  const Outcome outcome = skeletonize(points);
  EXPECT_EQ(1u, outcome.report.number_of_skeleton_components);
}

TEST(Point_skeleton, handles_few_or_coplanar_points)
{
  std::mt19937_64 random(1);
  for (const std::size_t number : {4u, 5u, 6u, 8u, 12u, 20u, 50u}) {
    SCOPED_TRACE(number);
    std::vector<Triple> points = sampled(CSCD::test::sphere(3), number, 1);
    EXPECT_LE(1u, skeletonize(points).report.number_of_skeleton_components);
  }
  std::vector<Triple> plane;
  for (int i = 0; i < 1000; ++i) {
    plane.push_back({CSCD::test::random_unit(random), CSCD::test::random_unit(random), 0});
  }
  EXPECT_EQ(1u, skeletonize(plane).report.number_of_skeleton_components);
}

/// Expects a message with `part`; the skeleton stays as it was.
void expect_refusal(const std::vector<Triple>& points, const std::string& part)
{
  Skeleton skeleton(1);
  const std::string message =
      CSCD::test::message_of([&] { CSCD::extract_curve_skeleton(to_points(points), skeleton); });
  EXPECT_NE(std::string::npos, message.find(part)) << message;
  EXPECT_EQ(1u, num_vertices(skeleton));
}

TEST(Point_skeleton, refuses_what_has_no_surface)
{
  expect_refusal({}, "empty");
  expect_refusal({{1, 2, 3}}, "same place");
  expect_refusal(std::vector<Triple>(10, {1, 2, 3}), "same place");
  expect_refusal({{1, 2, 3}, {2, 3, 4}}, "2 different points");
  expect_refusal({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}, "3 different points");
  std::vector<Triple> line;
  std::vector<Triple> circle;
  for (int i = 0; i < 500; ++i) {
    line.push_back({0.1 * i, -0.2 * i, 0.3 * i});
    circle.push_back({std::cos(0.01256 * i), std::sin(0.01256 * i), 0.1 * std::sin(0.05 * i)});
  }
  expect_refusal(line, "one line");
  expect_refusal(circle, "do not sample a surface");
}

TEST(Point_skeleton, calls_sparse_slices_no_scan_of_a_tree)
{
  std::vector<Triple> contours;
  for (int i = 0; i < 20000; ++i) {
    contours.push_back({std::cos(0.001 * i), std::sin(0.001 * i), 0.5 * (i % 10)});
  }
  expect_refusal(contours, "parallel planes");
  Skeleton skeleton;
  try {
    CSCD::extract_curve_skeleton(to_points(contours), skeleton);
  } catch (const CSCD::Surface_error& error) { // which leads the program on to trees
    ADD_FAILURE() << error.what();
  } catch (const CSCD::Input_error&) {
  }
}

TEST(Point_skeleton, refuses_coordinates_that_are_not_finite)
{
  std::vector<Triple> points = some_points();
  points[17][1] = std::numeric_limits<double>::quiet_NaN();
  expect_refusal(points, "point 17 ");
  points[17][1] = std::numeric_limits<double>::infinity();
  expect_refusal(points, "point 17 ");
}

} // namespace
