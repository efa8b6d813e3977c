// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Strands on one edge keep their order, whatever is added, removed or flipped beside them.

#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Published/Edge_flip_shortening.h>
#include <CSCD/Published/Intrinsic_patch.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

namespace {

using CSCD::Index;
using CSCD::no_index;
using CSCD::Triangulated_surface;
using Intrinsic_patch = CSCD::internal::Intrinsic_patch<Triangulated_surface>;
using Edge_path = CSCD::internal::Edge_path<Intrinsic_patch>;

TEST(Edge_path, keeps_the_order_of_strands_on_an_edge)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::tetrahedron());
  Intrinsic_patch patch(surface, 0);
  Edge_path path(patch);
  const Index h = patch.halfedge_along(0);
  const Index t = patch.twin(h);
  EXPECT_FALSE(path.is_on_edge(h));
  // From the left of h to its right: second (backwards), first, third.
  const Index first = path.add(h, h);
  const Index second = path.add(t, h);
  const Index third = path.add(h, t);
  EXPECT_EQ(path.outermost(h), second);
  EXPECT_EQ(path.outermost(t), third);
  EXPECT_TRUE(path.are_side_by_side(first, second));
  EXPECT_TRUE(path.are_side_by_side(second, first));
  EXPECT_TRUE(path.are_side_by_side(first, third));
  EXPECT_FALSE(path.are_side_by_side(second, third));
  path.remove(first);
  EXPECT_TRUE(path.is_removed(first));
  EXPECT_TRUE(path.are_side_by_side(second, third));
  EXPECT_TRUE(path.are_side_by_side(third, second));
  path.remove(second);
  EXPECT_EQ(path.outermost(h), third);
  path.remove(third);
  EXPECT_FALSE(path.is_on_edge(h));
  EXPECT_FALSE(path.is_on_edge(t));
}

TEST(Edge_path, follows_flips)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::sphere(1));
  Intrinsic_patch patch(surface, 0);
  Edge_path path(patch);
  const Index h = patch.halfedge_along(0);
  const Index t = patch.twin(h);
  // Two strands on each side of the quadrilateral of h, in both directions.
  const Index sides[] = {Intrinsic_patch::next(h), Intrinsic_patch::previous(h), Intrinsic_patch::next(t),
                         Intrinsic_patch::previous(t)};
  Index inner[4];
  Index outer[4];
  Index origin[4];
  for (int k = 0; k < 4; ++k) {
    outer[k] = path.add(patch.twin(sides[k]), sides[k]);
    inner[k] = path.add(sides[k], sides[k]);
    origin[k] = patch.origin(sides[k]);
  }
  ASSERT_TRUE(patch.flip_if_convex(h));
  path.follow_flip(h, t);
  for (int k = 0; k < 4; ++k) {
    const Index side = path.halfedge(inner[k]);
    EXPECT_EQ(patch.origin(side), origin[k]);
    EXPECT_TRUE(patch.are_twins(side, path.halfedge(outer[k])));
    EXPECT_EQ(path.outermost(side), inner[k]);
    EXPECT_EQ(path.outermost(patch.twin(side)), outer[k]);
    EXPECT_TRUE(path.are_side_by_side(inner[k], outer[k]));
  }
  EXPECT_FALSE(path.is_on_edge(Intrinsic_patch::previous(h)));
  EXPECT_FALSE(path.is_on_edge(Intrinsic_patch::previous(t)));
}

TEST(Edge_path, counts_changes_of_what_follows)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::tetrahedron());
  Intrinsic_patch patch(surface, 0);
  Edge_path path(patch);
  const Index a = path.add(patch.halfedge_along(0), patch.halfedge_along(0));
  const Index b = path.add(patch.halfedge_along(1), patch.halfedge_along(1));
  EXPECT_EQ(path.next(a), no_index);
  const Index version = path.version(a);
  path.link(a, b);
  EXPECT_EQ(path.next(a), b);
  EXPECT_EQ(path.previous(b), a);
  EXPECT_NE(path.version(a), version);
  path.link(b, no_index);
  path.link(no_index, a);
  EXPECT_EQ(path.next(b), no_index);
  EXPECT_EQ(path.previous(a), no_index);
}

} // namespace
