// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Length, center, normal and planarity of polygons with known values.

#include "Separator/make_separator.h"
#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Separator/Separator.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using CSCD::Vector_3;
using CSCD::internal::measure_polygon;
using CSCD::internal::Polygon_measures;
using CSCD::test::pi;

TEST(curve_measures, of_a_square)
{
  const Polygon_measures measures = measure_polygon({{1, 1, 5}, {3, 1, 5}, {3, 3, 5}, {1, 3, 5}});
  EXPECT_NEAR(measures.length, 8, 1e-12);
  EXPECT_LT((measures.center - Vector_3(2, 2, 5)).norm(), 1e-12);
  EXPECT_LT((measures.vector_area - Vector_3(0, 0, 4)).norm(), 1e-12) << "counterclockwise seen from above";
  EXPECT_NEAR(measures.planarity, 0, 1e-12);
}

TEST(curve_measures, do_not_depend_on_how_finely_a_curve_is_sampled)
{
  const Polygon_measures coarse = measure_polygon({{0, 0, 0}, {4, 0, 1}, {0, 3, 0}});
  const Polygon_measures fine =
      measure_polygon({{0, 0, 0}, {1, 0, 0.25}, {2, 0, 0.5}, {4, 0, 1}, {0, 3, 0}, {0, 1, 0}});
  EXPECT_NEAR(coarse.length, fine.length, 1e-12);
  EXPECT_LT((coarse.center - fine.center).norm(), 1e-12);
  EXPECT_LT((coarse.vector_area - fine.vector_area).norm(), 1e-12);
}

TEST(curve_measures, planarity_is_relative_to_the_length)
{
  // A square whose corners are by turns a height above and below its plane.
  for (const double scale : {1., 1000.}) {
    const double height = 0.1 * scale;
    const Polygon_measures measures =
        measure_polygon({{scale, 0, height}, {0, scale, -height}, {-scale, 0, height}, {0, -scale, -height}});
    EXPECT_LT(measures.center.norm(), 1e-12 * scale);
    EXPECT_NEAR(measures.planarity, height / measures.length, 1e-12);
  }
}

TEST(curve_measures, of_degenerate_polygons_are_finite)
{
  EXPECT_EQ(measure_polygon({}).length, 0);
  const Vector_3 point(1, 2, 3);
  EXPECT_EQ(measure_polygon({point, point, point}).center, point);
  CSCD::Separator separator;
  CSCD::internal::set_measures(separator, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  EXPECT_EQ(separator.area, 0);
  EXPECT_NEAR(separator.normal.norm(), 1, 1e-12) << "any unit vector";
  EXPECT_TRUE(std::isfinite(separator.planarity));
}

TEST(curve_measures, crossing_points_lie_on_their_edges)
{
  const auto surface = CSCD::test::to_surface(CSCD::test::cube());
  const Vector_3 from = surface.point(surface.origin(0));
  const Vector_3 to = surface.point(surface.target(0));
  const Vector_3 point = CSCD::internal::crossing_point(surface, {0, 0.25});
  EXPECT_LT((point - (0.75 * from + 0.25 * to)).norm(), 1e-15);
  EXPECT_LT((point - CSCD::internal::crossing_point(surface, {surface.twin(0), 0.75})).norm(), 1e-15);
  std::vector<Vector_3> points(7);
  CSCD::internal::crossing_points(surface, {{0, 0.25}}, points);
  EXPECT_EQ(points, std::vector<Vector_3>{point});
}

TEST(curve_measures, normal_of_a_separator_points_to_its_left)
{
  const auto surface = CSCD::test::to_surface(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat));
  const CSCD::Separator separator = CSCD::test::section_separator(surface, {5.03, 0, 0}, {1, 0, 0}, {5.03, 0, 1});
  for (const CSCD::Edge_crossing& crossing : separator.crossings) {
    const Vector_3 to_left =
        surface.point(surface.target(crossing.halfedge)) - surface.point(surface.origin(crossing.halfedge));
    EXPECT_GT(separator.normal.dot(to_left), 0);
  }
  EXPECT_NEAR(separator.radius(), 1, 0.01);
  EXPECT_NEAR(separator.area, pi, 0.05);
}

} // namespace
