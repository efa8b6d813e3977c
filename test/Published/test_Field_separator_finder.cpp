// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Separators from whole distance fields.

#include "Separator/is_closed_curve.h"
#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Options.h>
#include <CSCD/Published/Cut_loop_finder.h>
#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Published/Field_separator_finder.h>
#include <CSCD/Published/Heat_method.h>
#include <CSCD/Published/Sampled_search.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using CSCD::Cut_loop_outcome;
using CSCD::Index;
using CSCD::Search_outcome;
using CSCD::Shortening_outcome;
using CSCD::Target_rule;
using CSCD::Triangulated_surface;
using CSCD::Vector_3;
using CSCD::internal::Field_search_result;
using CSCD::test::pi;

/// A surface with all that separators are found with.
class Searched_surface
{
public:
  explicit Searched_surface(const CSCD::test::Shape& shape, Target_rule rule = Target_rule::nearest_in_space)
      : m_surface(CSCD::test::to_surface(shape)), m_space(m_surface, settings(rule)), m_finder(m_space.make_finder())
  {
  }

  const Triangulated_surface& surface() const { return m_surface; }

  /// The separator of the vertex nearest to `point`.
  Field_search_result find(const Vector_3& point)
  {
    const Index source = CSCD::test::nearest_vertex(m_surface, point);
    std::vector<double> distances;
    m_space.heat_method()({CSCD::internal::Geodesic_source::at_vertex(source)}, distances, m_workspace);
    Field_search_result result;
    m_finder(source, distances, result);
    if (result.outcome == Search_outcome::found) {
      EXPECT_TRUE(CSCD::test::is_closed_curve(m_surface, result.separator.crossings));
      EXPECT_EQ(result.separator.source, source);
    }
    return result;
  }

private:
  static CSCD::Field_search_settings settings(Target_rule rule)
  {
    CSCD::Field_search_settings result;
    result.target_rule = rule;
    return result;
  }

  using Space = CSCD::internal::Field_search_space<Triangulated_surface>;

  Triangulated_surface m_surface;
  Space m_space;
  CSCD::internal::Heat_method::Workspace m_workspace;
  Space::Finder m_finder;
};

/// What a search asks of a surface.
class Searched_triangulation
{
public:
  explicit Searched_triangulation(const CSCD::test::Shape& shape) : m_surface(CSCD::test::to_surface(shape)) {}
  const Triangulated_surface& triangulation() const { return m_surface; }

private:
  Triangulated_surface m_surface;
};

TEST(Field_separator_finder, goes_around_a_tube)
{
  Searched_surface searched(CSCD::test::tube(10, 1, 32, CSCD::test::Tube_end::flat));
  for (double x : {3., 5., 6.5}) {
    for (double angle : {0., 1., 2.5, 4.}) {
      const Field_search_result result = searched.find({x, std::cos(angle), std::sin(angle)});
      ASSERT_EQ(result.outcome, Search_outcome::found);
      EXPECT_NEAR(result.separator.length, 2 * pi, 0.05 * 2 * pi);
      EXPECT_NEAR(result.separator.center.x(), x, 0.3);
      EXPECT_NEAR(std::hypot(result.separator.center.y(), result.separator.center.z()), 0, 0.05);
    }
  }
}

TEST(Field_separator_finder, goes_around_the_tube_of_a_torus_not_around_its_hole)
{
  Searched_surface searched(CSCD::test::torus(3, 1, 32));
  for (const Vector_3& point : {Vector_3(4, 0, 0), Vector_3(0, 2, 0), Vector_3(-3, 0, 1)}) {
    const Field_search_result result = searched.find(point);
    ASSERT_EQ(result.outcome, Search_outcome::found);
    EXPECT_NEAR(result.separator.length, 2 * pi, 0.1 * 2 * pi);
    EXPECT_NEAR(result.separator.center.norm(), 3, 0.1);
  }
}

/// A wide flat box: through the body to the other side it is near, along the surface far.
TEST(Field_separator_finder, takes_the_target_that_the_rule_says)
{
  const CSCD::test::Shape shape = CSCD::test::midpoint_subdivided(CSCD::test::box("slab", {8, 4, 1}), 5);
  Searched_surface in_space(shape);
  Searched_surface along_surface(shape, Target_rule::nearest_along_surface);
  const Vector_3 middle(4, 2, 1);
  const Field_search_result first = in_space.find(middle);
  const Field_search_result second = along_surface.find(middle);
  ASSERT_EQ(first.outcome, Search_outcome::found);
  ASSERT_EQ(second.outcome, Search_outcome::found);
  EXPECT_NEAR(first.separator.length, 10, 0.5);
  EXPECT_NEAR(second.separator.length, 10, 0.5);
}

TEST(Field_separator_finder, answers_again_as_before)
{
  Searched_surface searched(CSCD::test::y_tube(0.15));
  const Field_search_result first = searched.find({1, 0, 0.3});
  searched.find({0, 1, 0.3});
  const Field_search_result again = searched.find({1, 0, 0.3});
  ASSERT_EQ(first.outcome, Search_outcome::found);
  EXPECT_EQ(first.separator.length, again.separator.length);
  EXPECT_EQ(first.separator.crossings.size(), again.separator.crossings.size());
}

TEST(Field_separator_finder, says_when_there_is_no_target)
{
  // Nothing is farther than a few edges.
  Searched_surface searched(CSCD::test::tetrahedron());
  const Field_search_result result = searched.find({0, 0, 0});
  EXPECT_EQ(result.outcome, Search_outcome::no_cut);
  EXPECT_EQ(result.loop, Cut_loop_outcome::no_cut_point);
}

/// On a cone, loops slide to the thin end until the locality constraint holds them.
TEST(Field_separator_finder, tells_loops_that_are_held_from_geodesics)
{
  Searched_surface cone(CSCD::test::tapered_tube(8, 0.3, 1.5, 32));
  const Field_search_result held = cone.find({4, 0.9, 0});
  ASSERT_EQ(held.outcome, Search_outcome::found);
  EXPECT_EQ(held.shortening, Shortening_outcome::held);
  Searched_surface torus(CSCD::test::torus(3, 1, 32));
  const Field_search_result straight = torus.find({4, 0, 0});
  ASSERT_EQ(straight.outcome, Search_outcome::found);
  EXPECT_EQ(straight.shortening, Shortening_outcome::straight);
}

TEST(Sampled_search, counts_loops_that_are_held)
{
  for (const bool is_cone : {true, false}) {
    const Searched_triangulation solid(is_cone ? CSCD::test::tapered_tube(8, 0.3, 1.5, 32)
                                               : CSCD::test::tube(10, 1, 32, CSCD::test::Tube_end::flat));
    CSCD::Skeletonization_report report;
    CSCD::Options settings;
    const std::vector<CSCD::Separator> separators =
        CSCD::internal::Sampled_search(solid, settings, CSCD::Field_search_settings())(96, report, [](double) {});
    EXPECT_GT(separators.size(), 48u);
    EXPECT_LE(report.number_of_held_loops + report.number_of_unfinished_loops, separators.size());
    if (is_cone) {
      EXPECT_GT(report.number_of_held_loops, separators.size() / 2);
    } else {
      EXPECT_LT(report.number_of_held_loops, separators.size() / 4);
    }
  }
}

} // namespace
