// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Separators made by edge flips are closed curves off the vertices, and have the measures of the geodesic.

#include "Separator/halfedges_along.h"
#include "Separator/is_closed_curve.h"
#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Published/Edge_flip_shortening.h>
#include <CSCD/Published/Field_separator_finder.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Shortening_outcome;
using CSCD::Triangulated_surface;
using CSCD::Vector_3;
using CSCD::test::pi;

TEST(Separator_flip_shortening, cuts_a_tube_across)
{
  constexpr Index around = 20;
  const Triangulated_surface surface =
      CSCD::test::to_surface(CSCD::test::tube(10, 1, around, CSCD::test::Tube_end::flat));
  CSCD::internal::Separator_flip_shortening shorten(surface, surface);
  CSCD::Separator separator;
  CSCD::Vertex_loop loop;
  // From ring 6 to ring 7 along a diagonal, and back along an edge of the tube.
  for (Index k = 0; k < around; ++k) {
    loop.push_back((k < 8 ? 6 : 7) * around + k);
  }
  loop.push_back(7 * around);
  EXPECT_EQ(shorten(CSCD::test::halfedges_along(surface, loop), loop.front(), separator), Shortening_outcome::straight);
  EXPECT_TRUE(CSCD::test::is_closed_curve(surface, separator.crossings));
  EXPECT_NEAR(separator.length, around * 2 * std::sin(pi / around), 1e-9);
  EXPECT_NEAR(std::fabs(separator.normal.x()), 1, 1e-9);
  EXPECT_LT(separator.planarity, 1e-9);
  // Pushed off the vertices it is nearly as long.
  std::vector<Vector_3> points;
  CSCD::internal::crossing_points(surface, separator.crossings, points);
  EXPECT_NEAR(CSCD::internal::measure_polygon(points).length, separator.length, 0.01 * separator.length);
  // The left side of the curve lies on the positive side of its normal.
  const Vector_3 left = surface.point(surface.target(separator.crossings.front().halfedge));
  const Vector_3 right = surface.point(surface.origin(separator.crossings.front().halfedge));
  EXPECT_GT((left - right).dot(separator.normal), 0);
}

TEST(Separator_flip_shortening, leaves_the_separator_alone_where_there_is_none)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::sphere(3));
  CSCD::internal::Separator_flip_shortening shorten(surface, surface);
  CSCD::Separator separator;
  separator.length = 7;
  std::vector<Index> ring;
  for (const Index h : surface.outgoing(100)) {
    ring.push_back(Triangulated_surface::next(h));
  }
  EXPECT_EQ(shorten(ring, 100, separator), Shortening_outcome::collapsed);
  EXPECT_EQ(separator.length, 7);
  EXPECT_TRUE(separator.crossings.empty());
}

TEST(push_off_vertices, finds_the_left_side_where_both_ways_lie_in_one_face)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::sphere(1));
  const Index vertex = 7;
  for (const Index incident_edge : surface.outgoing(vertex)) {
    const Index opposite = Triangulated_surface::next(incident_edge);
    const auto number_of_incident_edges = [&](double in, double out) {
      std::vector<CSCD::Edge_crossing> crossings;
      CSCD::internal::push_off_vertex(surface, {surface.twin(opposite), 1 - in}, {incident_edge, 0.}, {opposite, out},
                                      crossings);
      for (const CSCD::Edge_crossing& crossing : crossings) {
        EXPECT_EQ(surface.origin(crossing.halfedge), vertex);
      }
      return crossings.size();
    };
    EXPECT_EQ(number_of_incident_edges(0.3, 0.7), surface.degree(vertex));
    EXPECT_EQ(number_of_incident_edges(0.7, 0.3), 0u);
  }
}

} // namespace
