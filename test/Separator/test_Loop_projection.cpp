// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops of a coarse level on the edges of the finest one.

#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Local/Geodesic_polar_coordinates.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/Straightening.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <set>

namespace {

using CSCD::Index;
using CSCD::no_index;
using CSCD::Surface_level;
using CSCD::Surface_levels;
using CSCD::Triangulated_surface;
using CSCD::Vertex_loop;
using CSCD::internal::Loop_projection;

double length(const Triangulated_surface& surface, const Vertex_loop& loop)
{
  double result = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    result += (surface.point(loop[(i + 1) % loop.size()]) - surface.point(loop[i])).norm();
  }
  return result;
}

TEST(Loop_projection, is_connected_simple_and_hardly_longer)
{
  const Surface_levels levels = CSCD::test::to_levels(CSCD::test::noisy(CSCD::test::torus(3, 1, 64), 0.1, 1));
  ASSERT_GE(levels.size(), 2u);
  const Surface_level& coarse = levels[1];
  const Triangulated_surface& fine = levels.finest().surface;
  CSCD::internal::Geodesic_polar_coordinates front(coarse.corners(), coarse.surface.number_of_vertices());
  Loop_projection project(levels);
  std::size_t number_of_loops = 0;
  for (Index source = 0; source < coarse.surface.number_of_vertices(); source += 31) {
    CSCD::internal::Nearest_meeting meeting(coarse.surface, front, source);
    front.grow(source, std::numeric_limits<std::size_t>::max(), meeting);
    if (!meeting.has_found()) {
      continue;
    }
    Vertex_loop loop;
    CSCD::internal::trace_loop(front, meeting.first(), meeting.second(), loop);
    Vertex_loop fine_loop;
    ASSERT_TRUE(project(coarse, loop, fine_loop));
    ++number_of_loops;
    ASSERT_EQ(std::set<Index>(fine_loop.begin(), fine_loop.end()).size(), fine_loop.size());
    for (std::size_t i = 0; i < fine_loop.size(); ++i) {
      ASSERT_NE(fine.find_halfedge(fine_loop[i], fine_loop[(i + 1) % fine_loop.size()]), no_index);
    }
    EXPECT_LT(length(fine, fine_loop), 1.2 * length(coarse.surface, loop));
  }
  EXPECT_GT(number_of_loops, 30u);
}

TEST(Loop_projection, on_the_finest_level_is_the_loop_itself)
{
  const Surface_levels levels = CSCD::test::to_levels(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat));
  Vertex_loop loop;
  for (Index k = 0; k < 24; ++k) {
    loop.push_back(10 * 24 + k);
  }
  Loop_projection project(levels);
  Vertex_loop fine_loop{1, 2, 3};
  ASSERT_TRUE(project(levels.finest(), loop, fine_loop));
  EXPECT_EQ(fine_loop, loop);
}

TEST(Loop_projection, of_few_far_vertices_is_joined_by_shortest_paths)
{
  const Surface_levels levels = CSCD::test::to_levels(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat));
  // A level is only asked for the numbers of its vertices.
  Surface_level corners_only(CSCD::test::to_surface(CSCD::test::tetrahedron()));
  const Index ring = 10 * 24;
  corners_only.finest_vertex = {ring, ring + 6, ring + 12, ring + 18};
  Loop_projection project(levels);
  Vertex_loop fine_loop;
  ASSERT_TRUE(project(corners_only, {0, 1, 2, 3}, fine_loop));
  EXPECT_EQ(fine_loop.size(), 24u);
  for (Index k = 0; k < 24; ++k) {
    EXPECT_EQ(fine_loop[k], ring + k);
  }
}

TEST(Loop_projection, refuses_there_and_back)
{
  const Surface_levels levels = CSCD::test::to_levels(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat));
  Surface_level two_vertices(CSCD::test::to_surface(CSCD::test::tetrahedron()));
  two_vertices.finest_vertex = {240, 243, 246, 0};
  Loop_projection project(levels);
  Vertex_loop fine_loop;
  EXPECT_FALSE(project(two_vertices, {0, 1, 2, 1}, fine_loop));
}

TEST(Loop_projection, refuses_a_path_that_strays)
{
  // Two fingers whose ends are close in space and far along the surface.
  const Surface_levels levels = CSCD::test::to_levels(CSCD::test::bent_tube(3, 6, 0.6, 24));
  const Triangulated_surface& surface = levels.finest().surface;
  Surface_level ends(CSCD::test::to_surface(CSCD::test::tetrahedron()));
  const Index first = CSCD::test::nearest_vertex(surface, {3, -0.7, 0});
  const Index second = CSCD::test::nearest_vertex(surface, {2.9, -1, 0});
  ends.finest_vertex = {first, second, first, second};
  Loop_projection project(levels);
  Vertex_loop fine_loop;
  EXPECT_FALSE(project(ends, {0, 1}, fine_loop));
}

} // namespace
