// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nodes and edges that are outside of the body come back in, and do not go far below the surface for it.

#include "Skeleton/make_branch.h"
#include "support/Shape_solid.h"
#include "support/shapes.h"
#include <CSCD/Skeleton/Inside_routing.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Skeleton_builder;
using CSCD::Vector_3;
using CSCD::internal::Inside_routing;
using CSCD::test::make_branch;
using CSCD::test::Shape_solid;

/// A body whose nearest surface leads nowhere, as where it cuts itself; counts the lines that are traced.
struct Unhelpful_solid
{
  const CSCD::Triangulated_surface& triangulation() const { return (*solid)->triangulation(); }
  bool is_inside(const Vector_3& point) const { return (*solid)->is_inside(point); }
  std::optional<Vector_3> middle_behind(const Vector_3&) const { return std::nullopt; }
  void crossings(const Vector_3& from, const Vector_3& to, std::vector<double>& distances) const
  {
    ++number_of_lines;
    (*solid)->crossings(from, to, distances);
  }

  const Shape_solid* solid;
  mutable std::size_t number_of_lines = 0;
};

/// Moves and leads all inside, and expects that nothing is left outside and that the branch stays one.
void expect_inside(const Shape_solid& solid, Skeleton_builder& builder)
{
  Inside_routing routing(*solid, builder);
  routing.bring_inside();
  routing.route_edges();
  const auto outside = routing.count_outside();
  EXPECT_EQ(outside.number_of_nodes, 0u);
  EXPECT_EQ(outside.number_of_edges, 0u);
  for (Index node = 0; node < builder.size(); ++node) {
    EXPECT_TRUE(solid->is_inside(builder[node].position)) << node;
  }
  EXPECT_EQ(builder.edges().size() + 1, builder.size());
}

/// The point of the axis of a tube bent around the z axis.
Vector_3 at_angle(double angle, double radius = 3)
{
  return {radius * std::cos(angle), radius * std::sin(angle), 0};
}

TEST(Inside_routing, brings_nodes_and_edges_into_a_bend)
{
  const Shape_solid solid(CSCD::test::bent_tube(3, 3, 0.6, 24));
  Skeleton_builder builder = make_branch(solid, {at_angle(0.2), at_angle(1.5, 4), at_angle(2.8)}, 0.6);
  const auto outside = Inside_routing(*solid, builder).count_outside();
  EXPECT_EQ(outside.number_of_nodes, 1u);
  EXPECT_EQ(outside.number_of_edges, 2u);
  expect_inside(solid, builder);
  EXPECT_GT(builder.size(), 3u) << "straight edges leave a bend";
}

TEST(Inside_routing, leads_an_edge_along_the_surface)
{
  const Shape_solid solid(CSCD::test::bent_tube(3, 3, 0.6, 24));
  Skeleton_builder builder = make_branch(solid, {at_angle(0.2), at_angle(2.8)}, 0.6);
  expect_inside(solid, builder);
  EXPECT_LT(builder.size(), 14u) << "far points are seen";
}

TEST(Inside_routing, brings_a_tip_inside)
{
  const Shape_solid solid(CSCD::test::horned_ball(0.1));
  Skeleton_builder builder = make_branch(solid, {{0, 0, 0}, {0, 0, 3.2}}, 0.2);
  EXPECT_EQ(Inside_routing(*solid, builder).count_outside().number_of_nodes, 1u);
  expect_inside(solid, builder);
}

TEST(Inside_routing, leads_an_edge_around_a_notch_and_not_into_the_ball)
{
  const Shape_solid solid(CSCD::test::horned_ball(0.1));
  Skeleton_builder builder = make_branch(solid, {{-0.4, 0, 3.12}, {0.4, 0, 3.12}}, 0.2);
  EXPECT_EQ(Inside_routing(*solid, builder).count_outside().number_of_edges, 1u);
  expect_inside(solid, builder);
  EXPECT_GT(builder.size(), 2u);
  for (Index node = 0; node < builder.size(); ++node) {
    EXPECT_GT(solid.to_shape(builder[node].position).z(), 2.1) << node << ": an edge below the surface";
  }
}

TEST(Inside_routing, goes_around_a_mouth_without_going_deep_into_the_body)
{
  // A bar with a slit in its end. The back of the slit looks along the whole bar.
  const Shape_solid solid(CSCD::test::midpoint_subdivided(
      CSCD::test::prism(
          "bar with a slit",
          {{0, 0, 0}, {10, 0, 0}, {10, 0.45, 0}, {9, 0.45, 0}, {9, 0.55, 0}, {10, 0.55, 0}, {10, 1, 0}, {0, 1, 0}},
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 7}, {4, 5, 7}, {5, 6, 7}}),
      3));
  const std::vector<Vector_3> way =
      CSCD::internal::Way_inside(*solid).find(solid.at(9.8, 0.2, 0.5), solid.at(9.8, 0.8, 0.5));
  ASSERT_FALSE(way.empty());
  for (const Vector_3& point : way) {
    EXPECT_TRUE(solid->is_inside(point));
    EXPECT_GT(point.x(), solid.at(8, 0, 0).x());
  }
}

TEST(Inside_routing, traces_few_lines_where_many_edges_are_outside)
{
  const Shape_solid shape(CSCD::test::capsule(6, 1, 24));
  const Unhelpful_solid solid{&shape};
  std::vector<Vector_3> points;
  constexpr std::size_t number = 100;
  for (std::size_t i = 0; i < number; ++i) {
    points.emplace_back(6. * double(i) / double(number), i % 2 == 0 ? 0 : 3, 0);
  }
  Skeleton_builder builder = make_branch(shape, points, 1);
  Inside_routing routing(solid, builder);
  routing.bring_inside();
  routing.route_edges();
  EXPECT_LT(solid.number_of_lines, 10 * number);
  EXPECT_EQ(routing.count_outside().number_of_edges, number - 1);
}

} // namespace
