// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search for separators: complete, bounded, and the same for any number of threads.

#include "Surface/to_surface.h"
#include "support/Allow_threads.h"
#include "support/shapes.h"
#include <CSCD/Local/Covering_search.h>
#include <CSCD/Local/Local_separator_finder.h>
#include <CSCD/Separator/Search_settings.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Separator;
using CSCD::Surface_levels;
using CSCD::internal::Separator_search;
using CSCD::test::to_levels;

constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();

/// What a search finds.
struct Findings
{
  std::vector<Separator> separators;
  CSCD::Skeletonization_report report;
  std::vector<double> progress;
};

Separator_search make_search(const Surface_levels& levels, unsigned seed, unsigned number_of_threads)
{
  CSCD::Search_settings settings;
  settings.random_seed = seed;
  settings.number_of_threads = number_of_threads;
  return Separator_search(levels, settings, [&levels]() -> CSCD::Separator_finder {
    const auto finder = std::make_shared<CSCD::Local_separator_finder>(levels);
    return [finder](Index source, Index level_hint, CSCD::Search_result& result) {
      (*finder)(source, level_hint, result);
    };
  });
}

Findings search(const Surface_levels& levels, unsigned seed, unsigned number_of_threads,
                std::size_t max_sources = no_limit)
{
  Findings findings;
  Separator_search separator_search = make_search(levels, seed, number_of_threads);
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
  const Surface_levels levels = to_levels(CSCD::test::y_tube(0.12));
  const Findings findings = search(levels, 0, 1);
  EXPECT_GT(findings.separators.size(), 10u);
  EXPECT_EQ(findings.report.number_of_sources, findings.separators.size() + findings.report.number_of_bumps +
                                                   findings.report.number_of_sources_without_cut);
  EXPECT_EQ(findings.report.number_of_plane_sections + findings.report.number_of_straightened_loops,
            findings.separators.size());
  EXPECT_LT(findings.report.number_of_sources, levels.finest().surface.number_of_vertices() / 4);
  EXPECT_TRUE(std::is_sorted(findings.progress.begin(), findings.progress.end()));
}

TEST(Separator_search, answers_the_same_for_every_number_of_threads)
{
  const CSCD::test::Allow_threads allow(3);
  for (const CSCD::test::Shape& shape :
       {CSCD::test::hand(0.12), CSCD::test::noisy(CSCD::test::torus(3, 1, 64), 0.1, 1)}) {
    SCOPED_TRACE(shape.name);
    const Surface_levels levels = to_levels(shape);
    const Findings sequential = search(levels, 5, 1);
    EXPECT_GT(sequential.separators.size(), 5u);
    expect_equal(sequential, search(levels, 5, 1));
    for (const unsigned number_of_threads : {1u, 2u, 3u}) {
      SCOPED_TRACE(number_of_threads);
      expect_equal(sequential, search(levels, 5, number_of_threads));
    }
  }
}

TEST(Separator_search, tries_no_more_sources_than_allowed_and_the_same_ones)
{
  const Surface_levels levels = to_levels(CSCD::test::hand(0.12));
  const Findings all = search(levels, 0, 1);
  for (const std::size_t max_sources : {std::size_t(0), std::size_t(1), std::size_t(20)}) {
    const Findings some = search(levels, 0, 1, max_sources);
    EXPECT_LE(some.report.number_of_sources, max_sources);
    EXPECT_LE(some.separators.size(), max_sources);
    expect_equal(some, search(levels, 0, 2, max_sources));
    for (std::size_t i = 0; i < std::min(some.separators.size(), std::size_t(10)); ++i) {
      EXPECT_EQ(some.separators[i].source, all.separators[i].source);
    }
  }
}

/// How many sources are tried on half of a ball, when none has a cut point and each covers `failure_radius` around it.
std::size_t number_of_failed_sources(const Surface_levels& levels, float failure_radius)
{
  const auto fail = [](Index, Index, CSCD::Search_result& result) {
    result.outcome = CSCD::Search_outcome::no_cut;
    result.level = 0;
  };
  Separator_search separator_search(levels, CSCD::Search_settings(), [&fail] { return CSCD::Separator_finder(fail); });
  separator_search.explore([&](Index vertex) { return levels.finest().surface.point(vertex).x() > 0; }, 1,
                           [failure_radius](Index) { return failure_radius; });
  std::vector<Separator> separators;
  CSCD::Skeletonization_report report;
  separator_search(no_limit, separators, report, [](double) {});
  EXPECT_TRUE(separators.empty());
  return report.number_of_sources;
}

TEST(Separator_search, tries_sources_without_a_cut_as_densely_as_asked_for)
{
  const Surface_levels levels = to_levels(CSCD::test::sphere(4));
  const auto& points = levels.finest().surface.points();
  const auto half = std::size_t(std::count_if(points.begin(), points.end(), [](const auto& p) { return p.x() > 0; }));
  EXPECT_EQ(number_of_failed_sources(levels, 0), half);
  const std::size_t dense = number_of_failed_sources(levels, 0.2F);
  const std::size_t sparse = number_of_failed_sources(levels, 0.4F);
  EXPECT_LT(dense, half);
  EXPECT_LT(sparse, dense);
  EXPECT_EQ(number_of_failed_sources(levels, 10), 1u) << "the first covers all others";
}

TEST(Separator_search, passes_on_what_the_progress_throws)
{
  const Surface_levels levels = to_levels(CSCD::test::sphere(4));
  Separator_search separator_search = make_search(levels, 0, 2);
  std::vector<Separator> separators;
  CSCD::Skeletonization_report report;
  EXPECT_THROW(separator_search(no_limit, separators, report, [](double) { throw std::runtime_error("stop"); }),
               std::runtime_error);
  EXPECT_LE(report.number_of_sources, 16u);
}

} // namespace
