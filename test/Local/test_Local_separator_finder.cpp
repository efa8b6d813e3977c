// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The finder of local separators on bodies whose limbs are known.

#include "Separator/is_closed_curve.h"
#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Local/Local_separator_finder.h>
#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <cstddef>

namespace {

using CSCD::Index;
using CSCD::Search_outcome;
using CSCD::Search_result;
using CSCD::Surface_levels;
using Finder = CSCD::Local_separator_finder;

TEST(Local_separator_finder, finds_simple_curves_around_limbs)
{
  const CSCD::test::Shape shape = CSCD::test::y_tube(0.12);
  const Surface_levels levels = CSCD::test::to_levels(shape);
  const auto& surface = levels.finest().surface;
  Finder find(levels);
  CSCD::internal::Separator_arrangement arrangement(surface);
  Search_result result;
  std::size_t found = 0;
  std::size_t on_limbs = 0;
  for (Index source = 0; source < surface.number_of_vertices(); source += 11) {
    find(source, 0, result);
    const double from_center = surface.point(source).norm();
    const bool is_on_limb = from_center > 1 && from_center < 2.8;
    on_limbs += is_on_limb ? 1u : 0u;
    if (result.outcome != Search_outcome::found) {
      continue;
    }
    ASSERT_GE(result.separator.crossings.size(), 3u);
    ASSERT_TRUE(CSCD::test::is_closed_curve(surface, result.separator.crossings));
    arrangement.clear();
    EXPECT_TRUE(arrangement.insert(0, result.separator.crossings)) << "it crosses itself, from source " << source;
    if (is_on_limb) {
      ++found;
      EXPECT_NEAR(result.separator.radius(), 0.4, 0.05);
      EXPECT_LT((result.separator.center - surface.point(source)).norm(), 0.6) << "it stays near its source";
    }
  }
  EXPECT_GT(on_limbs, 50u);
  EXPECT_GT(found, on_limbs * 19 / 20);
}

TEST(Local_separator_finder, finds_separators_on_any_level)
{
  const Surface_levels levels = CSCD::test::to_levels(CSCD::test::noisy(CSCD::test::torus(3, 1, 64), 0.1, 1));
  ASSERT_GE(levels.size(), 2u);
  Finder find(levels);
  Search_result result;
  for (Index hint = 0; hint < levels.size() + 3; ++hint) {
    for (Index source = 5; source < 7000; source += 499) {
      find(source, hint, result);
      ASSERT_EQ(result.outcome, Search_outcome::found) << "source " << source << ", level " << hint;
      EXPECT_TRUE(CSCD::test::is_closed_curve(levels.finest().surface, result.separator.crossings));
      EXPECT_NEAR(result.separator.radius(), 1, 0.1);
      EXPECT_LT(result.level, levels.size());
    }
  }
}

TEST(Local_separator_finder, gives_the_same_when_it_is_used_again)
{
  const Surface_levels levels = CSCD::test::to_levels(CSCD::test::hand(0.12));
  Finder used(levels);
  Search_result first;
  Search_result second;
  for (Index source = 0; source < levels.finest().surface.number_of_vertices(); source += 101) {
    Finder fresh(levels);
    used(source, 0, first);
    fresh(source, 0, second);
    ASSERT_EQ(first.outcome, second.outcome);
    ASSERT_EQ(first.level, second.level);
    ASSERT_EQ(first.loop_length, second.loop_length);
    ASSERT_EQ(first.is_section, second.is_section);
    ASSERT_EQ(first.separator.crossings.size(), second.separator.crossings.size());
    if (first.outcome == Search_outcome::found) {
      ASSERT_EQ(first.separator.length, second.separator.length);
    }
  }
}

TEST(Local_separator_finder, finds_nothing_to_separate_on_a_sphere_but_great_circles)
{
  const Surface_levels levels = CSCD::test::to_levels(CSCD::test::sphere(4));
  Finder find(levels);
  Search_result result;
  for (Index source = 0; source < 2562; source += 50) {
    find(source, 0, result);
    if (result.outcome == Search_outcome::found) {
      EXPECT_GT(result.separator.radius(), 0.9);
    }
  }
}

} // namespace
