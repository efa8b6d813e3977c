// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cut loci of point clouds: at the places that symmetry implies, with and without noise, for any order of the points.

#include "support/Similarity.h"
#include "support/convert_shape.h"
#include "support/invariants.h"
#include "support/sampling.h"
#include "support/shapes.h"
#include <CSCD/Published/Cut_locus_extraction.h>
#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Traits/Input_points.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/extract_cut_locus_from_points.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/property_map.h>

#include <boost/range/iterator_range.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <limits>
#include <random>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Graph = CSCD::Point_cut_locus_graph<Point>;
using CSCD::test::pi, CSCD::test::Shape, CSCD::test::Triple;
using CSCD::test::operator*;
using CSCD::test::operator-;
namespace parameters = CSCD::parameters;

std::size_t nearest_point(const std::vector<Triple>& points, const Triple& p)
{
  return std::size_t(std::min_element(points.begin(), points.end(),
                                      [&](const Triple& a, const Triple& b) {
                                        return CSCD::test::norm(a - p) < CSCD::test::norm(b - p);
                                      }) -
                     points.begin());
}

/// The cut locus of the point that is nearest to `source`.
Graph point_cut_locus(const std::vector<Triple>& points, const Triple& source)
{
  Graph graph;
  CSCD::extract_cut_locus(CSCD::test::to_points<Point>(points), nearest_point(points, source), graph);
  return graph;
}

double distance_from(const Graph& graph, const Triple& p)
{
  double least = std::numeric_limits<double>::max();
  for (const auto v : boost::make_iterator_range(vertices(graph))) {
    least = std::min(least, CSCD::test::norm(CSCD::test::to_triple(graph[v].point) - p));
  }
  return least;
}

/// Some samples of a shape, with about the same length of edges.
struct Samples
{
  Samples(const Shape& shape, std::size_t number)
      // Of triangles with six at each point, the edge length is 2.15 times the mean distance to the nearest point.
      : edge(2.15 * CSCD::test::mean_spacing(shape, number))
  {
    const std::vector<Triple> points = CSCD::test::sampled(shape, number, 5);
    clouds = {points, CSCD::test::shaken(points, 0.3 * CSCD::test::mean_spacing(shape, number), 6)};
  }

  double edge;
  std::vector<std::vector<Triple>> clouds;
};

TEST(extract_cut_locus_from_points, of_a_sphere_is_the_antipode)
{
  const Samples samples(CSCD::test::sphere(5), 4000);
  for (const auto& points : samples.clouds) {
    for (const Triple& source : {Triple{0, 0, 1}, Triple{0.6, 0.8, 0}, Triple{-0.5, 0.7, 0.2}}) {
      Graph graph;
      // At less than that fronts meet in a wider spot: they come from all sides.
      CSCD::extract_cut_locus(CSCD::test::to_points<Point>(points), nearest_point(points, source), graph,
                              parameters::angle_threshold(pi / 3));
      EXPECT_EQ(CSCD::test::skeleton_facts(graph).number_of_components, 1u);
      for (const auto v : boost::make_iterator_range(vertices(graph))) {
        const Triple opposite = -1 * CSCD::test::unit(points[nearest_point(points, source)]);
        EXPECT_LT(CSCD::test::norm(CSCD::test::to_triple(graph[v].point) - opposite), 4 * samples.edge);
        EXPECT_NEAR(graph[v].distance, pi, 4 * samples.edge);
      }
    }
  }
}

TEST(extract_cut_locus_from_points, of_a_torus_is_what_symmetry_says)
{
  const double major_radius = 1.5;
  const Samples samples(CSCD::test::torus(major_radius, 1, 64), 6000);
  for (const auto& points : samples.clouds) {
    const Graph graph = point_cut_locus(points, {major_radius + 1, 0, 0});
    EXPECT_EQ(CSCD::test::skeleton_facts(graph).number_of_components, 1u);
    // The vertices of the cut locus are points of the cloud, not moved onto the curve: three edges away at most.
    for (const auto v : boost::make_iterator_range(vertices(graph))) {
      const Triple p = CSCD::test::to_triple(graph[v].point);
      const double from_meridian = p[0] < 0 ? std::fabs(p[1]) : std::numeric_limits<double>::max();
      EXPECT_LT(std::min(std::fabs(p[2]), from_meridian), 3.5 * samples.edge) << p[0] << ' ' << p[1] << ' ' << p[2];
    }
    // Where fronts meet at an angle that can be seen: on the outer equator behind its conjugate points, which are at
    // the angle 1.99, and on the inner one towards the source. Elsewhere the loops are open.
    for (double angle = 0; angle < 0.75; angle += 0.05) {
      const double radius = major_radius + 1;
      EXPECT_LT(distance_from(graph, {-radius * std::cos(angle), radius * std::sin(angle), 0}), 1.5 * samples.edge);
      EXPECT_LT(distance_from(graph, {-radius * std::cos(angle), -radius * std::sin(angle), 0}), 1.5 * samples.edge);
    }
    for (double angle = -1.5; angle < 1.5; angle += 0.05) {
      const double radius = major_radius - 1;
      EXPECT_LT(distance_from(graph, {radius * std::cos(angle), radius * std::sin(angle), 0}), 1.5 * samples.edge);
    }
    EXPECT_GT(distance_from(graph, {2.5 * std::cos(1.6), 2.5 * std::sin(1.6), 0}), 0.3);
  }
}

TEST(extract_cut_locus_from_points, of_an_ellipsoid_is_an_arc)
{
  const Samples samples(CSCD::test::ellipsoid({2, 1.2, 1}, 5), 5000);
  for (const auto& points : samples.clouds) {
    const Graph graph = point_cut_locus(points, {0, 0, 1});
    EXPECT_EQ(CSCD::test::skeleton_facts(graph).number_of_components, 1u);
    EXPECT_LT(distance_from(graph, {0, 0, -1}), 1.5 * samples.edge);
    for (const auto v : boost::make_iterator_range(vertices(graph))) {
      EXPECT_LT(std::fabs(graph[v].point.y()), 3 * samples.edge);
      EXPECT_LT(graph[v].point.z(), 0);
    }
  }
}

TEST(extract_cut_locus_from_points, moves_turns_and_scales_with_the_points_in_any_order)
{
  const std::vector<Triple> points = CSCD::test::sampled(CSCD::test::y_tube(0.2), 3000, 1);
  const Graph graph = point_cut_locus(points, points[7]);
  ASSERT_GT(num_vertices(graph), 10u);
  for (const auto v : boost::make_iterator_range(vertices(graph))) {
    EXPECT_LT(CSCD::test::norm(CSCD::test::to_triple(graph[v].point) - points[graph[v].location]), 1e-5);
    EXPECT_GT(graph[v].distance, 0);
  }
  for (const double scale : {1e-5, 1., 1e5}) {
    const CSCD::test::Similarity similarity{scale, CSCD::test::unit({1, 2, 3}), 0.7, {3 * scale, 1, 2}};
    std::mt19937_64 random(3);
    const std::vector<std::size_t> order = CSCD::test::random_permutation(points.size(), random);
    std::vector<Triple> moved(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      moved[order[i]] = similarity(points[i]);
    }
    Graph other;
    CSCD::extract_cut_locus(CSCD::test::to_points<Point>(moved), order[7], other);
    ASSERT_EQ(num_vertices(other), num_vertices(graph));
    ASSERT_EQ(num_edges(other), num_edges(graph));
    for (const auto v : boost::make_iterator_range(vertices(graph))) {
      EXPECT_LT(distance_from(other, similarity(CSCD::test::to_triple(graph[v].point))), 1e-5 * scale);
    }
  }
}

TEST(extract_cut_locus_from_points, lies_between_several_sources)
{
  const Samples samples(CSCD::test::sphere(5), 4000);
  const auto& points = samples.clouds.front();
  Graph graph;
  CSCD::extract_cut_locus(CSCD::test::to_points<Point>(points),
                          std::vector<std::size_t>{nearest_point(points, {0, 0, 1}), nearest_point(points, {0, 0, -1})},
                          graph);
  EXPECT_EQ(CSCD::test::skeleton_facts(graph).number_of_components, 1u);
  for (const auto v : boost::make_iterator_range(vertices(graph))) {
    EXPECT_LT(std::fabs(graph[v].point.z()), 2.5 * samples.edge);
  }
  for (double angle = 0; angle < 2 * pi; angle += 0.1) {
    EXPECT_LT(distance_from(graph, {std::cos(angle), std::sin(angle), 0}), 4 * samples.edge);
  }
}

TEST(extract_cut_locus_from_points, takes_far_less_than_quadratic_time)
{
  const auto least_time = [](std::size_t number) {
    const std::vector<Point> points =
        CSCD::test::to_points<Point>(CSCD::test::sampled(CSCD::test::torus(1.5, 1, 64), number, 5));
    double least = std::numeric_limits<double>::max();
    for (int i = 0; i < 3; ++i) {
      const std::clock_t begin = std::clock();
      Graph graph;
      CSCD::extract_cut_locus(points, 0, graph);
      least = std::min(least, double(std::clock() - begin));
    }
    return least;
  };
  // Four times as many points: sixteen times as long if the time is quadratic.
  EXPECT_LT(least_time(8000), 9 * least_time(2000));
}

TEST(extract_cut_locus_from_points, refuses_what_has_no_answer)
{
  std::vector<Triple> triples = CSCD::test::sampled(CSCD::test::sphere(4), 1000, 1);
  triples.push_back({9, 9, 9});
  const std::vector<Point> points = CSCD::test::to_points<Point>(triples);
  Graph graph(7);
  EXPECT_THROW(CSCD::extract_cut_locus(points, std::vector<std::size_t>{}, graph), CSCD::Input_error);
  EXPECT_THROW(CSCD::extract_cut_locus(points, points.size(), graph), CSCD::Input_error);
  EXPECT_THROW(CSCD::extract_cut_locus(points, points.size() - 1, graph), CSCD::Input_error) << "an outlier";
  EXPECT_THROW(CSCD::extract_cut_locus(std::vector<Point>(), 0, graph), CSCD::Input_error);
  EXPECT_THROW(CSCD::extract_cut_locus(std::vector<Point>(9, Point(1, 2, 3)), 0, graph), CSCD::Input_error);
  EXPECT_EQ(num_vertices(graph), 7u);
}

} // namespace
