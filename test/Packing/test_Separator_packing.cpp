// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Separators packed by cost, and their disjointness.

#include "Separator/make_separator.h"
#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Packing/Separator_packing.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <random>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Separator;
using CSCD::Triangulated_surface;
using CSCD::Vector_3;
using CSCD::internal::Disjoint_separators;
using CSCD::internal::Separator_packing;
using CSCD::test::circle_separator;
using CSCD::test::section_separator;
using Indices = std::vector<Index>;

class Separator_packing_test : public testing::Test
{
protected:
  Separator section(double x, const Vector_3& axis = {1, 0, 0}) const
  {
    return CSCD::test::tube_section(m_tube, x, axis);
  }

  Triangulated_surface m_tube = CSCD::test::to_surface(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat));
};

TEST_F(Separator_packing_test, cuts_along_what_is_packed)
{
  const std::vector<Separator> separators{section(2), section(2.1), section(5), section(8, {1, 0.5, 0})};
  const Separator_packing packing(m_tube, separators, {1, 2, 3, 4});
  EXPECT_EQ(packing.packed(), (Indices{0, 2, 3}));
  EXPECT_EQ(packing.cut_graph().pieces().size(), 4u);
  EXPECT_EQ(Separator_packing(m_tube, {}, {}).cut_graph().pieces().size(), 1u);
}

TEST_F(Separator_packing_test, prunes_a_bump)
{
  // A flat circle on the side of the tube cuts off a disc, between two separators that make the rest a junction.
  const Index vertex = CSCD::test::nearest_vertex(m_tube, {5, 0, 1});
  const std::vector<Separator> separators{section(2), section(8), circle_separator(m_tube, vertex, 0.8)};
  const Separator_packing packing(m_tube, separators, {2, 3, 1});
  EXPECT_EQ(packing.packed(), (Indices{0, 1}));
  EXPECT_EQ(packing.cut_graph().pieces().size(), 3u);
}

TEST_F(Separator_packing_test, packs_again_what_a_bump_was_in_the_way_of)
{
  const Index vertex = CSCD::test::nearest_vertex(m_tube, {5, 0, 1});
  const double x = m_tube.point(vertex).x();
  const std::vector<Separator> separators{section(2), section(8), circle_separator(m_tube, vertex, 0.8),
                                          section(x + 0.05)};
  EXPECT_EQ(Separator_packing(m_tube, separators, {2, 3, 1, 4}).packed(), (Indices{0, 1, 3}));
}

TEST_F(Separator_packing_test, prunes_bump_after_bump_to_the_last)
{
  // Circles with the same center are not packed together: each takes the place of the one pruned before it.
  const Index vertex = CSCD::test::nearest_vertex(m_tube, {5, 0, 1});
  std::vector<Separator> separators{section(2), section(8)};
  std::vector<double> weights{9, 9};
  for (double part : {0.5, 0.6, 0.7, 0.8, 0.9}) {
    separators.push_back(circle_separator(m_tube, vertex, part));
    weights.push_back(part);
  }
  const Separator_packing packing(m_tube, separators, weights);
  EXPECT_EQ(packing.packed(), (Indices{0, 1}));
  EXPECT_EQ(packing.cut_graph().pieces().size(), 3u) << "the cut graph is that of what is packed";
}

TEST(Separator_packing, keeps_limbs_and_prunes_their_ends_only_with_them)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::y_tube(0.15));
  std::vector<Separator> separators;
  std::vector<double> weights;
  for (int limb = 0; limb < 3; ++limb) {
    const double angle = 0.2 + 2 * CSCD::test::pi * limb / 3;
    const Vector_3 axis(std::cos(angle), std::sin(angle), 0);
    for (double along : {1.03, 2.01, 3.2}) {
      separators.push_back(section_separator(surface, along * axis, axis, along * axis));
      weights.push_back(separators.back().length);
    }
  }
  const Separator_packing packing(surface, separators, weights);
  EXPECT_EQ(packing.packed().size(), separators.size())
      << "the separators near the tips cut off little, but they belong to limbs";
  std::vector<std::size_t> degrees;
  for (const auto& piece : packing.cut_graph().pieces()) {
    degrees.push_back(piece.separators.size());
  }
  std::sort(degrees.begin(), degrees.end());
  EXPECT_EQ(degrees, (std::vector<std::size_t>{1, 1, 1, 2, 2, 2, 2, 2, 2, 3}));
}

TEST(Separator_packing, keeps_the_cycles_of_handles)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::torus(3, 1, 24));
  const std::vector<Separator> separators{
      section_separator(surface, {0.01, 0, 0}, {1, 0, 0}, {0, 3, 1}),
      section_separator(surface, {0.01, 0, 0}, {1, 0, 0}, {0, -3, 1}),
      circle_separator(surface, CSCD::test::nearest_vertex(surface, {4, 0, 0}), 0.8)};
  const Separator_packing packing(surface, separators, {1, 1, 1});
  EXPECT_EQ(packing.packed(), (Indices{0, 1}));
  EXPECT_EQ(packing.cut_graph().pieces().size(), 2u);
}

TEST(Separator_cost, prefers_short_and_planar_separators)
{
  using CSCD::internal::separator_cost;
  Separator separator;
  separator.length = 2;
  EXPECT_EQ(separator_cost(separator), 2);
  Separator longer = separator;
  longer.length = 2.1;
  EXPECT_LT(separator_cost(separator), separator_cost(longer));
  Separator bent = separator;
  bent.planarity = 0.01;
  EXPECT_LT(separator_cost(separator), separator_cost(bent));
  bent.planarity = 0.25;
  EXPECT_EQ(separator_cost(bent), 4) << "as documented";
}

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

/// Separators of length alone, with centers in a cube: they cross nothing.
std::vector<Separator> random_separators(std::size_t number, double min_radius, double max_radius)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::uniform_real_distribution<double> exponent(std::log(min_radius), std::log(max_radius));
  std::vector<Separator> result(number);
  for (Separator& separator : result) {
    separator.center = Vector_3(coordinate(random), coordinate(random), coordinate(random));
    separator.length = 2 * CSCD::test::pi * std::exp(exponent(random));
  }
  return result;
}

TEST_F(Disjoint_separators_test, keeps_the_spacing_that_all_pairs_have)
{
  const std::vector<Separator> separators = random_separators(2000, 1e-3, 1);
  Indices expected;
  for (Index i = 0; i < separators.size(); ++i) {
    const auto is_near = [&](Index j) {
      return (separators[i].center - separators[j].center).norm() <
             0.3 * std::min(separators[i].radius(), separators[j].radius());
    };
    if (std::none_of(expected.begin(), expected.end(), is_near)) {
      expected.push_back(i);
    }
  }
  Disjoint_separators packing(m_tube, separators, std::vector<double>(separators.size(), 1));
  packing.pack([](Index) { return true; });
  EXPECT_LT(expected.size(), separators.size());
  EXPECT_EQ(packing.packed(), expected);
}

TEST_F(Disjoint_separators_test, packs_very_many_in_a_moment)
{
  const std::vector<Separator> separators = random_separators(200000, 1e-6, 1e-3);
  Disjoint_separators packing(m_tube, separators, std::vector<double>(separators.size(), 1));
  const std::clock_t begin = std::clock();
  packing.pack([](Index) { return true; });
  EXPECT_LT(double(std::clock() - begin) / CLOCKS_PER_SEC, 10) << "a minute and more, if all pairs are looked at";
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
