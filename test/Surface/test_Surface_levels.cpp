// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Coarser surfaces keep the topology, the hole-filling faces, and a part of the vertices.

#include "Surface/to_surface.h"
#include "support/Allow_threads.h"
#include "support/shapes.h"
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Indexed_triangles;
using CSCD::Surface_level;
using CSCD::Surface_levels;
using CSCD::Triangulated_surface;
using CSCD::internal::Coarsening;

int euler_number(const Triangulated_surface& surface)
{
  return int(surface.number_of_vertices()) - int(surface.number_of_faces()) / 2;
}

TEST(Coarsening, keeps_closed_manifolds_of_the_same_topology)
{
  for (const CSCD::test::Shape_maker& maker : CSCD::test::hard_closed_shapes()) {
    SCOPED_TRACE(maker.name);
    const Triangulated_surface fine = CSCD::test::to_surface(maker.make());
    const Coarsening coarsening(fine);
    const Triangulated_surface coarse(coarsening.triangles());
    ASSERT_FALSE(coarse.defect());
    EXPECT_EQ(euler_number(coarse), euler_number(fine));
    EXPECT_LE(coarse.number_of_vertices(), fine.number_of_vertices());
    // The surface is still simplicial: no edge has the ends of another one.
    for (Index vertex = 0; vertex < coarse.number_of_vertices(); ++vertex) {
      std::set<Index> neighbors;
      for (Index h : coarse.outgoing(vertex)) {
        ASSERT_TRUE(neighbors.insert(coarse.target(h)).second);
      }
    }
  }
}

TEST(Coarsening, maps_every_vertex_to_itself_or_a_neighbor_that_stays)
{
  const Triangulated_surface fine = CSCD::test::to_surface(CSCD::test::noisy(CSCD::test::torus(3, 1, 24), 0.2, 1));
  const Coarsening coarsening(fine);
  const Triangulated_surface coarse(coarsening.triangles());
  ASSERT_EQ(coarsening.fine_vertex().size(), coarse.number_of_vertices());
  ASSERT_EQ(coarsening.coarse_vertex().size(), fine.number_of_vertices());
  EXPECT_TRUE(std::is_sorted(coarsening.fine_vertex().begin(), coarsening.fine_vertex().end()));
  for (Index vertex = 0; vertex < coarse.number_of_vertices(); ++vertex) {
    EXPECT_EQ(coarse.point(vertex), fine.point(coarsening.fine_vertex()[vertex]));
    EXPECT_EQ(coarsening.coarse_vertex()[coarsening.fine_vertex()[vertex]], vertex);
  }
  for (Index vertex = 0; vertex < fine.number_of_vertices(); ++vertex) {
    const Index kept = coarsening.fine_vertex()[coarsening.coarse_vertex()[vertex]];
    // A collapse leads to a neighbor; it may have become one by earlier collapses.
    EXPECT_LT((fine.point(kept) - fine.point(vertex)).norm(), 1.5);
  }
}

TEST(Coarsening, leaves_about_two_sevenths_of_a_regular_surface_and_hardly_changes_it)
{
  const Triangulated_surface fine = CSCD::test::to_surface(CSCD::test::sphere(5));
  const Coarsening coarsening(fine);
  const Triangulated_surface coarse(coarsening.triangles());
  const double ratio = double(coarse.number_of_vertices()) / fine.number_of_vertices();
  EXPECT_GT(ratio, 0.2);
  EXPECT_LT(ratio, 0.4);
  EXPECT_NEAR(coarse.total_area(), fine.total_area(), 0.02 * fine.total_area());
  for (Index face = 0; face < coarse.number_of_faces(); ++face) {
    EXPECT_GT(coarse.face_vector(face).dot(coarse.point(coarse.origin(3 * face))), 0) << "no face is turned over";
  }
}

TEST(Coarsening, of_several_blocks_does_not_depend_on_the_number_of_threads)
{
  const CSCD::test::Allow_threads allow(3);
  const Triangulated_surface fine = CSCD::test::to_surface(CSCD::test::noisy(CSCD::test::torus(3, 1, 260), 0.05, 1));
  ASSERT_GT(fine.number_of_vertices(), 2U << 16U);
  const Coarsening coarsening(fine, 1);
  const Triangulated_surface coarse(coarsening.triangles());
  ASSERT_FALSE(coarse.defect());
  EXPECT_EQ(euler_number(coarse), euler_number(fine));
  EXPECT_LT(coarse.number_of_vertices(), 0.4 * fine.number_of_vertices());
  for (const unsigned number_of_threads : {2U, 3U}) {
    const Coarsening by_threads(fine, number_of_threads);
    EXPECT_EQ(by_threads.fine_vertex(), coarsening.fine_vertex());
    EXPECT_EQ(by_threads.coarse_vertex(), coarsening.coarse_vertex());
    EXPECT_EQ(by_threads.triangles().faces, coarsening.triangles().faces);
  }
}

TEST(Coarsening, keeps_bridging_faces_as_they_are)
{
  Indexed_triangles triangles = CSCD::test::to_indexed_triangles(CSCD::test::sphere(4));
  triangles.first_hole_filling_face = triangles.faces.size() - 40;
  const Triangulated_surface fine(std::move(triangles));
  const Coarsening coarsening(fine);
  Indexed_triangles result = coarsening.triangles();
  ASSERT_EQ(result.faces.size() - result.first_hole_filling_face, 40u);
  std::set<std::set<Index>> expected;
  for (Index face = fine.first_hole_filling_face(); face < fine.number_of_faces(); ++face) {
    expected.insert({fine.origin(3 * face), fine.origin(3 * face + 1), fine.origin(3 * face + 2)});
  }
  for (std::size_t face = result.first_hole_filling_face; face < result.faces.size(); ++face) {
    const auto [a, b, c] = result.faces[face];
    const std::vector<Index>& fine_vertex = coarsening.fine_vertex();
    EXPECT_EQ(expected.count({fine_vertex[a], fine_vertex[b], fine_vertex[c]}), 1u);
  }
  const Triangulated_surface coarse(std::move(result));
  EXPECT_FALSE(coarse.defect());
  EXPECT_LT(coarse.number_of_vertices(), fine.number_of_vertices() / 2);
}

TEST(Coarsening, can_be_repeated)
{
  Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::double_torus(0.1));
  const int euler = euler_number(surface);
  for (int i = 0; i < 4; ++i) {
    Triangulated_surface coarse(Coarsening(surface).triangles());
    ASSERT_FALSE(coarse.defect());
    ASSERT_EQ(euler_number(coarse), euler);
    surface = std::move(coarse);
  }
  EXPECT_LT(surface.number_of_vertices(), 1000u);
}

TEST(Vertex_fan_table, agrees_with_the_surface)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::noisy(CSCD::test::sphere(2), 0.2, 1));
  const CSCD::Vertex_fan_table corners(surface);
  double length = 0;
  for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
    const auto fan = corners.fan(vertex);
    ASSERT_EQ(fan.size(), surface.degree(vertex) + 1);
    ASSERT_EQ(corners.neighbors(vertex).size(), surface.degree(vertex));
    EXPECT_EQ((fan.end() - 1)->neighbor, fan.begin()->neighbor);
    for (Index i = 0; i < surface.degree(vertex); ++i) {
      const Index h = surface.outgoing(vertex).begin()[i];
      const CSCD::Corner& corner = fan.begin()[i];
      EXPECT_EQ(corner.neighbor, surface.target(h));
      EXPECT_NEAR(double(corner.length), surface.length(h), 1e-6);
      EXPECT_NEAR(double(corner.cosine * corner.cosine + corner.sine * corner.sine), 1, 1e-6);
      const double product = (surface.point(surface.target(h)) - surface.point(vertex))
                                 .dot(surface.point(fan.begin()[i + 1].neighbor) - surface.point(vertex));
      EXPECT_NEAR(double(corner.cosine * corner.length * fan.begin()[i + 1].length), product, 1e-6);
      length += surface.length(h);
    }
  }
  EXPECT_NEAR(corners.mean_length(), length / surface.number_of_halfedges(), 1e-9);
}

TEST(Vertex_fan_table, gives_edges_without_length_no_angle)
{
  CSCD::test::Shape shape = CSCD::test::cube();
  shape.points[1] = shape.points[0];
  const Triangulated_surface surface = CSCD::test::to_surface(shape);
  const CSCD::Vertex_fan_table corners(surface);
  for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
    for (const CSCD::Corner& corner : corners.neighbors(vertex)) {
      EXPECT_TRUE(corner.cosine >= -1.0001f && corner.cosine <= 1.0001f);
      EXPECT_TRUE(corner.sine >= 0 && corner.sine <= 1.0001f);
      EXPECT_TRUE(corner.length > 0 || (corner.cosine == 1 && corner.sine == 0));
    }
  }
}

TEST(Surface_levels, map_to_and_from_the_finest_level)
{
  const Surface_levels levels = CSCD::test::to_levels(CSCD::test::torus(3, 1, 150));
  ASSERT_GE(levels.size(), 3u);
  EXPECT_EQ(levels.top(), levels.size() - 1);
  EXPECT_EQ(&levels.coarsest(), &levels[levels.top()]);
  EXPECT_EQ(&levels.finest(), &levels[0]);
  const Triangulated_surface& finest = levels.finest().surface;
  for (Index i = 0; i < levels.size(); ++i) {
    const Surface_level& level = levels[i];
    EXPECT_EQ(euler_number(level.surface), 0);
    EXPECT_TRUE(i == 0 || level.surface.number_of_vertices() < levels[i - 1].surface.number_of_vertices() / 2);
    for (Index vertex = 0; vertex < level.surface.number_of_vertices(); ++vertex) {
      ASSERT_EQ(level.from_finest(level.to_finest(vertex)), vertex);
      ASSERT_EQ(level.surface.point(vertex), finest.point(level.to_finest(vertex)));
    }
    for (Index vertex = 0; vertex < finest.number_of_vertices(); ++vertex) {
      ASSERT_LT(level.from_finest(vertex), level.surface.number_of_vertices());
      const double distance = (level.surface.point(level.from_finest(vertex)) - finest.point(vertex)).norm();
      ASSERT_LT(distance, 4 * level.corners().mean_length()) << "it stands for vertices nearby";
    }
  }
}

TEST(Surface_levels, are_chosen_by_size)
{
  const Surface_levels levels = CSCD::test::to_levels(CSCD::test::torus(3, 1, 150));
  for (Index limit : {Index(1), Index(5000), Index(15000), Index(1000000)}) {
    const Index level = levels.finest_with_at_most(limit);
    EXPECT_TRUE(level == levels.top() || levels[level].surface.number_of_vertices() <= limit);
    EXPECT_TRUE(level == 0 || levels[level - 1].surface.number_of_vertices() > limit);
  }
}

TEST(Surface_levels, of_a_surface_that_needs_the_finest_are_not_chosen)
{
  const Surface_levels levels(CSCD::test::to_surface(CSCD::test::torus(3, 1, 150)), 1, true);
  EXPECT_GT(levels.size(), 1u);
  EXPECT_TRUE(levels.needs_finest());
  EXPECT_EQ(levels.finest_with_at_most(1), 0u);
}

TEST(Surface_levels, of_a_small_surface_is_the_surface)
{
  const Surface_levels levels = CSCD::test::to_levels(CSCD::test::cube());
  EXPECT_EQ(levels.size(), 1u);
  EXPECT_EQ(levels.finest().to_finest(5), 5u);
  EXPECT_EQ(levels.finest().from_finest(5), 5u);
}

} // namespace
