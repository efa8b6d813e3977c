// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons of regions: their topology, their position, and what belongs to their nodes.

#include "archetypes/Skeletonization_traits_archetype.h"
#include "support/name_of_shape.h"
#include "support/shapes.h"
#include <CSCD/Local_policies.h>
#include <CSCD/Selection/Region_packing.h>
#include <CSCD/Selection/Search_settings.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeleton/build_quotient_skeleton.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/internal/Disjoint_sets.h>
#include <CSCD/Vector_3.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using CSCD::Embedded_skeleton;
using CSCD::Separator;
using CSCD::Skeletonization_report;
using CSCD::Index;
using CSCD::Vector_3;
using CSCD::test::Shape;
using CSCD::test::Skeletonization_traits_archetype;

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

/// The skeleton of the regions of packed local separators.
Outcome skeletonize(const Skeletonization_traits_archetype& traits)
{
  Outcome outcome;
  const CSCD::Local_policies<Skeletonization_traits_archetype> policies;
  const std::vector<Separator> separators =
      policies.find_separators<CGAL::Sequential_tag>(traits, CSCD::Search_settings(), outcome.report, [](double) {});
  const CSCD::internal::Region_packing packing(traits, separators, outcome.report);
  outcome.number_of_packed = packing.packed().size();
  outcome.skeleton = CSCD::internal::Quotient_skeleton_builder<Skeletonization_traits_archetype>(
      traits, packing.regions())(outcome.report);
  return outcome;
}

class Quotient_skeleton_test : public testing::TestWithParam<CSCD::test::Shape_maker>
{
};

TEST_P(Quotient_skeleton_test, has_the_topology_of_the_shape_and_partitions_the_sites)
{
  const Shape shape = GetParam().make();
  const Skeletonization_traits_archetype traits(shape);
  const Outcome outcome = skeletonize(traits);
  EXPECT_EQ(outcome.number_of_components(), traits.number_of_components());
  EXPECT_EQ(outcome.betti_number(), traits.genus());
  EXPECT_EQ(outcome.report.number_of_nodes_outside, 0u);
  EXPECT_EQ(outcome.report.number_of_edges_outside, 0u);
  ASSERT_EQ(outcome.skeleton.node_of_vertex.size(), traits.number_of_sites());
  ASSERT_EQ(outcome.skeleton.radius.size(), outcome.skeleton.graph.size());
  std::vector<std::size_t> number_of_sites(outcome.skeleton.graph.size(), 0);
  for (Index node : outcome.skeleton.node_of_vertex) {
    ++number_of_sites.at(node);
  }
  std::size_t number_of_nodes_with_sites = 0;
  for (Index node = 0; node < outcome.skeleton.graph.size(); ++node) {
    EXPECT_GT(outcome.skeleton.radius[node], 0);
    number_of_nodes_with_sites += number_of_sites[node] > 0 ? 1 : 0;
  }
  EXPECT_GE(number_of_nodes_with_sites, outcome.number_of_packed);
}

INSTANTIATE_TEST_SUITE_P(Known, Quotient_skeleton_test, testing::ValuesIn(CSCD::test::shapes_with_known_skeleton()),
                         CSCD::test::name_of_shape);

TEST(Quotient_skeleton, of_a_tube_is_centred_and_has_its_radius)
{
  const Skeletonization_traits_archetype traits(CSCD::test::tube(12, 1, 32, CSCD::test::Tube_end::flat));
  const Outcome outcome = skeletonize(traits);
  ASSERT_GE(outcome.skeleton.graph.size(), 8u);
  double sum = 0;
  for (Index node = 0; node < outcome.skeleton.graph.size(); ++node) {
    const auto point = traits.to_input_point(outcome.skeleton.graph[node].position);
    const double offset = std::hypot(point.y(), point.z());
    sum += offset;
    if (point.x() > 1.5 && point.x() < 10.5) {
      EXPECT_LT(offset, 0.25) << "the borders of regions between separators that are not parallel are slanted";
      EXPECT_NEAR(traits.to_input_length(outcome.skeleton.radius[node]), 1, 0.1);
    }
  }
  EXPECT_LT(sum / outcome.skeleton.graph.size(), 0.1);
}

TEST(Quotient_skeleton, of_what_has_no_separator_is_a_node)
{
  const Skeletonization_traits_archetype traits(CSCD::test::tetrahedron());
  Skeletonization_report report;
  const CSCD::internal::Region_packing packing(traits, {}, report);
  const Embedded_skeleton skeleton =
      CSCD::internal::Quotient_skeleton_builder<Skeletonization_traits_archetype>(traits, packing.regions())(report);
  ASSERT_EQ(skeleton.graph.size(), 1u);
  EXPECT_TRUE(traits.is_inside(skeleton.graph[0].position));
  EXPECT_EQ(skeleton.node_of_vertex, std::vector<Index>(traits.number_of_sites(), 0));
}

} // namespace
