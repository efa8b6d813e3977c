// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Separators are weighed by balance and roundness; bumps and tunnels are pruned.

#include "Separator/make_separator.h"
#include "archetypes/Solid_traits_archetype.h"
#include "support/shapes.h"
#include <CSCD/Selection/Balance_and_roundness.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <vector>

namespace {

using CSCD::Separator;
using CSCD::Vector_3;
using CSCD::test::section_separator;
using CSCD::test::Solid_traits_archetype;
using CSCD::test::tube_section;
using Judge = CSCD::internal::Balance_and_roundness<Solid_traits_archetype>;
using Verdict = Judge::Verdict;

class Balance_and_roundness_test : public testing::Test
{
protected:
  explicit Balance_and_roundness_test(const CSCD::test::Shape& shape = CSCD::test::tube(10, 1, 32,
                                                                                        CSCD::test::Tube_end::round))
      : m_traits(shape), m_judge(m_traits)
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
    CSCD::internal::crossing_points(m_traits.solid_surface(), separator.crossings, points);
    return CSCD::internal::span_inside_share(m_traits, points, separator.center);
  }

  Solid_traits_archetype m_traits;
  Judge m_judge;
};

TEST_F(Balance_and_roundness_test, is_nearly_1_on_a_tube)
{
  EXPECT_GT(weight(tube_section(m_traits.solid_surface(), 5)), 0.9);
  EXPECT_EQ(inside_share(tube_section(m_traits.solid_surface(), 5)), 1);
}

TEST_F(Balance_and_roundness_test, is_less_for_tilted_ones_and_at_the_ends)
{
  const double straight = weight(tube_section(m_traits.solid_surface(), 5));
  const double tilted = weight(tube_section(m_traits.solid_surface(), 5, {1, 1, 0}));
  const double more_tilted = weight(tube_section(m_traits.solid_surface(), 5, {1, 2, 0}));
  EXPECT_LT(tilted, 0.99 * straight);
  EXPECT_LT(more_tilted, 0.95 * tilted);
  EXPECT_LT(weight(tube_section(m_traits.solid_surface(), 10.2)), 0.9 * straight);
}

TEST_F(Balance_and_roundness_test, takes_circles_on_one_side_for_bumps)
{
  const Separator circle = section_separator(m_traits.solid_surface(), {5, 0, 0.8}, {0, 0, 1}, {5, 0.6, 0.8});
  EXPECT_EQ(verdict(circle), Verdict::bump) << "long as it is, it cuts off little";
  const auto vertex = CSCD::test::nearest_vertex(m_traits.solid_surface(), {5, 0, 1});
  EXPECT_EQ(verdict(CSCD::test::circle_separator(m_traits.solid_surface(), vertex, 0.9)), Verdict::bump);
}

class Balance_and_roundness_of_torus_test : public Balance_and_roundness_test
{
protected:
  Balance_and_roundness_of_torus_test() : Balance_and_roundness_test(CSCD::test::torus(3, 1, 48)) {}
};

TEST_F(Balance_and_roundness_of_torus_test, tells_handles_from_tunnels)
{
  const auto& surface = m_traits.solid_surface();
  const Separator around_the_tube = section_separator(surface, {3, 0, 0}, {0, 1, 0}, {4, 0, 0});
  EXPECT_GT(weight(around_the_tube), 0.9);
  const Separator around_the_hole = section_separator(surface, {0, 0, 0.05}, {0, 0, 1}, {2, 0, 0});
  EXPECT_EQ(verdict(around_the_hole), Verdict::tunnel);
  EXPECT_LT(inside_share(around_the_hole), 0.1);
  const Separator around_all = section_separator(surface, {0, 0, 0.05}, {0, 0, 1}, {4, 0, 0});
  EXPECT_EQ(verdict(around_all), Verdict::tunnel);
}

} // namespace
