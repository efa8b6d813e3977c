// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The library runs on minimal models of the concepts.

#include "archetypes/Policies_archetype.h"
#include "archetypes/Skeleton_archetype.h"
#include "archetypes/Skeletonization_traits_archetype.h"
#include "archetypes/Surface_archetype.h"
#include "archetypes/Triangle_mesh_archetype.h"
#include "archetypes/Visitor_archetype.h"
#include "support/Shape_solid.h"
#include "support/shapes.h"
#include <CSCD/Curve_skeletonization.h>
#include <CSCD/Local_policies.h>
#include <CSCD/Published_policies.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/concepts.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace {

using CSCD::Index, CSCD::Triangulated_solid, CSCD::Vector3, CSCD::test::Input_descriptor_archetype,
    CSCD::test::Point_archetype, CSCD::test::Policies_archetype, CSCD::test::Shape_solid,
    CSCD::test::Skeletonization_traits_archetype, CSCD::test::Surface_archetype, CSCD::test::Triangle_mesh_archetype,
    CSCD::test::Vertex_point_map_archetype, CSCD::test::Visitor_archetype;
using Skeleton_archetype = CSCD::test::Skeleton_archetype<Point_archetype, Input_descriptor_archetype>;
using Mesh_skeleton_archetype = CSCD::test::Skeleton_archetype<Point_archetype, Triangle_mesh_archetype::Vertex>;

CSCD::test::Shape shape()
{
  return CSCD::test::y_tube(0.25);
}

/// Expects every one of `number` vertices in one node.
template <class Skeleton>
void expect_partition(const Skeleton& skeleton, std::size_t number)
{
  std::vector<std::size_t> count(number, 0);
  const auto nodes = vertices(skeleton);
  for (auto node = nodes.first; node != nodes.second; ++node) {
    for (const auto& v : skeleton[*node].vertices) {
      ++count[v.number()];
    }
  }
  EXPECT_EQ(count, std::vector<std::size_t>(number, 1));
}

TEST(Archetypes, of_all_that_the_free_function_takes)
{
  const Triangle_mesh_archetype mesh(shape());
  Visitor_archetype visitor;
  Mesh_skeleton_archetype skeleton;
  const CSCD::Skeletonization_report report = CSCD::extract_curve_skeleton(
      mesh, skeleton, CSCD::parameters::vertex_point_map(Vertex_point_map_archetype(mesh)).visitor(std::ref(visitor)));
  EXPECT_EQ(report.number_of_tips, 3u);
  EXPECT_EQ(num_vertices(skeleton), report.number_of_nodes);
  EXPECT_EQ(num_edges(skeleton), report.number_of_edges);
  EXPECT_GT(visitor.number_of_calls(), 0u);
  EXPECT_FALSE(CSCD::has_radius_v<Mesh_skeleton_archetype>);
  expect_partition(skeleton, shape().points.size());
}

TEST(Archetypes, of_traits_for_the_local_method_step_by_step)
{
  const Shape_solid solid(shape());
  const Skeletonization_traits_archetype<Triangulated_solid> traits(*solid);
  CSCD::Curve_skeletonization skeletonization(traits);
  EXPECT_GT(skeletonization.find_separators(), 0u);
  EXPECT_GT(skeletonization.pack_separators(), 0u);
  Skeleton_archetype skeleton;
  skeletonization.convert_to_skeleton(skeleton);
  expect_partition(skeleton, traits.surface().triangulation().number_of_vertices());
  EXPECT_EQ(skeletonization.report().number_of_tips, 3u);
  for (const auto packed : skeletonization.packed_separators()) {
    EXPECT_GE(skeletonization.polyline(skeletonization.separators()[packed]).size(), 3u);
  }
}

/// The torus around the z axis with radii 3 and 1.
TEST(Archetypes, of_surfaces_for_the_published_method)
{
  const auto nearest_of_middle = [](const Vector3& p) {
    const Vector3 on_circle = 3 * Vector3(p.x(), p.y(), 0).stableNormalized();
    return on_circle.norm() > 0 ? on_circle : Vector3(3, 0, 0);
  };
  const Surface_archetype torus(CSCD::test::torus(3, 1, 24), nearest_of_middle, 1);
  const Skeletonization_traits_archetype<Surface_archetype> traits(torus);
  CSCD::Curve_skeletonization skeletonization(traits, CSCD::Published_policies());
  skeletonization.set_maximum_number_of_sources(96);
  Skeleton_archetype skeleton;
  const CSCD::Skeletonization_report& report = skeletonization.run(skeleton);
  EXPECT_EQ(report.number_of_sources, 96u);
  EXPECT_GT(report.number_of_separators, 48u);
  EXPECT_GE(report.number_of_packed_separators, 3u);
  EXPECT_EQ(report.number_of_skeleton_components, 1u);
  EXPECT_EQ(report.betti_number, 1u);
  EXPECT_EQ(report.number_of_tips, 0u);
  EXPECT_EQ(report.number_of_nodes_outside, 0u);
  EXPECT_EQ(report.number_of_edges_outside, 0u);
  expect_partition(skeleton, torus.triangulation().number_of_vertices());
  const auto nodes = vertices(skeleton);
  for (auto node = nodes.first; node != nodes.second; ++node) {
    const Point_archetype& p = skeleton[*node].point; // at twice the size
    EXPECT_NEAR(std::hypot(p.x(), p.y()), 6, 1);
    EXPECT_NEAR(p.z(), 0, 0.5);
  }
}

TEST(Archetypes, of_surfaces_in_two_components_for_the_published_method)
{
  const double length = 8;
  const CSCD::test::Shape tube = CSCD::test::tube(length, 1, 20, CSCD::test::Tube_end::flat);
  const Surface_archetype tubes(
      CSCD::test::merged("two tubes", {tube, CSCD::test::translated(tube, {0, 0, 10})}),
      [length](const Vector3& p) { return Vector3(std::clamp(p.x(), 0., length), 0, p.z() < 5 ? 0 : 10); }, 1);
  const Skeletonization_traits_archetype<Surface_archetype> traits(tubes);
  CSCD::Curve_skeletonization skeletonization(traits, CSCD::Published_policies());
  skeletonization.set_maximum_number_of_sources(96);
  Skeleton_archetype skeleton;
  const CSCD::Skeletonization_report& report = skeletonization.run(skeleton);
  EXPECT_EQ(report.number_of_skeleton_components, 2u);
  EXPECT_EQ(report.betti_number, 0u);
  EXPECT_EQ(report.number_of_tips, 4u);
  expect_partition(skeleton, tubes.triangulation().number_of_vertices());
}

TEST(Archetypes, of_policies_for_any_surface)
{
  const Surface_archetype torus(
      CSCD::test::torus(3, 1, 24), [](const Vector3& p) { return p; }, 1);
  const Skeletonization_traits_archetype<Surface_archetype> traits(torus);
  CSCD::Curve_skeletonization skeletonization(traits, Policies_archetype<Surface_archetype>(7));
  Skeleton_archetype skeleton;
  const CSCD::Skeletonization_report& report = skeletonization.run(skeleton);
  EXPECT_EQ(report.number_of_sources, 1u);
  EXPECT_EQ(report.number_of_packed_separators, 1u);
  EXPECT_EQ(report.number_of_nodes, 1u);
  EXPECT_EQ(report.number_of_skeleton_components, 1u);
  EXPECT_EQ(skeleton[*vertices(skeleton).first].point.z(), 6);
  EXPECT_EQ(skeletonization.polyline(skeletonization.separators().front()).size(), 6u);
  expect_partition(skeleton, torus.triangulation().number_of_vertices());
}

} // namespace
