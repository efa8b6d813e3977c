// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Branches move to the middle of the body, stay inside, and do not turn back.

#include "Skeleton/make_branch.h"
#include "support/Shape_solid.h"
#include "support/shapes.h"
#include <CSCD/Skeleton/Branch_relaxation.h>
#include <CSCD/Skeleton/Inside_routing.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Skeleton_builder;
using CSCD::Vector_3;
using CSCD::internal::Branch_division;
using CSCD::internal::Branch_relaxation;
using CSCD::internal::Inside_routing;
using CSCD::test::make_branch;
using CSCD::test::Shape_solid;

/// A capsule from 0 to 6 along the x axis, of radius 1.
class Branch_in_capsule : public testing::Test
{
protected:
  /// The largest distance of the node inside the branch from the axis.
  double max_offset(const Skeleton_builder& builder) const
  {
    double result = 0;
    for (Index node = 0; node < builder.size(); ++node) {
      const Vector_3 point = m_solid.to_shape(builder[node].position);
      result = builder.is_regular(node) ? std::max(result, std::hypot(point.y(), point.z())) : result;
    }
    return result;
  }

  void divide(Skeleton_builder& builder) const
  {
    Inside_routing routing(*m_solid, builder);
    Branch_division(routing, builder)();
    builder.compact();
  }

  Shape_solid m_solid{CSCD::test::capsule(6, 1, 48)};
};

TEST_F(Branch_in_capsule, moves_to_the_axis)
{
  Skeleton_builder builder = make_branch(
      m_solid, {{1, 0, 0}, {1.6, 0.2, 0}, {2.2, 0.2, 0.1}, {2.8, 0.2, 0.1}, {3.4, 0.2, 0.1}, {4, 0.2, 0}, {5, 0, 0}},
      1);
  Branch_relaxation(*m_solid, builder)();
  EXPECT_LT(max_offset(builder), 0.03);
}

TEST_F(Branch_in_capsule, keeps_its_ends)
{
  Skeleton_builder builder = make_branch(m_solid, {{1, 0, 0.3}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0.3}}, 1);
  const Skeleton_builder before = builder;
  Branch_relaxation(*m_solid, builder)();
  EXPECT_EQ(builder[0].position, before[0].position);
  EXPECT_EQ(builder[4].position, before[4].position);
}

TEST_F(Branch_in_capsule, turns_back_no_more)
{
  for (const std::vector<Vector_3>& points :
       {std::vector<Vector_3>{{1, 0, 0}, {2, 0, 0}, {3, 0.1, 0}, {2.6, -0.1, 0}, {4, 0, 0}, {5, 0, 0}},
        std::vector<Vector_3>{{1, 0, 0}, {2, 0, 0}, {1.9, 0.5, 0}, {3, 0.1, 0}, {4, 0, 0}}}) {
    Skeleton_builder builder = make_branch(m_solid, points, 1);
    Branch_relaxation(*m_solid, builder)();
    for (Index node = 1; node + 1 < builder.size(); ++node) {
      const Vector_3 in = builder[node].position - builder[node - 1].position;
      const Vector_3 out = builder[node + 1].position - builder[node].position;
      EXPECT_GE(in.dot(out), 0) << node;
    }
  }
}

TEST_F(Branch_in_capsule, has_nodes_at_most_half_a_radius_apart)
{
  Skeleton_builder builder = make_branch(m_solid, {{0.5, 0, 0}, {2.5, 0, 0}, {5.5, 0, 0}}, 1);
  for (Index node = 0; node < builder.size(); ++node) {
    builder[node].number_of_vertices = 1000;
  }
  divide(builder);
  for (const auto& [a, b] : builder.edges()) {
    EXPECT_LE(builder.edge_length(a, b) * m_solid.unit(), 0.5 + 1e-9);
  }
}

TEST_F(Branch_in_capsule, loses_nodes_that_own_few_vertices_until_the_others_own_enough)
{
  const auto with_counts = [this](const std::vector<Vector_3>& points, double number) {
    Skeleton_builder builder = make_branch(m_solid, points, 1);
    for (Index node = 0; node < builder.size(); ++node) {
      builder[node].number_of_vertices = number;
    }
    divide(builder);
    return builder.size();
  };
  EXPECT_EQ(with_counts({{1, 0, 0}, {1.3, 0, 0}, {1.6, 0, 0}, {1.9, 0, 0}, {2.2, 0, 0}, {2.5, 0, 0}}, 5), 3u)
      << "with what its neighbors owned, one owns enough";
  EXPECT_EQ(with_counts({{1, 0, 0}, {2.5, 0, 0}, {4, 0, 0}}, 0), 5u) << "edges are no longer than the radius";
}

TEST(Branch_relaxation, stays_inside_a_notched_body)
{
  const Shape_solid solid(CSCD::test::horned_ball(0.1));
  // From horn to horn below the surface of the ball: to go half way to the line between the ends would leave it.
  Skeleton_builder builder = make_branch(solid, {{-0.4, 0, 3.15}, {0, 0, 2.7}, {0.4, 0, 3.15}}, 0.2);
  Branch_relaxation(*solid, builder)();
  EXPECT_EQ(Inside_routing(*solid, builder).count_outside().number_of_edges, 0u);
}

} // namespace
