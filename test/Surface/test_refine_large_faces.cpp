// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Refinement of faces that are too large, and of pillows.

#include "Surface/to_indexed_triangles.h"
#include "support/shapes.h"
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Surface/close_surface.h>
#include <CSCD/Surface/refine_large_faces.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace {

using CSCD::Halfedge_pairing;
using CSCD::Index;
using CSCD::Indexed_triangles;
using CSCD::Triangulated_surface;
using CSCD::Vector_3;
using CSCD::internal::Surface_components;
using CSCD::test::Shape;

struct Refined
{
  explicit Refined(const Shape& shape) : triangles(CSCD::test::to_indexed_triangles(shape))
  {
    Halfedge_pairing pairing(triangles.faces, triangles.points.size());
    CSCD::internal::bridge_borders(triangles, pairing);
    pairing = Halfedge_pairing(triangles.faces, triangles.points.size());
    Surface_components components(triangles);
    area = total(components);
    volume = components.measures.front().volume;
    number_of_inserted_vertices = CSCD::internal::refine_large_faces(triangles, pairing, components);
    EXPECT_EQ(triangles.points.size(), shape.points.size() + number_of_inserted_vertices);
    EXPECT_EQ(components.component.size(), triangles.faces.size());
    const Surface_components refined(triangles);
    EXPECT_EQ(refined.component, components.component);
    EXPECT_NEAR(total(refined), area, 1e-11 * area);
    EXPECT_NEAR(refined.measures.front().volume, volume, 1e-11 * std::abs(volume));
  }

  static double total(const Surface_components& components)
  {
    double result = 0;
    for (const auto& measure : components.measures) {
      result += measure.area;
    }
    return result;
  }

  Indexed_triangles triangles;
  double area = 0;
  double volume = 0;
  std::size_t number_of_inserted_vertices = 0;
};

double longest_edge(const Indexed_triangles& triangles)
{
  double result = 0;
  for (const auto& face : triangles.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      result = std::max(result, (triangles.points[face[k]] - triangles.points[face[(k + 1) % 3]]).norm());
    }
  }
  return result;
}

TEST(refine_large_faces, gives_a_cube_about_two_thousand_vertices)
{
  Refined refined(CSCD::test::cube());
  EXPECT_GE(refined.triangles.points.size(), 1500u);
  EXPECT_LE(refined.triangles.points.size(), 2500u);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(refined.triangles.points[i], CSCD::test::to_indexed_triangles(CSCD::test::cube()).points[i]);
  }
  EXPECT_FALSE(Triangulated_surface(std::move(refined.triangles)).defect());
}

TEST(refine_large_faces, leaves_a_well_sampled_surface_alone)
{
  for (const Shape& shape : {CSCD::test::sphere(4), CSCD::test::subdivided_cube(5), CSCD::test::torus(3, 1, 48)}) {
    ASSERT_GE(shape.points.size(), 2500u);
    EXPECT_EQ(Refined(shape).number_of_inserted_vertices, 0u) << shape.name;
  }
}

TEST(refine_large_faces, keeps_closed_manifolds_and_short_edges)
{
  for (const Shape& shape :
       {CSCD::test::tetrahedron(), CSCD::test::beam(), CSCD::test::l_bracket(), CSCD::test::plate_with_hole(),
        CSCD::test::double_cone(24), CSCD::test::anisotropic_tube(40, 1, 8, 2),
        CSCD::test::tube(20, 1, 64, CSCD::test::Tube_end::flat)}) {
    SCOPED_TRACE(shape.name);
    Refined refined(shape);
    EXPECT_GT(refined.number_of_inserted_vertices, 0u);
    EXPECT_LE(longest_edge(refined.triangles), 2.2 * std::sqrt(refined.area / 2000) * (1 + 1e-12));
    Triangulated_surface surface(std::move(refined.triangles));
    ASSERT_FALSE(surface.defect());
    EXPECT_EQ(long(surface.number_of_vertices()) - long(surface.number_of_faces() / 2), 2 - 2 * long(shape.genus));
  }
}

TEST(refine_large_faces, keeps_bridging_faces_at_the_end)
{
  Shape shape = CSCD::test::tube(20, 1, 12, CSCD::test::Tube_end::open);
  const Refined refined(shape);
  ASSERT_LT(refined.triangles.first_hole_filling_face, refined.triangles.faces.size());
  for (std::size_t f = 0; f < refined.triangles.faces.size(); ++f) {
    const auto& face = refined.triangles.faces[f];
    const Vector_3& a = refined.triangles.points[face[0]];
    const Vector_3 normal =
        (refined.triangles.points[face[1]] - a).cross(refined.triangles.points[face[2]] - a).normalized();
    const bool is_cap = std::abs(normal.x()) > 0.5;
    ASSERT_EQ(f >= refined.triangles.first_hole_filling_face, is_cap) << f;
  }
}

TEST(refine_large_faces, shares_a_budget_among_many_components)
{
  Shape cubes;
  for (std::size_t i = 0; i < 2000; ++i) {
    const Shape cube = CSCD::test::translated(CSCD::test::cube(), {2. * double(i), 0, 0});
    for (const auto& t : cube.triangles) {
      cubes.triangles.push_back({t[0] + 8 * i, t[1] + 8 * i, t[2] + 8 * i});
    }
    cubes.points.insert(cubes.points.end(), cube.points.begin(), cube.points.end());
  }
  const Refined refined(cubes);
  EXPECT_GT(refined.number_of_inserted_vertices, 0u);
  EXPECT_LE(refined.triangles.points.size(), 4 * cubes.points.size() + 20000);
}

TEST(refine_large_faces, ends_on_faces_without_area)
{
  Indexed_triangles triangles{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 2, 1}}, 2};
  Halfedge_pairing pairing(triangles.faces, 3);
  Surface_components components(triangles);
  EXPECT_EQ(CSCD::internal::refine_large_faces(triangles, pairing, components), 0u);
}

TEST(split_two_face_components, leaves_other_surfaces_alone)
{
  Indexed_triangles triangles = CSCD::test::to_indexed_triangles(CSCD::test::tetrahedron());
  Halfedge_pairing pairing(triangles.faces, 4);
  Surface_components components(triangles);
  EXPECT_EQ(CSCD::internal::split_two_face_components(triangles, pairing, components), 0u);
  EXPECT_EQ(triangles.faces.size(), 4u);
}

TEST(split_two_face_components, splits_the_second_face)
{
  // A bridged triangle, a closed pillow, and a tetrahedron between their faces.
  Indexed_triangles triangles = CSCD::test::to_indexed_triangles(CSCD::test::tetrahedron());
  for (int i = 0; i < 6; ++i) {
    triangles.points.emplace_back(i, i * i, i % 3);
  }
  triangles.faces.insert(triangles.faces.begin(), {{7, 8, 9}, {4, 5, 6}});
  triangles.faces.insert(triangles.faces.end(), {{7, 9, 8}, {4, 6, 5}});
  triangles.first_hole_filling_face = 7; // the last face
  Halfedge_pairing pairing(triangles.faces, triangles.points.size());
  Surface_components components(triangles);
  EXPECT_EQ(CSCD::internal::split_two_face_components(triangles, pairing, components), 2u);
  EXPECT_EQ(triangles.faces.size(), 12u);
  EXPECT_EQ(triangles.first_hole_filling_face, 9u);
  EXPECT_EQ(Surface_components(triangles).component, components.component);
  CSCD::internal::refine_large_faces(triangles, pairing, components);
  const Triangulated_surface surface(std::move(triangles));
  ASSERT_FALSE(surface.defect());
  for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
    EXPECT_GE(surface.degree(vertex), 3u);
  }
}

} // namespace
