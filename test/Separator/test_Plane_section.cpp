// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plane sections: known lengths, planes through vertices, edges and whole faces, and the axis of a limb.

#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Separator/Plane_section.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace {

using CSCD::Edge_crossing, CSCD::Index, CSCD::Triangulated_surface, CSCD::Vector3, CSCD::internal::Plane_section;

constexpr double any_length = std::numeric_limits<double>::max();

/// Whether every crossing lies strictly within its edge, and the curve continues in the face that it has entered.
testing::AssertionResult is_closed_curve(const Triangulated_surface& surface,
                                         const std::vector<Edge_crossing>& crossings)
{
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const Edge_crossing& crossing = crossings[i];
    const Edge_crossing& next = crossings[(i + 1) % crossings.size()];
    if (!(crossing.position > 0 && crossing.position < 1)) {
      return testing::AssertionFailure() << "crossing " << i << " at position " << crossing.position;
    }
    if (Triangulated_surface::face(surface.twin(crossing.halfedge)) != Triangulated_surface::face(next.halfedge)) {
      return testing::AssertionFailure() << "crossing " << i << " and the next one share no face";
    }
    if (surface.edge(crossing.halfedge) == surface.edge(next.halfedge)) {
      return testing::AssertionFailure() << "crossing " << i << " is followed by one of the same edge";
    }
  }
  return testing::AssertionSuccess();
}

/// Whether no edge is crossed twice.
bool is_simple(const Triangulated_surface& surface, const std::vector<Edge_crossing>& crossings)
{
  std::set<Index> edges;
  for (const Edge_crossing& crossing : crossings) {
    edges.insert(surface.edge(crossing.halfedge));
  }
  return edges.size() == crossings.size();
}

TEST(Plane_section, closes_for_every_vertex_and_every_axis)
{
  const std::vector<Vector3> axes{{1, 0, 0},
                                  {0, 1, 0},
                                  {0, 0, -1},
                                  Vector3(1, 1, 0).normalized(),
                                  Vector3(1, 1, 1).normalized(),
                                  Vector3(0.3, -0.5, 0.7).normalized()};
  for (const CSCD::test::Shape& shape :
       {CSCD::test::subdivided_cube(2), CSCD::test::beam(), CSCD::test::plate_with_hole(), CSCD::test::l_bracket(),
        CSCD::test::tetrahedron(), CSCD::test::noisy(CSCD::test::torus(3, 1, 12), 0.3, 1)}) {
    SCOPED_TRACE(shape.name);
    const Triangulated_surface surface = CSCD::test::to_surface(shape);
    Plane_section section(surface);
    for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
      for (const Vector3& axis : axes) {
        bool is_minimum = true;
        for (const Index h : surface.outgoing(vertex)) {
          is_minimum = is_minimum && axis.dot(surface.point(surface.target(h))) >= axis.dot(surface.point(vertex));
        }
        ASSERT_EQ(section.cut_at_vertex(vertex, axis, any_length), !is_minimum);
        if (!is_minimum) {
          ASSERT_TRUE(is_closed_curve(surface, section.crossings()));
          ASSERT_TRUE(is_simple(surface, section.crossings()));
        }
      }
    }
  }
}

TEST(Plane_section, knows_the_axis_of_a_tube_and_of_a_cone)
{
  for (const CSCD::test::Shape& shape :
       {CSCD::test::tube(10, 1, 48, CSCD::test::Tube_end::flat), CSCD::test::tapered_tube(10, 0.4, 1.2, 48)}) {
    SCOPED_TRACE(shape.name);
    const Triangulated_surface surface = CSCD::test::to_surface(shape);
    Plane_section section(surface);
    for (const Vector3& tilted : {Vector3(1, 0, 0), Vector3(1, 0.3, 0), Vector3(1, -0.2, 0.4)}) {
      ASSERT_TRUE(
          section.cut_at_vertex(CSCD::test::nearest_vertex(surface, {5, 0, 1}), tilted.normalized(), any_length));
      EXPECT_GT(std::fabs(section.symmetry_axis().x()), std::cos(0.05));
      EXPECT_NEAR(section.symmetry_axis().norm(), 1, 1e-9);
    }
  }
}

} // namespace
