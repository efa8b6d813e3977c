// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ways to the source end there, whatever the field is like.

#include "Published/to_surface_with_borders.h"
#include "support/shapes.h"
#include <CSCD/Published/Cut_locus_indicators.h>
#include <CSCD/Published/Descent.h>
#include <CSCD/Published/Tangent_frames.h>
#include <CSCD/Surface/Triangulated_surface.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Triangulated_surface;
using CSCD::internal::Cut_locus_indicators;
using CSCD::internal::Descent;
using CSCD::internal::Edge_steps;
using CSCD::internal::Tangent_frames;
using CSCD::test::Triple;

/// Whether `path` leads from `begin` to `end` and passes no vertex twice.
bool is_simple_path(const Triangulated_surface& surface, const Edge_steps& path, Index begin, Index end)
{
  std::set<Index> passed{begin};
  Index at = begin;
  for (const auto& step : path) {
    if (begin_of(surface, step) != at || !passed.insert(end_of(surface, step)).second) {
      return false;
    }
    at = end_of(surface, step);
  }
  return at == end;
}

TEST(Descent, leads_straight_down_a_good_field)
{
  const CSCD::test::Shape grid = CSCD::test::flat_grid(20, 20, 1);
  const Triangulated_surface surface = CSCD::test::to_surface_with_borders(grid);
  const Tangent_frames<Triangulated_surface> frames(surface);
  const std::vector<double> distances =
      CSCD::test::sampled(grid, [](const Triple& p) { return std::hypot(p[0], p[1]); });
  const Cut_locus_indicators<Triangulated_surface> measures(frames, distances);
  Descent<Tangent_frames<Triangulated_surface>> descent(frames);
  for (Index v = 0; v < surface.number_of_vertices(); ++v) {
    Edge_steps path;
    ASSERT_TRUE(descent(measures, v, 0, path));
    EXPECT_TRUE(is_simple_path(surface, path, v, 0));
    for (const auto& step : path) {
      EXPECT_LT(distances[end_of(surface, step)], distances[begin_of(surface, step)]);
    }
  }
  EXPECT_EQ(descent.number_of_minima(), 0u);
}

TEST(Descent, leaves_minima)
{
  // A basin between the source and everything else: going to the least neighbor alone would stay in it for ever.
  const CSCD::test::Shape grid = CSCD::test::flat_grid(20, 3, 1);
  const Triangulated_surface surface = CSCD::test::to_surface_with_borders(grid);
  const Tangent_frames<Triangulated_surface> frames(surface);
  const std::vector<double> distances =
      CSCD::test::sampled(grid, [](const Triple& p) { return p[0] - 6 * std::exp(-(p[0] - 10) * (p[0] - 10)); });
  const Cut_locus_indicators<Triangulated_surface> measures(frames, distances);
  Descent<Tangent_frames<Triangulated_surface>> descent(frames);
  for (Index v = 0; v < surface.number_of_vertices(); ++v) {
    Edge_steps path;
    ASSERT_TRUE(descent(measures, v, 0, path));
    EXPECT_TRUE(is_simple_path(surface, path, v, 0));
  }
  EXPECT_GT(descent.number_of_minima(), 0u);
}

TEST(Descent, ends_at_the_source_of_any_field)
{
  const CSCD::test::Shape torus = CSCD::test::torus(3, 1, 12);
  const Triangulated_surface surface = CSCD::test::to_surface_with_borders(torus);
  const Tangent_frames<Triangulated_surface> frames(surface);
  Descent<Tangent_frames<Triangulated_surface>> descent(frames);
  std::mt19937_64 random(4);
  for (int i = 0; i < 20; ++i) {
    const std::vector<double> distances =
        CSCD::test::sampled(torus, [&](const Triple&) { return CSCD::test::random_signed_unit(random); });
    const Cut_locus_indicators<Triangulated_surface> measures(frames, distances);
    for (Index v = 0; v < surface.number_of_vertices(); v += 11) {
      Edge_steps path;
      ASSERT_TRUE(descent(measures, v, 5, path));
      EXPECT_TRUE(is_simple_path(surface, path, v, 5));
    }
  }
  const std::vector<double> level(surface.number_of_vertices(), 1.);
  const Cut_locus_indicators<Triangulated_surface> measures(frames, level);
  Edge_steps path;
  EXPECT_TRUE(descent(measures, 100, 5, path));
  EXPECT_TRUE(is_simple_path(surface, path, 100, 5));
}

TEST(Descent, says_when_there_is_no_way)
{
  const CSCD::test::Shape two =
      CSCD::test::merged("", {CSCD::test::sphere(1), CSCD::test::translated(CSCD::test::sphere(1), {5, 0, 0})});
  const Triangulated_surface surface = CSCD::test::to_surface_with_borders(two);
  const Tangent_frames<Triangulated_surface> frames(surface);
  const std::vector<double> distances = CSCD::test::sampled(two, [](const Triple& p) { return p[0]; });
  const Cut_locus_indicators<Triangulated_surface> measures(frames, distances);
  Descent<Tangent_frames<Triangulated_surface>> descent(frames);
  Edge_steps path;
  EXPECT_FALSE(descent(measures, surface.number_of_vertices() - 1, 0, path));
}

TEST(Descent, gives_up_when_its_budget_is_spent)
{
  const CSCD::test::Shape torus = CSCD::test::torus(3, 1, 24);
  const Triangulated_surface surface = CSCD::test::to_surface_with_borders(torus);
  const Tangent_frames<Triangulated_surface> frames(surface);
  Descent<Tangent_frames<Triangulated_surface>> descent(frames);
  std::mt19937_64 random(4);
  const std::vector<double> distances =
      CSCD::test::sampled(torus, [&](const Triple&) { return CSCD::test::random_signed_unit(random); });
  const Cut_locus_indicators<Triangulated_surface> measures(frames, distances);
  const auto count_found = [&] {
    std::size_t number = 0;
    for (Index v = 0; v < surface.number_of_vertices(); ++v) {
      Edge_steps path;
      number += descent(measures, v, 5, path) ? 1 : 0;
    }
    return number;
  };
  EXPECT_EQ(count_found(), surface.number_of_vertices());
  EXPECT_FALSE(descent.is_exhausted());
  descent.set_budget(20 * surface.number_of_vertices()); // a detour spreads over many vertices
  const std::size_t number_of_minima = descent.number_of_minima();
  const std::size_t number_found = count_found();
  EXPECT_TRUE(descent.is_exhausted());
  EXPECT_GT(number_found, 0u);
  EXPECT_LT(number_found, surface.number_of_vertices());
  EXPECT_GT(number_of_minima, 2 * (descent.number_of_minima() - number_of_minima));
  descent.set_budget(1000000000);
  EXPECT_EQ(count_found(), surface.number_of_vertices());
}

} // namespace
