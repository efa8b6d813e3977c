// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is outside of the body comes back in, and does not go far below the surface for it.

#include "Skeleton/make_branch.h"
#include "support/Shape_solid.h"
#include "support/shapes.h"
#include <CSCD/Skeleton/Inside_repair.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

namespace {

using CSCD::Index;
using CSCD::Skeleton_builder;
using CSCD::Vector_3;
using CSCD::internal::Inside_repair;
using CSCD::test::Shape_solid;

class Repair_of_horned_ball : public testing::Test
{
protected:
  /// An edge from one point of the shape to the other.
  Skeleton_builder edge(const Vector_3& from, const Vector_3& to) const
  {
    return CSCD::test::make_branch(m_solid, {from, to}, 0.2);
  }

  Shape_solid m_solid{CSCD::test::horned_ball(0.1)};
};

TEST_F(Repair_of_horned_ball, brings_a_tip_inside)
{
  Skeleton_builder builder = edge({0, 0, 0}, {0, 0, 3.2});
  Inside_repair repair(*m_solid, builder);
  EXPECT_EQ(repair.number_of_nodes_outside(), 1u);
  repair();
  EXPECT_EQ(repair.number_of_nodes_outside(), 0u);
  EXPECT_TRUE(m_solid->is_inside(builder[1].position));
  EXPECT_EQ(repair.number_of_edges_outside(), 0u);
}

TEST_F(Repair_of_horned_ball, leads_an_edge_around_the_notch_and_not_into_the_ball)
{
  Skeleton_builder builder = edge({-0.4, 0, 3.12}, {0.4, 0, 3.12});
  Inside_repair repair(*m_solid, builder);
  EXPECT_EQ(repair.number_of_nodes_outside(), 0u);
  EXPECT_EQ(repair.number_of_edges_outside(), 1u);
  repair();
  EXPECT_EQ(repair.number_of_edges_outside(), 0u);
  EXPECT_GT(builder.size(), 2u);
  for (Index node = 0; node < builder.size(); ++node) {
    EXPECT_TRUE(m_solid->is_inside(builder[node].position)) << node;
    EXPECT_GT(m_solid.to_shape(builder[node].position).z(), 2.5) << node << ": half of the edge below the surface";
  }
}

} // namespace
