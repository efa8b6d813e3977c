// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the published method prepares to measure distances along a surface.

#include "Surface/to_bridged_surface.h"
#include "support/shapes.h"
#include <CSCD/Published/Field_separator_finder.h>
#include <CSCD/Published/Heat_method.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

TEST(Field_search_space, measures_around_a_slit_and_not_over_it)
{
  using CSCD::Index;
  const CSCD::Triangulated_surface surface = CSCD::test::to_bridged_surface(CSCD::test::slit_tube(12, 1, 24));
  const CSCD::internal::Field_search_space<CSCD::Triangulated_surface> space(surface, {});
  // Along the slit, the faces that fill it join both sides.
  Index source = 0;
  for (Index h = 3 * surface.first_hole_filling_face(); h < surface.number_of_halfedges(); ++h) {
    if (std::fabs(surface.point(surface.origin(h)).x() - 6) < std::fabs(surface.point(source).x() - 6)) {
      source = surface.origin(h);
    }
  }
  CSCD::internal::Heat_method::Workspace workspace;
  std::vector<double> distances;
  space.heat_method()({CSCD::internal::Geodesic_source::at_vertex(source)}, distances, workspace);
  // The slit is one edge wide: the path to its other side leads round the tube.
  double farthest = 0;
  for (const Index h : surface.outgoing(source)) {
    farthest = std::max(farthest, distances[surface.target(h)]);
  }
  EXPECT_NEAR(farthest, 2 * CSCD::test::pi * 23 / 24, 0.3);
}

} // namespace
