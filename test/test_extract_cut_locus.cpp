// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Known cut loci, and the guarantees of the function on any surface.

#include "support/Similarity.h"
#include "support/convert_shape.h"
#include "support/invariants.h"
#include "support/shapes.h"
#include <CSCD/Published/Cut_locus_extraction.h>
#include <CSCD/Published/Cut_tree.h>
#include <CSCD/exceptions.h>
#include <CSCD/extract_cut_locus.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/range/iterator_range.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Graph = CSCD::Cut_locus_graph<Point, Mesh::Face_index>;
using CSCD::test::operator+;
using CSCD::test::operator-;
using CSCD::test::operator*;
using CSCD::test::pi, CSCD::test::Shape, CSCD::test::Shape_maker, CSCD::test::skeleton_facts, CSCD::test::Triple;
namespace parameters = CSCD::parameters;

double length(const Graph& graph)
{
  double sum = 0;
  for (const auto e : boost::make_iterator_range(edges(graph))) {
    sum += std::sqrt(CGAL::squared_distance(graph[source(e, graph)].point, graph[target(e, graph)].point));
  }
  return sum;
}

/// Distance from `p` to the nearest point of `graph`.
double distance_to(const Graph& graph, const Triple& p)
{
  double least = std::numeric_limits<double>::max();
  for (const auto v : boost::make_iterator_range(vertices(graph))) {
    least = std::min(least, CSCD::test::norm(CSCD::test::to_triple(graph[v].point) - p));
  }
  return least;
}

Vertex nearest_vertex(const Shape& shape, const Triple& p)
{
  const auto is_nearer = [&](const Triple& a, const Triple& b) {
    return CSCD::test::norm(a - p) < CSCD::test::norm(b - p);
  };
  return Vertex(
      Mesh::size_type(std::min_element(shape.points.begin(), shape.points.end(), is_nearer) - shape.points.begin()));
}

/// The cut locus of the vertex of `shape` that is nearest to `source`.
Graph cut_locus_of(const Shape& shape, const Triple& source)
{
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(shape);
  Graph graph;
  CSCD::extract_cut_locus(mesh, nearest_vertex(shape, source), graph);
  return graph;
}

TEST(extract_cut_locus, of_a_sphere_is_the_antipode)
{
  const Shape sphere = CSCD::test::sphere(4);
  const double edge = CSCD::test::mean_edge_length(sphere);
  for (const Triple& source : {Triple{0, 0, 1}, Triple{0.6, 0.8, 0}, Triple{-0.5, 0.7, 0.2}}) {
    const Graph graph = cut_locus_of(sphere, source);
    ASSERT_EQ(num_vertices(graph), 1u);
    const Triple opposite = -1 * CSCD::test::unit(sphere.points[nearest_vertex(sphere, source)]);
    EXPECT_LT(CSCD::test::norm(CSCD::test::to_triple(graph[0].point) - opposite), 1.5 * edge);
    EXPECT_NEAR(graph[0].distance, pi, 0.1);
  }
}

/// Expects the length of a curve that is `true_length` long, followed along edges: these are at most 2 / sqrt(3) times
/// as long among equilateral triangles.
void expect_length_along_edges(const Graph& graph, double true_length)
{
  EXPECT_GE(length(graph), 0.97 * true_length);
  EXPECT_LE(length(graph), 2 / std::sqrt(3.) * true_length);
}

TEST(extract_cut_locus, of_a_torus_is_what_symmetry_says)
{
  // From the outer equator: the meridian opposite, the inner equator, and the outer one behind its conjugate points.
  // On a thinner torus fronts meet at the inner equator at angles that no mesh resolves.
  const double major_radius = 1.5;
  const Shape torus = CSCD::test::torus(major_radius, 1, 40);
  const double edge = CSCD::test::mean_edge_length(torus);
  const Graph graph = cut_locus_of(torus, {major_radius + 1, 0, 0});
  EXPECT_EQ(skeleton_facts(graph).number_of_components, 1u);
  EXPECT_EQ(skeleton_facts(graph).betti_number, 2u);
  for (const auto v : boost::make_iterator_range(vertices(graph))) {
    const Triple p = CSCD::test::to_triple(graph[v].point);
    const double from_meridian = p[0] < 0 ? std::fabs(p[1]) : std::numeric_limits<double>::max();
    EXPECT_LT(std::min(std::fabs(p[2]), from_meridian), 2 * edge) << p[0] << ' ' << p[1] << ' ' << p[2];
  }
  for (double angle = 0; angle < 2 * pi; angle += 0.1) {
    const double radius = major_radius + std::cos(angle);
    EXPECT_LT(distance_to(graph, {-radius, 0, std::sin(angle)}), 1.5 * edge);
    const double inner_radius = major_radius - 1;
    EXPECT_LT(distance_to(graph, {inner_radius * std::cos(angle), inner_radius * std::sin(angle), 0}), 1.5 * edge);
  }
  // The conjugate points of the outer equator are pi sqrt(r (R + r)) away along it: at the angle 1.99.
  EXPECT_GT(distance_to(graph, {2.5 * std::cos(1.6), 2.5 * std::sin(1.6), 0}), 0.3);
}

TEST(extract_cut_locus, of_a_tube_is_the_line_opposite)
{
  const Shape tube = CSCD::test::tube(10, 1, 32, CSCD::test::Tube_end::flat);
  const double edge = CSCD::test::mean_edge_length(tube);
  const Graph graph = cut_locus_of(tube, {5, 0, 1});
  EXPECT_EQ(skeleton_facts(graph).number_of_components, 1u);
  EXPECT_EQ(skeleton_facts(graph).betti_number, 0u);
  for (const auto v : boost::make_iterator_range(vertices(graph))) {
    const Triple p = CSCD::test::to_triple(graph[v].point);
    if (p[0] > 1 && p[0] < 9) {
      EXPECT_LT(std::fabs(p[1]), 1.5 * edge);
      EXPECT_LT(p[2], 0);
    }
  }
  for (double x = 1; x < 9; x += 0.25) {
    EXPECT_LT(distance_to(graph, {x, 0, -1}), 1.5 * edge);
  }
}

TEST(extract_cut_locus, of_an_ellipsoid_is_an_arc)
{
  // From the end of the shortest axis two equal ways lead to each point of the plane of the other longer axes.
  const Shape ellipsoid = CSCD::test::ellipsoid({2, 1.2, 1}, 5);
  const double edge = CSCD::test::mean_edge_length(ellipsoid);
  const Graph graph = cut_locus_of(ellipsoid, {0, 0, 1});
  EXPECT_EQ(skeleton_facts(graph).number_of_components, 1u);
  EXPECT_EQ(skeleton_facts(graph).betti_number, 0u);
  EXPECT_EQ(skeleton_facts(graph).number_of_tips, 2u);
  EXPECT_GT(length(graph), 0.5);
  EXPECT_LT(distance_to(graph, {0, 0, -1}), edge);
  for (const auto v : boost::make_iterator_range(vertices(graph))) {
    EXPECT_LT(std::fabs(graph[v].point.y()), 1.5 * edge);
    EXPECT_LT(graph[v].point.z(), 0);
  }
}

/// Surfaces of every genus, with few and many vertices.
class Any_surface : public testing::TestWithParam<Shape_maker>
{
};

TEST_P(Any_surface, has_a_cut_locus_around_each_handle)
{
  const Shape shape = GetParam().make();
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(shape);
  const auto expect_loops = [&](const Graph& graph) {
    EXPECT_EQ(skeleton_facts(graph).number_of_components, 1u);
    if (shape.number_of_components == 1) {
      EXPECT_EQ(skeleton_facts(graph).betti_number, 2 * shape.genus);
    }
  };
  Graph graph;
  for (const std::size_t source : {std::size_t(0), shape.points.size() / 2}) {
    CSCD::extract_cut_locus(mesh, Vertex(Mesh::size_type(source)), graph);
    expect_loops(graph);
  }
}

TEST_P(Any_surface, holds_the_points_of_its_cut_locus)
{
  const Shape shape = GetParam().make();
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(shape);
  Graph graph;
  CSCD::extract_cut_locus(mesh, Vertex(0), graph);
  const double diagonal = CSCD::test::diagonal(shape);
  for (const auto v : boost::make_iterator_range(vertices(graph))) {
    const auto& [face, weights] = graph[v].location;
    const auto side = halfedge(face, mesh);
    const std::array<Vertex, 3> corners{source(side, mesh), target(side, mesh), target(next(side, mesh), mesh)};
    Triple sum{0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_GE(weights[k], 0);
      sum = sum + weights[k] * CSCD::test::to_triple(mesh.point(corners[k]));
    }
    EXPECT_LT(CSCD::test::norm(sum - CSCD::test::to_triple(graph[v].point)), 1e-12 * diagonal);
    EXPECT_GT(graph[v].distance, 0);
  }
}

std::vector<Shape_maker> all_surfaces()
{
  std::vector<Shape_maker> result = CSCD::test::shapes_with_known_skeleton();
  for (const auto& more : {CSCD::test::hard_closed_shapes(), CSCD::test::open_shapes()}) {
    result.insert(result.end(), more.begin(), more.end());
  }
  return result;
}

INSTANTIATE_TEST_SUITE_P(extract_cut_locus, Any_surface, testing::ValuesIn(all_surfaces()),
                         testing::PrintToStringParamName());

TEST(extract_cut_locus, moves_turns_and_scales_with_the_mesh)
{
  const Shape shape = CSCD::test::noisy(CSCD::test::y_tube(0.2), 0.1, 1);
  const Graph graph = cut_locus_of(shape, shape.points[7]);
  for (const double scale : {1e-5, 1., 1e5}) {
    const CSCD::test::Similarity similarity{scale, CSCD::test::unit({1, 2, 3}), 0.7, {3 * scale, 1, 2}};
    const Shape moved = CSCD::test::moved(shape, similarity, scale);
    const Graph other = cut_locus_of(moved, moved.points[7]);
    ASSERT_EQ(num_vertices(other), num_vertices(graph));
    ASSERT_EQ(num_edges(other), num_edges(graph));
    for (const auto v : boost::make_iterator_range(vertices(graph))) {
      const Triple expected = similarity(CSCD::test::to_triple(graph[v].point));
      EXPECT_LT(CSCD::test::norm(CSCD::test::to_triple(other[v].point) - expected), 1e-5 * scale);
      EXPECT_NEAR(other[v].distance, scale * graph[v].distance, 1e-5 * scale);
    }
  }
}

TEST(extract_cut_locus, lies_between_several_sources)
{
  const Shape sphere = CSCD::test::sphere(4);
  const double edge = CSCD::test::mean_edge_length(sphere);
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(sphere);
  Graph graph;
  const std::vector<Vertex> poles{nearest_vertex(sphere, {0, 0, 1}), nearest_vertex(sphere, {0, 0, -1})};
  CSCD::extract_cut_locus(mesh, poles, graph);
  EXPECT_EQ(skeleton_facts(graph).betti_number, 1u);
  EXPECT_EQ(skeleton_facts(graph).number_of_tips, 0u);
  expect_length_along_edges(graph, 2 * pi);
  for (const auto v : boost::make_iterator_range(vertices(graph))) {
    EXPECT_LT(std::fabs(graph[v].point.z()), edge);
  }

  const std::vector<Vertex> three{nearest_vertex(sphere, {1, 0, 0}),
                                  nearest_vertex(sphere, {std::cos(2 * pi / 3), std::sin(2 * pi / 3), 0}),
                                  nearest_vertex(sphere, {std::cos(4 * pi / 3), std::sin(4 * pi / 3), 0})};
  CSCD::extract_cut_locus(mesh, three, graph);
  EXPECT_EQ(skeleton_facts(graph).betti_number, 2u) << "three halves of circles from pole to pole";
  expect_length_along_edges(graph, 3 * pi);
}

TEST(extract_cut_locus, takes_distances_as_they_are)
{
  const Shape sphere = CSCD::test::sphere(4);
  Mesh mesh = CSCD::test::to_mesh<Mesh>(sphere);
  auto distance = mesh.add_property_map<Vertex, float>("v:distance").first;
  for (const Vertex v : vertices(mesh)) {
    distance[v] = float(std::acos(std::clamp(mesh.point(v).z(), -1., 1.)));
  }
  Graph graph;
  const Vertex source = nearest_vertex(sphere, {0, 0, 1});
  CSCD::extract_cut_locus(mesh, source, graph, parameters::distance_map(distance));
  ASSERT_EQ(num_vertices(graph), 1u);
  EXPECT_NEAR(graph[0].point.z(), -1, 1e-2);
  EXPECT_FLOAT_EQ(float(graph[0].distance), float(std::acos(std::clamp(graph[0].point.z(), -1., 1.))));

  distance[Vertex(3)] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(CSCD::extract_cut_locus(mesh, source, graph, parameters::distance_map(distance)), CSCD::Input_error);
  EXPECT_EQ(num_vertices(graph), 1u) << "it is left as it was";
}

TEST(extract_cut_locus, stays_on_the_component_of_the_source)
{
  const Shape two =
      CSCD::test::merged("", {CSCD::test::sphere(3), CSCD::test::translated(CSCD::test::sphere(3), {5, 0, 0})});
  const Graph graph = cut_locus_of(two, {5, 0, 1});
  ASSERT_EQ(num_vertices(graph), 1u);
  EXPECT_NEAR(graph[0].point.x(), 5, 0.2);
}

TEST(extract_cut_locus, refuses_what_has_no_answer)
{
  Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::tetrahedron());
  Graph graph(7);
  EXPECT_THROW(CSCD::extract_cut_locus(mesh, std::vector<Vertex>{}, graph), CSCD::Input_error);
  const Vertex lone = mesh.add_vertex(Point(9, 9, 9));
  EXPECT_THROW(CSCD::extract_cut_locus(mesh, lone, graph), CSCD::Input_error);
  EXPECT_THROW(CSCD::extract_cut_locus(Mesh(), lone, graph), CSCD::Input_error);
  EXPECT_EQ(num_vertices(graph), 7u);
}

} // namespace
