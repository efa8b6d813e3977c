// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Centers and areas of sections, and whether a point lies in an outline.

#include <CSCD/Separator/Plane_section.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace {

using CSCD::Vector_3;
using CSCD::internal::is_in_outline;
using CSCD::internal::section_disc;
using CSCD::internal::Section_disc;
using Outline = std::vector<Vector_3>;

const Outline l_shape{{0, 0, 1}, {3, 0, 1}, {3, 1, 1}, {1, 1, 1}, {1, 3, 1}, {0, 3, 1}};

TEST(Section_disc, of_a_rectangle_whose_corners_are_sampled_unevenly)
{
  const Section_disc disc = section_disc({{0, 0, 5}, {0.1, 0, 5}, {0.2, 0, 5}, {4, 0, 5}, {4, 2, 5}, {0, 2, 5}});
  EXPECT_LT((disc.center - Vector_3(2, 1, 5)).norm(), 1e-12);
  EXPECT_NEAR(disc.area, 8, 1e-12);
  EXPECT_NEAR(disc.radius(), std::sqrt(8 / 3.14159265358979), 1e-12);
}

TEST(Section_disc, is_the_centroid_of_the_area)
{
  // Two rectangles, 3 x 2 and 1 x 1.
  const Section_disc disc = section_disc({{0, 0, 1}, {3, 0, 1}, {3, 2, 1}, {1, 2, 1}, {1, 3, 1}, {0, 3, 1}});
  EXPECT_NEAR(disc.area, 7, 1e-12);
  EXPECT_LT((disc.center - Vector_3((6 * 1.5 + 0.5) / 7, (6 * 1 + 2.5) / 7, 1)).norm(), 1e-12);
}

TEST(Section_disc, does_not_depend_on_orientation)
{
  Outline reversed = l_shape;
  std::reverse(reversed.begin(), reversed.end());
  EXPECT_LT((section_disc(reversed).center - section_disc(l_shape).center).norm(), 1e-12);
  EXPECT_NEAR(section_disc(reversed).area, 5, 1e-12);
}

TEST(Section_disc, falls_back_to_the_outline_where_the_centroid_is_outside)
{
  // A thin U: its centroid lies between the arms.
  const Outline u{{0, 0, 0}, {4, 0, 0}, {4, 9, 0}, {3.9, 9, 0}, {3.9, 0.1, 0}, {0.1, 0.1, 0}, {0.1, 9, 0}, {0, 9, 0}};
  const Section_disc disc = section_disc(u);
  EXPECT_NEAR(disc.area, 0.4 + 2 * 0.89, 1e-9);
  EXPECT_LT((disc.center - CSCD::internal::measure_polygon(u).center).norm(), 1e-12);
}

TEST(Section_disc, of_what_has_no_area_is_finite)
{
  const Section_disc disc = section_disc({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  EXPECT_EQ(disc.area, 0);
  EXPECT_LT((disc.center - Vector_3(1, 0, 0)).norm(), 1e-12);
}

TEST(is_in_outline, knows_an_l)
{
  const Vector_3 normal(0, 0, 1);
  EXPECT_TRUE(is_in_outline(l_shape, {0.5, 2.5, 1}, normal));
  EXPECT_TRUE(is_in_outline(l_shape, {2.5, 0.5, 7}, normal)) << "the point is projected";
  EXPECT_FALSE(is_in_outline(l_shape, {2, 2, 1}, normal));
  EXPECT_FALSE(is_in_outline(l_shape, {-1, 0.5, 1}, normal));
  EXPECT_TRUE(is_in_outline(l_shape, {0.5, 2.5, 1}, -normal));
}

TEST(is_in_outline, agrees_with_the_sum_of_angles)
{
  std::mt19937 random(1);
  const auto number = [&] { return 2 * double(random()) / double(std::mt19937::max()) - 1; };
  for (int round = 0; round < 2000; ++round) {
    // A star-shaped polygon in a tilted plane.
    const Vector_3 u = Vector_3(number(), number(), number()).normalized();
    const Vector_3 v = u.unitOrthogonal();
    Outline outline;
    for (int k = 0; k < 9; ++k) {
      const double angle = 2 * 3.14159265358979 * k / 9;
      outline.emplace_back((1.2 + number()) * (std::cos(angle) * u + std::sin(angle) * v));
    }
    const Vector_3 normal = u.cross(v);
    const Vector_3 point = 1.5 * (number() * u + number() * v);
    double turn = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vector_3 a = outline[i] - point;
      const Vector_3 b = outline[(i + 1) % outline.size()] - point;
      turn += std::atan2(a.cross(b).dot(normal), a.dot(b));
    }
    ASSERT_EQ(is_in_outline(outline, point, normal), turn > 3) << "turn " << turn;
  }
}

} // namespace
