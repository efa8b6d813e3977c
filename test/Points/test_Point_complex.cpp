// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Halfedges, areas and components of complexes made by hand, also where they are no surface.

#include "Points/to_point_complex.h"
#include "support/sampling.h"
#include "support/shapes.h"
#include <CSCD/Points/Point_complex.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Point_complex;
using CSCD::Vector_3;

TEST(Point_complex, numbers_halfedges_counterclockwise)
{
  const Point_complex complex = CSCD::test::to_point_complex(CSCD::test::torus(3, 1, 16));
  Index number = 0;
  for (Index v = 0; v < complex.number_of_vertices(); ++v) {
    const auto range = complex.outgoing(v);
    for (const Index h : range) {
      EXPECT_EQ(number++, h);
      EXPECT_EQ(v, complex.origin(h));
      EXPECT_EQ(h, complex.twin(complex.twin(h)));
      EXPECT_EQ(v, complex.target(complex.twin(h)));
      EXPECT_EQ(complex.edge(h), complex.edge(complex.twin(h)));
      EXPECT_EQ(h, complex.find_halfedge(v, complex.target(h)));
      EXPECT_DOUBLE_EQ((complex.point(complex.target(h)) - complex.point(v)).norm(), complex.length(h));
      const Index next = h + 1 == *range.end() ? *range.begin() : h + 1;
      const Vector_3 x = complex.point(complex.target(h)) - complex.point(v);
      const Vector_3 y = complex.point(complex.target(next)) - complex.point(v);
      EXPECT_GT(complex.normal(v).dot(x.cross(y)), 0);
    }
  }
  EXPECT_EQ(number, complex.number_of_halfedges());
}

TEST(Point_complex, has_the_faces_and_the_area_of_its_triangles)
{
  const CSCD::test::Shape shape = CSCD::test::torus(3, 1, 16);
  const Point_complex complex = CSCD::test::to_point_complex(shape);
  ASSERT_EQ(shape.triangles.size(), complex.number_of_faces());
  double area = 0;
  for (Index f = 0; f < complex.number_of_faces(); ++f) {
    const auto [a, b, c] = complex.face_halfedges(f);
    EXPECT_EQ(complex.target(a), complex.origin(b));
    EXPECT_EQ(complex.target(b), complex.origin(c));
    EXPECT_EQ(complex.target(c), complex.origin(a));
    const auto& t = shape.triangles[f];
    EXPECT_EQ((std::array<Index, 3>{Index(t[0]), Index(t[1]), Index(t[2])}), complex.face_vertices(f));
    area += CSCD::test::area(shape, t);
  }
  double sum = 0;
  for (Index v = 0; v < complex.number_of_vertices(); ++v) {
    sum += complex.vertex_area(v);
  }
  EXPECT_NEAR(area, sum, 1e-9 * area);
  EXPECT_EQ(1u, complex.number_of_components());
}

TEST(Point_complex, shares_the_area_where_triangles_overlap)
{
  // All four triangles of a square.
  std::vector<Vector_3> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}};
  std::vector<Vector_3> normals(points.size(), Vector_3::UnitZ());
  const std::vector<std::array<Index, 3>> around{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  std::vector<std::array<Index, 3>> twice = around;
  twice.insert(twice.end(), {{0, 1, 2}, {2, 3, 0}});
  const Point_complex once(std::vector<Vector_3>(points), std::vector<Vector_3>(normals), around);
  EXPECT_DOUBLE_EQ(1. / 3, once.vertex_area(4));
  // A second cover of the center.
  points.insert(points.end(), {{2, 0.5, 0}, {-1, 1.5, 0}, {-1, -0.5, 0}});
  normals.resize(points.size(), Vector_3::UnitZ());
  twice = around;
  twice.insert(twice.end(), {{5, 6, 4}, {6, 7, 4}, {7, 5, 4}});
  const Point_complex covered(std::move(points), std::move(normals), twice);
  const double outer = (1.5 * 0.5 * 2 + 2 * 1.5) / 2 / 3;
  EXPECT_NEAR((1. / 3 + outer) / 2, covered.vertex_area(4), 0.2) << "about half of the sum";
  EXPECT_LT(covered.vertex_area(4), 1. / 3 + outer);
}

TEST(Point_complex, may_have_three_triangles_at_an_edge_and_vertices_without)
{
  std::vector<Vector_3> points{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {9, 9, 9}};
  std::vector<Vector_3> normals(points.size(), Vector_3(0.6, 0.8, 0));
  const Point_complex complex(std::move(points), std::move(normals), {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}});
  EXPECT_EQ(3u, complex.number_of_faces());
  EXPECT_EQ(14u, complex.number_of_halfedges());
  EXPECT_TRUE(complex.outgoing(5).empty());
  EXPECT_EQ(0, complex.vertex_area(5));
  EXPECT_EQ(2u, complex.number_of_components());
  EXPECT_NE(complex.component(0), complex.component(5));
}

TEST(Point_complex, without_points_is_empty)
{
  const Point_complex complex({}, {}, {});
  EXPECT_EQ(0u, complex.number_of_vertices());
  EXPECT_EQ(0u, complex.number_of_components());
  EXPECT_EQ(0, complex.mean_edge_length());
}

} // namespace
