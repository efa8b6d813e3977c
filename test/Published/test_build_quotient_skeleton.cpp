// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The quotient graph of regions and the skeleton built of it.

#include "Separator/make_separator.h"
#include "Surface/to_surface.h"
#include "support/Shape_solid.h"
#include "support/name_of_shape.h"
#include "support/shapes.h"
#include <CSCD/Local_policies.h>
#include <CSCD/Options.h>
#include <CSCD/Points/Point_complex.h>
#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Published/Quotient_skeleton.h>
#include <CSCD/Published/Region_packing.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/flat_arrays.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace {

using CSCD::Embedded_skeleton;
using CSCD::Index;
using CSCD::Point_complex;
using CSCD::Separator;
using CSCD::Skeletonization_report;
using CSCD::Triangulated_surface;
using CSCD::Vector_3;
using CSCD::internal::Quotient_graph;
using CSCD::test::section_separator;
using CSCD::test::Shape;
using CSCD::test::Shape_solid;
using Meetings = std::vector<std::vector<Index>>;

struct Outcome
{
  Embedded_skeleton skeleton;
  Skeletonization_report report;
  std::size_t number_of_packed = 0;

  std::size_t number_of_edges() const
  {
    std::size_t count = 0;
    skeleton.graph.for_each_edge([&](Index, Index) { ++count; });
    return count;
  }
  std::size_t number_of_components() const
  {
    CSCD::internal::Disjoint_sets sets(skeleton.graph.size());
    std::size_t count = skeleton.graph.size();
    skeleton.graph.for_each_edge([&](Index a, Index b) { count -= sets.join(a, b) ? 1 : 0; });
    return count;
  }
  std::size_t betti_number() const { return number_of_edges() + number_of_components() - skeleton.graph.size(); }
};

/// The skeleton of the regions of the packed ones of `separators`.
Outcome skeletonize(const CSCD::Triangulated_solid& solid, const std::vector<Separator>& separators)
{
  Outcome outcome;
  const CSCD::internal::Region_packing packing(solid, separators, CSCD::Field_search_settings(), outcome.report);
  outcome.number_of_packed = packing.packed().size();
  outcome.skeleton = CSCD::internal::Quotient_skeleton_builder(solid, packing.regions())(outcome.report);
  return outcome;
}

/// The skeleton of the regions of packed local separators.
Outcome skeletonize(const CSCD::Triangulated_solid& solid)
{
  Skeletonization_report report;
  return skeletonize(solid, CSCD::Local_policies().find_separators(solid, CSCD::Options(), report, [](double) {}));
}

class Quotient_skeleton_test : public testing::TestWithParam<CSCD::test::Shape_maker>
{
};

TEST_P(Quotient_skeleton_test, has_the_topology_of_the_shape_and_partitions_the_vertices)
{
  const Shape shape = GetParam().make();
  const Shape_solid solid(shape);
  const Outcome outcome = skeletonize(*solid);
  EXPECT_EQ(outcome.number_of_components(), solid->number_of_components());
  EXPECT_EQ(outcome.betti_number(), solid->genus());
  EXPECT_EQ(outcome.report.number_of_nodes_outside, 0u);
  EXPECT_EQ(outcome.report.number_of_edges_outside, 0u);
  ASSERT_EQ(outcome.skeleton.node_of_vertex.size(), solid.surface().number_of_vertices());
  ASSERT_EQ(outcome.skeleton.radius.size(), outcome.skeleton.graph.size());
  std::vector<std::size_t> number_of_vertices(outcome.skeleton.graph.size(), 0);
  for (Index node : outcome.skeleton.node_of_vertex) {
    ++number_of_vertices.at(node);
  }
  std::size_t number_of_nodes_with_vertices = 0;
  for (Index node = 0; node < outcome.skeleton.graph.size(); ++node) {
    EXPECT_GT(outcome.skeleton.radius[node], 0);
    number_of_nodes_with_vertices += number_of_vertices[node] > 0 ? 1 : 0;
  }
  EXPECT_GE(number_of_nodes_with_vertices, outcome.number_of_packed);
}

INSTANTIATE_TEST_SUITE_P(Known, Quotient_skeleton_test, testing::ValuesIn(CSCD::test::shapes_with_known_skeleton()),
                         CSCD::test::name_of_shape);

TEST(Quotient_skeleton, of_a_tube_is_centred_and_has_its_radius)
{
  const Shape_solid solid(CSCD::test::tube(12, 1, 32, CSCD::test::Tube_end::flat));
  // Regions have whole vertices.
  constexpr double quarter_edge = 0.05;
  std::vector<Separator> separators;
  for (int i = 1; i < 12; ++i) {
    separators.push_back(section_separator(solid.surface(), solid.at(i, 0, 0), {1, 0, 0}, solid.at(i, 0, 1)));
  }
  const Outcome outcome = skeletonize(*solid, separators);
  ASSERT_EQ(outcome.number_of_packed, separators.size());
  ASSERT_GE(outcome.skeleton.graph.size(), separators.size());
  for (Index node = 0; node < outcome.skeleton.graph.size(); ++node) {
    const Vector_3 point = solid.to_shape(outcome.skeleton.graph[node].position);
    EXPECT_LT(std::hypot(point.y(), point.z()), quarter_edge);
    if (point.x() > 1.4 && point.x() < 10.6) { // the others own flat ends
      EXPECT_NEAR(solid.unit() * outcome.skeleton.radius[node], 1, quarter_edge);
    }
  }
}

/// The regions that `region(point)` makes of the vertices.
template <class Surface, class Region>
Meetings meetings(const Surface& surface, const Region& region)
{
  const Quotient_graph graph(surface, [&](Index vertex) { return region(surface.point(vertex)); });
  Meetings result = graph.meetings();
  for (std::vector<Index>& meeting : result) {
    std::sort(meeting.begin(), meeting.end());
  }
  std::sort(result.begin(), result.end());
  return result;
}

TEST(Quotient_graph, of_slices_of_a_tube_is_a_path)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::tube(10, 1, 16, CSCD::test::Tube_end::flat));
  const auto slice = [](const Vector_3& point) { return Index(std::clamp(point.x() / 2.5, 0., 3.)); };
  EXPECT_EQ(meetings(surface, slice), (Meetings{{0, 1}, {1, 2}, {2, 3}}));
}

TEST(Quotient_graph, of_slices_of_a_torus_is_a_cycle_even_of_two)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::torus(3, 1, 24));
  const auto sector = [](int number) {
    return [number](const Vector_3& point) {
      return Index(std::floor((std::atan2(point.y(), point.x()) / CSCD::test::pi + 1) / 2 * number * 0.999));
    };
  };
  EXPECT_EQ(meetings(surface, sector(2)), (Meetings{{0, 1}, {0, 1}}));
  EXPECT_EQ(meetings(surface, sector(3)), (Meetings{{0, 1}, {0, 2}, {1, 2}})) << "no junction: they meet in no face";
}

TEST(Quotient_graph, of_sectors_of_a_ball_is_one_junction)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::sphere(4));
  const auto sector = [](const Vector_3& point) {
    return Index(std::floor((std::atan2(point.y(), point.x()) / CSCD::test::pi + 1) / 2 * 3 * 0.999));
  };
  EXPECT_EQ(meetings(surface, sector), (Meetings{{0, 1, 2}}));
}

/// The faces of `surface` that have no vertex within `radius` of one of `centers`.
Point_complex with_holes(const Triangulated_surface& surface, const std::vector<Vector_3>& centers, double radius)
{
  std::vector<std::array<Index, 3>> triangles;
  for (Index face = 0; face < surface.number_of_faces(); ++face) {
    std::array<Index, 3> vertices{};
    bool is_kept = true;
    for (std::size_t k = 0; k < 3; ++k) {
      vertices[k] = surface.origin(3 * face + Index(k));
      for (const Vector_3& center : centers) {
        is_kept = is_kept && (surface.point(vertices[k]) - center).norm() > radius;
      }
    }
    if (is_kept) {
      triangles.push_back(vertices);
    }
  }
  std::vector<Vector_3> normals;
  for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
    normals.push_back(surface.vertex_normal(vertex));
  }
  return {std::vector<Vector_3>(surface.points()), std::move(normals), triangles};
}

/// Whether the graph of the parts of one color that are connected is a tree.
template <class Surface>
void expect_tree(const Surface& surface, const std::vector<unsigned>& color)
{
  CSCD::internal::Disjoint_sets regions(color.size());
  std::size_t number_of_regions = 0;
  for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
    number_of_regions += surface.outgoing(vertex).empty() ? 0 : 1;
  }
  for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
    const Index a = surface.origin(h);
    const Index b = surface.target(h);
    number_of_regions -= color[a] == color[b] && regions.join(a, b) ? 1 : 0;
  }
  const Quotient_graph graph(surface, [&](Index vertex) { return regions.find(vertex); });
  const Index number_of_meetings = Index(graph.meetings().size());
  CSCD::internal::Disjoint_sets joined(color.size() + number_of_meetings);
  for (Index i = 0; i < number_of_meetings; ++i) {
    EXPECT_GE(graph.meetings()[i].size(), 2u);
    for (Index region : graph.meetings()[i]) {
      EXPECT_TRUE(joined.join(region, Index(color.size()) + i)) << "a cycle";
      --number_of_regions;
    }
  }
  EXPECT_EQ(number_of_regions + number_of_meetings, 1u) << "not connected";
}

/// On a sphere everything is planar: for any regions and holes, the graph is a tree.
TEST(Quotient_graph, of_any_regions_of_a_sphere_is_a_tree)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::sphere(4));
  const Point_complex with_hole = with_holes(surface, {Vector_3::UnitX()}, 0.5);
  const Point_complex with_many = with_holes(surface, {Vector_3::UnitX(), Vector_3::UnitY(), -Vector_3::UnitZ()}, 0.2);
  std::mt19937 random(1);
  for (unsigned number_of_colors : {2U, 3U, 7U}) {
    for (int trial = 0; trial < 20; ++trial) {
      std::vector<unsigned> color(surface.number_of_vertices());
      std::generate(color.begin(), color.end(), [&] { return unsigned(random()) % number_of_colors; });
      expect_tree(surface, color);
      expect_tree(with_hole, color);
      expect_tree(with_many, color);
    }
  }
}

} // namespace
