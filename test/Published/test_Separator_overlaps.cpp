// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where separators overlap, and packing by it.

#include "Separator/make_separator.h"
#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Published/Region_packing.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Separator;
using CSCD::Triangulated_surface;
using CSCD::internal::Separator_overlaps;
using CSCD::test::circle_separator;
using CSCD::test::tube_section;
using Indices = std::vector<Index>;

class Separator_overlaps_test : public testing::Test
{
protected:
  Indices others(const std::vector<Separator>& separators, Index separator) const
  {
    return Separator_overlaps(m_tube, separators).others(separator);
  }

  Triangulated_surface m_tube = CSCD::test::to_surface(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat));
};

TEST_F(Separator_overlaps_test, are_none_between_distant_ones)
{
  const std::vector<Separator> separators{tube_section(m_tube, 2), tube_section(m_tube, 5), tube_section(m_tube, 8)};
  for (Index i : {0U, 1U, 2U}) {
    EXPECT_TRUE(others(separators, i).empty());
  }
}

TEST_F(Separator_overlaps_test, are_of_all_pairs_that_cross)
{
  const std::vector<Separator> separators{tube_section(m_tube, 4), tube_section(m_tube, 4, {1, 0.6, 0}),
                                          tube_section(m_tube, 4, {1, 0, 0.6}), tube_section(m_tube, 8)};
  EXPECT_EQ(others(separators, 0), (Indices{1, 2}));
  EXPECT_EQ(others(separators, 1), (Indices{0, 2}));
  EXPECT_EQ(others(separators, 2), (Indices{0, 1}));
  EXPECT_TRUE(others(separators, 3).empty());
}

TEST_F(Separator_overlaps_test, are_of_those_that_coincide)
{
  const Separator section = tube_section(m_tube, 5.03);
  EXPECT_EQ(others({section, section}, 0), Indices{1});
  Separator reversed = section;
  std::reverse(reversed.crossings.begin(), reversed.crossings.end());
  for (CSCD::Edge_crossing& crossing : reversed.crossings) {
    crossing = {m_tube.twin(crossing.halfedge), 1 - crossing.position};
  }
  EXPECT_EQ(others({section, reversed}, 0), Indices{1}) << "whichever way round";
}

TEST_F(Separator_overlaps_test, are_of_those_that_cross_edges_in_the_middle_in_opposite_directions)
{
  const Separator section = tube_section(m_tube, 5);
  Separator middle = section;
  Separator reversed = section;
  std::reverse(reversed.crossings.begin(), reversed.crossings.end());
  for (std::size_t i = 0; i < section.crossings.size(); ++i) {
    middle.crossings[i].position = 0.5;
    reversed.crossings[i] = {m_tube.twin(reversed.crossings[i].halfedge), 0.5};
  }
  EXPECT_EQ(others({middle, reversed}, 0), Indices{1});
}

/// The overlaps are found by vertices: no crossing may be missed.
TEST_F(Separator_overlaps_test, hold_all_that_an_arrangement_refuses)
{
  std::vector<Separator> separators;
  for (int i = 0; i < 60; ++i) {
    separators.push_back(tube_section(m_tube, 1 + 8. * (i * 37 % 60) / 60, {1, 0.4 * (i % 5 - 2), 0.3 * (i % 3 - 1)}));
  }
  std::size_t number_of_crossing_pairs = 0;
  for (Index i = 0; i < separators.size(); ++i) {
    for (Index j = 0; j < i; ++j) {
      CSCD::internal::Separator_arrangement arrangement(m_tube);
      ASSERT_TRUE(arrangement.insert(i, separators[i].crossings));
      if (!arrangement.insert(j, separators[j].crossings)) {
        const Indices found = others(separators, i);
        EXPECT_TRUE(std::binary_search(found.begin(), found.end(), j)) << i << ' ' << j;
        ++number_of_crossing_pairs;
      }
    }
  }
  EXPECT_GT(number_of_crossing_pairs, 50u);
}

TEST_F(Separator_overlaps_test, are_of_circles_around_one_vertex)
{
  const Index vertex = CSCD::test::nearest_vertex(m_tube, {5, 0, 1});
  const std::vector<Separator> separators{circle_separator(m_tube, vertex, 0.2), circle_separator(m_tube, vertex, 0.4),
                                          circle_separator(m_tube, vertex, 0.8)};
  EXPECT_EQ(others(separators, 0), Indices{1}) << "the third runs along the neighbors of the vertex";
  EXPECT_TRUE(others(separators, 2).empty());
}

TEST_F(Separator_overlaps_test, tell_a_curve_that_crosses_itself)
{
  // Twice around, once straight and once tilted: an eight on the tube.
  Separator twice = tube_section(m_tube, 5);
  const Separator tilted = tube_section(m_tube, 5, {1, 0.8, 0});
  const std::vector<CSCD::Edge_crossing> straight = twice.crossings;
  const auto shared = std::find_if(straight.begin(), straight.end(), [&](const auto& crossing) {
    return std::any_of(tilted.crossings.begin(), tilted.crossings.end(),
                       [&](const auto& other) { return other.halfedge == crossing.halfedge; });
  });
  ASSERT_NE(shared, straight.end());
  const auto start = std::find_if(tilted.crossings.begin(), tilted.crossings.end(),
                                  [&](const auto& crossing) { return crossing.halfedge == shared->halfedge; });
  twice.crossings.assign(straight.begin(), shared);
  twice.crossings.insert(twice.crossings.end(), start, tilted.crossings.end());
  twice.crossings.insert(twice.crossings.end(), tilted.crossings.begin(), start);
  twice.crossings.insert(twice.crossings.end(), shared, straight.end());
  Separator_overlaps overlaps(m_tube, {tube_section(m_tube, 2), twice});
  EXPECT_FALSE(overlaps.crosses_itself(0));
  EXPECT_TRUE(overlaps.crosses_itself(1));
}

TEST_F(Separator_overlaps_test, as_crossings_are_what_an_arrangement_refuses)
{
  std::vector<Separator> separators;
  for (int i = 0; i < 60; ++i) {
    separators.push_back(tube_section(m_tube, 1 + 8. * (i * 37 % 60) / 60, {1, 0.4 * (i % 5 - 2), 0.3 * (i % 3 - 1)}));
  }
  Separator_overlaps near(m_tube, separators);
  Separator_overlaps meeting = Separator_overlaps::meeting(m_tube, separators);
  std::size_t number_of_near_pairs = 0;
  std::size_t number_of_meeting_pairs = 0;
  for (Index i = 0; i < separators.size(); ++i) {
    number_of_near_pairs += near.others(i).size();
    const Indices found = meeting.others(i);
    for (Index j = 0; j < separators.size(); ++j) {
      if (j == i) {
        continue;
      }
      const bool is_found = std::binary_search(found.begin(), found.end(), j);
      number_of_meeting_pairs += is_found ? 1 : 0;
      CSCD::internal::Separator_arrangement arrangement(m_tube);
      ASSERT_TRUE(arrangement.insert(i, separators[i].crossings));
      EXPECT_TRUE(is_found || arrangement.insert(j, separators[j].crossings)) << i << ' ' << j;
    }
  }
  EXPECT_GT(number_of_meeting_pairs, 100u);
  EXPECT_LT(number_of_meeting_pairs, number_of_near_pairs);
}

TEST_F(Separator_overlaps_test, as_crossings_are_none_of_curves_side_by_side)
{
  const std::vector<Separator> separators{tube_section(m_tube, 5.02), tube_section(m_tube, 5.04),
                                          tube_section(m_tube, 5.02)};
  Separator_overlaps meeting = Separator_overlaps::meeting(m_tube, separators);
  EXPECT_EQ(meeting.others(0), Indices{2}) << "what coincides overlaps";
  EXPECT_TRUE(meeting.others(1).empty());
  EXPECT_EQ(others(separators, 1), (Indices{0, 2}));
}

TEST(Do_segments_meet, in_all_cases_of_two_segments)
{
  using CSCD::internal::do_segments_meet;
  EXPECT_TRUE(do_segments_meet({1, 0}, {0, 0.5}, {0, 0}, {0.6, 0.4})) << "across";
  EXPECT_FALSE(do_segments_meet({1, 0}, {0, 0.5}, {0, 0}, {0.2, 0.1})) << "one ends before the other";
  EXPECT_TRUE(do_segments_meet({1, 0}, {0, 0}, {0.3, 0}, {0, 0.4})) << "with an end on the other";
  EXPECT_TRUE(do_segments_meet({1, 0}, {0, 0}, {1, 0}, {0, 1})) << "at a vertex";
  EXPECT_FALSE(do_segments_meet({0.5, 0}, {0, 0.5}, {0.6, 0}, {0, 0.6})) << "parallel";
  EXPECT_TRUE(do_segments_meet({0.5, 0}, {0, 0.5}, {0.4, 0.1}, {0.1, 0.4})) << "on one line, one in the other";
  EXPECT_TRUE(do_segments_meet({0.5, 0}, {0.3, 0}, {0.3, 0}, {0.1, 0})) << "on one line, end to end";
  EXPECT_FALSE(do_segments_meet({0.5, 0}, {0.3, 0}, {0.2, 0}, {0.1, 0})) << "on one line, apart";
}

class Pack_by_overlap_test : public testing::Test
{
protected:
  Indices pack(const std::vector<Separator>& separators, const std::vector<double>& weights) const
  {
    Separator_overlaps overlaps(m_tube, separators);
    return CSCD::internal::pack_by_overlap(overlaps, weights);
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
  Separator_overlaps overlaps(m_tube, separators);
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
