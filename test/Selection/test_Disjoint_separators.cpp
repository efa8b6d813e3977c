// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Of separators that cross or nearly coincide the lighter one is packed.

#include "Separator/make_separator.h"
#include "Traits/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Selection/Separator_packing.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <vector>

namespace {

using CSCD::Separator;
using CSCD::internal::Disjoint_separators;
using CSCD::Index;
using CSCD::Triangulated_surface;
using CSCD::Vector_3;
using CSCD::test::section_separator;
using Indices = std::vector<Index>;

class Disjoint_separators_test : public testing::Test
{
protected:
  Separator section(double x, const Vector_3& axis = {1, 0, 0}) const
  {
    return section_separator(m_tube, {x, 0, 0}, axis.normalized(), {x, 0, 1});
  }

  Indices packed(const std::vector<Separator>& separators, const std::vector<double>& weights) const
  {
    Disjoint_separators disjoint(m_tube, separators, weights);
    disjoint.pack([](Index) { return true; });
    return disjoint.packed();
  }

  Triangulated_surface m_tube = CSCD::test::to_surface(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat));
};

TEST_F(Disjoint_separators_test, keeps_what_is_disjoint_by_increasing_weight)
{
  const std::vector<Separator> separators{section(2), section(4), section(6), section(8)};
  EXPECT_EQ(packed(separators, {4, 2, 3, 1}), (Indices{3, 1, 2, 0}));
  EXPECT_EQ(packed(separators, {1, 1, 1, 1}), (Indices{0, 1, 2, 3}));
}

TEST_F(Disjoint_separators_test, keeps_the_lighter_of_two_that_cross)
{
  const std::vector<Separator> separators{section(5), section(5, {1, 0.6, 0})};
  EXPECT_EQ(packed(separators, {1, 2}), Indices{0});
  EXPECT_EQ(packed(separators, {2, 1}), Indices{1});
}

TEST_F(Disjoint_separators_test, keeps_the_lighter_of_two_that_nearly_coincide)
{
  const std::vector<Separator> separators{section(5), section(5.05), section(6)};
  EXPECT_EQ(packed(separators, {3, 2, 1}), (Indices{2, 1}));
}

TEST_F(Disjoint_separators_test, packs_anew_what_is_allowed)
{
  const std::vector<Separator> separators{section(5), section(5, {1, 0.6, 0}), section(8)};
  Disjoint_separators disjoint(m_tube, separators, {1, 2, 3});
  disjoint.pack([](Index) { return true; });
  EXPECT_EQ(disjoint.packed(), (Indices{0, 2}));
  disjoint.pack([](Index separator) { return separator != 0; });
  EXPECT_EQ(disjoint.packed(), (Indices{1, 2})) << "room for the other of the two";
  EXPECT_FALSE(disjoint.insert(0)) << "it crosses one that is packed";
  disjoint.reduce([](Index separator) { return separator != 1; });
  EXPECT_EQ(disjoint.packed(), Indices{2}) << "nothing takes the place of what is unpacked";
  disjoint.pack([](Index) { return false; });
  EXPECT_TRUE(disjoint.packed().empty());
  EXPECT_TRUE(disjoint.insert(0));
  EXPECT_EQ(disjoint.packed(), Indices{0});
  EXPECT_EQ(disjoint.arrangement().chords().size(), separators[0].crossings.size());
}

} // namespace
