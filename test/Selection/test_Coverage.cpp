// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the result of a search covers.

#include "archetypes/Multiresolution_traits_archetype.h"
#include "support/shapes.h"
#include <CSCD/Selection/Coverage.h>
#include <CSCD/Separator/Local_separator_finder.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

namespace {

using CSCD::Search_outcome;
using CSCD::Search_result;
using CSCD::internal::Coverage;
using CSCD::Index;
using Levels_traits = CSCD::test::Multiresolution_traits_archetype;
using Finder = CSCD::Local_separator_finder<Levels_traits>;

TEST(Coverage, grows_around_separators_and_not_elsewhere)
{
  const Levels_traits traits(CSCD::test::tube(20, 1, 24, CSCD::test::Tube_end::flat));
  const auto& surface = traits.levels().finest().surface;
  Coverage coverage(traits.levels());
  Finder find(traits);
  Search_result result;
  const Index source = CSCD::test::nearest_vertex(surface, {10, 0, 1});
  EXPECT_FALSE(coverage.is_covered(source));
  EXPECT_EQ(coverage.level_hint(source), 0u) << "there is one level only";
  for (int i = 0; i < 4; ++i) {
    find(source, 0, result);
    ASSERT_EQ(result.outcome, Search_outcome::found);
    coverage.add(source, result);
  }
  EXPECT_TRUE(coverage.is_covered(source));
  EXPECT_TRUE(coverage.is_covered(CSCD::test::nearest_vertex(surface, {10, 0, -1}))) << "all around the limb";
  EXPECT_FALSE(coverage.is_covered(CSCD::test::nearest_vertex(surface, {12, 0, 1})));
  EXPECT_FALSE(coverage.is_covered(CSCD::test::nearest_vertex(surface, {8, 0, 1})));
}

TEST(Coverage, covers_every_source_that_was_tried_in_vain)
{
  const Levels_traits traits(CSCD::test::sphere(4));
  for (const Search_outcome outcome : {Search_outcome::no_cut, Search_outcome::bump, Search_outcome::degenerate}) {
    Coverage coverage(traits.levels());
    Search_result result;
    result.outcome = outcome;
    result.loop_length = 1;
    coverage.add(42, result);
    EXPECT_TRUE(coverage.is_covered(42));
    EXPECT_FALSE(coverage.is_covered(2000));
  }
}

} // namespace
