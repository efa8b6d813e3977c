// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which vertices separators cover, and the order of sources.

#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Local/Covering_search.h>
#include <CSCD/Local/Local_separator_finder.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Search_outcome;
using CSCD::Search_result;
using CSCD::Surface_levels;
using CSCD::internal::Coverage;
using CSCD::internal::Source_sequence;
using CSCD::test::to_levels;

/// Takes note of `result` and its band, as the search does.
void add_with_band(const Surface_levels& levels, Coverage& coverage, Index source, const Search_result& result)
{
  std::vector<Index> band;
  CSCD::internal::Coverage_band grow(levels);
  grow(source, result, CSCD::internal::Coverage_band::max_failure_radius(levels), band);
  coverage.add(source, result, band);
}

TEST(Coverage, grows_around_separators_and_not_elsewhere)
{
  const Surface_levels levels = to_levels(CSCD::test::tube(20, 1, 24, CSCD::test::Tube_end::flat));
  const auto& surface = levels.finest().surface;
  Coverage coverage(levels);
  CSCD::Local_separator_finder find(levels);
  Search_result result;
  const Index source = CSCD::test::nearest_vertex(surface, {10, 0, 1});
  EXPECT_FALSE(coverage.is_covered(source));
  for (int i = 0; i < 4; ++i) {
    find(source, 0, result);
    ASSERT_EQ(result.outcome, Search_outcome::found);
    add_with_band(levels, coverage, source, result);
  }
  EXPECT_TRUE(coverage.is_covered(source));
  EXPECT_TRUE(coverage.is_covered(CSCD::test::nearest_vertex(surface, {10, 0, -1}))) << "all around the limb";
  EXPECT_FALSE(coverage.is_covered(CSCD::test::nearest_vertex(surface, {12, 0, 1})));
  EXPECT_FALSE(coverage.is_covered(CSCD::test::nearest_vertex(surface, {8, 0, 1})));
}

TEST(Coverage, starts_on_a_small_surface_itself_and_on_the_next_level_of_a_large_one)
{
  const Surface_levels small = to_levels(CSCD::test::sphere(4));
  ASSERT_GE(small.size(), 2u);
  EXPECT_EQ(Coverage(small).level_hint(42), 0u);
  const Surface_levels large = to_levels(CSCD::test::torus(3, 1, 64));
  ASSERT_GE(large.size(), 3u);
  EXPECT_EQ(Coverage(large).level_hint(42), 1u);
}

TEST(Coverage, covers_every_source_that_was_tried_in_vain)
{
  const Surface_levels levels = to_levels(CSCD::test::sphere(4));
  for (const Search_outcome outcome : {Search_outcome::no_cut, Search_outcome::bump, Search_outcome::degenerate}) {
    Coverage coverage(levels);
    Search_result result;
    result.outcome = outcome;
    result.loop_length = 1;
    add_with_band(levels, coverage, 42, result);
    EXPECT_TRUE(coverage.is_covered(42));
    EXPECT_FALSE(coverage.is_covered(2000));
  }
}

TEST(Source_sequence, tries_every_vertex_once_unless_it_is_covered)
{
  const Surface_levels levels = to_levels(CSCD::test::sphere(3));
  const Coverage nothing(levels);
  Source_sequence sources(levels, 3);
  std::vector<Index> batch;
  std::set<Index> seen;
  double progress = 0;
  for (sources.next_batch(nothing, 16, batch); !batch.empty(); sources.next_batch(nothing, 16, batch)) {
    EXPECT_LE(batch.size(), 16u);
    for (const Index source : batch) {
      EXPECT_TRUE(seen.insert(source).second);
    }
    EXPECT_GE(sources.progress(), progress);
    progress = sources.progress();
  }
  EXPECT_EQ(progress, 1);
  EXPECT_EQ(seen.size(), levels.finest().surface.number_of_vertices());
  sources.next_batch(nothing, 16, batch);
  EXPECT_TRUE(batch.empty());
}

TEST(Source_sequence, depends_on_the_seed_alone_and_is_scattered)
{
  const Surface_levels levels = to_levels(CSCD::test::sphere(4));
  const Coverage nothing(levels);
  const auto first_sources = [&](unsigned seed) {
    Source_sequence sources(levels, seed);
    std::vector<Index> batch;
    sources.next_batch(nothing, 64, batch);
    return batch;
  };
  EXPECT_EQ(first_sources(0), first_sources(0));
  EXPECT_NE(first_sources(0), first_sources(1));
  // Sources that are tried one after the other should lie far apart.
  const auto& surface = levels.finest().surface;
  double mean = 0;
  const std::vector<Index> sources = first_sources(5);
  for (std::size_t i = 1; i < sources.size(); ++i) {
    mean += (surface.point(sources[i]) - surface.point(sources[i - 1])).norm() / double(sources.size() - 1);
  }
  EXPECT_GT(mean, 1) << "for points at random on a sphere: 4/3";
}

TEST(Source_sequence, passes_over_what_is_covered)
{
  const Surface_levels levels = to_levels(CSCD::test::sphere(3));
  Coverage coverage(levels);
  Search_result bump;
  bump.outcome = Search_outcome::degenerate;
  add_with_band(levels, coverage, 7, bump);
  ASSERT_TRUE(coverage.is_covered(7));
  Source_sequence sources(levels, 0);
  std::vector<Index> batch;
  sources.next_batch(coverage, 100000, batch);
  EXPECT_EQ(std::count(batch.begin(), batch.end(), Index(7)), 0);
  EXPECT_EQ(batch.size() + 1, levels.finest().surface.number_of_vertices());
}

} // namespace
