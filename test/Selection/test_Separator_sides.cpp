// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface on either side of a separator.

#include "Separator/make_separator.h"
#include "Traits/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Selection/Balance_and_roundness.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <limits>

namespace {

using CSCD::Separator;
using CSCD::internal::Separator_sides;
using CSCD::Surface_level;
using CSCD::test::tube_section;

constexpr double unlimited = std::numeric_limits<double>::max();

Surface_level tube_level()
{
  return Surface_level(CSCD::test::to_surface(CSCD::test::tube(10, 1, 48, CSCD::test::Tube_end::flat)));
}

TEST(Separator_sides, are_together_the_whole_surface)
{
  const Surface_level level = tube_level();
  Separator_sides sides(level.surface);
  for (double x : {0.5, 3., 7.}) {
    const Separator separator = tube_section(level.surface, x);
    const double left = sides.measure(separator, true, 0, unlimited).area;
    const double right = sides.measure(separator, false, 0, unlimited).area;
    EXPECT_NEAR(left + right, level.surface.total_area(), 1e-5 * level.surface.total_area());
    // The left side lies on the positive side of the normal.
    const double length_on_the_left = separator.normal.x() > 0 ? 10 - x : x;
    const double pi = CSCD::test::pi;
    EXPECT_NEAR(left, pi + 2 * pi * length_on_the_left, 0.05 * level.surface.total_area());
  }
}

TEST(Separator_sides, have_bands_as_wide_as_asked)
{
  const Surface_level level = tube_level();
  Separator_sides sides(level.surface);
  const Separator separator = tube_section(level.surface, 5);
  for (double width : {0.5, 1., 2.}) {
    for (bool is_left : {false, true}) {
      const auto side = sides.measure(separator, is_left, width, 0);
      EXPECT_NEAR(side.band_area, separator.length * width, 0.15 * separator.length) << width;
    }
  }
}

TEST(Separator_sides, have_one_band_smaller_near_an_end)
{
  const Surface_level level = tube_level();
  Separator_sides sides(level.surface);
  const Separator separator = tube_section(level.surface, 9.8);
  const double left = sides.measure(separator, true, 3, 0).band_area;
  const double right = sides.measure(separator, false, 3, 0).band_area;
  const double disc = CSCD::test::pi * (1 + 2 * 0.2);
  EXPECT_NEAR(separator.normal.x() > 0 ? left : right, disc, 0.1 * disc);
  EXPECT_NEAR(separator.normal.x() > 0 ? right : left, 3 * separator.length, 0.15 * separator.length);
}

TEST(Separator_sides, need_not_be_counted_beyond_a_limit)
{
  const Surface_level level = tube_level();
  Separator_sides sides(level.surface);
  const Separator separator = tube_section(level.surface, 5);
  const double limit = separator.length;
  const double area = sides.measure(separator, true, 0.1, limit).area;
  EXPECT_GT(area, limit);
  EXPECT_LT(area, 2 * limit);
}

TEST(Separator_sides, of_a_circle_around_a_vertex_are_the_vertex_and_the_rest)
{
  const Surface_level level = tube_level();
  Separator_sides sides(level.surface);
  const auto vertex = CSCD::test::nearest_vertex(level.surface, {5, 0, 1});
  const Separator separator = CSCD::test::circle_separator(level.surface, vertex, 0.5);
  EXPECT_EQ(sides.measure(separator, false, 0, unlimited).area, double(level.surface.vertex_area(vertex)));
  EXPECT_NEAR(sides.measure(separator, true, 0, unlimited).area,
              level.surface.total_area() - double(level.surface.vertex_area(vertex)),
              1e-5 * level.surface.total_area());
}

} // namespace
