// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Searches in order of distance.

#include <CSCD/Vector_3.h>
#include <CSCD/internal/Dijkstra_search.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::no_index;
using CSCD::internal::Dijkstra_search;
using CSCD::internal::Multi_source_dijkstra_search;

constexpr float infinity = std::numeric_limits<float>::infinity();

/// The neighbors of each vertex, and how far they are.
using Graph = std::vector<std::vector<std::pair<Index, float>>>;

/// Short and long edges, many ties, and vertices that nothing leads to. Sums of such lengths are exact.
Graph random_graph(Index number_of_vertices, std::mt19937& random)
{
  Graph graph(number_of_vertices);
  for (Index i = 0; i < 2 * number_of_vertices; ++i) {
    const auto a = Index(random() % number_of_vertices);
    const auto b = Index(random() % number_of_vertices);
    const auto length = float(random() % 8);
    graph[a].emplace_back(b, length);
    graph[b].emplace_back(a, length);
  }
  return graph;
}

std::vector<float> relaxed_distances(const Graph& graph, std::vector<float> distance)
{
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    for (Index a = 0; a < graph.size(); ++a) {
      for (const auto& [b, length] : graph[a]) {
        if (distance[a] + length < distance[b]) {
          distance[b] = distance[a] + length;
          is_changed = true;
        }
      }
    }
  }
  return distance;
}

TEST(Dijkstra_search, passes_every_vertex_once_in_order_at_its_least_distance)
{
  constexpr Index number_of_vertices = 200;
  std::mt19937 random(1);
  Dijkstra_search front(number_of_vertices); // one for all graphs: nothing may be left of those before
  for (int round = 0; round < 20; ++round) {
    const Graph graph = random_graph(number_of_vertices, random);
    std::vector<float> start(number_of_vertices, infinity);
    front.clear();
    for (float distance : {3.f, 0.f, 5.f}) {
      const auto source = Index(random() % number_of_vertices);
      EXPECT_EQ(front.reach(source, distance), distance < start[source]);
      start[source] = std::min(start[source], distance);
    }
    const std::vector<float> expected = relaxed_distances(graph, start);
    std::vector<int> times_passed(number_of_vertices, 0);
    float last = 0;
    front.spread([&](Index vertex, float distance) {
      EXPECT_GE(distance, last);
      EXPECT_EQ(distance, expected[vertex]);
      last = distance;
      ++times_passed[vertex];
      for (const auto& [neighbor, length] : graph[vertex]) {
        front.reach(neighbor, distance + length);
      }
    });
    for (Index vertex = 0; vertex < number_of_vertices; ++vertex) {
      const bool is_reachable = expected[vertex] < infinity;
      EXPECT_EQ(front.is_reached(vertex), is_reachable);
      EXPECT_EQ(times_passed[vertex], is_reachable ? 1 : 0);
      if (is_reachable) {
        EXPECT_EQ(front.distance(vertex), expected[vertex]);
      }
    }
  }
}

TEST(Dijkstra_search, tells_whether_a_way_is_shorter)
{
  Dijkstra_search front(2);
  EXPECT_TRUE(front.reach(1, 2));
  EXPECT_FALSE(front.reach(1, 2));
  EXPECT_FALSE(front.reach(1, 3));
  EXPECT_TRUE(front.reach(1, 1));
  EXPECT_EQ(front.distance(1), 1);
  EXPECT_FALSE(front.is_reached(0));
  front.clear();
  EXPECT_FALSE(front.is_reached(1));
  front.spread([](Index vertex, float) { ADD_FAILURE() << vertex << " is left"; });
}

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
