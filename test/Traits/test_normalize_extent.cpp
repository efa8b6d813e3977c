// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points of any magnitude come into the unit box, and back.

#include "Traits/message_of.h"
#include <CSCD/Surface/Normalization.h>

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace {

using CSCD::normalize_extent;
using CSCD::Vector_3;
using CSCD::test::message_of;
using CSCD::test::names;

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
