// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every vertex of a grid gets the label of the nearest start.

#include <CSCD/internal/Dijkstra_search.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace {

using CSCD::Index;
using CSCD::internal::Multi_source_dijkstra_search;
using CSCD::no_index;

/// Calls `visit` for the neighbors on a square grid of `width` columns and rows, which are 1 apart.
template <class Visit>
void visit_grid(Index width, Index vertex, const Visit& visit)
{
  const Index x = vertex % width;
  const Index y = vertex / width;
  if (x > 0) {
    visit(vertex - 1, 1.f);
  }
  if (x + 1 < width) {
    visit(vertex + 1, 1.f);
  }
  if (y > 0) {
    visit(vertex - width, 1.f);
  }
  if (y + 1 < width) {
    visit(vertex + width, 1.f);
  }
}

TEST(Multi_source_dijkstra_search, gives_every_vertex_the_label_of_the_nearest_start)
{
  constexpr Index width = 12;
  constexpr Index starts[] = {0, 5 * width + 7, 11 * width + 2};
  Multi_source_dijkstra_search front(width * width);
  for (Index label = 0; label < 3; ++label) {
    front.reach(starts[label], 0, label);
  }
  front.spread([](Index vertex, const auto& visit) { visit_grid(width, vertex, visit); });
  const auto distance = [](Index a, Index b) {
    return std::abs(int(a % width) - int(b % width)) + std::abs(int(a / width) - int(b / width));
  };
  for (Index vertex = 0; vertex < width * width; ++vertex) {
    int least = std::numeric_limits<int>::max();
    for (const Index start : starts) {
      least = std::min(least, distance(vertex, start));
    }
    EXPECT_EQ(front.distance(vertex), float(least));
    EXPECT_EQ(distance(vertex, starts[front.label(vertex)]), least) << vertex;
  }
}

TEST(Multi_source_dijkstra_search, goes_on_from_where_a_later_start_is)
{
  Multi_source_dijkstra_search front(6); // two lines: 0 1 2 and 3 4 5
  const auto line = [](Index vertex, const auto& visit) {
    if (vertex % 3 > 0) {
      visit(vertex - 1, 1.f);
    }
    if (vertex % 3 < 2) {
      visit(vertex + 1, 1.f);
    }
  };
  front.reach(0, 0, 7);
  front.spread(line);
  EXPECT_EQ(front.label(2), 7u);
  EXPECT_EQ(front.label(3), no_index);
  EXPECT_EQ(front.distance(3), std::numeric_limits<float>::infinity());
  front.reach(4, 0, 8);
  front.spread(line);
  EXPECT_EQ(front.label(0), 7u);
  EXPECT_EQ(front.label(5), 8u);
  EXPECT_EQ(front.distance(5), 1);
}

} // namespace
