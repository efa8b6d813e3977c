// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The normalized surface has unit area around the origin; hole-filling faces do not count.

#include "Traits/message_of.h"
#include "Traits/to_indexed_triangles.h"
#include "support/shapes.h"
#include <CSCD/Surface/Normalization.h>

#include <gtest/gtest.h>

namespace {

using CSCD::Indexed_triangles;
using CSCD::normalize_area;
using CSCD::Vector_3;

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

} // namespace
