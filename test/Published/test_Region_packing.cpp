// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every vertex belongs to the nearest packed separator; regions are connected and not empty.

#include "Separator/make_separator.h"
#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Published/Region_packing.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/flat_arrays.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Separator;
using CSCD::Surface_level;
using CSCD::internal::Separator_regions;
using CSCD::test::tube_section;

Surface_level level_of(const CSCD::test::Shape& shape)
{
  return Surface_level(CSCD::test::to_surface(shape));
}

/// The number of parts, connected by edges within a region, of all regions together.
Index number_of_parts(const Surface_level& level, const Separator_regions& regions)
{
  CSCD::internal::Disjoint_sets sets(level.surface.number_of_vertices());
  Index count = level.surface.number_of_vertices();
  for (Index h = 0; h < level.surface.number_of_halfedges(); ++h) {
    const Index a = level.surface.origin(h);
    const Index b = level.surface.target(h);
    count -= regions[a] == regions[b] && sets.join(a, b) ? 1 : 0;
  }
  return count;
}

TEST(Separator_regions, are_of_the_nearest_separator)
{
  const Surface_level level = level_of(CSCD::test::tube(10, 1, 32, CSCD::test::Tube_end::flat));
  const std::vector<Separator> separators{tube_section(level.surface, 8), tube_section(level.surface, 5),
                                          tube_section(level.surface, 2)};
  const Separator_regions regions(level.surface, separators, {2, 0});
  ASSERT_EQ(regions.size(), 2u);
  for (Index vertex = 0; vertex < level.surface.number_of_vertices(); ++vertex) {
    const double x = level.surface.point(vertex).x();
    if (std::abs(x - 5) > 0.3) {
      EXPECT_EQ(regions[vertex], x < 5 ? 0u : 1u) << x;
    }
  }
}

TEST(Separator_regions, are_connected_and_not_empty_however_close_the_separators)
{
  const Surface_level level = level_of(CSCD::test::anisotropic_tube(10, 1, 24, 30));
  std::vector<Separator> separators;
  std::vector<double> weights;
  for (int i = 0; i < 80; ++i) {
    separators.push_back(tube_section(level.surface, 0.5 + 9. * i / 80, {1, 0.3 * (i % 5 - 2), 0.2 * (i % 3 - 1)}));
    weights.push_back(0.1 + 0.9 * (i * 13 % 17) / 17);
  }
  CSCD::internal::Separator_overlaps overlaps(level.surface, separators);
  const std::vector<Index> packed = CSCD::internal::pack_by_overlap(overlaps, weights);
  const Separator_regions regions(level.surface, separators, packed);
  ASSERT_EQ(regions.size(), packed.size());
  EXPECT_GT(regions.size(), 8u);
  std::set<Index> found;
  for (Index vertex = 0; vertex < level.surface.number_of_vertices(); ++vertex) {
    found.insert(regions[vertex]);
  }
  EXPECT_EQ(found.size(), regions.size());
  EXPECT_EQ(number_of_parts(level, regions), regions.size());
}

TEST(Separator_regions, of_a_component_without_separators_are_one)
{
  const Surface_level level =
      level_of(CSCD::test::merged("tube and cubes", {CSCD::test::tube(10, 1, 16, CSCD::test::Tube_end::flat),
                                                     CSCD::test::translated(CSCD::test::cube(), {0, 5, 0}),
                                                     CSCD::test::translated(CSCD::test::cube(), {0, 9, 0})}));
  const std::vector<Separator> separators{tube_section(level.surface, 5)};
  const Separator_regions regions(level.surface, separators, {0});
  EXPECT_EQ(regions.size(), 3u);
  EXPECT_EQ(number_of_parts(level, regions), 3u);
  for (Index vertex = 0; vertex < level.surface.number_of_vertices(); ++vertex) {
    EXPECT_EQ(regions[vertex] == 0, level.surface.point(vertex).y() < 3);
  }
  EXPECT_EQ(Separator_regions(level.surface, separators, {}).size(), 3u);
}

} // namespace
