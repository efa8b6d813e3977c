// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The borders of a tube: place, size and the pieces of the cut surface behind them.

#include "Separator/make_separator.h"
#include "support/Shape_solid.h"
#include "support/shapes.h"
#include <CSCD/Packing/Separator_packing.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Bridged_borders.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using CSCD::Vector_3;
using CSCD::internal::Bridged_border;

std::vector<Bridged_border> borders_of_cut(const CSCD::test::Shape_solid& solid, const Vector_3& point,
                                           const Vector_3& normal)
{
  const std::vector<CSCD::Separator> separators{CSCD::test::section_separator(solid.surface(), point, normal, point)};
  const CSCD::internal::Separator_packing packing(solid.surface(), separators, {1});
  return CSCD::internal::bridged_borders(solid.surface(), packing.cut_graph());
}

TEST(Bridged_borders, of_an_open_tube)
{
  constexpr std::size_t around = 24;
  const CSCD::test::Shape_solid solid(CSCD::test::tube(6, 1, around, CSCD::test::Tube_end::open));
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
  const CSCD::test::Shape_solid solid(CSCD::test::slit_tube(8, 1, 24));
  const std::vector<Bridged_border> borders = borders_of_cut(solid, solid.at(4.03, 0, 0), {1, 0, 0});
  ASSERT_EQ(borders.size(), 1u);
  EXPECT_EQ(borders.front().pieces, (std::vector<CSCD::Index>{0, 1}));
}

TEST(Bridged_borders, none_of_a_closed_body)
{
  const CSCD::test::Shape_solid solid(CSCD::test::capsule(6, 1, 24));
  EXPECT_TRUE(borders_of_cut(solid, solid.at(3.01, 0, 0), {1, 0, 0}).empty());
}

} // namespace
