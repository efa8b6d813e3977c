// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sheets, cavities and limbs of one surface, each component by itself.

#include "Surface/to_indexed_triangles.h"
#include "support/shapes.h"
#include <CSCD/Surface/Triangulated_solid.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace {

using CSCD::Border_treatment;
using CSCD::Halfedge_pairing;
using CSCD::Index;
using CSCD::Indexed_triangles;
using CSCD::Vector_3;
using CSCD::internal::Compiled_surface;
using CSCD::test::Shape;

Compiled_surface compiled(const std::vector<Shape>& parts, Border_treatment treatment)
{
  Indexed_triangles triangles = CSCD::test::to_indexed_triangles(CSCD::test::merged("parts", parts));
  Halfedge_pairing pairing(triangles.faces, triangles.points.size());
  return CSCD::internal::compile_surface(std::move(triangles), std::move(pairing), treatment, 1);
}

/// A flat strip of squares from the origin along the x axis, with all vertices on its border.
Shape ribbon(std::size_t number_of_squares)
{
  Shape shape;
  for (std::size_t i = 0; i <= number_of_squares; ++i) {
    shape.points.push_back({double(i), 0, 0});
    shape.points.push_back({double(i), 1, 0});
    if (i > 0) {
      shape.triangles.push_back({2 * i - 2, 2 * i, 2 * i - 1});
      shape.triangles.push_back({2 * i, 2 * i + 1, 2 * i - 1});
    }
  }
  return shape;
}

/// A ball with a hole of one triangle.
Shape pierced_ball()
{
  Shape shape = CSCD::test::sphere(3);
  shape.triangles.pop_back();
  return shape;
}

TEST(compile_surface, gives_a_ribbon_two_sides)
{
  const Compiled_surface result = compiled({ribbon(20)}, Border_treatment::open);
  EXPECT_EQ(result.number_of_sheets, 1u);
  const CSCD::Triangulated_surface& surface = result.surface;
  std::vector<double> height{0, 0, 0};
  for (Index v = 0; v < surface.number_of_vertices(); ++v) {
    const Index input = result.input_point[v];
    if (input != CSCD::no_index) {
      height[std::size_t(result.side_of_sheet[v])] = surface.point(v).z();
    } else if (result.side_of_sheet[v] == 2) {
      height[2] = surface.point(v).z();
    }
  }
  // The width is 2 x 20 / 42; half of the thickness 0.015 of it, in the unit of a square root of the area of both
  // sides.
  const double width = 40. / 42;
  EXPECT_NEAR((height[1] - height[2]) * result.normalization.unit, 2 * 0.015 * width, 1e-3 * width);
}

TEST(compile_surface, fills_cavities_beside_sheets)
{
  const std::vector<Shape> body{CSCD::test::scaled(CSCD::test::sphere(3), 10),
                                CSCD::test::reversed(CSCD::test::sphere(2))};
  const Shape sheet = CSCD::test::translated(ribbon(20), {30, 0, 0});
  for (const bool is_sheet_first : {false, true}) {
    const Compiled_surface result = is_sheet_first ? compiled({sheet, body[1], body[0]}, Border_treatment::open)
                                                   : compiled({body[0], body[1], sheet}, Border_treatment::open);
    EXPECT_EQ(result.number_of_sheets, 1u);
    EXPECT_EQ(result.cavities.number, 1u);
    EXPECT_EQ(result.cavities.vertices.size(), body[1].points.size());
    EXPECT_EQ(result.number_of_reversed_components, 0u);
    ASSERT_EQ(result.component_begin.size(), 3u);
    ASSERT_EQ(result.side_of_sheet.size(), result.surface.number_of_vertices());
    // Sides belong to the vertices of the sheet alone.
    for (Index v = 0; v < result.surface.number_of_vertices(); ++v) {
      const Vector_3 point = result.normalization.to_input(result.surface.point(v));
      EXPECT_EQ(result.side_of_sheet[v] != 0, point.x() > 20);
    }
  }
}

TEST(compile_surface, samples_limbs_beside_holes_and_sheets)
{
  const Shape comb = CSCD::test::comb(30, true);
  const std::size_t alone = compiled({comb}, Border_treatment::bridge).number_of_inserted_vertices;
  EXPECT_GE(alone, 24 * 30u);
  const Shape ball = CSCD::test::translated(pierced_ball(), {0, 0, 1000});
  const Compiled_surface pierced = compiled({comb, ball}, Border_treatment::bridge);
  EXPECT_EQ(pierced.number_of_bridged_borders, 1u);
  EXPECT_TRUE(pierced.has_sampled_limbs);
  EXPECT_GE(pierced.number_of_inserted_vertices, 24 * 30u);
  const Compiled_surface beside_sheet =
      compiled({CSCD::test::translated(ribbon(20), {0, 0, 1000}), comb}, Border_treatment::open);
  EXPECT_EQ(beside_sheet.number_of_sheets, 1u);
  EXPECT_TRUE(beside_sheet.has_sampled_limbs);
}

} // namespace
