// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface traits of a mesh: counts, coordinates, correspondence, and independence from numbers and pose.

#include "Surface/to_indexed_triangles.h"
#include "Traits/message_of.h"
#include "support/Similarity.h"
#include "support/convert_shape.h"
#include "support/shapes.h"
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Traits/Triangle_mesh_traits.h>
#include <CSCD/Vector_3.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Traits = CSCD::Triangle_mesh_traits<Mesh>;
using CSCD::Index;
using CSCD::Vector_3;
using CSCD::test::message_of;
using CSCD::test::names;
using CSCD::test::Shape;

static_assert(!std::is_constructible_v<Traits, Mesh>, "a temporary mesh is refused");
static_assert(std::is_constructible_v<Traits, const Mesh&>);
static_assert(!std::is_copy_constructible_v<Traits>);

Mesh to_mesh(const Shape& shape)
{
  return CSCD::test::to_mesh<Mesh>(shape);
}

CSCD::Skeletonization_report description(const Traits& traits)
{
  CSCD::Skeletonization_report report;
  traits.describe_input(report);
  return report;
}

TEST(Triangle_mesh_traits, counts_what_the_shapes_are_known_to_have)
{
  std::vector<CSCD::test::Shape_maker> makers;
  for (const auto& some :
       {CSCD::test::shapes_with_known_skeleton(), CSCD::test::hard_closed_shapes(), CSCD::test::open_shapes()}) {
    makers.insert(makers.end(), some.begin(), some.end());
  }
  for (const auto& maker : makers) {
    const Shape shape = maker.make();
    SCOPED_TRACE(shape.name);
    const Mesh mesh = to_mesh(shape);
    const Traits traits(mesh);
    const CSCD::Skeletonization_report report = description(traits);
    EXPECT_EQ(report.number_of_surface_components, shape.number_of_components);
    EXPECT_EQ(report.genus, shape.genus);
    EXPECT_EQ(report.number_of_bridged_borders, shape.number_of_border_cycles);
    EXPECT_EQ(report.number_of_input_vertices, shape.points.size());
    EXPECT_EQ(traits.surface().triangulation().number_of_vertices(),
              shape.points.size() + report.number_of_inserted_vertices);
    EXPECT_EQ(report.number_of_isolated_vertices, 0u);
    EXPECT_EQ(report.number_of_degenerate_faces, 0u);
    EXPECT_EQ(report.number_of_levels, traits.surface().levels().size());
    EXPECT_EQ(report.warnings.empty(), shape.is_closed());
  }
}

TEST(Triangle_mesh_traits, maps_vertices_to_those_of_the_mesh)
{
  const Shape shape = CSCD::test::merged("two", {CSCD::test::noisy(CSCD::test::beam(), 0.01, 1),
                                                 CSCD::test::translated(CSCD::test::sphere(2), {3, 3, 9})});
  const Mesh mesh = to_mesh(shape);
  const Traits traits(mesh);
  ASSERT_GT(traits.surface().number_of_inserted_vertices(), 0u);
  const CSCD::Triangulated_surface& surface = traits.surface().triangulation();
  std::set<Mesh::Vertex_index> seen;
  double area = 0;
  std::size_t number_of_inserted_vertices = 0;
  for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
    area += double(surface.vertex_area(vertex));
    const auto descriptors = traits.descriptors(vertex);
    if (descriptors.empty()) {
      ++number_of_inserted_vertices;
    } else {
      ASSERT_EQ(descriptors.size(), 1u);
      EXPECT_TRUE(seen.insert(*descriptors.begin()).second);
      const Point expected = mesh.point(*descriptors.begin());
      EXPECT_LT(std::sqrt(CGAL::squared_distance(traits.to_input_point(surface.point(vertex)), expected)), 1e-13 * 20);
    }
  }
  EXPECT_EQ(seen.size(), shape.points.size());
  EXPECT_EQ(number_of_inserted_vertices, traits.surface().number_of_inserted_vertices());
  EXPECT_NEAR(area, 1, 1e-4);
}

TEST(Triangle_mesh_traits, of_triangles_are_those_of_their_mesh)
{
  Shape shape = CSCD::test::noisy(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::open), 0.01, 1);
  shape.points.insert(shape.points.begin() + 5, 2, {0, 0, 9}); // without faces
  for (auto& triangle : shape.triangles) {
    for (auto& corner : triangle) {
      corner += corner < 5 ? 0 : 2;
    }
  }
  const Mesh mesh = to_mesh(shape);
  const Traits expected(mesh);
  CSCD::Indexed_triangles triangles = CSCD::test::to_indexed_triangles(shape);
  CSCD::Halfedge_pairing pairing(triangles.faces, triangles.points.size());
  const Traits traits(std::move(triangles), std::move(pairing));
  EXPECT_EQ(description(traits).number_of_isolated_vertices, 2u);
  EXPECT_EQ(description(traits).number_of_input_vertices, description(expected).number_of_input_vertices);
  EXPECT_EQ(description(traits).warnings, description(expected).warnings);
  ASSERT_EQ(traits.surface().triangulation().points(), expected.surface().triangulation().points());
  for (Index vertex = 0; vertex < traits.surface().triangulation().number_of_vertices(); ++vertex) {
    ASSERT_EQ(traits.descriptors(vertex).size(), expected.descriptors(vertex).size());
    if (!traits.descriptors(vertex).empty()) {
      EXPECT_EQ(*traits.descriptors(vertex).begin(), *expected.descriptors(vertex).begin());
    }
  }
}

TEST(Triangle_mesh_traits, of_triangles_refuse_coordinates_that_are_not_finite)
{
  CSCD::Indexed_triangles triangles = CSCD::test::to_indexed_triangles(CSCD::test::cube());
  triangles.points[3].y() = std::numeric_limits<double>::infinity();
  CSCD::Halfedge_pairing pairing(triangles.faces, triangles.points.size());
  EXPECT_TRUE(names(message_of([&] { Traits(std::move(triangles), std::move(pairing)); }), "vertex 3"));
}

TEST(Triangle_mesh_traits, keeps_lengths_in_proportion)
{
  const Mesh mesh = to_mesh(CSCD::test::scaled(CSCD::test::cube(), 100));
  const Traits traits(mesh);
  EXPECT_NEAR(traits.to_input_length(1), std::sqrt(6.) * 100, 1e-9);
  const Point center = traits.to_input_point(Vector_3::Zero());
  EXPECT_NEAR(center.x(), 50, 1e-9);
}

TEST(Triangle_mesh_traits, numbers_components_by_area)
{
  const Mesh mesh = to_mesh(
      CSCD::test::merged("two", {CSCD::test::cube(), CSCD::test::translated(CSCD::test::sphere(4), {9, 0, 0})}));
  const Traits traits(mesh);
  const CSCD::Triangulated_surface& surface = traits.surface().triangulation();
  for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
    const bool is_sphere = traits.to_input_point(surface.point(vertex)).x() > 5;
    ASSERT_EQ(traits.surface().component(vertex), is_sphere ? 0u : 1u);
  }
}

TEST(Triangle_mesh_traits, turns_bodies_that_look_inwards)
{
  const Mesh mesh = to_mesh(CSCD::test::reversed(CSCD::test::sphere(3)));
  const Traits traits(mesh);
  EXPECT_EQ(traits.surface().number_of_reversed_components(), 1u);
  const CSCD::Triangulated_surface& surface = traits.surface().triangulation();
  for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
    ASSERT_GT(surface.vertex_normal(vertex).dot(surface.point(vertex)), 0);
  }
}

/// Equal to the last bit.
void expect_equal_surfaces(const Traits& a, const Traits& b)
{
  const CSCD::Triangulated_surface& p = a.surface().triangulation();
  const CSCD::Triangulated_surface& q = b.surface().triangulation();
  ASSERT_EQ(p.points(), q.points());
  ASSERT_EQ(p.number_of_halfedges(), q.number_of_halfedges());
  for (Index halfedge = 0; halfedge < p.number_of_halfedges(); ++halfedge) {
    ASSERT_EQ(p.origin(halfedge), q.origin(halfedge));
  }
}

TEST(Triangle_mesh_traits, does_not_depend_on_numbers)
{
  for (const Shape& shape :
       {CSCD::test::y_tube(0.2), CSCD::test::noisy(CSCD::test::with_small_holes(CSCD::test::sphere(4), 20, 1), 0.1, 1),
        CSCD::test::cube(), CSCD::test::reversed(CSCD::test::l_bracket()), CSCD::test::chain_of_rings(3, 16)}) {
    SCOPED_TRACE(shape.name);
    const Mesh mesh = to_mesh(shape);
    const Mesh renumbered_mesh = to_mesh(CSCD::test::renumbered(shape, 7).shape);
    expect_equal_surfaces(Traits(mesh), Traits(renumbered_mesh));
  }
}

Vector_3 to_vector(const CSCD::test::Triple& p)
{
  return {p[0], p[1], p[2]};
}

TEST(Triangle_mesh_traits, does_not_depend_on_the_pose_beyond_rounding)
{
  const Shape shape = CSCD::test::noisy(CSCD::test::y_tube(0.2), 0.1, 3);
  const CSCD::test::Similarity similarity{1e6, CSCD::test::unit({1, 2, -0.5}), 1.1, {1e7, -3e6, 4e5}};
  const Mesh mesh = to_mesh(shape);
  const Mesh moved_mesh = to_mesh(CSCD::test::moved(shape, similarity));
  const Traits traits(mesh);
  const Traits moved(moved_mesh);
  const CSCD::Triangulated_surface& surface = traits.surface().triangulation();
  const CSCD::Triangulated_surface& moved_surface = moved.surface().triangulation();
  ASSERT_EQ(surface.number_of_vertices(), moved_surface.number_of_vertices());
  for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
    ASSERT_TRUE(std::equal(traits.descriptors(vertex).begin(), traits.descriptors(vertex).end(),
                           moved.descriptors(vertex).begin(), moved.descriptors(vertex).end()));
    const Point p = traits.to_input_point(surface.point(vertex));
    const Vector_3 expected = to_vector(similarity({p.x(), p.y(), p.z()}));
    const Point q = moved.to_input_point(moved_surface.point(vertex));
    ASSERT_LT((expected - to_vector({q.x(), q.y(), q.z()})).norm(), 1e-12 * 2e7);
  }
}

TEST(Triangle_mesh_traits, reads_other_mesh_types_alike)
{
  const Shape shape = CSCD::test::y_tube(0.2);
  const Mesh mesh = to_mesh(shape);
  const auto polyhedron = CSCD::test::to_mesh<CGAL::Polyhedron_3<Kernel>>(shape);
  const auto exact = CSCD::test::to_mesh<CGAL::Surface_mesh<CGAL::Epeck::Point_3>>(shape);
  const Traits traits(mesh);
  const CSCD::Triangle_mesh_traits polyhedron_traits(polyhedron);
  const CSCD::Triangle_mesh_traits exact_traits(exact);
  EXPECT_EQ(traits.surface().triangulation().points(), polyhedron_traits.surface().triangulation().points());
  EXPECT_EQ(traits.surface().triangulation().points(), exact_traits.surface().triangulation().points());
  const CGAL::Epeck::Point_3 point = exact_traits.to_input_point(exact_traits.surface().triangulation().point(0));
  EXPECT_NEAR(CGAL::to_double(point.x()), traits.to_input_point(traits.surface().triangulation().point(0)).x(), 1e-12);
}

TEST(Triangle_mesh_traits, answers_queries_from_several_threads)
{
  const Mesh mesh = to_mesh(CSCD::test::sphere(4));
  const Traits traits(mesh);
  const CSCD::Triangulated_solid& solid = traits.surface();
  std::vector<std::size_t> inside(4, 0);
  std::vector<std::thread> threads;
  for (std::size_t& count : inside) {
    threads.emplace_back([&solid, &count] {
      for (const Vector_3& point : solid.triangulation().points()) {
        count += solid.is_inside(0.9 * point) && !solid.is_inside(1.1 * point);
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_EQ(inside, std::vector<std::size_t>(4, solid.triangulation().number_of_vertices()));
  const auto hit = solid.first_hit(Vector_3::Zero(), {0, 0, 1});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(traits.to_input_length(hit->distance), 1, 0.01);
  EXPECT_NEAR(traits.to_input_length(solid.closest_point(Vector_3::Zero()).point.norm()), 1, 0.01);
}

TEST(Triangle_mesh_traits, takes_the_smallest_surfaces)
{
  for (const auto& triangles :
       {std::vector<CSCD::test::Triangle>{{0, 1, 2}}, std::vector<CSCD::test::Triangle>{{0, 1, 2}, {0, 2, 3}}}) {
    Shape shape;
    shape.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    shape.points.resize(triangles.size() + 2);
    shape.triangles = triangles;
    const Mesh mesh = to_mesh(shape);
    const Traits traits(mesh);
    EXPECT_EQ(traits.surface().number_of_bridged_borders(), 1u);
    EXPECT_EQ(traits.surface().genus(), 0u);
    EXPECT_NEAR(traits.surface().triangulation().total_area(), 1, 1e-12);
  }
}

TEST(Triangle_mesh_traits, counts_degenerate_faces)
{
  Mesh mesh = to_mesh(CSCD::test::subdivided_cube(1));
  // Slid along an edge of the cube onto its end: the two faces of the edge between them lose their area.
  for (Mesh::Vertex_index v : mesh.vertices()) {
    if (mesh.point(v) == Point(0.5, 0, 0)) {
      mesh.point(v) = Point(0, 0, 0);
    }
  }
  const Traits traits(mesh);
  EXPECT_EQ(traits.surface().number_of_degenerate_faces(), 2u);
}

TEST(Triangle_mesh_traits, refuses_surfaces_without_extent_or_area)
{
  Mesh mesh = to_mesh(CSCD::test::cube());
  for (Mesh::Vertex_index v : mesh.vertices()) {
    mesh.point(v) = Point(mesh.point(v).x(), 0, 0);
  }
  EXPECT_TRUE(names(message_of([&] { Traits traits(mesh); }), "all faces have zero area"));
  for (Mesh::Vertex_index v : mesh.vertices()) {
    mesh.point(v) = Point(1, 2, 3);
  }
  EXPECT_TRUE(names(message_of([&] { Traits traits(mesh); }), "all vertices are at the same point"));
}

TEST(Triangle_mesh_traits, takes_coordinates_whose_squares_overflow)
{
  for (double factor : {1e-200, 1e200}) {
    const Mesh mesh = to_mesh(CSCD::test::scaled(CSCD::test::sphere(2), factor));
    const Traits traits(mesh);
    EXPECT_EQ(traits.surface().genus(), 0u);
    EXPECT_NEAR(traits.to_input_point(traits.surface().triangulation().point(0)).x() / factor,
                mesh.point(*traits.descriptors(0).begin()).x() / factor, 1e-14);
  }
}

} // namespace
