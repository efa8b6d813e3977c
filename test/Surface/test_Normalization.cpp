// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Unit area or unit extent, centered, whatever the size and the place.

#include "Surface/to_indexed_triangles.h"
#include "Traits/message_of.h"
#include "support/shapes.h"
#include <CSCD/Surface/Normalization.h>

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace {

using CSCD::Indexed_triangles;
using CSCD::normalize_area;
using CSCD::normalize_extent;
using CSCD::Vector_3;
using CSCD::test::message_of;
using CSCD::test::names;

double area(const Indexed_triangles& triangles)
{
  double result = 0;
  for (std::size_t f = 0; f < triangles.first_hole_filling_face; ++f) {
    const Vector_3& a = triangles.points[triangles.faces[f][0]];
    result +=
        (triangles.points[triangles.faces[f][1]] - a).cross(triangles.points[triangles.faces[f][2]] - a).norm() / 2;
  }
  return result;
}

TEST(normalize_area, gives_unit_area_around_the_origin)
{
  Indexed_triangles triangles =
      CSCD::test::to_indexed_triangles(CSCD::test::translated(CSCD::test::cube(), {10, -20, 30}));
  const Vector_3 corner = triangles.points[7];
  const auto normalization = normalize_area(triangles);
  EXPECT_NEAR(area(triangles), 1, 1e-14);
  EXPECT_TRUE(normalization.origin.isApprox(Vector_3(10.5, -19.5, 30.5), 1e-14));
  EXPECT_NEAR(normalization.unit, std::sqrt(6.), 1e-14);
  EXPECT_TRUE(normalization.to_input(triangles.points[7]).isApprox(corner, 1e-14));
  EXPECT_TRUE(normalization.from_input(corner).isApprox(triangles.points[7], 1e-14));
}

TEST(normalize_area, does_not_count_bridging_faces)
{
  Indexed_triangles triangles = CSCD::test::to_indexed_triangles(CSCD::test::cube());
  triangles.first_hole_filling_face = 6;
  normalize_area(triangles);
  EXPECT_NEAR(area(triangles), 1, 1e-14);
}

TEST(normalize_area, refuses_collinear_points)
{
  Indexed_triangles triangles = CSCD::test::to_indexed_triangles(CSCD::test::cube());
  for (Vector_3& point : triangles.points) {
    point = Vector_3::Constant(point.x() + 0.3 * point.y() + 0.1 * point.z());
  }
  EXPECT_TRUE(
      CSCD::test::names(CSCD::test::message_of([&] { normalize_area(triangles); }), "all faces have zero area"));
}

TEST(Normalization, composes)
{
  const CSCD::Normalization first{{1, 2, 3}, 2};
  const CSCD::Normalization second{{-1, 0.5, 0}, 0.25};
  const Vector_3 point(0.125, -4, 8);
  EXPECT_EQ(first.then(second).to_input(point), first.to_input(second.to_input(point)));
}

TEST(normalize_extent, maps_the_bounding_box_to_the_unit_box)
{
  std::vector<Vector_3> points{{1, 2, 3}, {5, 2, 3}, {3, 4, 3.5}};
  const auto normalization = normalize_extent(points);
  EXPECT_EQ(points[0], Vector_3(-1, -0.5, -0.125));
  EXPECT_EQ(points[1], Vector_3(1, -0.5, -0.125));
  EXPECT_EQ(normalization.to_input(points[2]), Vector_3(3, 4, 3.5));
}

TEST(normalize_extent, does_not_depend_on_scale)
{
  // Powers of two are exact, so the normalized points are equal bit by bit.
  const std::vector<Vector_3> unscaled{{1, 2, 3}, {5, 2.5, 3}, {3, 4, 3.7}};
  std::vector<Vector_3> expected = unscaled;
  normalize_extent(expected);
  for (double factor : {0x1p-900, 0x1p-30, 0x1p30, 0x1p900}) {
    std::vector<Vector_3> points;
    for (const Vector_3& point : unscaled) {
      points.push_back(factor * point);
    }
    const auto normalization = normalize_extent(points);
    EXPECT_EQ(points, expected) << factor;
    EXPECT_TRUE(normalization.to_input(points[1]).isApprox(factor * unscaled[1], 1e-15)) << factor;
  }
}

TEST(normalize_extent, refuses_equal_points)
{
  std::vector<Vector_3> points(4, Vector_3(1, 2, 3));
  EXPECT_TRUE(names(message_of([&] { normalize_extent(points); }), "all vertices are at the same point"));
}

TEST(normalize_extent, refuses_extents_that_cannot_be_computed_with)
{
  for (double extent : {std::numeric_limits<double>::denorm_min(), 1e-300, 1e300, std::numeric_limits<double>::max()}) {
    std::vector<Vector_3> points{{-extent, 0, 0}, {extent, 0, 0}};
    EXPECT_TRUE(names(message_of([&] { normalize_extent(points); }), "the extent of the surface is outside")) << extent;
  }
}

} // namespace
