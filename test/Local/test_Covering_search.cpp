// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search for separators: complete, bounded, and the same for any number of threads.

#include "Surface/to_indexed_triangles.h"
#include "support/Allow_threads.h"
#include "support/shapes.h"
#include <CSCD/Local/Covering_search.h>
#include <CSCD/Options.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/limb_tests.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

static_assert(!std::is_move_constructible_v<CSCD::internal::Covering_search>, "the search holds a pointer to it");

using CSCD::Index;
using CSCD::Separator;
using CSCD::internal::Separator_search;

/// The body of a shape.
class Solid : public CSCD::Triangulated_solid
{
public:
  explicit Solid(const CSCD::test::Shape& shape) : Solid(CSCD::test::to_indexed_triangles(shape)) {}

private:
  explicit Solid(CSCD::Indexed_triangles&& triangles)
      : Solid(std::move(triangles), CSCD::Halfedge_pairing(triangles.faces, triangles.points.size()))
  {
  }
  Solid(CSCD::Indexed_triangles&& triangles, CSCD::Halfedge_pairing&& pairing)
      : Triangulated_solid(std::move(triangles), std::move(pairing))
  {
  }
};

constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();

/// What a search finds.
struct Findings
{
  std::vector<Separator> separators;
  CSCD::Skeletonization_report report;
  std::vector<double> progress;
};

Separator_search make_search(const Solid& solid, unsigned seed, unsigned number_of_threads)
{
  CSCD::Options settings;
  settings.random_seed = seed;
  settings.number_of_threads = number_of_threads;
  return Separator_search(solid, settings);
}

Findings search(const Solid& solid, unsigned seed, unsigned number_of_threads, std::size_t max_sources = no_limit)
{
  Findings findings;
  Separator_search separator_search = make_search(solid, seed, number_of_threads);
  separator_search(max_sources, findings.separators, findings.report,
                   [&](double fraction) { findings.progress.push_back(fraction); });
  return findings;
}

void expect_equal(const Findings& a, const Findings& b)
{
  EXPECT_EQ(a.report.number_of_sources, b.report.number_of_sources);
  EXPECT_EQ(a.report.number_of_bumps, b.report.number_of_bumps);
  EXPECT_EQ(a.report.number_of_sources_without_cut, b.report.number_of_sources_without_cut);
  EXPECT_EQ(a.report.number_of_plane_sections, b.report.number_of_plane_sections);
  EXPECT_EQ(a.progress, b.progress);
  ASSERT_EQ(a.separators.size(), b.separators.size());
  for (std::size_t i = 0; i < a.separators.size(); ++i) {
    const Separator& s = a.separators[i];
    const Separator& t = b.separators[i];
    ASSERT_EQ(s.source, t.source);
    ASSERT_EQ(s.level, t.level);
    ASSERT_EQ(s.length, t.length);
    ASSERT_EQ(s.center, t.center);
    ASSERT_EQ(s.planarity, t.planarity);
    ASSERT_TRUE(
        std::equal(s.crossings.begin(), s.crossings.end(), t.crossings.begin(), t.crossings.end(),
                   [](const auto& c, const auto& d) { return c.halfedge == d.halfedge && c.position == d.position; }));
  }
}

TEST(Separator_search, covers_the_surface)
{
  const Solid solid(CSCD::test::y_tube(0.12));
  const Findings findings = search(solid, 0, 1);
  EXPECT_GT(findings.separators.size(), 10u);
  EXPECT_EQ(findings.report.number_of_sources, findings.separators.size() + findings.report.number_of_bumps +
                                                   findings.report.number_of_sources_without_cut);
  EXPECT_EQ(findings.report.number_of_plane_sections + findings.report.number_of_straightened_loops,
            findings.separators.size());
  EXPECT_LT(findings.report.number_of_sources, solid.triangulation().number_of_vertices() / 4);
  EXPECT_TRUE(std::is_sorted(findings.progress.begin(), findings.progress.end()));
}

TEST(Separator_search, answers_the_same_for_every_number_of_threads)
{
  const CSCD::test::Allow_threads allow(3);
  for (const CSCD::test::Shape& shape :
       {CSCD::test::hand(0.12), CSCD::test::noisy(CSCD::test::torus(3, 1, 64), 0.1, 1)}) {
    SCOPED_TRACE(shape.name);
    const Solid solid(shape);
    const Findings sequential = search(solid, 5, 1);
    EXPECT_GT(sequential.separators.size(), 5u);
    expect_equal(sequential, search(solid, 5, 1));
    for (const unsigned number_of_threads : {1u, 2u, 3u}) {
      SCOPED_TRACE(number_of_threads);
      expect_equal(sequential, search(solid, 5, number_of_threads));
    }
  }
}

TEST(Separator_search, tries_no_more_sources_than_allowed_and_the_same_ones)
{
  const Solid solid(CSCD::test::hand(0.12));
  const Findings all = search(solid, 0, 1);
  for (const std::size_t max_sources : {std::size_t(0), std::size_t(1), std::size_t(20)}) {
    const Findings some = search(solid, 0, 1, max_sources);
    EXPECT_LE(some.report.number_of_sources, max_sources);
    EXPECT_LE(some.separators.size(), max_sources);
    expect_equal(some, search(solid, 0, 2, max_sources));
    for (std::size_t i = 0; i < std::min(some.separators.size(), std::size_t(10)); ++i) {
      EXPECT_EQ(some.separators[i].source, all.separators[i].source);
    }
  }
}

TEST(Separator_search, passes_on_what_the_progress_throws)
{
  const Solid solid(CSCD::test::sphere(4));
  Separator_search separator_search = make_search(solid, 0, 2);
  std::vector<Separator> separators;
  CSCD::Skeletonization_report report;
  EXPECT_THROW(separator_search(no_limit, separators, report, [](double) { throw std::runtime_error("stop"); }),
               std::runtime_error);
  EXPECT_LE(report.number_of_sources, 16u);
}

} // namespace
