// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The order in which sources are tried.

#include "archetypes/Multiresolution_traits_archetype.h"
#include "support/shapes.h"
#include <CSCD/Selection/Coverage.h>
#include <CSCD/Separator/Local_separator_finder.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

namespace {

using CSCD::Search_outcome;
using CSCD::Search_result;
using CSCD::internal::Coverage;
using CSCD::Index;
using CSCD::internal::Source_sequence;
using Levels_traits = CSCD::test::Multiresolution_traits_archetype;

TEST(Source_sequence, tries_every_vertex_once_unless_it_is_covered)
{
  const Levels_traits traits(CSCD::test::sphere(3));
  const Coverage nothing(traits.levels());
  Source_sequence sources(traits.levels(), 3);
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
  EXPECT_EQ(seen.size(), traits.levels().finest().surface.number_of_vertices());
  sources.next_batch(nothing, 16, batch);
  EXPECT_TRUE(batch.empty());
}

TEST(Source_sequence, depends_on_the_seed_alone_and_is_scattered)
{
  const Levels_traits traits(CSCD::test::sphere(4));
  const Coverage nothing(traits.levels());
  const auto first_sources = [&](unsigned seed) {
    Source_sequence sources(traits.levels(), seed);
    std::vector<Index> batch;
    sources.next_batch(nothing, 64, batch);
    return batch;
  };
  EXPECT_EQ(first_sources(0), first_sources(0));
  EXPECT_NE(first_sources(0), first_sources(1));
  // Sources that are tried one after the other should lie far apart.
  const auto& surface = traits.levels().finest().surface;
  double mean = 0;
  const std::vector<Index> sources = first_sources(5);
  for (std::size_t i = 1; i < sources.size(); ++i) {
    mean += (surface.point(sources[i]) - surface.point(sources[i - 1])).norm() / double(sources.size() - 1);
  }
  EXPECT_GT(mean, 1) << "for points at random on a sphere: 4/3";
}

TEST(Source_sequence, passes_over_what_is_covered)
{
  const Levels_traits traits(CSCD::test::sphere(3));
  Coverage coverage(traits.levels());
  Search_result bump;
  bump.outcome = Search_outcome::degenerate;
  coverage.add(7, bump);
  ASSERT_TRUE(coverage.is_covered(7));
  Source_sequence sources(traits.levels(), 0);
  std::vector<Index> batch;
  sources.next_batch(coverage, 100000, batch);
  EXPECT_EQ(std::count(batch.begin(), batch.end(), Index(7)), 0);
  EXPECT_EQ(batch.size() + 1, traits.levels().finest().surface.number_of_vertices());
}

} // namespace
