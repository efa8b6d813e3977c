// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances from one and several vertices where the exact ones are known.

#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Published/Heat_method.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Triangulated_surface;
using CSCD::internal::distances_from_vertices;

TEST(Distances_from_vertices, are_great_arcs_on_a_sphere)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::sphere(4));
  const double tolerance = 0.6 * surface.length(0); // of the method: see test_Heat_method
  const Index source = 17;
  const std::vector<double> distances = distances_from_vertices(surface, {source});
  ASSERT_EQ(distances.size(), surface.number_of_vertices());
  const CSCD::Vector_3 pole = surface.point(source).normalized();
  for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
    const CSCD::Vector_3 direction = surface.point(vertex).normalized();
    EXPECT_NEAR(distances[vertex], std::atan2(pole.cross(direction).norm(), pole.dot(direction)), tolerance);
  }
}

TEST(Distances_from_vertices, of_several_sources_are_those_of_the_nearest)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::sphere(4));
  const std::vector<Index> sources{3, 40, 1000};
  const std::vector<double> distances = distances_from_vertices(surface, sources);
  std::vector<double> nearest = distances_from_vertices(surface, {sources.front()});
  for (const Index source : sources) {
    EXPECT_EQ(distances[source], 0);
    const std::vector<double> alone = distances_from_vertices(surface, {source});
    for (std::size_t i = 0; i < nearest.size(); ++i) {
      nearest[i] = std::min(nearest[i], alone[i]);
    }
  }
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    EXPECT_NEAR(distances[i], nearest[i], 0.1);
  }
}

TEST(Distances_from_vertices, are_infinite_where_no_source_is_connected)
{
  const CSCD::test::Shape ball = CSCD::test::sphere(2);
  const Triangulated_surface surface =
      CSCD::test::to_surface(CSCD::test::merged("two", {ball, CSCD::test::translated(ball, {10, 0, 0})}));
  const std::vector<double> distances = distances_from_vertices(surface, {0});
  for (std::size_t i = 0; i < distances.size(); ++i) {
    EXPECT_EQ(std::isfinite(distances[i]), i < ball.points.size()) << i;
  }
}

} // namespace
