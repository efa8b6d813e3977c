// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes of several types are read alike, and bad ones are refused with the element named.

#include "Traits/message_of.h"
#include "support/convert_shape.h"
#include "support/shapes.h"
#include <CSCD/Traits/collect_triangles.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using CSCD::Index;
using CSCD::test::message_of;
using CSCD::test::names;
using CSCD::test::Shape;

template <class TriangleMesh>
auto collect(const TriangleMesh& mesh)
{
  return CSCD::internal::collect_triangles(mesh, get(CGAL::vertex_point, mesh));
}

std::string message(const Mesh& mesh)
{
  return message_of([&] { collect(mesh); });
}

/// Every face as its points, from the least on: independent of numbers.
template <class TriangleMesh>
std::vector<std::array<std::array<double, 3>, 3>> sorted_faces(const TriangleMesh& mesh)
{
  const auto collected = collect(mesh);
  std::vector<std::array<std::array<double, 3>, 3>> result;
  for (const auto& face : collected.triangles.faces) {
    std::array<std::array<double, 3>, 3> points;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& p = collected.triangles.points[face[k]];
      points[k] = {p.x(), p.y(), p.z()};
    }
    std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
    result.push_back(points);
  }
  std::sort(result.begin(), result.end());
  return result;
}

template <class TriangleMesh>
class Collect_triangles_of : public testing::Test
{
};

using Mesh_types =
    testing::Types<CGAL::Polyhedron_3<Kernel>, CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>,
                   CGAL::Surface_mesh<CGAL::Epeck::Point_3>>;
TYPED_TEST_SUITE(Collect_triangles_of, Mesh_types, );

TYPED_TEST(Collect_triangles_of, a_cube_reads_alike)
{
  const auto mesh = CSCD::test::to_mesh<TypeParam>(CSCD::test::cube());
  EXPECT_EQ(sorted_faces(mesh), sorted_faces(CSCD::test::to_mesh<Mesh>(CSCD::test::cube())));
}

TEST(collect_triangles, reads_in_order_of_iteration)
{
  const Shape shape = CSCD::test::sphere(2);
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(shape);
  const auto collected = collect(mesh);
  ASSERT_EQ(collected.descriptors.size(), shape.points.size());
  ASSERT_EQ(collected.triangles.faces.size(), shape.triangles.size());
  EXPECT_EQ(collected.triangles.first_hole_filling_face, shape.triangles.size());
  for (std::size_t i = 0; i < shape.points.size(); ++i) {
    EXPECT_EQ(collected.triangles.points[i].x(), shape.points[i][0]);
    EXPECT_EQ(mesh.point(collected.descriptors[i]).z(), shape.points[i][2]);
  }
  EXPECT_FALSE(collected.pairing.has_border());
}

TEST(collect_triangles, reads_a_part_of_a_mesh)
{
  Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::merged("two", {CSCD::test::cube(), CSCD::test::sphere(1)}));
  auto part = mesh.add_property_map<Mesh::Face_index, int>("f:part").first;
  for (Mesh::Face_index f : mesh.faces()) {
    part[f] = f.idx() < 12 ? 0 : 1;
  }
  const CGAL::Face_filtered_graph<Mesh> sphere(mesh, 1, part);
  const auto collected = collect(sphere);
  EXPECT_EQ(collected.triangles.faces.size(), 80u);
  EXPECT_EQ(collected.descriptors.size(), 42u);
  EXPECT_GE(collected.descriptors.front().idx(), 8u);
}

TEST(collect_triangles, reads_a_mesh_with_removed_elements)
{
  Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::sphere(2));
  CGAL::Euler::collapse_edge(edge(halfedge(Mesh::Vertex_index(50), mesh), mesh), mesh);
  ASSERT_TRUE(mesh.has_garbage());
  EXPECT_EQ(collect(mesh).descriptors.size(), mesh.number_of_vertices());
}

TEST(collect_triangles, uses_the_point_map)
{
  Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::cube());
  auto doubled = mesh.add_property_map<Mesh::Vertex_index, Point>("v:doubled").first;
  for (Mesh::Vertex_index v : mesh.vertices()) {
    doubled[v] = Point(2 * mesh.point(v).x(), 0, 0);
  }
  const auto collected = CSCD::internal::collect_triangles(mesh, doubled);
  EXPECT_EQ(collected.triangles.points[7], CSCD::Vector_3(2, 0, 0));
}

TEST(collect_triangles, leaves_isolated_vertices_out)
{
  Mesh mesh;
  mesh.add_vertex(Point(9, 9, std::numeric_limits<double>::quiet_NaN()));
  const Shape cube = CSCD::test::cube();
  std::vector<Mesh::Vertex_index> vertices;
  for (const auto& p : cube.points) {
    vertices.push_back(mesh.add_vertex(Point(p[0], p[1], p[2])));
    mesh.add_vertex(Point(9, 9, 9));
  }
  for (const auto& t : cube.triangles) {
    mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
  }
  const auto collected = collect(mesh);
  EXPECT_EQ(collected.number_of_isolated_vertices, 9u);
  EXPECT_EQ(collected.descriptors, vertices);
  EXPECT_EQ(collected.triangles.points[7], CSCD::Vector_3(1, 1, 1));
}

TEST(collect_triangles, refuses_a_mesh_without_faces)
{
  Mesh mesh;
  EXPECT_TRUE(names(message(mesh), "the mesh has no faces"));
  mesh.add_vertex(Point(0, 0, 0));
  EXPECT_TRUE(names(message(mesh), "the mesh has no faces"));
}

TEST(collect_triangles, refuses_a_polygon)
{
  Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::cube());
  CGAL::Euler::join_face(halfedge(Mesh::Vertex_index(0), mesh), mesh);
  const std::string text = message(mesh);
  EXPECT_NE(text.find("has 4 sides: triangulate"), std::string::npos) << text;
  EXPECT_TRUE(names(text, "face ")) << text;
}

TEST(collect_triangles, refuses_coordinates_that_are_not_finite)
{
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::cube());
    mesh.point(Mesh::Vertex_index(5)) = Point(0, bad, 0);
    EXPECT_TRUE(names(message(mesh), "vertex 5 has a coordinate that is not finite"));
  }
}

TEST(collect_triangles, counts_isolated_vertices_in_the_numbers_of_messages)
{
  Mesh mesh;
  mesh.add_vertex(Point(9, 9, 9));
  const auto a = mesh.add_vertex(Point(0, 0, 0));
  const auto b = mesh.add_vertex(Point(1, 0, 0));
  const auto c = mesh.add_vertex(Point(0, std::numeric_limits<double>::infinity(), 0));
  mesh.add_face(a, b, c);
  EXPECT_TRUE(names(message(mesh), "vertex 3 has a coordinate"));
}

TEST(collect_triangles, refuses_a_face_that_uses_a_vertex_twice)
{
  // Two halfedge loops through the same vertex, as a collapse without check leaves them.
  Mesh mesh;
  const auto a = mesh.add_vertex(Point(0, 0, 0));
  const auto b = mesh.add_vertex(Point(1, 0, 0));
  const auto c = mesh.add_vertex(Point(0, 1, 0));
  const auto f = mesh.add_face(a, b, c);
  mesh.set_target(mesh.halfedge(f), mesh.target(mesh.next(mesh.halfedge(f))));
  EXPECT_TRUE(names(message(mesh), "face 0 uses a vertex twice"));
}

TEST(collect_triangles, refuses_a_pinched_vertex)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (int i = 0; i < 5; ++i) {
    v.push_back(mesh.add_vertex(Point(i, i * i, 0)));
  }
  mesh.add_face(v[0], v[1], v[2]);
  mesh.add_face(v[2], v[3], v[4]);
  EXPECT_TRUE(names(message(mesh), "vertex 2 is pinched")) << message(mesh);
}

TEST(collect_triangles, refuses_two_edges_with_the_same_ends)
{
  // Collapsing the middle of a band of two rings of three leaves pairs of faces with equal corners.
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (int i = 0; i < 4; ++i) {
    v.push_back(mesh.add_vertex(Point(i, i * i, i % 2)));
  }
  const auto first = mesh.add_face(v[0], v[1], v[2]);
  const auto copy = mesh.add_vertex(Point(1, 1, 1));
  const auto second = mesh.add_face(v[0], copy, v[3]);
  for (auto h : halfedges_around_face(mesh.halfedge(second), mesh)) {
    if (mesh.target(h) == copy) {
      mesh.set_target(h, v[1]);
    }
  }
  ASSERT_NE(first, second);
  const std::string text = message(mesh);
  EXPECT_TRUE(names(text, "the edge between vertices 0 and 1")) << text;
}

} // namespace
