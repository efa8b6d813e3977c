// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pipeline step by step: its answer and the order of its stages.

#include "support/convert_shape.h"
#include "support/implicit_surface.h"
#include "support/shapes.h"
#include "support/sheet_shapes.h"
#include <CSCD/Curve_skeletonization.h>
#include <CSCD/Local_policies.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Traits/Triangle_mesh_traits.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Traits = CSCD::Triangle_mesh_traits<Mesh>;
using Skeletonization = CSCD::Curve_skeletonization<Traits>;
using Skeleton = Skeletonization::Skeleton;
using CSCD::Default_skeletonization_visitor, CSCD::Local_policies;

static_assert(std::is_constructible_v<Skeletonization, const Traits&>);
static_assert(std::is_constructible_v<Skeletonization, Traits&, Local_policies, Default_skeletonization_visitor>);
static_assert(!std::is_constructible_v<Skeletonization, Traits>, "temporary traits are refused");
static_assert(!std::is_constructible_v<Skeletonization, const Traits>);
static_assert(!std::is_constructible_v<Skeletonization, Traits, Local_policies>);
static_assert(!std::is_constructible_v<Skeletonization, Traits, Local_policies, Default_skeletonization_visitor>);

void expect_equal(const Skeleton& a, const Skeleton& b)
{
  ASSERT_EQ(num_vertices(a), num_vertices(b));
  ASSERT_EQ(num_edges(a), num_edges(b));
  for (std::size_t node = 0; node < num_vertices(a); ++node) {
    EXPECT_EQ(a[node].point, b[node].point);
    EXPECT_EQ(a[node].radius, b[node].radius);
    EXPECT_EQ(a[node].vertices, b[node].vertices);
  }
  for (auto [e, f] = std::make_pair(edges(a).first, edges(b).first); e != edges(a).second; ++e, ++f) {
    EXPECT_EQ(source(*e, a), source(*f, b));
    EXPECT_EQ(target(*e, a), target(*f, b));
  }
}

class Curve_skeletonization : public testing::Test
{
protected:
  Mesh m_mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::y_tube(0.15));
  Traits m_traits{m_mesh};
};

TEST_F(Curve_skeletonization, of_a_mesh_makes_its_traits)
{
  Skeleton whole;
  Skeletonization(m_traits).run(whole);
  CSCD::Curve_skeletonization of_mesh(m_mesh);
  static_assert(std::is_same_v<decltype(of_mesh), Skeletonization>);
  CSCD::Curve_skeletonization moved(std::move(of_mesh));
  Skeleton skeleton;
  moved.run(skeleton);
  expect_equal(skeleton, whole);
}

TEST(Curve_skeletonization_of_a_sheet, equals_the_free_function)
{
  const Mesh sheet = CSCD::test::to_mesh<Mesh>(CSCD::test::strip_sheet(8, 2).shape);
  Skeleton skeleton;
  EXPECT_EQ(1U, CSCD::Curve_skeletonization(sheet).run(skeleton).number_of_sheets);
  Skeleton free_function;
  CSCD::extract_curve_skeleton(sheet, free_function);
  expect_equal(skeleton, free_function);
}

TEST_F(Curve_skeletonization, step_by_step_equals_all_at_once)
{
  Skeletonization steps(m_traits);
  Skeleton stepwise;
  const std::size_t number_of_separators = steps.find_separators();
  EXPECT_EQ(number_of_separators, steps.separators().size());
  const std::size_t number_of_packed_separators = steps.pack_separators();
  EXPECT_EQ(number_of_packed_separators, steps.packed_separators().size());
  steps.convert_to_skeleton(stepwise);
  Skeleton whole;
  Skeletonization all(m_traits);
  all.run(whole);
  expect_equal(stepwise, whole);
  Skeleton free_function;
  CSCD::extract_curve_skeleton(m_mesh, free_function);
  expect_equal(stepwise, free_function);
  Skeleton parallel;
  all.run<CGAL::Parallel_tag>(parallel);
  expect_equal(stepwise, parallel);
}

TEST(Curve_skeletonization_of_a_pipe, may_be_packed_again)
{
  const auto wall = [](const CSCD::test::Triple& p) {
    return std::fmax(std::fabs(std::hypot(p[0], p[1]) - 0.75) - 0.25, std::fabs(p[2]) - 1.5);
  };
  const Mesh pipe =
      CSCD::test::to_mesh<Mesh>(CSCD::test::implicit_surface(wall, {-1.3, -1.3, -1.8}, {1.3, 1.3, 1.8}, 0.1));
  const Traits traits(pipe);
  Skeletonization skeletonization(traits);
  skeletonization.find_separators();
  skeletonization.pack_separators();
  EXPECT_GT(skeletonization.report().number_of_tunnels, 0U);
  Skeleton once;
  skeletonization.convert_to_skeleton(once);
  skeletonization.pack_separators();
  Skeleton twice;
  skeletonization.convert_to_skeleton(twice);
  expect_equal(once, twice);
}

TEST_F(Curve_skeletonization, draws_separators_in_the_coordinates_of_the_input)
{
  Skeletonization skeletonization(m_traits);
  skeletonization.find_separators();
  for (const CSCD::Separator& separator : skeletonization.separators()) {
    const std::vector<Point> polyline = skeletonization.polyline(separator);
    ASSERT_EQ(polyline.size(), separator.crossings.size());
    double length = 0;
    for (std::size_t i = 0; i < polyline.size(); ++i) {
      length += std::sqrt(CGAL::squared_distance(polyline[i], polyline[(i + 1) % polyline.size()]));
    }
    EXPECT_NEAR(length, m_traits.normalization().unit * separator.length, 1e-9);
  }
}

TEST_F(Curve_skeletonization, requires_stages_in_order)
{
  Skeletonization skeletonization(m_traits);
  Skeleton skeleton;
  EXPECT_THROW(skeletonization.convert_to_skeleton(skeleton), CGAL::Precondition_exception);
  EXPECT_THROW(skeletonization.packed_separators(), CGAL::Precondition_exception);
}

} // namespace
