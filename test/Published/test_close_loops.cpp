// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops of cut loci: as many as the surface has, whatever the distances are, on triangulations of every kind.

#include "Published/to_surface_with_borders.h"
#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Published/Cut_locus_indicators.h>
#include <CSCD/Published/Cut_tree.h>
#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Published/Tangent_frames.h>
#include <CSCD/Surface/Triangles.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::no_index;
using CSCD::Triangulated_surface;
using CSCD::internal::Cut_locus_indicators;
using CSCD::internal::Cut_locus_settings;
using CSCD::internal::Cut_tree;
using CSCD::internal::Org_tree;
using CSCD::internal::Tangent_frames;
using CSCD::test::Triple;

/// The tree is grown by the default thresholds.
Cut_locus_settings settings_of_growth(double min_branch_length)
{
  Cut_locus_settings settings;
  settings.policy = CSCD::Growing_policy();
  settings.minimum_branch_length = min_branch_length;
  return settings;
}

/// The unit square with opposite sides glued: two faces, one vertex, three edges from it to itself.
struct One_vertex_torus : CSCD::Triangle_halfedges
{
  static Index number_of_vertices() { return 1; }
  static Index number_of_halfedges() { return 6; }
  static Index number_of_faces() { return 2; }
  static Index origin(Index) { return 0; }
  static Index target(Index) { return 0; }
  static Index twin(Index h) { return h < 3 ? h + 3 : h - 3; }
  static double length(Index h) { return h % 3 == 2 ? std::sqrt(2.) : 1; }
};

TEST(close_loops, of_a_torus_with_one_vertex)
{
  const One_vertex_torus torus;
  const Tangent_frames<One_vertex_torus> frames(torus);
  EXPECT_DOUBLE_EQ(frames.area(0), 1);
  for (Index h = 0; h < 6; ++h) {
    EXPECT_LT(std::abs(frames.transport_to_origin(h) - 1.), 1e-12) << "it is flat";
  }
  const std::vector<double> distances{0};
  const Cut_locus_indicators<One_vertex_torus> measures(frames, distances);
  const Org_tree tree(measures, find_loop_vertices(measures, {0}));
  const Cut_tree cut = find_cut_tree(measures, tree, {0}, settings_of_growth(0));
  EXPECT_EQ(cut.chords().size(), 2u);
}

/// The number of chords that `sources` make on `surface` for the field `distances`.
template <class Triangulation>
std::size_t number_of_chords(const Triangulation& surface, const std::vector<double>& distances,
                             const std::vector<Index>& sources)
{
  const Tangent_frames<Triangulation> frames(surface);
  const Cut_locus_indicators<Triangulation> measures(frames, distances);
  const Org_tree tree(measures, find_loop_vertices(measures, sources));
  EXPECT_EQ(tree.roots().size(), 1u);
  const Cut_tree cut = find_cut_tree(measures, tree, sources, settings_of_growth(0.1));
  for (Index halfedge : cut.chords()) {
    for (Index vertex : {surface.origin(halfedge), surface.target(halfedge)}) {
      for (; vertex != no_index; vertex = tree.parent(vertex)) {
        EXPECT_TRUE(cut.is_kept(vertex)) << "a loop is cut open";
      }
    }
  }
  return cut.chords().size();
}

TEST(close_loops, of_any_field)
{
  std::mt19937_64 random(2);
  const CSCD::test::Shape shape = CSCD::test::ladder(3, 0.2);
  const Triangulated_surface surface = CSCD::test::to_surface(shape);
  const Triangulated_surface open = CSCD::test::to_surface_with_borders(shape);
  for (int i = 0; i < 5; ++i) {
    const std::vector<double> distances =
        CSCD::test::sampled(shape, [&](const Triple&) { return CSCD::test::random_signed_unit(random); });
    EXPECT_EQ(number_of_chords(surface, distances, {0}), 6u);
    EXPECT_EQ(number_of_chords(open, distances, {0, 100, 500}), 6u + 2u);
  }
}

TEST(close_loops, counts_borders_as_closed)
{
  const CSCD::test::Shape shape = CSCD::test::with_small_holes(CSCD::test::torus(3, 1, 24), 9, 1);
  const std::vector<double> distances = CSCD::test::sampled(shape, [](const Triple& p) { return p[0] + 4; });
  EXPECT_EQ(number_of_chords(CSCD::test::to_surface_with_borders(shape), distances, {0}), 2u);
}

TEST(Org_tree, spans_what_has_a_distance)
{
  const CSCD::test::Shape shape =
      CSCD::test::merged("", {CSCD::test::sphere(2), CSCD::test::translated(CSCD::test::sphere(2), {5, 0, 0})});
  const Triangulated_surface surface = CSCD::test::to_surface_with_borders(shape);
  const Tangent_frames<Triangulated_surface> frames(surface);
  const std::vector<double> distances = CSCD::test::sampled(
      shape, [](const Triple& p) { return p[0] > 2 ? std::numeric_limits<double>::infinity() : p[2]; });
  const Cut_locus_indicators<Triangulated_surface> measures(frames, distances);
  const Org_tree tree(measures, std::vector<char>(distances.size(), 0));
  ASSERT_EQ(tree.roots().size(), 1u);
  EXPECT_EQ(tree.order().size(), distances.size() / 2);
  EXPECT_EQ(num_edges(tree.graph()), distances.size() / 2 - 1);
  EXPECT_EQ(tree.order().front(), tree.roots().front());
  EXPECT_NEAR(distances[tree.roots().front()], 1, 0.1) << "the farthest";
  std::set<Index> passed;
  for (Index vertex : tree.order()) {
    EXPECT_TRUE(measures.is_reached(vertex));
    EXPECT_TRUE(vertex == tree.roots().front() || passed.count(tree.parent(vertex)) == 1);
    EXPECT_TRUE(passed.insert(vertex).second);
  }
}

TEST(find_cut_tree, has_no_short_branches_and_is_one_vertex_wide)
{
  const CSCD::test::Shape shape = CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat);
  const Triangulated_surface surface = CSCD::test::to_surface(shape);
  const Tangent_frames<Triangulated_surface> frames(surface);
  const Index source = CSCD::test::nearest_vertex(surface, {5, 0, 1});
  const std::vector<double> distances = CSCD::test::sampled(
      shape, [](const Triple& p) { return std::hypot(p[0] - 5, std::fabs(std::atan2(p[1], p[2]))); });
  const Cut_locus_indicators<Triangulated_surface> measures(frames, distances);
  const Org_tree tree(measures, find_loop_vertices(measures, {source}));
  const double min_length = 0.5;
  const double greatest = *std::max_element(distances.begin(), distances.end());
  const Cut_tree cut = find_cut_tree(measures, tree, {source}, settings_of_growth(min_length / greatest));
  std::size_t number_of_leaves = 0;
  for (Index vertex : tree.order()) {
    if (!cut.is_free_leaf(vertex)) {
      continue;
    }
    ++number_of_leaves;
    EXPECT_FALSE(is_beside_branch(frames, cut, vertex));
    double length = 0;
    Index at = vertex;
    do {
      length += frames.corner(tree.halfedge_to_parent(at)).length;
      at = tree.parent(at);
    } while (!cut.is_root(at) && cut.number_of_children(at) == 1);
    EXPECT_GE(length, min_length);
  }
  EXPECT_GT(number_of_leaves, 0u);
}

} // namespace
