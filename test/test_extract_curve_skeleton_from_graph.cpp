// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "support/Shape.h"
#include "support/convert_shape.h"
#include "support/limb_shapes.h"
#include "support/message_of.h"
#include "support/swept_shapes.h"
#include <CSCD/Skeleton_graph.h>
#include <CSCD/exceptions.h>
#include <CSCD/extract_curve_skeleton_from_graph.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/tags.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/iterator_range_core.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace {

using CSCD::test::edges_of, CSCD::test::Shape, CSCD::test::to_graph, CSCD::test::Triple;
using CSCD::test::operator+;
using Point = CGAL::Simple_cartesian<double>::Point_3;

struct Place
{
  Point point;
};
using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Place>;
using Edges = std::vector<std::pair<std::size_t, std::size_t>>;
using Skeleton = CSCD::Skeleton_graph<Point, std::size_t>;

/// Points on a line, and the edges between consecutive ones.
Graph path_graph(std::size_t size)
{
  std::vector<Triple> points;
  Edges edges;
  for (std::size_t i = 0; i < size; ++i) {
    points.push_back({double(i), 0, 0});
    if (i > 0) {
      edges.emplace_back(i - 1, i);
    }
  }
  return to_graph<Graph>(points, edges);
}

Graph cycle_graph(std::size_t size)
{
  Graph graph = path_graph(size);
  for (std::size_t i = 0; i < size; ++i) {
    const double angle = 2 * CSCD::test::pi * double(i) / double(size);
    graph[i].point = Point(std::cos(angle), std::sin(angle), 0);
  }
  add_edge(size - 1, 0, graph);
  return graph;
}

struct Counts
{
  std::size_t nodes = 0;
  std::size_t components = 0;
  std::size_t betti = 0;
  std::size_t tips = 0;
  std::size_t junctions = 0;
};

/// Extracts the skeleton, and checks that each vertex belongs to one node.
Counts skeletonize_graph(const Graph& graph, Skeleton& skeleton)
{
  const auto report = CSCD::extract_curve_skeleton(graph, skeleton);
  std::vector<int> owners(num_vertices(graph), 0);
  for (const auto node : boost::make_iterator_range(vertices(skeleton))) {
    for (const std::size_t vertex : skeleton[node].vertices) {
      ++owners[vertex];
    }
  }
  EXPECT_EQ(std::count(owners.begin(), owners.end(), 1), std::ptrdiff_t(owners.size()));
  EXPECT_EQ(report.number_of_skeleton_components, report.number_of_surface_components);
  return {report.number_of_nodes, report.number_of_skeleton_components, report.betti_number, report.number_of_tips,
          report.number_of_junctions};
}

Counts counts_of(const Graph& graph)
{
  Skeleton skeleton;
  return skeletonize_graph(graph, skeleton);
}

std::vector<Point> node_points(const Skeleton& skeleton)
{
  std::vector<Point> result;
  for (const auto node : boost::make_iterator_range(vertices(skeleton))) {
    result.push_back(skeleton[node].point);
  }
  return result;
}

TEST(Graph_skeleton, a_path_is_its_own_skeleton)
{
  const Graph graph = path_graph(9);
  Skeleton skeleton;
  const Counts counts = skeletonize_graph(graph, skeleton);
  EXPECT_EQ(counts.nodes, 9U);
  EXPECT_EQ(counts.tips, 2U);
  for (const auto node : boost::make_iterator_range(vertices(skeleton))) {
    ASSERT_EQ(skeleton[node].vertices.size(), 1U);
    EXPECT_NEAR(std::sqrt(CGAL::squared_distance(skeleton[node].point, graph[skeleton[node].vertices[0]].point)), 0,
                1e-12);
  }
}

TEST(Graph_skeleton, a_cycle_is_its_own_skeleton_from_five_edges_on)
{
  for (const std::size_t size : {5U, 6U, 17U}) {
    const Counts counts = counts_of(cycle_graph(size));
    EXPECT_EQ(counts.nodes, size);
    EXPECT_EQ(counts.betti, 1U);
    EXPECT_EQ(counts.tips, 0U);
  }
  for (const std::size_t size : {3U, 4U}) {
    EXPECT_EQ(counts_of(cycle_graph(size)).nodes, 1U) << "a face";
  }
}

TEST(Graph_skeleton, a_tree_is_its_own_skeleton)
{
  // The root has five children, each other vertex but the last ones two.
  std::vector<Triple> points;
  Edges edges;
  for (std::size_t i = 0; i < 32; ++i) {
    points.push_back({std::cos(double(i)), double(i), std::sin(2. * double(i))});
    if (i > 0) {
      edges.emplace_back(i < 6 ? 0 : (i - 4) / 2, i);
    }
  }
  const Counts counts = counts_of(to_graph<Graph>(points, edges));
  EXPECT_EQ(counts.nodes, 32U);
  EXPECT_EQ(counts.betti, 0U);
  EXPECT_EQ(counts.tips, 18U);
  EXPECT_EQ(counts.junctions, 14U);
}

TEST(Graph_skeleton, components_and_isolated_vertices_get_nodes)
{
  const Counts counts = counts_of(
      to_graph<Graph>({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 5, 0}, {0, 6, 0}, {9, 9, 9}}, {{0, 1}, {1, 2}, {3, 4}}));
  EXPECT_EQ(counts.components, 3U);
  EXPECT_EQ(counts.nodes, 6U);
  EXPECT_EQ(counts_of(to_graph<Graph>({{1, 2, 3}}, {})).nodes, 1U);
}

TEST(Graph_skeleton, parallel_edges_and_edges_without_length_change_nothing)
{
  Graph graph = path_graph(7);
  add_edge(2, 3, graph);
  add_edge(4, 4, graph);
  graph[add_vertex(graph)].point = graph[3].point;
  add_edge(3, 7, graph); // no length
  Skeleton skeleton;
  const Counts counts = skeletonize_graph(graph, skeleton);
  EXPECT_EQ(counts.nodes, 7U);
  EXPECT_EQ(counts.betti, 0U);
  EXPECT_EQ(counts.tips, 2U);
}

TEST(Graph_skeleton, a_tube_of_squares_is_a_curve_on_its_axis)
{
  // No triangles at all: cycles of four edges are its faces.
  constexpr std::size_t around = 12;
  constexpr std::size_t size = 40;
  std::vector<Triple> points;
  Edges edges;
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < around; ++j) {
      const double angle = 2 * CSCD::test::pi * double(j) / around;
      points.push_back({double(i), 2 * std::cos(angle), 2 * std::sin(angle)});
      edges.emplace_back(i * around + j, i * around + (j + 1) % around);
      if (i > 0) {
        edges.emplace_back(i * around + j, (i - 1) * around + j);
      }
    }
  }
  Skeleton skeleton;
  const Counts counts = skeletonize_graph(to_graph<Graph>(points, edges), skeleton);
  EXPECT_GE(counts.nodes, 15U);
  EXPECT_EQ(counts.betti, 0U);
  EXPECT_EQ(counts.tips, 2U);
  for (const Point& p : node_points(skeleton)) {
    EXPECT_LT(std::hypot(p.y(), p.z()), 0.5) << "at " << p;
  }
}

TEST(Graph_skeleton, a_cone_is_followed_to_its_tip)
{
  // The two sides of a front differ by its cross-sections.
  const Shape cone = CSCD::test::limb_shape("cone", {{{0, 0, 0}, {10, 0, 0}, 2, 0.2}}, 0.3);
  Skeleton skeleton;
  const Counts counts = skeletonize_graph(to_graph<Graph>(cone.points, edges_of(cone)), skeleton);
  EXPECT_GE(counts.nodes, 24U);
  EXPECT_EQ(counts.tips, 2U);
}

TEST(Graph_skeleton, the_edges_of_a_torus_and_a_knot_give_one_cycle)
{
  for (const Shape& shape : {CSCD::test::torus(3, 1, 20), CSCD::test::trefoil_knot(0.4, 16)}) {
    Skeleton skeleton;
    const Counts counts = skeletonize_graph(to_graph<Graph>(shape.points, edges_of(shape)), skeleton);
    EXPECT_EQ(counts.betti, 1U) << shape.name;
    EXPECT_EQ(counts.tips, 0U) << shape.name;
    EXPECT_GE(counts.nodes, 10U) << shape.name;
  }
}

TEST(Graph_skeleton, nodes_of_a_torus_are_in_its_middle_with_its_radius)
{
  const Shape shape = CSCD::test::torus(3, 1, 24);
  Skeleton skeleton;
  skeletonize_graph(to_graph<Graph>(shape.points, edges_of(shape)), skeleton);
  for (const auto node : boost::make_iterator_range(vertices(skeleton))) {
    const Point& p = skeleton[node].point;
    EXPECT_LT(std::hypot(std::hypot(p.x(), p.y()) - 3, p.z()), 0.25);
    EXPECT_NEAR(skeleton[node].radius, 1, 0.25);
  }
}

TEST(Graph_skeleton, a_soup_that_is_no_surface_is_accepted)
{
  // A tube with a fin on it: its edges belong to three triangles each. And one triangle that hangs on a vertex.
  Shape shape = CSCD::test::capsule(12, 1, 14);
  const std::size_t size = shape.points.size();
  for (std::size_t i = 0; i + 1 < 40; i += 2) {
    shape.points.push_back(shape.points[i] + Triple{0, 0, 0.05});
    shape.triangles.push_back({i, i + 1, shape.points.size() - 1});
  }
  shape.points.push_back(shape.points[size / 2] + Triple{0.1, 0, 0});
  shape.points.push_back(shape.points[size / 2] + Triple{0, 0.1, 0});
  shape.triangles.push_back({size / 2, shape.points.size() - 1, shape.points.size() - 2});
  const Counts counts = counts_of(to_graph<Graph>(shape.points, edges_of(shape)));
  EXPECT_EQ(counts.betti, 0U);
  EXPECT_GE(counts.nodes, 5U);
}

TEST(Graph_skeleton, points_are_joined_to_their_nearest_neighbors)
{
  const Shape shape = CSCD::test::trefoil_knot(0.4, 9);
  std::vector<CSCD::Vector3> points;
  for (const Triple& p : shape.points) {
    points.emplace_back(p[0], p[1] + 0.01 * std::sin(100 * p[0]), p[2]); // no two at the same distance
  }
  constexpr std::size_t number = 7;
  std::set<std::pair<std::size_t, std::size_t>> expected;
  std::vector<std::pair<double, std::size_t>> others;
  for (std::size_t i = 0; i < points.size(); ++i) {
    others.clear();
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (j != i) {
        others.emplace_back((points[i] - points[j]).norm(), j);
      }
    }
    std::partial_sort(others.begin(), others.begin() + number, others.end());
    for (std::size_t k = 0; k < number; ++k) {
      expected.insert(std::minmax(i, others[k].second));
    }
  }
  std::set<std::pair<std::size_t, std::size_t>> found;
  for (const auto& edge : CSCD::neighbor_edges(points, number)) {
    EXPECT_TRUE(found.emplace(edge.source, edge.target).second) << "twice";
    EXPECT_NEAR(edge.length, (points[edge.source] - points[edge.target]).norm(), 1e-12);
  }
  EXPECT_EQ(found, expected);
}

TEST(Graph_skeleton, numbers_of_vertices_do_not_matter)
{
  const Shape shape = CSCD::test::trefoil_knot(0.4, 12);
  const std::size_t size = shape.points.size();
  std::vector<Triple> points(size);
  const auto renumbered = [size](std::size_t i) { return (7919 * i + 5) % size; };
  ASSERT_NE(size % 7919, 0U);
  Edges edges;
  for (std::size_t i = 0; i < size; ++i) {
    points[renumbered(i)] = shape.points[i];
  }
  for (const auto& [a, b] : edges_of(shape)) {
    edges.emplace_back(renumbered(b), renumbered(a));
  }
  std::reverse(edges.begin(), edges.end());
  Skeleton first;
  Skeleton second;
  skeletonize_graph(to_graph<Graph>(shape.points, edges_of(shape)), first);
  skeletonize_graph(to_graph<Graph>(points, edges), second);
  EXPECT_EQ(node_points(first), node_points(second));
}

TEST(Graph_skeleton, coordinates_that_are_not_finite_are_refused)
{
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Graph graph = path_graph(4);
    graph[2].point = Point(0, bad, 0);
    Skeleton skeleton(1);
    EXPECT_EQ(CSCD::test::message_of([&] { CSCD::extract_curve_skeleton(graph, skeleton); }),
              "vertex 2 has a coordinate that is not finite: correct or remove it");
    EXPECT_EQ(num_vertices(skeleton), 1U) << "the output is left as it was";
  }
  Skeleton skeleton;
  EXPECT_THROW(CSCD::extract_curve_skeleton(Graph(), skeleton), CSCD::Input_error);
}

struct Weight
{
  double weight = 1;
};
using Weighted_graph = boost::adjacency_list<boost::listS, boost::vecS, boost::directedS, Place, Weight>;

TEST(Graph_skeleton, weights_of_edges_are_lengths)
{
  Weighted_graph graph;
  for (int i = 0; i < 3; ++i) {
    graph[add_vertex(graph)].point = Point(i, 0, 0);
  }
  add_edge(0, 1, Weight{4}, graph);
  add_edge(2, 1, Weight{0}, graph);
  const CSCD::Spatial_graph_traits traits(graph, CSCD::internal::bundled_point_map(graph));
  const CSCD::Spatial_graph& surface = traits.surface();
  ASSERT_EQ(surface.number_of_halfedges(), 4U);
  double sum = 0;
  for (CSCD::Index h = 0; h < 4; ++h) {
    sum += traits.normalization().unit * surface.length(h);
    EXPECT_EQ(surface.twin(surface.twin(h)), h);
    EXPECT_EQ(surface.origin(h), surface.target(surface.twin(h)));
    EXPECT_TRUE(surface.is_adjacent(surface.origin(h), surface.target(h)));
  }
  EXPECT_NEAR(sum, 8, 1e-12);
  for (const double bad : {-1., std::numeric_limits<double>::quiet_NaN()}) {
    graph[*edges(graph).first].weight = bad;
    Skeleton skeleton;
    EXPECT_THROW(CSCD::extract_curve_skeleton(graph, skeleton), CSCD::Input_error);
  }
}

TEST(Graph_skeleton, radii_of_vertices_are_those_of_the_nodes)
{
  // A skeleton is a graph with positions and radii.
  Skeleton wire;
  for (int i = 0; i < 6; ++i) {
    const auto node = add_vertex(wire);
    wire[node].point = Point(i, 0, 0);
    wire[node].radius = 0.5 + i;
    if (i > 0) {
      add_edge(node - 1, node, wire);
    }
  }
  Skeleton skeleton;
  CSCD::extract_curve_skeleton(wire, skeleton);
  ASSERT_EQ(num_vertices(skeleton), 6U);
  for (const auto node : boost::make_iterator_range(vertices(skeleton))) {
    EXPECT_NEAR(skeleton[node].radius, 0.5 + skeleton[node].point.x(), 1e-9);
  }
}

} // namespace
