// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances of the front where the exact ones are known, and when it stops.

#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Local/Geodesic_polar_coordinates.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::no_index;
using CSCD::Triangulated_surface;
using CSCD::Vector_3;
using CSCD::Vertex_fan_table;
using CSCD::internal::Front_end;
using CSCD::internal::Geodesic_polar_coordinates;
using CSCD::test::pi;

constexpr std::size_t no_cap = std::numeric_limits<std::size_t>::max();

/// Writes down the meetings.
struct Observer
{
  float stop = std::numeric_limits<float>::max();
  bool is_content = false;
  std::vector<std::pair<Index, Index>> meetings = {};

  void on_meeting(Index vertex, Index neighbor) { meetings.emplace_back(vertex, neighbor); }
  float stop_distance() const { return stop; }
  bool has_found() const { return is_content; }
};

/// A surface with a front on it.
struct Fixture
{
  explicit Fixture(const CSCD::test::Shape& shape)
      : surface(CSCD::test::to_surface(shape)), corners(surface), front(corners, surface.number_of_vertices())
  {
  }

  /// The largest error of the front's distances from `source`, relative to the distance `exact(vertex)`; vertices for
  /// which that is 0 do not count.
  template <class Exact>
  double max_relative_error(Index source, const Exact& exact)
  {
    Observer observer;
    EXPECT_EQ(front.grow(source, no_cap, observer), Front_end::exhausted);
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

TEST(Geodesic_polar_coordinates, is_exact_on_a_plane)
{
  Fixture fixture(CSCD::test::subdivided_cube(5));
  const Vector_3 center(0.5, 0.5, 1);
  const Index source = CSCD::test::nearest_vertex(fixture.surface, center);
  const double error = fixture.max_relative_error(source, [&](Index vertex) {
    const Vector_3 offset = fixture.surface.point(vertex) - center;
    return offset.z() == 0 ? offset.norm() : 0.;
  });
  // Single precision, added up over a few dozen triangles.
  EXPECT_LT(error, 1e-5);
}

TEST(Geodesic_polar_coordinates, is_nearly_exact_on_a_cylinder)
{
  Fixture fixture(CSCD::test::tube(6, 1, 48, CSCD::test::Tube_end::flat));
  const Index source = CSCD::test::nearest_vertex(fixture.surface, {3, 0, 1});
  const Vector_3 from = fixture.surface.point(source);
  const double error = fixture.max_relative_error(source, [&](Index vertex) {
    const Vector_3 to = fixture.surface.point(vertex);
    const double angle = std::acos(std::clamp(to.y() * from.y() + to.z() * from.z(), -1., 1.));
    const double distance = std::hypot(to.x() - from.x(), angle);
    // Beyond, the way over the flat ends may be shorter.
    return std::fabs(to.x() - from.x()) < 1 ? distance : 0.;
  });
  EXPECT_LT(error, 0.005);
}

TEST(Geodesic_polar_coordinates, is_nearly_exact_on_a_sphere)
{
  Fixture fixture(CSCD::test::sphere(4));
  for (const Index source : {Index(0), Index(100), Index(2000)}) {
    const double error = fixture.max_relative_error(source, [&](Index vertex) {
      return std::acos(std::clamp(fixture.surface.point(vertex).dot(fixture.surface.point(source)), -1., 1.));
    });
    EXPECT_LT(error, 0.02);
  }
}

TEST(Geodesic_polar_coordinates, is_never_shorter_than_the_straight_line_and_parents_lead_to_the_source)
{
  for (const CSCD::test::Shape& shape :
       {CSCD::test::noisy(CSCD::test::torus(3, 1, 24), 0.3, 1), CSCD::test::double_cone(50), CSCD::test::cube()}) {
    SCOPED_TRACE(shape.name);
    Fixture fixture(shape);
    Observer observer;
    fixture.front.grow(1, no_cap, observer);
    EXPECT_EQ(fixture.front.parent(1), no_index);
    EXPECT_EQ(fixture.front.distance(1), 0.f);
    EXPECT_EQ(fixture.front.number_of_visits(), fixture.surface.number_of_vertices());
    for (Index vertex = 0; vertex < fixture.surface.number_of_vertices(); ++vertex) {
      const double straight = (fixture.surface.point(vertex) - fixture.surface.point(1)).norm();
      ASSERT_GE(double(fixture.front.distance(vertex)), (1 - 1e-5) * straight);
      Index ancestor = vertex;
      for (Index steps = 0; ancestor != 1; ++steps) {
        const Index parent = fixture.front.parent(ancestor);
        ASSERT_NE(fixture.surface.find_halfedge(ancestor, parent), no_index);
        ASSERT_LT(steps, fixture.surface.number_of_vertices()) << "the parents form a cycle";
        ancestor = parent;
      }
    }
  }
}

TEST(Geodesic_polar_coordinates, meets_itself_behind_the_body_only)
{
  Fixture fixture(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat));
  const Index source = CSCD::test::nearest_vertex(fixture.surface, {5, 0, 1});
  const Vector_3 from = fixture.surface.point(source);
  Observer observer;
  observer.stop = 4;
  fixture.front.grow(source, no_cap, observer);
  ASSERT_FALSE(observer.meetings.empty());
  for (const auto& [vertex, neighbor] : observer.meetings) {
    ASSERT_NE(fixture.surface.find_halfedge(vertex, neighbor), no_index);
    const Vector_3 middle = (fixture.surface.point(vertex) + fixture.surface.point(neighbor)) / 2;
    const Vector_3 opposite(middle.x(), -from.y(), -from.z());
    EXPECT_LT((middle - opposite).norm(), 2 * 2 * pi / 24) << "two edges from the line opposite of the source";
  }
}

TEST(Geodesic_polar_coordinates, does_not_meet_itself_on_a_flat_disc)
{
  Fixture fixture(CSCD::test::noisy(CSCD::test::subdivided_cube(5), 0.15, 2));
  Observer observer;
  observer.stop = 0.45f;
  fixture.front.grow(CSCD::test::nearest_vertex(fixture.surface, {0.5, 0.5, 1}), no_cap, observer);
  EXPECT_TRUE(observer.meetings.empty());
}

TEST(Geodesic_polar_coordinates, stops_at_the_distance_that_the_observer_names)
{
  Fixture fixture(CSCD::test::sphere(4));
  Observer observer;
  fixture.front.grow(5, no_cap, observer);
  std::size_t near = 0;
  for (Index vertex = 0; vertex < fixture.surface.number_of_vertices(); ++vertex) {
    near += fixture.front.distance(vertex) <= 0.7f ? 1u : 0u;
  }
  observer.stop = 0.7f;
  EXPECT_EQ(fixture.front.grow(5, no_cap, observer), Front_end::exhausted);
  // A front may come to a vertex a little late.
  EXPECT_NEAR(double(fixture.front.number_of_visits()), double(near), 0.01 * double(near) + 1);
}

TEST(Geodesic_polar_coordinates, is_capped_unless_something_was_found)
{
  Fixture fixture(CSCD::test::sphere(4));
  Observer observer;
  EXPECT_EQ(fixture.front.grow(5, 100, observer), Front_end::capped);
  EXPECT_LE(fixture.front.number_of_visits(), 101u);
  observer.is_content = true;
  EXPECT_EQ(fixture.front.grow(5, 100, observer), Front_end::exhausted);
  EXPECT_EQ(fixture.front.number_of_visits(), fixture.surface.number_of_vertices());
}

TEST(Geodesic_polar_coordinates, gives_the_same_when_it_is_used_again)
{
  Fixture used(CSCD::test::torus(3, 1, 24));
  Observer observer;
  for (const Index source : {Index(3), Index(500), Index(71)}) {
    used.front.grow(source, 300, observer);
  }
  Fixture fresh(CSCD::test::torus(3, 1, 24));
  Observer used_observer;
  Observer fresh_observer;
  used.front.grow(9, no_cap, used_observer);
  fresh.front.grow(9, no_cap, fresh_observer);
  EXPECT_EQ(used_observer.meetings, fresh_observer.meetings);
  EXPECT_EQ(used.front.ring_radius(), fresh.front.ring_radius());
  for (Index vertex = 0; vertex < fresh.surface.number_of_vertices(); ++vertex) {
    ASSERT_EQ(used.front.distance(vertex), fresh.front.distance(vertex));
    ASSERT_EQ(used.front.parent(vertex), fresh.front.parent(vertex));
  }
}

TEST(Geodesic_polar_coordinates, survives_edges_without_length)
{
  CSCD::test::Shape shape = CSCD::test::sphere(2);
  shape.points[shape.triangles[0][1]] = shape.points[shape.triangles[0][0]];
  Fixture fixture(shape);
  for (Index source = 0; source < fixture.surface.number_of_vertices(); ++source) {
    Observer observer;
    fixture.front.grow(source, no_cap, observer);
    ASSERT_EQ(fixture.front.number_of_visits(), fixture.surface.number_of_vertices());
    for (Index vertex = 0; vertex < fixture.surface.number_of_vertices(); ++vertex) {
      ASSERT_TRUE(std::isfinite(fixture.front.distance(vertex)));
    }
  }
}

} // namespace
