// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From packed separators to placed nodes on a tube: regions, pieces, nodes, refinement, repair, and the vertices of
// each node.

#include "Separator/make_separator.h"
#include "support/Shape_solid.h"
#include "support/shapes.h"
#include <CSCD/Packing/Separator_packing.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Branch_refinement.h>
#include <CSCD/Skeleton/Inside_repair.h>
#include <CSCD/Skeleton/Node_placement.h>
#include <CSCD/Skeleton/Rim_trimming.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeleton/Vertex_assignment.h>
#include <CSCD/Skeleton/place_junctions.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Separator;
using CSCD::Skeleton_builder;
using CSCD::Vector_3;
using CSCD::test::Shape_solid;

/// A body from which the nearest surface leads nowhere, as where it cuts itself; counts the lines that are traced.
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

/// A capsule with sections across it; in normalized coordinates, as all that is tested here.
class Node_placement : public testing::Test
{
protected:
  Node_placement()
  {
    for (double x : {1.01, 3.02, 5.03}) {
      m_separators.push_back(CSCD::test::section_separator(m_solid.surface(), at(x), {1, 0, 0}, at(x)));
      m_weights.push_back(x);
    }
  }

  /// The point of the axis at `x` in the coordinates of the shape, from 0 to 6.
  Vector_3 at(double x) const { return {(x - 3) / m_unit, 0, 0}; }

  Shape_solid m_solid{CSCD::test::capsule(6, 1, 24)};
  double m_unit = m_solid.unit();
  std::vector<Separator> m_separators;
  std::vector<double> m_weights;
};

TEST_F(Node_placement, regions_are_of_the_nearest_separator)
{
  const CSCD::internal::Surface_regions regions(m_solid->levels(), m_separators, {0, 1, 2},
                                                CSCD::internal::Surface_regions::precise_size);
  const auto& surface = regions.level().surface;
  for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
    const double x = m_unit * surface.point(vertex).x() + 3;
    // Beside the borders of the regions, in the middles between the separators.
    if (std::fabs(x - 2) > 0.3 && std::fabs(x - 4) > 0.3) {
      ASSERT_EQ(regions.separator(vertex), x < 2 ? 0u : x < 4 ? 1u : 2u);
    }
    const double distance = m_unit * double(regions.distance(vertex));
    if (x > 1 && x < 5) {
      const double straight = std::fabs(x - (x < 2 ? 1.01 : x < 4 ? 3.02 : 5.03));
      ASSERT_GE(distance, straight - 0.35);
      ASSERT_LE(distance, 1.4 * straight + 0.35);
    }
  }
}

TEST_F(Node_placement, pieces_hold_each_vertex_once)
{
  const CSCD::internal::Separator_packing packing(m_solid.surface(), m_separators, m_weights);
  const CSCD::internal::Surface_regions regions(m_solid->levels(), m_separators, packing.packed(),
                                                CSCD::internal::Surface_regions::precise_size);
  const CSCD::internal::Surface_pieces pieces(packing.cut_graph(), regions);
  std::vector<int> times(regions.level().surface.number_of_vertices(), 0);
  double weight = 0;
  for (Index piece = 0; piece < packing.cut_graph().pieces().size(); ++piece) {
    EXPECT_FALSE(pieces.vertices(piece).empty());
    EXPECT_GT(pieces.limb_end(piece).height(), 0.f);
    weight += pieces.area_sum(piece).weight;
    for (Index vertex : pieces.vertices(piece)) {
      ++times[vertex];
      EXPECT_EQ(packing.cut_graph().piece_of_vertex(regions.level().to_finest(vertex)), piece);
    }
  }
  EXPECT_EQ(times, std::vector<int>(times.size(), 1));
  EXPECT_NEAR(weight, 1, 1e-4);
}

TEST_F(Node_placement, gives_a_path_with_tips_on_the_axis)
{
  const CSCD::internal::Separator_packing packing(m_solid.surface(), m_separators, m_weights);
  CSCD::internal::Node_placement placement(*m_solid, m_separators, packing.packed(), packing.cut_graph());
  Skeleton_builder builder = placement();
  ASSERT_EQ(builder.size(), 5u);
  for (Index node = 0; node < builder.size(); ++node) {
    EXPECT_LT(m_unit * std::hypot(builder[node].position.y(), builder[node].position.z()), 0.05);
    EXPECT_NEAR(m_unit * builder[node].radius, 1, 0.05);
    EXPECT_TRUE(m_solid->is_inside(builder[node].position));
    EXPECT_EQ(builder.degree(node), builder[node].separators.empty() ? 1u : 2u);
  }
  CSCD::internal::Branch_refinement(*m_solid, builder)();
  builder.compact();
  EXPECT_GT(builder.size(), 8u);
  std::size_t edges = 0;
  builder.for_each_edge([&](Index a, Index b) {
    ++edges;
    EXPECT_LT(m_unit * builder.edge_length(a, b), 1.1);
  });
  EXPECT_EQ(edges + 1, builder.size());
  for (Index node = 0; node < builder.size(); ++node) {
    EXPECT_LT(m_unit * std::hypot(builder[node].position.y(), builder[node].position.z()), 0.05);
  }
  // Every vertex belongs to the nearest node, and the radius is that of the capsule.
  const CSCD::internal::Vertex_assignment assignment(m_solid.surface(), packing.cut_graph(), builder);
  const std::vector<double> radii = assignment.radii();
  for (Index vertex = 0; vertex < m_solid.surface().number_of_vertices(); ++vertex) {
    ASSERT_LT(assignment.node(vertex), builder.size());
    const double distance = (builder[assignment.node(vertex)].position - m_solid.surface().point(vertex)).norm();
    for (Index node = 0; node < builder.size(); ++node) {
      ASSERT_LE(distance, (builder[node].position - m_solid.surface().point(vertex)).norm() + 1e-12);
    }
  }
  for (Index node = 0; node < builder.size(); ++node) {
    // The end of the curve lies in the hemisphere, some of which is nearer than the wall of the tube.
    EXPECT_NEAR(m_unit * radii[node], 1, builder.degree(node) == 1 ? 0.25 : 0.1);
  }
}

TEST_F(Node_placement, gives_a_component_without_separators_a_node_inside)
{
  const CSCD::internal::Separator_packing packing(m_solid.surface(), {}, {});
  const std::vector<Separator> none;
  CSCD::internal::Node_placement placement(*m_solid, none, packing.packed(), packing.cut_graph());
  const Skeleton_builder builder = placement();
  EXPECT_EQ(builder.size(), 3u) << "a node in the middle and two tips, since the body is long";
  for (Index node = 0; node < builder.size(); ++node) {
    EXPECT_TRUE(m_solid->is_inside(builder[node].position));
  }
}

TEST_F(Node_placement, centers_a_junction_in_the_body)
{
  Skeleton_builder builder;
  const Index junction = builder.add_node(at(3) + Vector_3(0, 0.7 / m_unit, 0), 0.1);
  for (double x : {1., 3., 5.}) {
    builder.add_edge(junction, builder.add_node(at(x), 1 / m_unit));
  }
  const Vector_3 tip = builder[1].position;
  CSCD::internal::Junction_centering(*m_solid, builder)();
  EXPECT_LT(m_unit * std::hypot(builder[junction].position.y(), builder[junction].position.z()), 0.1);
  EXPECT_NEAR(m_unit * builder[junction].radius, 1, 0.1);
  EXPECT_EQ(builder[1].position, tip) << "only junctions move";
}

/// A branch along the x axis to x = `end`, and from there to a tip at (`x`, `y`, 0); its radius is 0.5.
Skeleton_builder branch_with_end(const Shape_solid& solid, double end, double x, double y)
{
  Skeleton_builder builder;
  for (double place : {end - 1, end - 0.5, end}) {
    const Index node = builder.add_node(solid.at(place, 0, 0), 0.5 / solid.unit());
    if (node > 0) {
      builder.add_edge(node - 1, node);
    }
  }
  builder.add_edge(2, builder.add_node(solid.at(x, y, 0), 0.5 / solid.unit()));
  return builder;
}

TEST(Rim_trimming, cuts_off_what_leads_into_a_rim)
{
  const std::vector<CSCD::test::Triple> places = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {4.3, 0, 0}};
  const Shape_solid trumpet(
      CSCD::test::swept_shape("trumpet", places, {0.5, 0.5, 0.5, 0.5, 0.5, 1.5}, 32, CSCD::test::Tube_end::flat));
  Skeleton_builder into_rim = branch_with_end(trumpet, 4, 4.2, 0.6);
  CSCD::internal::Rim_trimming(*trumpet, into_rim)();
  into_rim.compact();
  EXPECT_EQ(into_rim.size(), 3u);
  EXPECT_EQ(into_rim.degree(2), 1u);
  Skeleton_builder ahead = branch_with_end(trumpet, 3.5, 4.2, 0.2);
  CSCD::internal::Rim_trimming(*trumpet, ahead)();
  EXPECT_EQ(ahead.degree(3), 1u) << "goes on";
}

TEST(Rim_trimming, keeps_feet)
{
  const Shape_solid leg(
      CSCD::test::limb_shape("leg", {{{0, 0, 0}, {4, 0, 0}, 0.5, 0.5}, {{4, 0, 0}, {4, 0.8, 0}, 0.5, 0.5}}, 0.15));
  Skeleton_builder builder = branch_with_end(leg, 3.9, 4, 0.65);
  CSCD::internal::Rim_trimming(*leg, builder)();
  EXPECT_EQ(builder.degree(3), 1u);
}

TEST(Inside_repair, brings_nodes_and_edges_back_into_the_body)
{
  const Shape_solid solid(CSCD::test::bent_tube(3, 3, 0.6, 24));
  const double unit = solid.unit();
  const auto normalized = [&](double angle, double radius) {
    return solid.at(radius * std::cos(angle), radius * std::sin(angle), 0);
  };
  Skeleton_builder builder;
  const Index first = builder.add_node(normalized(0.2, 3), 0.6 / unit);
  const Index outside = builder.add_node(normalized(1.5, 4), 0.6 / unit);
  const Index last = builder.add_node(normalized(2.8, 3), 0.6 / unit);
  builder.add_edge(first, outside);
  builder.add_edge(outside, last);
  ASSERT_FALSE(solid->is_inside(builder[outside].position));
  CSCD::internal::Inside_repair repair(*solid, builder);
  EXPECT_EQ(repair.number_of_nodes_outside(), 1u);
  EXPECT_EQ(repair.number_of_edges_outside(), 2u);
  repair();
  EXPECT_EQ(repair.number_of_nodes_outside(), 0u);
  EXPECT_EQ(repair.number_of_edges_outside(), 0u);
  EXPECT_GT(builder.size(), 3u) << "straight edges leave a bend";
  std::size_t edges = 0;
  builder.for_each_edge([&](Index, Index) { ++edges; });
  EXPECT_EQ(edges + 1, builder.size());
}

TEST(Inside_repair, ends_branches_before_tips_that_stay_outside)
{
  const Shape_solid solid(CSCD::test::tube(6, 1, 24, CSCD::test::Tube_end::flat));
  Skeleton_builder builder;
  const Index first = builder.add_node(solid.at(2, 0, 0), 1 / solid.unit());
  const Index middle = builder.add_node(solid.at(4, 0, 0), 1 / solid.unit());
  // No sheet is so near to them that they could be brought back.
  const Index outside = builder.add_node(solid.at(9, 0, 0), 0.01 / solid.unit());
  const Index tip = builder.add_node(solid.at(12, 0, 0), 0.01 / solid.unit());
  builder.add_edge(first, middle);
  builder.add_edge(middle, outside);
  builder.add_edge(outside, tip);
  builder[outside].is_on_sheet = true;
  builder[tip].is_on_sheet = true;
  builder[tip].pieces = {7};
  CSCD::internal::Inside_repair repair(*solid, builder);
  ASSERT_EQ(repair.number_of_nodes_outside(), 2u);
  repair.draw_back_tips();
  EXPECT_EQ(repair.number_of_nodes_outside(), 0u);
  EXPECT_EQ(repair.number_of_edges_outside(), 0u);
  EXPECT_EQ(builder.degree(middle), 1u) << "the tip now";
  EXPECT_EQ(builder[middle].pieces, std::vector<Index>{7});
}

TEST(Inside_repair, leads_an_edge_along_the_surface)
{
  const Shape_solid solid(CSCD::test::bent_tube(3, 3, 0.6, 24));
  Skeleton_builder builder;
  const Index first = builder.add_node(solid.at(3 * std::cos(0.2), 3 * std::sin(0.2), 0), 0.6 / solid.unit());
  const Index last = builder.add_node(solid.at(3 * std::cos(2.8), 3 * std::sin(2.8), 0), 0.6 / solid.unit());
  const std::vector<Vector_3> way =
      CSCD::internal::Way_inside(*solid).find(builder[first].position, builder[last].position);
  ASSERT_FALSE(way.empty());
  EXPECT_LT(way.size(), 12u) << "far ones are seen";
  builder.add_edge(first, last);
  Index previous = first;
  for (const Vector_3& point : way) {
    previous = builder.split_edge(previous, last, point, 0);
  }
  EXPECT_EQ(CSCD::internal::Inside_repair(*solid, builder).number_of_nodes_outside(), 0u);
  EXPECT_EQ(CSCD::internal::Inside_repair(*solid, builder).number_of_edges_outside(), 0u);
}

TEST(Inside_repair, leads_an_edge_around_a_mouth_without_going_deep_into_the_body)
{
  // A bar with a slit in its end, of which the back looks along the whole bar.
  const Shape_solid solid(CSCD::test::midpoint_subdivided(
      CSCD::test::prism(
          "bar with a slit",
          {{0, 0, 0}, {10, 0, 0}, {10, 0.45, 0}, {9, 0.45, 0}, {9, 0.55, 0}, {10, 0.55, 0}, {10, 1, 0}, {0, 1, 0}},
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 7}, {4, 5, 7}, {5, 6, 7}}),
      3));
  const Vector_3 from = solid.at(9.8, 0.2, 0.5);
  const Vector_3 to = solid.at(9.8, 0.8, 0.5);
  const std::vector<Vector_3> way = CSCD::internal::Way_inside(*solid).find(from, to);
  ASSERT_FALSE(way.empty());
  for (const Vector_3& point : way) {
    EXPECT_TRUE(solid->is_inside(point));
    EXPECT_GT(point.x(), solid.at(8, 0, 0).x());
  }
}

TEST(Inside_repair, traces_few_lines_where_many_edges_are_outside)
{
  const Shape_solid shape(CSCD::test::capsule(6, 1, 24));
  const Unhelpful_solid solid{&shape};
  Skeleton_builder builder;
  constexpr Index number = 100;
  for (Index i = 0; i < number; ++i) {
    builder.add_node(shape.at(6. * i / number, i % 2 == 0 ? 0 : 3, 0), 1 / shape.unit());
    if (i > 0) {
      builder.add_edge(i - 1, i);
    }
  }
  CSCD::internal::Inside_repair repair(solid, builder);
  repair();
  EXPECT_LT(solid.number_of_lines, std::size_t(10) * number) << "of the rounds";
  EXPECT_EQ(repair.number_of_edges_outside(), number - 1);
}

} // namespace
