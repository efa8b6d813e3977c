// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers that stand behind the detail.

#include <CSCD/Separator/limb_tests.h>
#include <CSCD/exceptions.h>

#include <boost/math/constants/constants.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using boost::math::double_constants::two_pi;
using CSCD::Detail;

TEST(Detail, takes_numbers_from_0_to_1_only)
{
  EXPECT_NO_THROW(Detail(0));
  EXPECT_NO_THROW(Detail(1));
  EXPECT_EQ(Detail().value(), Detail::default_value);
  for (double value : {-1e-9, 1 + 1e-9, std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_THROW(Detail{value}, CSCD::Input_error) << value;
  }
}

TEST(Detail, asks_for_shorter_limbs_the_higher_it_is)
{
  EXPECT_TRUE(std::isinf(Detail(0).min_limb_length()));
  EXPECT_EQ(Detail(1).min_limb_length(), 0);
  for (double value = 0.1; value < 0.9; value += 0.1) {
    EXPECT_GT(Detail(value).min_limb_length(), Detail(value + 0.09).min_limb_length());
    EXPECT_GT(Detail(value).min_branch_area_ratio(), Detail(value + 0.09).min_branch_area_ratio());
  }
}

TEST(Detail, area_ratio_is_that_of_a_cylinder_with_a_flat_end)
{
  const double radius = 0.7;
  const Detail detail(0.2);
  const double length = detail.min_limb_length() * radius;
  const double area = two_pi * radius * length + two_pi / 2 * radius * radius;
  EXPECT_NEAR(detail.min_branch_area_ratio(), area / std::pow(two_pi * radius, 2), 1e-12);
  EXPECT_NEAR(Detail(1).min_branch_area_ratio(), 1 / (2 * two_pi), 1e-12) << "a flat disc";
}

TEST(Detail, loops_are_judged_less_strictly_than_branches)
{
  for (double value : {0., 0.1, 0.5, 1.}) {
    EXPECT_LT(Detail(value).min_loop_area_ratio(), Detail(value).min_branch_area_ratio());
    EXPECT_LE(Detail(value).min_loop_area_ratio(), Detail::max_loop_area_ratio);
  }
}

} // namespace
