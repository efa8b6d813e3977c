// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Disjoint sets against labels that are rewritten at every union, on random operations.

#include <CSCD/Vector_3.h>
#include <CSCD/internal/flat_arrays.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::internal::Disjoint_sets;

/// Whether `sets` are those of the indices with equal labels, each represented by one of them.
testing::AssertionResult are_those_of(Disjoint_sets& sets, const std::vector<Index>& labels)
{
  if (sets.size() != labels.size()) {
    return testing::AssertionFailure() << sets.size() << " indices";
  }
  for (Index a = 0; a < labels.size(); ++a) {
    if (labels[sets.find(a)] != labels[a]) {
      return testing::AssertionFailure() << a << " is represented by " << sets.find(a) << " of another set";
    }
    for (Index b = 0; b < a; ++b) {
      if ((sets.find(a) == sets.find(b)) != (labels[a] == labels[b])) {
        return testing::AssertionFailure() << a << " and " << b;
      }
    }
  }
  return testing::AssertionSuccess();
}

TEST(Disjoint_sets, are_single_at_first)
{
  Disjoint_sets sets(5);
  EXPECT_TRUE(are_those_of(sets, {0, 1, 2, 3, 4}));
  EXPECT_EQ(Disjoint_sets().size(), 0u);
}

TEST(Disjoint_sets, tell_whether_they_were_two)
{
  Disjoint_sets sets(4);
  EXPECT_TRUE(sets.join(0, 1));
  EXPECT_FALSE(sets.join(1, 0));
  EXPECT_FALSE(sets.join(2, 2));
  EXPECT_TRUE(sets.join(2, 3));
  EXPECT_TRUE(sets.join(3, 0));
  EXPECT_FALSE(sets.join(2, 1)) << "by way of others";
}

TEST(Disjoint_sets, follow_random_unions_and_additions)
{
  std::mt19937 random(1);
  Disjoint_sets sets(20);
  std::vector<Index> labels(20);
  for (Index i = 0; i < 20; ++i) {
    labels[i] = i;
  }
  for (int step = 0; step < 200; ++step) {
    if (random() % 3 == 0) {
      EXPECT_EQ(sets.add(), labels.size());
      labels.push_back(Index(1000 + step));
    } else {
      const auto a = Index(random() % labels.size());
      const auto b = Index(random() % labels.size());
      EXPECT_EQ(sets.join(a, b), labels[a] != labels[b]);
      std::replace(labels.begin(), labels.end(), Index(labels[a]), Index(labels[b]));
    }
    ASSERT_TRUE(are_those_of(sets, labels)) << "after step " << step;
  }
}

TEST(Disjoint_sets, go_their_own_ways_after_a_copy)
{
  Disjoint_sets sets(3);
  sets.join(0, 1);
  Disjoint_sets copy = sets;
  copy.join(1, 2);
  EXPECT_TRUE(are_those_of(sets, {0, 0, 2}));
  EXPECT_TRUE(are_those_of(copy, {0, 0, 0}));
  sets = copy;
  sets.add();
  EXPECT_TRUE(are_those_of(sets, {0, 0, 0, 3}));
  EXPECT_TRUE(are_those_of(copy, {0, 0, 0}));
}

} // namespace
