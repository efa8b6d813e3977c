// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sides of separators, their balance and roundness.

#include "Separator/make_separator.h"
#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Published/Region_packing.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace {

using CSCD::Separator;
using CSCD::Surface_level;
using CSCD::Vector_3;
using CSCD::internal::Separator_sides;
using CSCD::test::section_separator;
using CSCD::test::tube_section;

/// A shape and its body, in the numbers and coordinates of the shape.
class Body
{
public:
  explicit Body(const CSCD::test::Shape& shape) : m_surface(CSCD::test::to_surface(shape)), m_queries(m_surface) {}
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  const CSCD::Triangulated_surface& triangulation() const { return m_surface; }
  bool is_inside(const Vector_3& point) const { return m_queries.is_inside(point); }

private:
  CSCD::Triangulated_surface m_surface;
  CSCD::internal::Solid_queries m_queries;
};

using Judge = CSCD::internal::Balance_and_roundness<Body>;
using Verdict = Judge::Verdict;

class Balance_and_roundness_test : public testing::Test
{
protected:
  explicit Balance_and_roundness_test(const CSCD::test::Shape& shape = CSCD::test::tube(10, 1, 32,
                                                                                        CSCD::test::Tube_end::round))
      : m_body(shape), m_judge(m_body)
  {
  }

  double weight(const Separator& separator)
  {
    double result = -1;
    EXPECT_EQ(m_judge(separator, result), Verdict::good);
    return result;
  }

  Verdict verdict(const Separator& separator)
  {
    double result = -1;
    const Verdict answer = m_judge(separator, result);
    EXPECT_EQ(result > 0, answer == Verdict::good);
    return answer;
  }

  double inside_share(const Separator& separator) const
  {
    std::vector<Vector_3> points;
    CSCD::internal::crossing_points(m_body.triangulation(), separator.crossings, points);
    return CSCD::internal::span_inside_share(m_body, points, separator.center);
  }

  Body m_body;
  Judge m_judge;
};

TEST_F(Balance_and_roundness_test, is_nearly_1_on_a_tube)
{
  EXPECT_GT(weight(tube_section(m_body.triangulation(), 5)), 0.9);
  EXPECT_EQ(inside_share(tube_section(m_body.triangulation(), 5)), 1);
}

TEST_F(Balance_and_roundness_test, is_less_for_tilted_ones_and_at_the_ends)
{
  const double straight = weight(tube_section(m_body.triangulation(), 5));
  const double tilted = weight(tube_section(m_body.triangulation(), 5, {1, 1, 0}));
  const double more_tilted = weight(tube_section(m_body.triangulation(), 5, {1, 2, 0}));
  EXPECT_LT(tilted, 0.99 * straight);
  EXPECT_LT(more_tilted, 0.95 * tilted);
  EXPECT_LT(weight(tube_section(m_body.triangulation(), 10.2)), 0.9 * straight);
}

TEST_F(Balance_and_roundness_test, takes_circles_on_one_side_for_bumps)
{
  const Separator circle = section_separator(m_body.triangulation(), {5, 0, 0.8}, {0, 0, 1}, {5, 0.6, 0.8});
  EXPECT_EQ(verdict(circle), Verdict::bump) << "long as it is, it cuts off little";
  const auto vertex = CSCD::test::nearest_vertex(m_body.triangulation(), {5, 0, 1});
  EXPECT_EQ(verdict(CSCD::test::circle_separator(m_body.triangulation(), vertex, 0.9)), Verdict::bump);
}

class Balance_and_roundness_of_torus_test : public Balance_and_roundness_test
{
protected:
  Balance_and_roundness_of_torus_test() : Balance_and_roundness_test(CSCD::test::torus(3, 1, 48)) {}
};

TEST_F(Balance_and_roundness_of_torus_test, tells_handles_from_tunnels)
{
  const auto& surface = m_body.triangulation();
  const Separator around_the_tube = section_separator(surface, {3, 0, 0}, {0, 1, 0}, {4, 0, 0});
  EXPECT_GT(weight(around_the_tube), 0.9);
  const Separator around_the_hole = section_separator(surface, {0, 0, 0.05}, {0, 0, 1}, {2, 0, 0});
  EXPECT_EQ(verdict(around_the_hole), Verdict::tunnel);
  EXPECT_LT(inside_share(around_the_hole), 0.1);
  const Separator around_all = section_separator(surface, {0, 0, 0.05}, {0, 0, 1}, {4, 0, 0});
  EXPECT_EQ(verdict(around_all), Verdict::tunnel);
}

TEST(is_around_hollow, tells_the_wall_of_a_cup_from_its_handle)
{
  const Body cup(CSCD::test::cup(0.1));
  const auto& surface = cup.triangulation();
  const auto is_around_hollow = [&](const Vector_3& point, const Vector_3& axis, const Vector_3& near) {
    return CSCD::internal::is_around_hollow(cup, section_separator(surface, point, axis, near));
  };
  EXPECT_TRUE(is_around_hollow({0, 0, 0.35}, {0, 0, 1}, {-1, 0, 0.35})) << "outside, below the handle";
  EXPECT_TRUE(is_around_hollow({0, 0, 1.8}, {0, 0, 1}, {-0.8, 0, 1.8})) << "inside";
  EXPECT_FALSE(is_around_hollow({1.5, 0, 1}, {0, 0, 1}, {1.6, 0, 1})) << "the handle";
  EXPECT_FALSE(is_around_hollow({0, 0, 0.12}, {0, 0, 1}, {-1, 0, 0.12})) << "the bottom";
  EXPECT_FALSE(is_around_hollow({-0.1, 0, 1}, {1, 0, 0}, {-0.1, 1, 1})) << "across the wall: like a bent sheet";
}

TEST(is_around_hollow, takes_an_oval_cup_for_a_cup)
{
  CSCD::test::Shape oval = CSCD::test::cup(0.1);
  for (CSCD::test::Triple& point : oval.points) {
    point[1] *= 2.2; // a roundness of 0.8
  }
  const Body cup(oval);
  const Separator wall = section_separator(cup.triangulation(), {0, 0, 0.35}, {0, 0, 1}, {-1, 0, 0.35});
  EXPECT_NEAR(wall.roundness(), 0.8, 0.03);
  EXPECT_TRUE(CSCD::internal::is_around_hollow(cup, wall));
}

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
