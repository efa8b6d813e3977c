// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The library compiles and runs with models that have nothing but what the concepts ask for.

#include "archetypes/Multiresolution_traits_archetype.h"
#include "archetypes/Point_archetype.h"
#include "archetypes/Policies_archetype.h"
#include "archetypes/Separator_cost_archetype.h"
#include "archetypes/Skeleton_archetype.h"
#include "archetypes/Skeletonization_traits_archetype.h"
#include "archetypes/Solid_traits_archetype.h"
#include "archetypes/Triangle_mesh_archetype.h"
#include "archetypes/Visitor_archetype.h"
#include "support/shapes.h"
#include <CSCD/Curve_skeletonization.h>
#include <CSCD/Selection/Separator_packing.h>
#include <CSCD/Selection/cut_handles.h>
#include <CSCD/Separator/Local_separator_finder.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Branch_refinement.h>
#include <CSCD/Skeleton/Inside_repair.h>
#include <CSCD/Skeleton/Node_placement.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeleton/place_junctions.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/concepts.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace {

using CSCD::test::Multiresolution_traits_archetype;
using CSCD::test::Point_archetype;
using CSCD::test::Separator_cost_archetype;
using CSCD::test::Skeletonization_traits_archetype;
using CSCD::test::Solid_traits_archetype;
using CSCD::test::Triangle_mesh_archetype;
using CSCD::test::Vertex_point_map_archetype;
using CSCD::test::Visitor_archetype;
using Vertex = Triangle_mesh_archetype::Vertex;
using Skeleton = CSCD::Skeleton_graph<Point_archetype, Vertex>;
using Skeleton_archetype = CSCD::test::Skeleton_archetype<Point_archetype, Vertex>;
using Policies_archetype = CSCD::test::Policies_archetype<Skeletonization_traits_archetype>;
using Finder_archetype = Policies_archetype::Separator_finder;

CSCD::test::Shape shape()
{
  return CSCD::test::y_tube(0.25);
}

/// Expects every vertex of the shape in one node.
template <class AnySkeleton>
void expect_partition(const AnySkeleton& skeleton)
{
  std::vector<std::size_t> count(shape().points.size(), 0);
  const auto nodes = vertices(skeleton);
  for (auto node = nodes.first; node != nodes.second; ++node) {
    for (const Vertex v : skeleton[*node].vertices) {
      ++count[v.number()];
    }
  }
  EXPECT_EQ(count, std::vector<std::size_t>(count.size(), 1));
}

TEST(Archetypes, are_models)
{
  EXPECT_TRUE(CSCD::is_triangle_mesh_v<Triangle_mesh_archetype>);
  EXPECT_TRUE(CSCD::is_skeletonization_traits_v<Skeletonization_traits_archetype>);
  EXPECT_TRUE(CSCD::is_solid_skeletonization_traits_v<Skeletonization_traits_archetype>);
  EXPECT_TRUE(CSCD::is_solid_skeletonization_traits_v<Solid_traits_archetype>);
  EXPECT_TRUE(CSCD::is_multiresolution_skeletonization_traits_v<Multiresolution_traits_archetype>);
  EXPECT_TRUE((CSCD::is_skeletonization_policies_v<Policies_archetype, Skeletonization_traits_archetype>));
  EXPECT_TRUE((CSCD::is_separator_finder_v<Finder_archetype, Skeletonization_traits_archetype>));
  EXPECT_TRUE(CSCD::is_separator_cost_v<Separator_cost_archetype>);
  EXPECT_TRUE(CSCD::is_curve_skeleton_graph_v<Skeleton_archetype>);
  EXPECT_TRUE(CSCD::is_skeletonization_visitor_v<Visitor_archetype>);
  EXPECT_FALSE(CSCD::has_radius_v<Skeleton_archetype>);
}

TEST(Archetypes, have_nothing_of_the_concepts_beyond_their_own)
{
  EXPECT_FALSE(CSCD::is_skeletonization_traits_v<Solid_traits_archetype>);
  EXPECT_FALSE(CSCD::is_skeletonization_traits_v<Multiresolution_traits_archetype>);
  EXPECT_FALSE(CSCD::is_solid_skeletonization_traits_v<Multiresolution_traits_archetype>);
}

TEST(Archetypes, of_all_that_the_free_function_takes)
{
  const Triangle_mesh_archetype mesh(shape());
  Visitor_archetype visitor;
  std::size_t number_of_weights = 0;
  Skeleton_archetype skeleton;
  const CSCD::Skeletonization_report report =
      CSCD::extract_curve_skeleton(mesh, skeleton,
                                   CSCD::parameters::vertex_point_map(Vertex_point_map_archetype(mesh))
                                       .visitor(std::ref(visitor))
                                       .separator_cost(Separator_cost_archetype(number_of_weights)));
  EXPECT_EQ(report.number_of_tips, 3u);
  EXPECT_EQ(num_vertices(skeleton), report.number_of_nodes);
  EXPECT_EQ(num_edges(skeleton), report.number_of_edges);
  EXPECT_GT(visitor.number_of_calls(), 0u);
  EXPECT_GE(number_of_weights, report.number_of_separators);
  expect_partition(skeleton);
}

TEST(Archetypes, of_surface_traits_step_by_step)
{
  const Skeletonization_traits_archetype traits(shape());
  CSCD::Curve_skeletonization<Skeletonization_traits_archetype> skeletonization(traits);
  EXPECT_GT(skeletonization.find_separators(), 0u);
  EXPECT_GT(skeletonization.pack_separators(), 0u);
  Skeleton skeleton;
  skeletonization.convert_to_skeleton(skeleton);
  expect_partition(skeleton);
  EXPECT_EQ(skeletonization.report().number_of_tips, 3u);
  for (const auto packed : skeletonization.packed_separators()) {
    EXPECT_GE(skeletonization.polyline(skeletonization.separators()[packed]).size(), 3u);
  }
}

TEST(Archetypes, of_policies_with_several_threads)
{
  const Skeletonization_traits_archetype traits(shape());
  Visitor_archetype visitor;
  std::size_t number_of_weights = 0;
  CSCD::Curve_skeletonization<Skeletonization_traits_archetype, Policies_archetype, Visitor_archetype&> skeletonization(
      traits, Policies_archetype(number_of_weights), visitor);
  Skeleton_archetype skeleton;
  skeletonization.set_number_of_threads(2).operator()<CGAL::Parallel_if_available_tag>(skeleton);
  expect_partition(skeleton);
  EXPECT_EQ(skeletonization.report().number_of_tips, 3u);
  EXPECT_GT(visitor.number_of_calls(), 0u);
  EXPECT_GE(number_of_weights, skeletonization.report().number_of_separators);
}

TEST(Archetypes, of_levels_of_detail_for_the_local_finder)
{
  const Multiresolution_traits_archetype traits(shape());
  CSCD::Local_separator_finder<Multiresolution_traits_archetype> finder(traits);
  CSCD::Search_result result;
  finder(CSCD::test::nearest_vertex(traits.levels().finest().surface, {2, 0, 0.3}), 0, result);
  EXPECT_EQ(result.outcome, CSCD::Search_outcome::found);
}

/// The steps that see a body, and neither sites nor an input.
TEST(Archetypes, of_bodies_for_the_placement_of_nodes)
{
  using namespace CSCD::internal;
  const Solid_traits_archetype traits(CSCD::test::torus(3, 1, 24));
  std::vector<CSCD::Separator> separators;
  Separator_packing packing(traits.solid_surface(), separators, {});
  EXPECT_GE(cut_handles(traits, separators, packing), 1u);
  Skeleton_builder builder =
      Node_placement<Solid_traits_archetype>(traits, separators, packing.packed(), packing.cut_graph())();
  make_simple(builder);
  center_junctions(traits, builder);
  Branch_refinement<Solid_traits_archetype>(traits, builder)();
  Inside_repair<Solid_traits_archetype> repair(traits, builder);
  repair();
  EXPECT_EQ(repair.number_of_nodes_outside(), 0u);
  EXPECT_EQ(repair.number_of_edges_outside(), 0u);
}

} // namespace
