// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances on meshes against exact shortest paths and CGAL's heat method; kinds of meshes, sources and parameters.

#include "Surface/to_surface.h"
#include "support/convert_shape.h"
#include "support/message_of.h"
#include "support/shapes.h"
#include <CSCD/Named_parameters.h>
#include <CSCD/Published/Heat_method.h>
#include <CSCD/Published/Intrinsic_triangulation.h>
#include <CSCD/estimate_geodesic_distances.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Distance_map = Mesh::Property_map<Vertex, double>;
using Estimator = CSCD::Geodesic_distance_estimator<Mesh>;
namespace parameters = CSCD::parameters;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A map of the mesh that no other has the name of.
Distance_map add_map(Mesh& mesh)
{
  return mesh.add_property_map<Vertex, double>("", -1).first;
}

Distance_map exact_distances(Mesh& mesh, Vertex source)
{
  CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>> shortest_path(mesh);
  shortest_path.add_source_point(source);
  Distance_map result = add_map(mesh);
  for (const Vertex vertex : mesh.vertices()) {
    result[vertex] = shortest_path.shortest_distance_to_source_points(vertex).first;
  }
  return result;
}

double mean_difference(const Mesh& mesh, const Distance_map& a, const Distance_map& b)
{
  double sum = 0;
  for (const Vertex vertex : mesh.vertices()) {
    sum += std::fabs(a[vertex] - b[vertex]);
  }
  return sum / mesh.number_of_vertices();
}

TEST(estimate_geodesic_distances, agrees_with_the_heat_method_of_cgal_and_with_shortest_paths)
{
  for (const CSCD::test::Shape& shape :
       {CSCD::test::torus(3, 1, 20), CSCD::test::noisy(CSCD::test::torus(3, 1, 20), 0.2, 1),
        CSCD::test::anisotropic_tube(10, 1, 60, 30)}) {
    SCOPED_TRACE(shape.name);
    const double edge = CSCD::test::mean_edge_length(shape);
    Mesh mesh = CSCD::test::to_mesh<Mesh>(shape);
    const Vertex source(17);
    const Distance_map exact = exact_distances(mesh, source);
    Distance_map ours = add_map(mesh);
    CSCD::estimate_geodesic_distances(mesh, source, ours);
    Distance_map theirs = add_map(mesh);
    CGAL::Heat_method_3::estimate_geodesic_distances(mesh, theirs, source, CGAL::Heat_method_3::Intrinsic_Delaunay());
    // Where four vertices lie on a circle, either diagonal is Delaunay, and they may take different ones.
    EXPECT_LT(mean_difference(mesh, ours, theirs), 0.1 * edge);
    EXPECT_LT(mean_difference(mesh, ours, exact), mean_difference(mesh, theirs, exact) + 0.05 * edge);
    EXPECT_LT(mean_difference(mesh, ours, exact), 0.7 * edge);
  }
}

TEST(Heat_method, gives_on_the_same_triangles_what_cgal_gives)
{
  for (const CSCD::test::Shape& shape :
       {CSCD::test::sphere(4), CSCD::test::torus(3, 1, 20), CSCD::test::noisy(CSCD::test::sphere(3), 0.1, 1)}) {
    SCOPED_TRACE(shape.name);
    Mesh mesh = CSCD::test::to_mesh<Mesh>(shape);
    Distance_map theirs = add_map(mesh);
    CGAL::Heat_method_3::estimate_geodesic_distances(mesh, theirs, Vertex(17), CGAL::Heat_method_3::Direct());
    const CSCD::internal::Intrinsic_triangulation triangulation(CSCD::test::to_surface(shape));
    const std::vector<double> ours = CSCD::internal::distances_from_vertices(triangulation, {17});
    const double largest = *std::max_element(ours.begin(), ours.end());
    for (const Vertex vertex : mesh.vertices()) {
      // CGAL adds 1e-8 to the diagonals of both matrices.
      ASSERT_NEAR(theirs[vertex], ours[vertex], 1e-4 * largest);
    }
  }
}

TEST(estimate_geodesic_distances, reaches_the_far_end_of_a_tube_of_a_thousand_edges)
{
  Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::tube(1000, 1, 6, CSCD::test::Tube_end::open));
  Distance_map distances = add_map(mesh);
  CSCD::estimate_geodesic_distances(mesh, Vertex(0), distances);
  for (const Vertex vertex : mesh.vertices()) {
    const double along = std::fabs(mesh.point(vertex).x() - mesh.point(Vertex(0)).x());
    ASSERT_NEAR(distances[vertex], along, along < 200 ? 5 : 0.02 * along);
  }
}

TEST(estimate_geodesic_distances, takes_any_mesh_and_any_map)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;
  const CSCD::test::Shape shape = CSCD::test::torus(3, 1, 12);
  Mesh mesh = CSCD::test::to_mesh<Mesh>(shape);
  Distance_map expected = add_map(mesh);
  CSCD::estimate_geodesic_distances(mesh, Vertex(5), expected);
  const Polyhedron polyhedron = CSCD::test::to_mesh<Polyhedron>(shape);
  const auto polyhedron_vertices = CSCD::test::vertices_in_order(polyhedron);
  std::map<Polyhedron::Vertex_const_handle, double> distances;
  CSCD::estimate_geodesic_distances(polyhedron, polyhedron_vertices[5], boost::make_assoc_property_map(distances));
  ASSERT_EQ(distances.size(), shape.points.size());
  for (std::size_t i = 0; i < shape.points.size(); ++i) {
    EXPECT_EQ(distances[polyhedron_vertices[i]], expected[Vertex(Mesh::size_type(i))]);
  }
}

TEST(estimate_geodesic_distances, heeds_the_point_map_and_the_time_step)
{
  const CSCD::test::Shape shape = CSCD::test::torus(3, 1, 12);
  Mesh mesh = CSCD::test::to_mesh<Mesh>(shape);
  auto doubled = mesh.add_property_map<Vertex, Point>("v:doubled").first;
  for (const Vertex vertex : mesh.vertices()) {
    const Point& p = mesh.point(vertex);
    doubled[vertex] = Point(2 * p.x(), 2 * p.y(), 2 * p.z());
  }
  Distance_map once = add_map(mesh);
  Distance_map twice = add_map(mesh);
  Distance_map smooth = add_map(mesh);
  CSCD::estimate_geodesic_distances(mesh, Vertex(5), once);
  CSCD::estimate_geodesic_distances(mesh, Vertex(5), twice, parameters::vertex_point_map(doubled));
  CSCD::estimate_geodesic_distances(mesh, Vertex(5), smooth, parameters::time_step_factor(10));
  double largest = 0;
  double max_smooth = 0;
  for (const Vertex vertex : mesh.vertices()) {
    EXPECT_EQ(2 * once[vertex], twice[vertex]);
    largest = std::max(largest, once[vertex]);
    max_smooth = std::max(max_smooth, smooth[vertex]);
  }
  EXPECT_GT(std::fabs(max_smooth - largest), 0.01 * largest);
}

TEST(estimate_geodesic_distances, takes_vertices_and_points_of_faces_one_or_several)
{
  Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::sphere(3));
  const Estimator estimator(mesh);
  Distance_map distances = add_map(mesh);
  const Mesh::Face_index face(77);
  const Mesh::Halfedge_index halfedge = mesh.halfedge(face);
  const std::array<Vertex, 3> corners{mesh.source(halfedge), mesh.target(halfedge), mesh.target(mesh.next(halfedge))};
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<double, 3> coordinates{0.05, 0.05, 0.05};
    coordinates[k] = 0.9;
    CSCD::estimate_geodesic_distances(mesh, Estimator::Face_location(face, coordinates), distances);
    for (std::size_t other = 0; other < 3; ++other) {
      EXPECT_LE(distances[corners[k]], distances[corners[other]]) << "in the order of PMP";
    }
    coordinates = {0, 0, 0};
    coordinates[k] = 1;
    Distance_map at_vertex = add_map(mesh);
    estimator.estimate(std::array<Estimator::Face_location, 1>{{{face, coordinates}}}, distances);
    estimator.estimate(std::vector<Vertex>{corners[k]}, at_vertex);
    for (const Vertex vertex : mesh.vertices()) {
      ASSERT_EQ(distances[vertex], at_vertex[vertex]);
    }
  }
  estimator.estimate(std::vector<Vertex>(mesh.vertices_begin(), mesh.vertices_end()), distances);
  EXPECT_EQ(*std::max_element(distances.begin(), distances.end()), 0) << "all are sources";
  estimator.estimate(std::vector<Vertex>(), distances);
  EXPECT_EQ(*std::min_element(distances.begin(), distances.end()), infinity) << "none is";
}

TEST(estimate_geodesic_distances, estimates_each_of_many_as_it_would_alone)
{
  Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::noisy(CSCD::test::torus(3, 1, 12), 0.2, 1));
  const Estimator estimator(mesh);
  std::vector<std::vector<Vertex>> source_sets;
  std::vector<Distance_map> maps;
  for (Mesh::size_type i = 0; i < 11; ++i) {
    source_sets.push_back({Vertex(i), Vertex(3 * i + 50)});
    maps.push_back(add_map(mesh));
  }
  estimator.estimate_each(source_sets, maps);
  Distance_map alone = add_map(mesh);
  for (std::size_t i = 0; i < source_sets.size(); ++i) {
    estimator.estimate(source_sets[i], alone);
    for (const Vertex vertex : mesh.vertices()) {
      ASSERT_EQ(maps[i][vertex], alone[vertex]);
    }
  }
}

TEST(estimate_geodesic_distances, knows_components_borders_and_vertices_without_a_face)
{
  Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::merged(
      "two", {CSCD::test::slit_tube(12, 1, 12), CSCD::test::translated(CSCD::test::sphere(2), {100, 0, 0})}));
  const Vertex alone = mesh.add_vertex(Point(-100, 0, 0));
  Distance_map distances = add_map(mesh);
  CSCD::estimate_geodesic_distances(mesh, Vertex(0), distances);
  EXPECT_EQ(distances[Vertex(0)], 0);
  EXPECT_EQ(distances[alone], infinity);
  for (const Vertex vertex : mesh.vertices()) {
    EXPECT_EQ(distances[vertex] < infinity, std::fabs(mesh.point(vertex).x()) < 50);
    EXPECT_TRUE(distances[vertex] > 0 || vertex == Vertex(0));
  }
  CSCD::estimate_geodesic_distances(mesh, alone, distances);
  EXPECT_EQ(std::count(distances.begin(), distances.end(), infinity), std::ptrdiff_t(mesh.number_of_vertices()) - 1);
  EXPECT_EQ(distances[alone], 0);
}

TEST(estimate_geodesic_distances, refuses_what_it_cannot_compute_with_and_leaves_the_map_alone)
{
  Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::sphere(1));
  Distance_map distances = add_map(mesh);
  const auto refusal = [&](const Estimator::Face_location& location) {
    return CSCD::test::message_of([&] { CSCD::estimate_geodesic_distances(mesh, location, distances); });
  };
  EXPECT_TRUE(CSCD::test::names(refusal({Mesh::Face_index(3), {0.5, 0.5, 0.5}}), "a source has barycentric"));
  EXPECT_TRUE(CSCD::test::names(refusal({Mesh::Face_index(3), {2, -1, 0}}), "a source has barycentric"));
  EXPECT_TRUE(CSCD::test::names(refusal({Mesh::Face_index(3), {NAN, 1, 0}}), "a source has barycentric"));
  mesh.point(Vertex(7)) = Point(NAN, 0, 0);
  EXPECT_TRUE(CSCD::test::names(
      CSCD::test::message_of([&] { CSCD::estimate_geodesic_distances(mesh, Vertex(0), distances); }), "vertex 7 "));
  EXPECT_EQ(*std::min_element(distances.begin(), distances.end()), -1);
  EXPECT_EQ(*std::max_element(distances.begin(), distances.end()), -1);
}

} // namespace
