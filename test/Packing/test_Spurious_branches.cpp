// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A branch is a bump if none of its separators cuts off a limb.

#include "Separator/make_separator.h"
#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Packing/Separator_packing.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Separator;
using CSCD::Triangulated_surface;
using CSCD::test::circle_separator;
using CSCD::test::nearest_vertex;
using CSCD::test::section_separator;
using Indices = std::vector<Index>;

/// The area of a limb 0.44 radii long with a flat end, relative to the squared length of the loop around it.
constexpr double flat_limb_area_ratio = 0.15;

/// The separators of bumps, all of `separators` being packed.
Indices bumps(const Triangulated_surface& surface, const std::vector<Separator>& separators)
{
  CSCD::internal::Separator_arrangement arrangement(surface);
  Indices packed;
  for (Index i = 0; i < separators.size(); ++i) {
    EXPECT_TRUE(arrangement.insert(i, separators[i].crossings)) << "separator " << i << " crosses another one";
    packed.push_back(i);
  }
  CSCD::internal::Cut_graph cut_graph(surface, arrangement);
  cut_graph.cut(arrangement);
  Indices result = CSCD::internal::Spurious_branches(cut_graph, separators, packed, flat_limb_area_ratio).separators();
  std::sort(result.begin(), result.end());
  return result;
}

class Bump_branches_test : public testing::Test
{
protected:
  Separator section(double x) const { return section_separator(m_tube, {x, 0, 0}, {1, 0, 0}, {x, 0, 1}); }
  /// Around a vertex, over `part` of the edges that lead away from it.
  Separator circle(double x, double part) const
  {
    return circle_separator(m_tube, nearest_vertex(m_tube, {x, 0, 1}), part);
  }

  Triangulated_surface m_tube = CSCD::test::to_surface(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat));
};

TEST_F(Bump_branches_test, finds_a_flat_circle_between_two_sections)
{
  EXPECT_EQ(bumps(m_tube, {section(2), circle(5, 0.8), section(8)}), Indices{1});
}

TEST_F(Bump_branches_test, names_all_separators_of_a_bump)
{
  EXPECT_EQ(bumps(m_tube, {circle(5, 0.8), section(2), circle(5, 0.4), section(8)}), (Indices{0, 2}));
}

TEST_F(Bump_branches_test, spares_branches_without_junction)
{
  EXPECT_EQ(bumps(m_tube, {}), Indices{});
  EXPECT_EQ(bumps(m_tube, {circle(5, 0.8)}), Indices{}) << "two tips";
  EXPECT_EQ(bumps(m_tube, {circle(5, 0.8), circle(5, 0.4), section(8)}), Indices{}) << "a path";
}

TEST_F(Bump_branches_test, spares_a_limb_whose_last_separator_cuts_off_little)
{
  // Close to its end, a limb is as flat as a bump; farther from it, the same branch cuts off more.
  const Separator end = section(9.7);
  EXPECT_EQ(bumps(m_tube, {section(2), circle(5, 0.8), end}), (Indices{1, 2}));
  EXPECT_EQ(bumps(m_tube, {section(2), circle(5, 0.8), section(8), end}), Indices{1});
}

} // namespace
