// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances of a front against relaxing all edges until nothing changes, on random graphs.

#include <CSCD/internal/Dijkstra_search.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace {

using CSCD::internal::Dijkstra_search;
using CSCD::Index;

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

} // namespace
