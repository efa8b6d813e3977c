// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface traits of a mesh: counts, coordinates, correspondence, and independence from numbers and pose.

#include "Traits/message_of.h"
#include "support/Similarity.h"
#include "support/convert_shape.h"
#include "support/shapes.h"
#include <CSCD/Traits/Triangle_mesh_traits.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <thread>
#include <type_traits>
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
    EXPECT_EQ(traits.number_of_components(), shape.number_of_components);
    EXPECT_EQ(traits.genus(), shape.genus);
    EXPECT_EQ(traits.number_of_bridged_borders(), shape.number_of_border_cycles);
    EXPECT_EQ(traits.is_closed_input(), shape.is_closed());
    EXPECT_EQ(traits.number_of_input_vertices(), shape.points.size());
    EXPECT_EQ(traits.number_of_sites(), shape.points.size() + traits.number_of_inserted_vertices());
    EXPECT_EQ(traits.number_of_isolated_vertices(), 0u);
    EXPECT_EQ(traits.number_of_degenerate_faces(), 0u);
  }
}

TEST(Triangle_mesh_traits, maps_sites_to_vertices)
{
  const Shape shape = CSCD::test::merged("two", {CSCD::test::noisy(CSCD::test::beam(), 0.01, 1),
                                                 CSCD::test::translated(CSCD::test::sphere(2), {3, 3, 9})});
  const Mesh mesh = to_mesh(shape);
  const Traits traits(mesh);
  ASSERT_GT(traits.number_of_inserted_vertices(), 0u);
  std::set<Mesh::Vertex_index> seen;
  double weight = 0;
  Index inserted = CSCD::no_index;
  for (Index site = 0; site < traits.number_of_sites(); ++site) {
    weight += traits.weight(site);
    if (traits.is_input_vertex(site)) {
      EXPECT_TRUE(seen.insert(traits.descriptor(site)).second);
      const Point expected = mesh.point(traits.descriptor(site));
      EXPECT_LT(std::sqrt(CGAL::squared_distance(traits.to_input_point(traits.point(site)), expected)), 1e-13 * 20);
    } else {
      inserted = site;
    }
  }
  EXPECT_EQ(seen.size(), shape.points.size());
  EXPECT_THROW(traits.descriptor(inserted), CGAL::Precondition_exception);
  EXPECT_NEAR(weight, 1, 1e-4);
}

TEST(Triangle_mesh_traits, keeps_lengths_in_proportion)
{
  const Mesh mesh = to_mesh(CSCD::test::scaled(CSCD::test::cube(), 100));
  const Traits traits(mesh);
  EXPECT_NEAR(traits.to_input_length(1), std::sqrt(6.) * 100, 1e-9);
  const Point center = traits.to_input_point(Vector_3::Zero());
  EXPECT_NEAR(center.x(), 50, 1e-9);
}

TEST(Triangle_mesh_traits, lists_neighbors_and_triangles)
{
  const Mesh mesh = to_mesh(CSCD::test::torus(3, 1, 24));
  const Traits traits(mesh);
  std::set<std::pair<Index, Index>> edges;
  for (Index f = 0; f < traits.number_of_triangles(); ++f) {
    const auto corner = traits.triangle(f);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_TRUE(edges.insert({corner[k], corner[(k + 1) % 3]}).second);
    }
  }
  std::size_t number = 0;
  for (Index site = 0; site < traits.number_of_sites(); ++site) {
    for (Index neighbor : traits.neighbors(site)) {
      EXPECT_EQ(edges.count({site, neighbor}), 1u);
      ++number;
    }
  }
  EXPECT_EQ(number, edges.size());
}

TEST(Triangle_mesh_traits, numbers_components_by_area)
{
  const Mesh mesh = to_mesh(
      CSCD::test::merged("two", {CSCD::test::cube(), CSCD::test::translated(CSCD::test::sphere(4), {9, 0, 0})}));
  const Traits traits(mesh);
  for (Index site = 0; site < traits.number_of_sites(); ++site) {
    const bool is_sphere = traits.to_input_point(traits.point(site)).x() > 5;
    ASSERT_EQ(traits.component(site), is_sphere ? 0u : 1u);
  }
}

TEST(Triangle_mesh_traits, turns_bodies_that_look_inwards)
{
  const Mesh mesh = to_mesh(CSCD::test::reversed(CSCD::test::sphere(3)));
  const Traits traits(mesh);
  EXPECT_EQ(traits.number_of_reversed_components(), 1u);
  for (Index site = 0; site < traits.number_of_sites(); ++site) {
    ASSERT_GT(traits.normal(site).dot(traits.point(site)), 0);
  }
}

/// Equal to the last bit.
void expect_equal_surfaces(const Traits& a, const Traits& b)
{
  ASSERT_EQ(a.number_of_sites(), b.number_of_sites());
  EXPECT_EQ(a.surface().points(), b.surface().points());
  for (Index f = 0; f < a.number_of_triangles(); ++f) {
    ASSERT_EQ(a.triangle(f), b.triangle(f));
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
  ASSERT_EQ(traits.number_of_sites(), moved.number_of_sites());
  for (Index site = 0; site < traits.number_of_sites(); ++site) {
    ASSERT_EQ(traits.is_input_vertex(site), moved.is_input_vertex(site));
    if (traits.is_input_vertex(site)) {
      ASSERT_EQ(traits.descriptor(site), moved.descriptor(site));
    }
    const Point p = traits.to_input_point(traits.point(site));
    const Vector_3 expected = to_vector(similarity({p.x(), p.y(), p.z()}));
    const Point q = moved.to_input_point(moved.point(site));
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
  EXPECT_EQ(traits.surface().points(), polyhedron_traits.surface().points());
  EXPECT_EQ(traits.surface().points(), exact_traits.surface().points());
  const CGAL::Epeck::Point_3 point = exact_traits.to_input_point(exact_traits.point(0));
  EXPECT_NEAR(CGAL::to_double(point.x()), traits.to_input_point(traits.point(0)).x(), 1e-12);
}

TEST(Triangle_mesh_traits, answers_queries_from_several_threads)
{
  const Mesh mesh = to_mesh(CSCD::test::sphere(4));
  const Traits traits(mesh);
  std::vector<std::size_t> inside(4, 0);
  std::vector<std::thread> threads;
  for (std::size_t& count : inside) {
    threads.emplace_back([&traits, &count] {
      for (Index site = 0; site < traits.number_of_sites(); ++site) {
        count += traits.is_inside(0.9 * traits.point(site)) && !traits.is_inside(1.1 * traits.point(site));
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_EQ(inside, std::vector<std::size_t>(4, traits.number_of_sites()));
  const auto hit = traits.first_hit(Vector_3::Zero(), {0, 0, 1});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(traits.to_input_length(hit->distance), 1, 0.01);
  EXPECT_NEAR(traits.to_input_length(traits.closest_point(Vector_3::Zero()).point.norm()), 1, 0.01);
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
    EXPECT_EQ(traits.number_of_bridged_borders(), 1u);
    EXPECT_EQ(traits.genus(), 0u);
    EXPECT_NEAR(traits.surface().total_area(), 1, 1e-12);
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
  EXPECT_EQ(traits.number_of_degenerate_faces(), 2u);
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
    EXPECT_EQ(traits.genus(), 0u);
    EXPECT_NEAR(traits.to_input_point(traits.point(0)).x() / factor, mesh.point(traits.descriptor(0)).x() / factor,
                1e-14);
  }
}

} // namespace
