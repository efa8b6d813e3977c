// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The target of a source: opposite, across the body, never across a hole.

#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Local/Geodesic_polar_coordinates.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace {

using CSCD::Index;
using CSCD::no_index;
using CSCD::Triangulated_surface;
using CSCD::Vector_3;
using CSCD::Vertex_fan_table;
using CSCD::internal::Geodesic_polar_coordinates;
using CSCD::internal::Nearest_meeting;
using CSCD::test::pi;

/// A surface and the targets on it.
class Target_finder
{
public:
  explicit Target_finder(const CSCD::test::Shape& shape)
      : m_surface(CSCD::test::to_surface(shape)), m_corners(m_surface),
        m_front(m_corners, m_surface.number_of_vertices())
  {
  }

  const Triangulated_surface& surface() const { return m_surface; }
  std::size_t number_of_visits() const { return m_front.number_of_visits(); }

  /// The point of the target of `source`, if there is one.
  std::optional<Vector_3> operator()(Index source)
  {
    Nearest_meeting meeting(m_surface, m_front, source);
    m_front.grow(source, std::numeric_limits<std::size_t>::max(), meeting);
    if (!meeting.has_found()) {
      return std::nullopt;
    }
    EXPECT_NE(m_surface.find_halfedge(meeting.first(), meeting.second()), no_index);
    return (m_surface.point(meeting.first()) + m_surface.point(meeting.second())) / 2;
  }

private:
  Triangulated_surface m_surface;
  Vertex_fan_table m_corners;
  Geodesic_polar_coordinates m_front;
};

TEST(Nearest_meeting, lies_opposite_on_a_tube)
{
  Target_finder finder(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat));
  const double edge = 2 * pi / 24;
  std::size_t number_of_sources = 0;
  for (Index source = 0; source < finder.surface().number_of_vertices(); ++source) {
    const Vector_3 from = finder.surface().point(source);
    if (std::fabs(from.x() - 5) > 2) {
      continue;
    }
    ++number_of_sources;
    const std::optional<Vector_3> target = finder(source);
    ASSERT_TRUE(target);
    EXPECT_LT((*target - Vector_3(from.x(), -from.y(), -from.z())).norm(), 2 * edge);
    EXPECT_LT(finder.number_of_visits(), finder.surface().number_of_vertices() * 3 / 4) << "it should stop early";
  }
  EXPECT_GT(number_of_sources, 300u);
}

TEST(Nearest_meeting, lies_opposite_on_a_thin_limb_of_four_edges)
{
  Target_finder finder(CSCD::test::tube(20, 1, 4, CSCD::test::Tube_end::flat));
  const Index source = CSCD::test::nearest_vertex(finder.surface(), {10, 0, 1});
  const std::optional<Vector_3> target = finder(source);
  ASSERT_TRUE(target);
  EXPECT_LT(target->dot(Vector_3(0, finder.surface().point(source).y(), finder.surface().point(source).z())), 0);
}

TEST(Nearest_meeting, goes_around_the_tube_of_a_torus_not_through_its_hole)
{
  // The hole is narrower than the tube: across it, the opposite side would be nearer.
  const double major_radius = 1.5;
  Target_finder finder(CSCD::test::torus(major_radius, 1, 24));
  for (Index source = 0; source < finder.surface().number_of_vertices(); source += 5) {
    const Vector_3 from = finder.surface().point(source);
    const std::optional<Vector_3> target = finder(source);
    if (!target) {
      continue;
    }
    const Vector_3 middle = (from + *target) / 2;
    EXPECT_LT(std::fabs(std::hypot(middle.x(), middle.y()) - major_radius), 1) << "the chord lies in the tube";
    EXPECT_LE((*target - from).norm(), 2.1);
    EXPECT_GT((*target - from).norm(), 1);
  }
}

TEST(Nearest_meeting, is_found_for_most_sources_of_a_torus)
{
  Target_finder finder(CSCD::test::torus(3, 1, 24));
  std::size_t found = 0;
  std::size_t tried = 0;
  for (Index source = 0; source < finder.surface().number_of_vertices(); source += 7) {
    found += finder(source).has_value() ? 1u : 0u;
    ++tried;
  }
  EXPECT_GT(found, tried * 9 / 10);
}

TEST(Nearest_meeting, is_not_sought_across_the_outside)
{
  Target_finder finder(CSCD::test::reversed(CSCD::test::sphere(3)));
  for (Index source = 0; source < finder.surface().number_of_vertices(); source += 10) {
    EXPECT_FALSE(finder(source)) << "seen from inside, all meetings are across the outside";
  }
}

} // namespace
