// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Circles through known points.

#include "Tree/Section_fitting.h"
#include "support/sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>
#include <vector>

namespace {

using CSCD::internal::Circle_fit;
using CSCD::internal::fit_circle;

constexpr double pi = 3.14159265358979323846;

/// Points on an arc of the circle of radius 2 around (3, -1), off it by at most `noise`.
std::vector<Eigen::Vector2d> arc(int number, double angle, double noise)
{
  std::mt19937_64 random(1);
  std::vector<Eigen::Vector2d> result;
  for (int i = 0; i < number; ++i) {
    const double phi = angle * (i + 0.5) / number;
    const double radius = 2 + noise * CSCD::test::random_signed_unit(random);
    result.emplace_back(3 + radius * std::cos(phi), -1 + radius * std::sin(phi));
  }
  return result;
}

void expect_circle(const std::optional<Circle_fit>& circle, double tolerance)
{
  ASSERT_TRUE(circle.has_value());
  EXPECT_NEAR(3, circle->center.x(), tolerance);
  EXPECT_NEAR(-1, circle->center.y(), tolerance);
  EXPECT_NEAR(2, circle->radius, tolerance);
}

TEST(Circle_fit, is_exact_on_exact_points)
{
  for (const double angle : {2 * pi, pi, pi / 2}) {
    SCOPED_TRACE(angle);
    const std::optional<Circle_fit> circle = fit_circle(arc(20, angle, 0));
    expect_circle(circle, 1e-9);
    EXPECT_NEAR(0, circle->deviation, 1e-9);
    EXPECT_EQ(1, circle->inlier_part);
    EXPECT_NEAR(angle * 19 / 20, circle->coverage, 1e-9);
  }
}

TEST(Circle_fit, handles_noise_on_an_arc)
{
  expect_circle(fit_circle(arc(200, 2 * pi, 0.2)), 0.03);
  const std::optional<Circle_fit> third = fit_circle(arc(200, 2 * pi / 3, 0.1));
  expect_circle(third, 0.15);
  EXPECT_NEAR(0.1 / std::sqrt(3.), third->deviation, 0.01); // of a uniform distribution
}

/// As where a limb leaves a trunk.
TEST(Circle_fit, does_not_mind_points_of_other_things)
{
  std::vector<Eigen::Vector2d> points = arc(60, 1.5 * pi, 0.02);
  for (int i = 0; i < 15; ++i) {
    points.emplace_back(5 + 0.2 * i, -1 + 0.01 * i);
  }
  const std::optional<Circle_fit> circle = fit_circle(points);
  expect_circle(circle, 0.05);
  EXPECT_NEAR(0.8, circle->inlier_part, 0.05);
}

TEST(Circle_fit, finds_none_where_there_is_none)
{
  EXPECT_FALSE(fit_circle(std::vector<Eigen::Vector2d>(10, {1, 2})).has_value());
  std::vector<Eigen::Vector2d> line;
  for (int i = 0; i < 10; ++i) {
    line.emplace_back(i, 2 * i);
  }
  EXPECT_FALSE(fit_circle(line).has_value());
}

} // namespace
