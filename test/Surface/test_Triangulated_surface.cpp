// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The flat arrays agree with the triangles that they were compiled from.

#include "Surface/to_indexed_triangles.h"
#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Indexed_triangles;
using CSCD::no_index;
using CSCD::Triangulated_surface;
using CSCD::Vector_3;
using CSCD::test::to_surface;

TEST(Triangulated_surface, connects_halfedges)
{
  const Triangulated_surface surface = to_surface(CSCD::test::torus(3, 1, 12));
  ASSERT_FALSE(surface.defect());
  EXPECT_EQ(surface.number_of_vertices() + surface.number_of_faces(), surface.number_of_halfedges() / 2);
  for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
    const Index twin = surface.twin(h);
    ASSERT_EQ(surface.twin(twin), h);
    ASSERT_EQ(surface.origin(twin), surface.target(h));
    ASSERT_EQ(surface.edge(h), surface.edge(twin));
    ASSERT_EQ(surface.next(surface.previous(h)), h);
    ASSERT_EQ(surface.face(surface.next(h)), surface.face(h));
    ASSERT_EQ(surface.opposite_vertex(h), surface.target(surface.next(h)));
    ASSERT_EQ(surface.previous_around_origin(surface.next_around_origin(h)), h);
    ASSERT_EQ(surface.find_halfedge(surface.origin(h), surface.target(h)), h);
  }
}

TEST(Triangulated_surface, lists_rings_counterclockwise)
{
  const Triangulated_surface surface = to_surface(CSCD::test::sphere(2));
  std::size_t sum = 0;
  for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
    const auto ring = surface.outgoing(vertex);
    ASSERT_EQ(ring.size(), surface.degree(vertex));
    sum += ring.size();
    const Vector_3& center = surface.point(vertex);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Index h = ring.begin()[i];
      const Index following = ring.begin()[(i + 1) % ring.size()];
      ASSERT_EQ(surface.origin(h), vertex);
      ASSERT_EQ(surface.next_around_origin(h), following);
      const Vector_3 incident_edge = surface.point(surface.target(h)) - center;
      const Vector_3 next_incident_edge = surface.point(surface.target(following)) - center;
      ASSERT_GT(incident_edge.cross(next_incident_edge).dot(center), 0) << "seen from outside the sphere";
    }
  }
  EXPECT_EQ(sum, surface.number_of_halfedges());
}

TEST(Triangulated_surface, measures)
{
  const Triangulated_surface surface = to_surface(CSCD::test::subdivided_cube(2));
  EXPECT_NEAR(surface.total_area(), 6, 1e-12);
  double face_sum = 0;
  for (Index face = 0; face < surface.number_of_faces(); ++face) {
    face_sum += surface.face_area(face);
    EXPECT_NEAR(surface.face_vector(face).norm() / 2, surface.face_area(face), 1e-6);
  }
  double vertex_sum = 0;
  for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
    vertex_sum += surface.vertex_area(vertex);
    EXPECT_NEAR(surface.vertex_normal(vertex).norm(), 1, 1e-6);
    EXPECT_GT(surface.vertex_normal(vertex).dot(surface.point(vertex) - Vector_3::Constant(0.5)), 0);
  }
  EXPECT_NEAR(face_sum, 6, 1e-5);
  EXPECT_NEAR(vertex_sum, 6, 1e-5);
}

TEST(Triangulated_surface, gives_bridging_faces_no_area)
{
  Indexed_triangles triangles = CSCD::test::to_indexed_triangles(CSCD::test::cube());
  triangles.first_hole_filling_face = 10;
  const Triangulated_surface surface(std::move(triangles));
  EXPECT_NEAR(surface.total_area(), 5, 1e-12);
  EXPECT_FALSE(surface.is_hole_filling(9));
  EXPECT_TRUE(surface.is_hole_filling(10));
  EXPECT_EQ(surface.face_area(10), 0.f);
  EXPECT_NEAR(surface.face_vector(10).norm(), 1, 1e-12) << "its direction still counts";
}

TEST(Triangulated_surface, accepts_a_pillow)
{
  const Triangulated_surface surface(Indexed_triangles{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}, 1});
  ASSERT_FALSE(surface.defect());
  EXPECT_EQ(surface.degree(0), 2u);
}

TEST(Triangulated_surface, finds_a_vertex_of_high_degree)
{
  const Triangulated_surface surface = to_surface(CSCD::test::double_cone(2000));
  ASSERT_FALSE(surface.defect());
  EXPECT_EQ(surface.degree(2000), 2000u);
}

TEST(Triangulated_surface, names_a_border_edge)
{
  Indexed_triangles triangles = CSCD::test::to_indexed_triangles(CSCD::test::tetrahedron());
  triangles.faces.erase(triangles.faces.begin());
  const Triangulated_surface surface(std::move(triangles));
  ASSERT_TRUE(surface.defect());
  EXPECT_NE(surface.defect().target, no_index);
  EXPECT_LT(surface.defect().vertex, 3u);
  EXPECT_LT(surface.defect().target, 3u);
}

TEST(Triangulated_surface, names_an_edge_of_opposite_orientations)
{
  Indexed_triangles triangles = CSCD::test::to_indexed_triangles(CSCD::test::tetrahedron());
  std::swap(triangles.faces[2][0], triangles.faces[2][1]);
  EXPECT_TRUE(Triangulated_surface(std::move(triangles)).defect());
}

TEST(Triangulated_surface, names_a_pinched_vertex)
{
  Indexed_triangles triangles;
  triangles.points.resize(7, Vector_3::Zero());
  triangles.faces = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}, {6, 4, 5}, {6, 0, 4}, {6, 5, 0}, {4, 0, 5}};
  triangles.first_hole_filling_face = 8;
  const Triangulated_surface surface(std::move(triangles));
  ASSERT_TRUE(surface.defect());
  EXPECT_EQ(surface.defect().vertex, 0u);
  EXPECT_EQ(surface.defect().target, no_index);
}

TEST(Triangulated_surface, has_borders_if_the_pairing_is_given)
{
  const CSCD::test::Shape shape = CSCD::test::tube(6, 1, 12, CSCD::test::Tube_end::open);
  Indexed_triangles triangles = CSCD::test::to_indexed_triangles(shape);
  CSCD::Halfedge_pairing pairing(triangles.faces, triangles.points.size());
  const Triangulated_surface surface(std::move(triangles), std::move(pairing));
  EXPECT_FALSE(surface.defect());
  std::size_t number_of_border_halfedges = 0;
  std::size_t sum = 0;
  for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
    const auto outgoing = surface.outgoing(vertex);
    ASSERT_EQ(outgoing.size(), surface.degree(vertex));
    sum += outgoing.size();
    for (std::size_t i = 0; i < outgoing.size(); ++i) {
      const Index h = outgoing.begin()[i];
      ASSERT_EQ(surface.origin(h), vertex);
      const bool is_on_border = surface.twin(h) == no_index;
      number_of_border_halfedges += is_on_border ? 1 : 0;
      ASSERT_TRUE(!is_on_border || i == 0) << "the fan begins at the border";
      ASSERT_EQ(surface.edge(h), is_on_border ? h : std::min(h, surface.twin(h)));
      const bool is_last_of_fan = surface.twin(outgoing.begin()[0]) == no_index && i + 1 == outgoing.size();
      ASSERT_EQ(surface.next_around_origin(h), is_last_of_fan ? no_index : outgoing.begin()[(i + 1) % outgoing.size()]);
    }
  }
  EXPECT_EQ(sum, surface.number_of_halfedges());
  EXPECT_EQ(number_of_border_halfedges, 2u * 12u);
}

} // namespace
