// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Straightening shortens curves and keeps them curves.

#include "Separator/is_closed_curve.h"
#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Local/Geodesic_polar_coordinates.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/Straightening.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace {

using CSCD::Edge_crossing;
using CSCD::Index;
using CSCD::Triangulated_surface;
using CSCD::Vector_3;
using CSCD::Vertex_loop;
using CSCD::internal::Polygon_measures;
using CSCD::internal::Straightening;
using CSCD::test::pi;

Polygon_measures measures(const Triangulated_surface& surface, const std::vector<Edge_crossing>& crossings)
{
  std::vector<Vector_3> points;
  CSCD::internal::crossing_points(surface, crossings, points);
  return CSCD::internal::measure_polygon(points);
}

/// The push-off of a ring of a tube that makes a detour at every `period`-th vertex.
std::vector<Edge_crossing> ring_with_detours(const Triangulated_surface& surface, Index around, Index period)
{
  Vertex_loop loop;
  const Index ring = 10;
  for (Index k = 0; k < around; ++k) {
    if (k % period == period - 1) {
      loop.push_back((ring + 1) * around + k);
      loop.push_back((ring + 1) * around + (k + 1) % around);
    } else {
      loop.push_back(ring * around + k);
    }
  }
  std::vector<Edge_crossing> crossings;
  EXPECT_TRUE(CSCD::internal::push_off(surface, loop, crossings));
  return crossings;
}

TEST(Straightening, makes_a_circle_of_a_zigzag_around_a_tube)
{
  constexpr Index around = 24;
  const Triangulated_surface surface =
      CSCD::test::to_surface(CSCD::test::tube(10, 1, around, CSCD::test::Tube_end::flat));
  Straightening straighten(surface);
  for (const Index period : {Index(24), Index(6), Index(4)}) {
    SCOPED_TRACE(period);
    std::vector<Edge_crossing> crossings = ring_with_detours(surface, around, period);
    const double length_before = measures(surface, crossings).length;
    straighten(crossings, 200);
    EXPECT_TRUE(CSCD::test::is_closed_curve(surface, crossings));
    const Polygon_measures after = measures(surface, crossings);
    EXPECT_LT(after.length, length_before);
    EXPECT_NEAR(after.length, 2 * pi, 0.01 * 2 * pi);
    EXPECT_LT(after.planarity, 0.005);
  }
}

TEST(Straightening, passes_over_vertices_towards_the_thin_end)
{
  constexpr Index around = 24;
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::tapered_tube(3, 0.2, 1.8, around));
  for (const bool is_reversed : {false, true}) {
    SCOPED_TRACE(is_reversed);
    Vertex_loop loop;
    for (Index k = 0; k < around; ++k) {
      loop.push_back(6 * around + k);
    }
    if (is_reversed) {
      std::reverse(loop.begin(), loop.end());
    }
    std::vector<Edge_crossing> crossings;
    ASSERT_TRUE(CSCD::internal::push_off(surface, loop, crossings));
    const Polygon_measures before = measures(surface, crossings);
    Straightening straighten(surface);
    straighten(crossings, 100);
    const Polygon_measures after = measures(surface, crossings);
    EXPECT_TRUE(CSCD::test::is_closed_curve(surface, crossings));
    EXPECT_LT(after.length, before.length);
    // It began on the thick side of ring 6 or, reversed, on its thin side.
    const Index passed = is_reversed ? 5 : 6;
    EXPECT_LT(after.center.x(), surface.point(passed * around).x()) << "it is still where it was";
  }
}

TEST(Straightening, keeps_closed_curves_on_rough_surfaces_and_shortens_them)
{
  for (const CSCD::test::Shape& shape :
       {CSCD::test::noisy(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat), 0.4, 1),
        CSCD::test::noisy(CSCD::test::torus(3, 1, 24), 0.3, 2), CSCD::test::y_tube(0.15),
        CSCD::test::subdivided_cube(3)}) {
    SCOPED_TRACE(shape.name);
    const Triangulated_surface surface = CSCD::test::to_surface(shape);
    const CSCD::Vertex_fan_table corners(surface);
    CSCD::internal::Geodesic_polar_coordinates front(corners, surface.number_of_vertices());
    Straightening straighten(surface);
    std::size_t number_of_curves = 0;
    for (Index source = 0; source < surface.number_of_vertices(); source += 3) {
      CSCD::internal::Nearest_meeting meeting(surface, front, source);
      front.grow(source, std::numeric_limits<std::size_t>::max(), meeting);
      Vertex_loop loop;
      std::vector<Edge_crossing> crossings;
      if (!meeting.has_found()) {
        continue;
      }
      CSCD::internal::trace_loop(front, meeting.first(), meeting.second(), loop);
      if (!CSCD::internal::push_off(surface, loop, crossings)) {
        continue;
      }
      ++number_of_curves;
      const double length_before = measures(surface, crossings).length;
      straighten(crossings, 15);
      ASSERT_TRUE(crossings.size() < 4 || CSCD::test::is_closed_curve(surface, crossings)) << "source " << source;
      ASSERT_LE(measures(surface, crossings).length, 1.0001 * length_before) << "source " << source;
    }
    EXPECT_GT(number_of_curves, 20u);
  }
}

TEST(Straightening, takes_out_what_goes_through_an_edge_and_straight_back)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat));
  std::vector<Edge_crossing> crossings = ring_with_detours(surface, 24, 24);
  const std::size_t size = crossings.size();
  const Index inserted = surface.next(surface.twin(crossings[5].halfedge));
  const Index next = crossings[6].halfedge;
  const Index aside = inserted == next ? surface.previous(surface.twin(crossings[5].halfedge)) : inserted;
  crossings.insert(crossings.begin() + 6, {{aside, 0.5}, {surface.twin(aside), 0.5}});
  Straightening straighten(surface);
  straighten(crossings, 1);
  EXPECT_LE(crossings.size(), size);
  EXPECT_TRUE(CSCD::test::is_closed_curve(surface, crossings));
}

TEST(Straightening, leaves_small_lists_alone)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::tetrahedron());
  Straightening straighten(surface);
  std::vector<Edge_crossing> crossings;
  for (const Index h : surface.outgoing(0)) {
    crossings.insert(crossings.begin(), {h, 0.5});
  }
  straighten(crossings, 5);
  EXPECT_EQ(crossings.size(), 3u);
  crossings.clear();
  straighten(crossings, 5);
  EXPECT_TRUE(crossings.empty());
}

TEST(Straightening, passes_over_the_vertices_of_a_detour)
{
  constexpr Index around = 24;
  const Triangulated_surface surface =
      CSCD::test::to_surface(CSCD::test::tube(10, 1, around, CSCD::test::Tube_end::flat));
  // Around ring 10, but along the tube to ring 14 and back on the way.
  Vertex_loop loop;
  for (Index k = 1; k < around - 1; ++k) {
    loop.push_back(10 * around + k);
  }
  for (Index ring = 11; ring <= 14; ++ring) {
    loop.push_back(ring * around + around - 2);
  }
  loop.push_back(14 * around + around - 1);
  for (Index ring = 14; ring >= 11; --ring) {
    loop.push_back(ring * around);
  }
  loop.push_back(10 * around);
  std::vector<Edge_crossing> crossings;
  ASSERT_TRUE(CSCD::internal::push_off(surface, loop, crossings));
  const auto touches_ring_or_beyond = [&](Index ring) {
    return std::any_of(crossings.begin(), crossings.end(), [&](const Edge_crossing& crossing) {
      return surface.origin(crossing.halfedge) / around >= ring || surface.target(crossing.halfedge) / around >= ring;
    });
  };
  ASSERT_TRUE(touches_ring_or_beyond(15));
  const double length_before = measures(surface, crossings).length;
  Straightening straighten(surface);
  straighten(crossings, 200);
  EXPECT_FALSE(touches_ring_or_beyond(13));
  EXPECT_TRUE(CSCD::test::is_closed_curve(surface, crossings));
  EXPECT_LT(measures(surface, crossings).length, 0.8 * length_before);
}

} // namespace
