// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where limbs end: the borders of a tube, and ends in rims.

#include "Separator/make_separator.h"
#include "Skeleton/make_branch.h"
#include "support/Shape_solid.h"
#include "support/shapes.h"
#include <CSCD/Packing/Separator_packing.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Limb_ends.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using CSCD::Skeleton_builder;
using CSCD::Vector_3;
using CSCD::internal::Bridged_border;
using CSCD::test::Shape_solid;

std::vector<Bridged_border> borders_of_cut(const Shape_solid& solid, const Vector_3& point, const Vector_3& normal)
{
  const std::vector<CSCD::Separator> separators{CSCD::test::section_separator(solid.surface(), point, normal, point)};
  const CSCD::internal::Separator_packing packing(solid.surface(), separators, {1});
  return CSCD::internal::bridged_borders(solid.surface(), packing.cut_graph());
}

TEST(Bridged_borders, of_an_open_tube)
{
  constexpr std::size_t around = 24;
  const Shape_solid solid(CSCD::test::tube(6, 1, around, CSCD::test::Tube_end::open));
  const std::vector<Bridged_border> borders = borders_of_cut(solid, solid.at(3.01, 0, 0), {1, 0, 0});
  ASSERT_EQ(borders.size(), 2u);
  const double half_angle = CSCD::test::pi / around;
  for (const Bridged_border& border : borders) {
    const Vector_3 centroid = solid.to_shape(border.centroid);
    const bool is_front = centroid.x() > 3;
    EXPECT_LT((centroid - Vector_3(is_front ? 6 : 0, 0, 0)).norm(), 1e-9);
    EXPECT_LT((border.normal - Vector_3(is_front ? 1 : -1, 0, 0)).norm(), 1e-9);
    EXPECT_NEAR(border.length * solid.unit(), 2 * around * std::sin(half_angle), 1e-9);
    EXPECT_NEAR(border.radius * solid.unit(), 1, 1e-9);
    EXPECT_EQ(border.pieces.size(), 1u);
  }
  EXPECT_NE(borders[0].pieces, borders[1].pieces);
}

TEST(Bridged_borders, that_separators_cross)
{
  const Shape_solid solid(CSCD::test::slit_tube(8, 1, 24));
  const std::vector<Bridged_border> borders = borders_of_cut(solid, solid.at(4.03, 0, 0), {1, 0, 0});
  ASSERT_EQ(borders.size(), 1u);
  EXPECT_EQ(borders.front().pieces, (std::vector<CSCD::Index>{0, 1}));
}

TEST(Bridged_borders, none_of_a_closed_body)
{
  const Shape_solid solid(CSCD::test::capsule(6, 1, 24));
  EXPECT_TRUE(borders_of_cut(solid, solid.at(3.01, 0, 0), {1, 0, 0}).empty());
}

/// A branch along the x axis to x = `end`, and from there to a tip at (`x`, `y`, 0); its radius is 0.5.
Skeleton_builder branch_with_end(const Shape_solid& solid, double end, double x, double y)
{
  return CSCD::test::make_branch(solid, {{end - 1, 0, 0}, {end - 0.5, 0, 0}, {end, 0, 0}, {x, y, 0}}, 0.5);
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

} // namespace
