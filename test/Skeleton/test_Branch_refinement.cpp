// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nodes of branches move to the middle of the body, and branches do not fold back.

#include "Skeleton/make_branch.h"
#include "support/Shape_solid.h"
#include "support/shapes.h"
#include <CSCD/Skeleton/Branch_refinement.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Skeleton_builder;
using CSCD::Vector_3;
using CSCD::test::Shape_solid;

/// A capsule from 0 to 6 along the x axis, of radius 1.
class Branch_in_capsule : public testing::Test
{
protected:
  /// A branch over points of the shape.
  Skeleton_builder branch(const std::vector<Vector_3>& points) const
  {
    return CSCD::test::make_branch(m_solid, points, 1);
  }

  /// How far `node` is from the axis, in radii.
  double offset(const Skeleton_builder& builder, Index node) const
  {
    const Vector_3 point = m_solid.to_shape(builder[node].position);
    return Vector_3(0, point.y(), point.z()).norm();
  }

  double max_offset(const Skeleton_builder& builder) const
  {
    double result = 0;
    for (Index node = 0; node < builder.size(); ++node) {
      if (builder.is_regular(node)) {
        result = std::max(result, offset(builder, node));
      }
    }
    return result;
  }

  Shape_solid m_solid{CSCD::test::capsule(6, 1, 48)};
};

TEST_F(Branch_in_capsule, centering_moves_a_branch_to_the_axis)
{
  Skeleton_builder builder =
      branch({{1, 0, 0}, {1.6, 0.2, 0}, {2.2, 0.2, 0.1}, {2.8, 0.2, 0.1}, {3.4, 0.2, 0.1}, {4, 0.2, 0}, {5, 0, 0}});
  const double before = max_offset(builder);
  CSCD::internal::Branch_centering(*m_solid, builder)();
  EXPECT_LT(max_offset(builder), 0.4 * before);
}

TEST_F(Branch_in_capsule, centering_leaves_a_centered_branch_and_all_ends_in_place)
{
  Skeleton_builder builder = branch({{1, 0, 0.3}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0.3}});
  const Skeleton_builder before = builder;
  CSCD::internal::Branch_centering(*m_solid, builder)();
  EXPECT_EQ(builder[0].position, before[0].position);
  EXPECT_EQ(builder[4].position, before[4].position);
  EXPECT_NEAR(offset(builder, 2), 0, 1e-3);
}

TEST_F(Branch_in_capsule, folds_are_dropped)
{
  Skeleton_builder builder = branch({{1, 0, 0}, {2, 0, 0}, {3, 0.1, 0}, {2.6, -0.1, 0}, {4, 0, 0}, {5, 0, 0}});
  CSCD::internal::Branch_straightening(*m_solid, builder).drop_folds();
  builder.compact();
  ASSERT_EQ(builder.size(), 5u);
  for (Index node = 1; node + 1 < builder.size(); ++node) {
    const Vector_3 in = builder[node].position - builder[builder[node].neighbors[0]].position;
    const Vector_3 out = builder[builder[node].neighbors[1]].position - builder[node].position;
    EXPECT_GT(in.dot(out), 0) << node;
  }
}

TEST_F(Branch_in_capsule, straight_branches_and_cycles_of_three_nodes_stay)
{
  Skeleton_builder straight = branch({{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}});
  CSCD::internal::Branch_straightening(*m_solid, straight).drop_folds();
  straight.compact();
  EXPECT_EQ(straight.size(), 4u);
  Skeleton_builder cycle = branch({{2, 0, 0}, {3, 0, 0}, {2.5, 0.2, 0}});
  cycle.add_edge(2, 0);
  CSCD::internal::Branch_straightening(*m_solid, cycle).drop_folds();
  cycle.compact();
  EXPECT_EQ(cycle.size(), 3u);
}

TEST_F(Branch_in_capsule, nodes_that_own_little_go_until_the_others_own_enough)
{
  Skeleton_builder dense = branch({{1, 0, 0}, {1.3, 0, 0}, {1.6, 0, 0}, {1.9, 0, 0}, {2.2, 0, 0}, {2.5, 0, 0}});
  CSCD::internal::Branch_straightening(*m_solid, dense).drop_scarce_nodes({5, 5, 5, 5, 5, 5});
  dense.compact();
  EXPECT_EQ(dense.size(), 4u) << "with what its neighbors owned, one owns enough";
  Skeleton_builder rich = branch({{1, 0, 0}, {1.3, 0, 0}, {1.6, 0, 0}});
  CSCD::internal::Branch_straightening(*m_solid, rich).drop_scarce_nodes({0, 100, 0});
  rich.compact();
  EXPECT_EQ(rich.size(), 3u);
  Skeleton_builder spaced = branch({{1, 0, 0}, {2.5, 0, 0}, {4, 0, 0}});
  CSCD::internal::Branch_straightening(*m_solid, spaced).drop_scarce_nodes({0, 0, 0});
  spaced.compact();
  EXPECT_EQ(spaced.size(), 3u) << "a long edge would be left";
}

TEST_F(Branch_in_capsule, sharp_turns_become_blunt)
{
  Skeleton_builder builder = branch({{1, 0, 0}, {2, 0, 0}, {1.9, 0.5, 0}, {3, 0.1, 0}, {4, 0, 0}});
  CSCD::internal::Branch_straightening(*m_solid, builder).blunt_turns();
  ASSERT_EQ(builder.size(), 5u);
  for (Index node = 1; node + 1 < builder.size(); ++node) {
    const Vector_3 in = builder[node].position - builder[node - 1].position;
    const Vector_3 out = builder[node + 1].position - builder[node].position;
    EXPECT_GE(in.dot(out), 0) << node;
  }
}

TEST(Branch_straightening, blunts_as_far_as_the_surface_allows)
{
  const Shape_solid solid(CSCD::test::horned_ball(0.1));
  // From horn to horn below the surface of the ball: to go half way to the line between the ends would leave it.
  Skeleton_builder builder = CSCD::test::make_branch(solid, {{-0.4, 0, 3.15}, {0, 0, 2.7}, {0.4, 0, 3.15}}, 0.2);
  const auto turn = [&builder] {
    return (builder[1].position - builder[0].position).dot(builder[2].position - builder[1].position);
  };
  ASSERT_LT(turn(), 0);
  CSCD::internal::Branch_straightening(*solid, builder).blunt_turns();
  EXPECT_GE(turn(), 0);
  std::vector<double> crossings;
  solid->crossings(builder[0].position, builder[1].position, crossings);
  EXPECT_TRUE(crossings.empty());
}

} // namespace
