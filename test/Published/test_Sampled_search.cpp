// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sources are drawn by area and by distance from earlier ones.

#include <CSCD/Published/Sampled_search.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::internal::Distance_sampling;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Draws one vertex `times` times from a new sampling each time, after a source at `distance`. \return how often each
template <class Distance>
std::vector<int> frequencies(const std::vector<double>& areas, const Distance& distance, unsigned times)
{
  std::vector<int> count(areas.size(), 0);
  std::vector<Index> batch;
  for (unsigned seed = 0; seed < times; ++seed) {
    Distance_sampling sampling(areas, seed);
    sampling.add_source(distance);
    sampling.draw(1, batch);
    ++count[batch.at(0)];
  }
  return count;
}

TEST(Distance_sampling, draws_first_by_area)
{
  const std::vector<double> areas{1, 0, 3};
  std::vector<int> count(3, 0);
  std::vector<Index> batch;
  for (unsigned seed = 0; seed < 4000; ++seed) {
    Distance_sampling(areas, seed).draw(1, batch);
    ++count[batch.at(0)];
  }
  // Five standard deviations of a binomial distribution.
  EXPECT_NEAR(count[0], 1000, 5 * std::sqrt(4000 * 0.25 * 0.75));
  EXPECT_EQ(count[1], 0);
}

TEST(Distance_sampling, draws_later_by_area_times_distance)
{
  const auto count = frequencies(
      {2, 1, 1, 1}, [](Index vertex) { return double(vertex); }, 6000);
  EXPECT_EQ(count[0], 0) << "the source itself";
  EXPECT_NEAR(count[1], 1000, 5 * std::sqrt(6000 * 1. / 6 * 5. / 6));
  EXPECT_NEAR(count[2], 2000, 5 * std::sqrt(6000 * 1. / 3 * 2. / 3));
  EXPECT_NEAR(count[3], 3000, 5 * std::sqrt(6000 * 0.25));
}

TEST(Distance_sampling, takes_the_nearest_of_several_sources)
{
  Distance_sampling sampling({1, 1, 1}, 0);
  sampling.add_source([](Index vertex) { return double(vertex); });
  sampling.add_source([](Index vertex) { return 2. - double(vertex); });
  std::vector<Index> batch;
  for (int i = 0; i < 20; ++i) {
    sampling.draw(1, batch);
    EXPECT_EQ(batch, std::vector<Index>{1});
  }
}

TEST(Distance_sampling, goes_to_what_no_source_reaches)
{
  const auto count = frequencies(
      {1, 1, 1, 1}, [](Index vertex) { return vertex < 3 ? double(vertex) : infinity; }, 5000);
  EXPECT_NEAR(count[3], 2000, 5 * std::sqrt(5000 * 0.24)) << "as far as the farthest that is reached";
}

TEST(Distance_sampling, draws_different_vertices_and_goes_on_when_all_have_been_drawn)
{
  Distance_sampling sampling(std::vector<double>(10, 0.1), 3);
  std::vector<Index> batch;
  sampling.draw(8, batch);
  EXPECT_EQ(std::set<Index>(batch.begin(), batch.end()).size(), 8u);
  sampling.add_source([](Index) { return 0.; });
  sampling.draw(5, batch);
  EXPECT_EQ(std::set<Index>(batch.begin(), batch.end()).size(), 5u);
}

TEST(Distance_sampling, ends_where_there_is_nothing_to_draw)
{
  std::vector<Index> batch{7};
  Distance_sampling({0, 0}, 0).draw(3, batch);
  EXPECT_TRUE(batch.empty());
  Distance_sampling({0, 1}, 0).draw(3, batch);
  EXPECT_EQ(batch, std::vector<Index>{1});
  Distance_sampling({}, 0).draw(3, batch);
  EXPECT_TRUE(batch.empty());
}

TEST(Distance_sampling, draws_the_same_for_the_same_seed)
{
  std::vector<Index> first;
  std::vector<Index> second;
  Distance_sampling(std::vector<double>(1000, 1), 5).draw(8, first);
  Distance_sampling(std::vector<double>(1000, 1), 5).draw(8, second);
  EXPECT_EQ(first, second);
  Distance_sampling(std::vector<double>(1000, 1), 6).draw(8, second);
  EXPECT_NE(first, second);
}

} // namespace
