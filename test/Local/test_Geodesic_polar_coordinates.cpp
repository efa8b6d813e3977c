// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances of the front compared with known exact ones, and the end of the front.

#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Local/Geodesic_polar_coordinates.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace {

using CSCD::Index, CSCD::no_index, CSCD::Triangulated_surface, CSCD::Vector3, CSCD::Vertex_fan_table,
    CSCD::internal::Geodesic_polar_coordinates, CSCD::test::pi;

constexpr std::size_t no_cap = std::numeric_limits<std::size_t>::max();

/// Writes down the meetings.
struct Observer
{
  float stop = std::numeric_limits<float>::max();
  std::vector<std::pair<Index, Index>> meetings = {};

  void on_meeting(Index vertex, Index neighbor) { meetings.emplace_back(vertex, neighbor); }
  float stop_distance() const { return stop; }
  bool has_found() const { return false; }
};

/// A surface with a front on it.
struct Fixture
{
  explicit Fixture(const CSCD::test::Shape& shape)
      : surface(CSCD::test::to_surface(shape)), corners(surface), front(corners, surface.number_of_vertices())
  {
  }

  /// The largest error of the front's distances from `source`, relative to the distance `exact(vertex)`; vertices where
  /// that is 0 do not count.
  template <class Exact>
  double max_relative_error(Index source, const Exact& exact)
  {
    Observer observer;
    EXPECT_FALSE(front.grow(source, no_cap, observer));
    double largest = 0;
    for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
      const double distance = exact(vertex);
      if (distance > 0) {
        largest = std::max(largest, std::fabs(double(front.distance(vertex)) - distance) / distance);
      }
    }
    return largest;
  }

  Triangulated_surface surface;
  Vertex_fan_table corners;
  Geodesic_polar_coordinates front;
};

TEST(Geodesic_polar_coordinates, is_nearly_exact_on_a_cylinder)
{
  Fixture fixture(CSCD::test::tube(6, 1, 48, CSCD::test::Tube_end::flat));
  const Index source = CSCD::test::nearest_vertex(fixture.surface, {3, 0, 1});
  const Vector3 from = fixture.surface.point(source);
  const double error = fixture.max_relative_error(source, [&](Index vertex) {
    const Vector3 to = fixture.surface.point(vertex);
    const double angle = std::acos(std::clamp(to.y() * from.y() + to.z() * from.z(), -1., 1.));
    const double distance = std::hypot(to.x() - from.x(), angle);
    // Beyond, the way over the flat ends may be shorter.
    return std::fabs(to.x() - from.x()) < 1 ? distance : 0.;
  });
  EXPECT_LT(error, 0.005);
}

TEST(Geodesic_polar_coordinates, meets_itself_behind_the_body_only)
{
  Fixture fixture(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat));
  const Index source = CSCD::test::nearest_vertex(fixture.surface, {5, 0, 1});
  const Vector3 from = fixture.surface.point(source);
  Observer observer;
  observer.stop = 4;
  fixture.front.grow(source, no_cap, observer);
  ASSERT_FALSE(observer.meetings.empty());
  for (const auto& [vertex, neighbor] : observer.meetings) {
    ASSERT_NE(fixture.surface.find_halfedge(vertex, neighbor), no_index);
    const Vector3 middle = (fixture.surface.point(vertex) + fixture.surface.point(neighbor)) / 2;
    const Vector3 opposite(middle.x(), -from.y(), -from.z());
    EXPECT_LT((middle - opposite).norm(), 2 * 2 * pi / 24) << "two edges from the line opposite of the source";
  }
}

} // namespace
