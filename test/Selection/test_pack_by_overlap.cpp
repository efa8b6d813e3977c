// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Packing by weight against the weights of what would be excluded.

#include "Separator/make_separator.h"
#include "Traits/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Selection/Separator_overlaps.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace {

using CSCD::Separator;
using CSCD::Index;
using CSCD::internal::Separator_overlaps;
using CSCD::Triangulated_surface;
using CSCD::test::tube_section;
using Indices = std::vector<Index>;

class Pack_by_overlap_test : public testing::Test
{
protected:
  Indices pack(const std::vector<Separator>& separators, const std::vector<double>& weights) const
  {
    return CSCD::internal::pack_by_overlap(Separator_overlaps(m_tube, separators), weights);
  }

  /// Long, and in the way of the first two.
  std::vector<Separator> two_and_one_across() const
  {
    return {tube_section(m_tube, 4), tube_section(m_tube, 6), tube_section(m_tube, 5, {1, 1.5, 0})};
  }

  Triangulated_surface m_tube = CSCD::test::to_surface(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat));
};

TEST_F(Pack_by_overlap_test, prefers_the_better_of_two)
{
  const std::vector<Separator> separators{tube_section(m_tube, 5), tube_section(m_tube, 5, {1, 0.6, 0})};
  EXPECT_EQ(pack(separators, {0.5, 0.9}), Indices{1});
  EXPECT_EQ(pack(separators, {0.9, 0.5}), Indices{0});
  EXPECT_EQ(pack(separators, {0.9, 0.9}), Indices{0});
}

TEST_F(Pack_by_overlap_test, prefers_two_to_a_better_one_that_excludes_both)
{
  // 1 / (1 + 1.4) against 0.7 / (1 + 1), and 1 / (1 + 1.8) against 0.9 / (1 + 1).
  EXPECT_EQ(pack(two_and_one_across(), {0.7, 0.7, 1}), Indices{2});
  EXPECT_EQ(pack(two_and_one_across(), {0.9, 0.9, 1}), (Indices{0, 1}));
}

TEST_F(Pack_by_overlap_test, leaves_out_what_has_no_weight_and_does_not_count_it)
{
  EXPECT_EQ(pack(two_and_one_across(), {0, 0, 0.1}), Indices{2});
  EXPECT_EQ(pack(two_and_one_across(), {0, 0.6, 0.5}), Indices{1});
  EXPECT_TRUE(pack(two_and_one_across(), {0, 0, 0}).empty());
  EXPECT_TRUE(pack({}, {}).empty());
}

TEST_F(Pack_by_overlap_test, packs_a_set_without_overlap_to_which_nothing_can_be_added)
{
  std::vector<Separator> separators;
  std::vector<double> weights;
  for (int i = 0; i < 60; ++i) {
    separators.push_back(tube_section(m_tube, 1 + 8. * (i * 37 % 60) / 60, {1, 0.4 * (i % 5 - 2), 0.3 * (i % 3 - 1)}));
    weights.push_back(0.1 + 0.9 * (i * 13 % 17) / 17);
  }
  const Separator_overlaps overlaps(m_tube, separators);
  const Indices packed = CSCD::internal::pack_by_overlap(overlaps, weights);
  const auto count_packed_others = [&](Index i) {
    const auto others = overlaps.others(i);
    return std::count_if(others.begin(), others.end(),
                         [&](Index other) { return std::count(packed.begin(), packed.end(), other) > 0; });
  };
  EXPECT_GT(packed.size(), 5u);
  for (Index i = 0; i < separators.size(); ++i) {
    const bool is_packed = std::count(packed.begin(), packed.end(), i) > 0;
    EXPECT_EQ(count_packed_others(i) == 0, is_packed) << i;
  }
}

} // namespace
