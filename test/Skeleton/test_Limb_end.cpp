// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tips and bands of the end of a limb.

#include <CSCD/Skeleton/Limb_end.h>
#include <CSCD/Vector_3.h>

#include <boost/math/constants/constants.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace {

using CSCD::Vector_3;
using CSCD::internal::Limb_end;

/// A tube of radius 1 along the x axis, from 0 to 5, with a ring of vertices every quarter.
Limb_end tube()
{
  Limb_end result;
  for (int ring = 0; ring <= 20; ++ring) {
    for (int i = 0; i < 12; ++i) {
      const double angle = i * boost::math::double_constants::pi / 6;
      result.add(Vector_3(ring / 4., std::cos(angle), std::sin(angle)), 1, float(ring) / 4);
    }
  }
  return result;
}

TEST(Limb_end, has_its_tip_below_the_surface)
{
  const std::optional<Vector_3> tip = tube().tip(Vector_3(-1, 0, 0), 1);
  ASSERT_TRUE(tip);
  EXPECT_NEAR((*tip - Vector_3(4.25, 0, 0)).norm(), 0, 1e-9);
}

TEST(Limb_end, has_no_tip_if_it_is_low_or_hardly_extends)
{
  EXPECT_FALSE(tube().below(0.6).tip(Vector_3(0, 0, 0), 1));
  EXPECT_FALSE(tube().tip_towards(Vector_3(4, 0, 0), Vector_3(1, 0, 0), 1));
  EXPECT_FALSE(Limb_end().tip(Vector_3(0, 0, 0), 1));
}

TEST(Limb_end, has_bands_around_the_middle)
{
  EXPECT_FLOAT_EQ(tube().beyond(2).height(), 3);
  const std::optional<Limb_end::Ball> ball = tube().beyond(2).below(0.6).ball();
  ASSERT_TRUE(ball);
  EXPECT_NEAR((ball->center - Vector_3(2.25, 0, 0)).norm(), 0, 1e-9);
  EXPECT_GE(ball->radius, 1);
  EXPECT_LT(ball->radius, 1.1);
  EXPECT_FALSE(Limb_end().ball());
}

} // namespace
