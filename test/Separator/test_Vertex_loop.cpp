// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops traced from fronts, and their push-off to the left.

#include "Separator/is_closed_curve.h"
#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Local/Geodesic_polar_coordinates.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

namespace {

using CSCD::Edge_crossing;
using CSCD::Index;
using CSCD::no_index;
using CSCD::Triangulated_surface;
using CSCD::Vector_3;
using CSCD::Vertex_fan_table;
using CSCD::Vertex_loop;
using CSCD::internal::Geodesic_polar_coordinates;
using CSCD::internal::Nearest_meeting;
using CSCD::internal::push_off;

/// The ring of vertices of a tube around x = 5.
Vertex_loop middle_ring(Index around)
{
  Vertex_loop loop;
  for (Index k = 0; k < around; ++k) {
    loop.push_back(10 * around + k);
  }
  return loop;
}

TEST(Vertex_loop, traced_from_a_front_is_simple_and_closed)
{
  for (const CSCD::test::Shape& shape :
       {CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat), CSCD::test::noisy(CSCD::test::torus(3, 1, 24), 0.3, 1),
        CSCD::test::y_tube(0.15), CSCD::test::tube(20, 1, 5, CSCD::test::Tube_end::flat)}) {
    SCOPED_TRACE(shape.name);
    const Triangulated_surface surface = CSCD::test::to_surface(shape);
    const Vertex_fan_table corners(surface);
    Geodesic_polar_coordinates front(corners, surface.number_of_vertices());
    std::size_t number_of_loops = 0;
    for (Index source = 0; source < surface.number_of_vertices(); source += 3) {
      Nearest_meeting meeting(surface, front, source);
      front.grow(source, std::numeric_limits<std::size_t>::max(), meeting);
      if (!meeting.has_found()) {
        continue;
      }
      Vertex_loop loop{7, 7, 7};
      CSCD::internal::trace_loop(front, meeting.first(), meeting.second(), loop);
      ++number_of_loops;
      ASSERT_GE(loop.size(), 3u);
      ASSERT_EQ(std::set<Index>(loop.begin(), loop.end()).size(), loop.size()) << "from source " << source;
      ASSERT_EQ(std::count(loop.begin(), loop.end(), meeting.first()), 1);
      ASSERT_EQ(std::count(loop.begin(), loop.end(), meeting.second()), 1);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        ASSERT_NE(surface.find_halfedge(loop[i], loop[(i + 1) % loop.size()]), no_index);
      }
    }
    EXPECT_GT(number_of_loops, 20u);
  }
}

TEST(Push_off, crosses_what_leaves_the_loop_to_the_left)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat));
  Vertex_loop loop = middle_ring(24);
  std::set<Index> crossed_targets;
  for (const bool is_reversed : {false, true}) {
    if (is_reversed) {
      std::reverse(loop.begin(), loop.end());
    }
    std::vector<Edge_crossing> crossings;
    ASSERT_TRUE(push_off(surface, loop, crossings));
    // A ring of a tube has two edges to either side at each vertex.
    EXPECT_EQ(crossings.size(), 48u);
    EXPECT_TRUE(CSCD::test::is_closed_curve(surface, crossings));
    std::vector<Vector_3> points;
    CSCD::internal::crossing_points(surface, crossings, points);
    for (std::size_t i = 0; i < crossings.size(); ++i) {
      const Index h = crossings[i].halfedge;
      EXPECT_EQ(std::count(loop.begin(), loop.end(), surface.origin(h)), 1);
      EXPECT_EQ(std::count(loop.begin(), loop.end(), surface.target(h)), 0);
      const Vector_3 forward = points[(i + 1) % points.size()] - points[i];
      const Vector_3 left = surface.face_vector(Triangulated_surface::face(surface.twin(h))).cross(forward);
      EXPECT_GT(left.dot(surface.point(surface.target(h)) - surface.point(surface.origin(h))), 0);
      EXPECT_TRUE(!is_reversed || crossed_targets.count(surface.target(h)) == 0) << "both sides are the same";
      if (!is_reversed) {
        crossed_targets.insert(surface.target(h));
      }
    }
  }
}

TEST(Push_off, refuses_what_is_no_loop)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat));
  std::vector<Edge_crossing> crossings;
  Vertex_loop gap = middle_ring(24);
  gap.erase(gap.begin() + 5);
  EXPECT_FALSE(push_off(surface, gap, crossings));
  const Vertex_loop ring = middle_ring(24);
  EXPECT_FALSE(push_off(surface, {ring[0], ring[1], ring[2], ring[1]}, crossings)) << "there and back";
  EXPECT_FALSE(push_off(surface, {}, crossings));
}

TEST(Push_off, of_a_triangle_leaves_its_face_alone)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::sphere(1));
  std::vector<Edge_crossing> crossings;
  EXPECT_FALSE(push_off(surface, {surface.origin(0), surface.origin(1), surface.origin(2)}, crossings))
      << "to its left there is nothing to cross";
  ASSERT_TRUE(push_off(surface, {surface.origin(2), surface.origin(1), surface.origin(0)}, crossings));
  EXPECT_TRUE(CSCD::test::is_closed_curve(surface, crossings));
}

} // namespace
