// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The published method, end to end.

#include "support/Allow_threads.h"
#include "support/Inside_count.h"
#include "support/Similarity.h"
#include "support/Skeleton_comparison.h"
#include "support/invariants.h"
#include "support/shapes.h"
#include "support/sheet_shapes.h"
#include <CSCD/Curve_skeletonization.h>
#include <CSCD/Published/Cut_loop_finder.h>
#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Published_policies.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Traits/Triangle_mesh_traits.h>
#include <CSCD/concepts.h>
#include <CSCD/exceptions.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/tags.h>

#include <boost/range/iterator_range.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numeric>

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Traits = CSCD::Triangle_mesh_traits<Mesh>;
using Policies = CSCD::Published_policies;
using Skeletonization = CSCD::Curve_skeletonization<Traits, Policies>;
using Skeleton = Skeletonization::Skeleton;
using CSCD::Skeletonization_report, CSCD::test::Plain_skeleton, CSCD::test::Shape, CSCD::test::Shape_maker;
using CSCD::test::Similarity;

constexpr std::size_t number_of_sources = 200;
/// Enough for properties that hold for all separators.
constexpr std::size_t few_sources = 32;

template <class ConcurrencyTag = CGAL::Sequential_tag>
Skeletonization_report skeletonize(const Mesh& mesh, Skeleton& skeleton, unsigned seed = 0,
                                   unsigned number_of_threads = 1, const Policies& policies = Policies(),
                                   std::size_t max_sources = number_of_sources)
{
  const Traits traits(mesh);
  Skeletonization skeletonization(traits, policies);
  skeletonization.set_random_seed(seed)
      .set_number_of_threads(number_of_threads)
      .set_maximum_number_of_sources(max_sources);
  return skeletonization.run<ConcurrencyTag>(skeleton);
}

class Published_method : public testing::TestWithParam<Shape_maker>
{
};

TEST_P(Published_method, keeps_the_invariants)
{
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(GetParam().make());
  Skeleton skeleton;
  const Skeletonization_report report = skeletonize(mesh, skeleton);
  EXPECT_EQ(CSCD::test::violated_invariants(mesh, skeleton, report), CSCD::test::Violations{});
  EXPECT_EQ(report.betti_number, report.genus);
  EXPECT_EQ(CSCD::test::count_inside(mesh, skeleton).number_of_nodes_outside, 0u);
  EXPECT_EQ(report.number_of_sources,
            report.number_of_separators + report.number_of_sources_without_cut + report.number_of_collapsed_loops);
  EXPECT_EQ(std::accumulate(report.number_of_rejections.begin(), report.number_of_rejections.end(), std::size_t(0)),
            report.number_of_sources_without_cut);
}

INSTANTIATE_TEST_SUITE_P(Known, Published_method, testing::ValuesIn(CSCD::test::shapes_with_known_skeleton()),
                         testing::PrintToStringParamName());

TEST(Published_policies, find_the_tips_of_limbs)
{
  Skeleton skeleton;
  const auto tips = [&](const CSCD::test::Shape& shape) {
    return skeletonize(CSCD::test::to_mesh<Mesh>(shape), skeleton).number_of_tips;
  };
  EXPECT_EQ(tips(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat)), 2u);
  EXPECT_EQ(tips(CSCD::test::y_tube(0.15)), 3u);
  EXPECT_EQ(tips(CSCD::test::star(5, 3, 0.35, 0.12)), 5u);
  EXPECT_EQ(tips(CSCD::test::torus(3, 1, 24)), 0u);
}

TEST(Published_policies, follow_the_middle_of_sheets)
{
  for (const CSCD::test::Sheet_shape& sheet :
       {CSCD::test::strip_sheet(8, 2), CSCD::test::torus_sheet(CSCD::test::pi), CSCD::test::y_sheet(6),
        CSCD::test::leaf_sheet(), CSCD::test::curved_sheet()}) {
    SCOPED_TRACE(sheet.shape.name);
    const Mesh mesh = CSCD::test::to_mesh<Mesh>(sheet.shape);
    const Traits traits(mesh, get(CGAL::vertex_point, mesh), CSCD::Border_treatment::automatic);
    Skeletonization skeletonization(traits);
    skeletonization.set_maximum_number_of_sources(number_of_sources);
    Skeleton skeleton;
    const Skeletonization_report& report = skeletonization.run(skeleton);
    EXPECT_EQ(report.number_of_sheets, 1u);
    EXPECT_GT(report.number_of_open_separators, 0u);
    EXPECT_EQ(report.betti_number, sheet.betti_number);
    const Plain_skeleton plain = CSCD::test::plain(mesh, skeleton);
    double sum = 0;
    for (const CSCD::test::Triple& point : plain.points) {
      sum += sheet.distance_from_middle(point) / sheet.half_width;
    }
    EXPECT_LT(sum / double(plain.points.size()), 0.05);
    if (report.number_of_junctions == 0) { // edges next to a junction cut the corner between middle lines
      EXPECT_LT(CSCD::test::max_distance_from_middle(sheet, plain.points, plain.edges), 0.05);
    }
    EXPECT_EQ(report.number_of_tips, sheet.ends.size());
    EXPECT_LT(CSCD::test::max_distance_from_ends(sheet, plain.points), 0.05);
  }
}

TEST(Published_policies, answer_the_same_for_any_number_of_threads)
{
  const CSCD::test::Allow_threads allow(3);
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::noisy(CSCD::test::y_tube(0.2), 0.05, 1));
  Skeleton sequential;
  skeletonize(mesh, sequential, 5);
  const CSCD::test::Plain_skeleton expected = CSCD::test::plain(mesh, sequential);
  for (unsigned number_of_threads : {1U, 2U, 3U}) {
    Skeleton parallel;
    skeletonize<CGAL::Parallel_if_available_tag>(mesh, parallel, 5, number_of_threads);
    EXPECT_TRUE(CSCD::test::plain(mesh, parallel) == expected);
  }
  Skeleton of_another_seed;
  skeletonize(mesh, of_another_seed, 6);
  EXPECT_FALSE(CSCD::test::plain(mesh, of_another_seed) == expected);
}

TEST(Published_policies, are_a_named_parameter)
{
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::y_tube(0.2));
  Skeleton expected;
  const Skeletonization_report expected_report = skeletonize(mesh, expected, 7, 1, Policies(), few_sources);
  Skeleton skeleton;
  const Skeletonization_report report = CSCD::extract_curve_skeleton(
      mesh, skeleton, CSCD::parameters::policies(Policies()).random_seed(7).maximum_number_of_sources(few_sources));
  EXPECT_EQ(CSCD::test::plain(mesh, skeleton), CSCD::test::plain(mesh, expected));
  EXPECT_EQ(report.number_of_sources, few_sources);
  EXPECT_EQ(report.number_of_rejections, expected_report.number_of_rejections);
  EXPECT_EQ(report.genus, 0u);
}

TEST(Published_policies, work_with_the_nearest_target_along_the_surface)
{
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::double_torus(0.15));
  Skeleton skeleton;
  CSCD::Field_search_settings settings;
  settings.target_rule = CSCD::Target_rule::nearest_along_surface;
  const Skeletonization_report report = skeletonize(mesh, skeleton, 0, 1, Policies(settings));
  EXPECT_EQ(report.betti_number, 2u);
  EXPECT_EQ(report.number_of_skeleton_components, 1u);
}

/// The number of tips of a tube with a limb, by `settings`.
std::size_t count_tips_of_limbs(const CSCD::Field_search_settings& settings)
{
  Skeleton skeleton;
  return skeletonize(CSCD::test::to_mesh<Mesh>(CSCD::test::y_tube(0.2)), skeleton, 0, 1, Policies(settings), 64)
      .number_of_tips;
}

void expect_two_cycles_of_two_handles(const CSCD::Field_search_settings& settings)
{
  Skeleton skeleton;
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::double_torus(0.2));
  const Skeletonization_report report = skeletonize(mesh, skeleton, 0, 1, Policies(settings), 64);
  EXPECT_EQ(report.betti_number, 2u);
  EXPECT_EQ(report.number_of_sources, 64u);
  EXPECT_EQ(CSCD::test::violated_invariants(mesh, skeleton, report), CSCD::test::Violations{});
}

TEST(Published_policies, work_with_targets_from_the_tree_of_the_cut_locus)
{
  CSCD::Field_search_settings settings;
  settings.cut_locus_rule = CSCD::Cut_locus_rule::tree;
  EXPECT_EQ(count_tips_of_limbs(settings), 3u);
  expect_two_cycles_of_two_handles(settings);
}

/// Fewer separators overlap, so that more are packed and there may be more tips.
TEST(Published_policies, work_as_printed)
{
  CSCD::Field_search_settings settings = CSCD::Field_search_settings::literal();
  for (const CSCD::Weight_rule rule : {CSCD::Weight_rule::balance_and_roundness, CSCD::Weight_rule::shortness}) {
    settings.weight_rule = rule;
    EXPECT_GE(count_tips_of_limbs(settings), 3u);
    expect_two_cycles_of_two_handles(settings);
  }
}

TEST(Published_policies, pack_the_shortest_first_where_length_is_the_weight)
{
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::tapered_tube(8, 0.3, 1.5, 32));
  const Traits traits(mesh);
  const auto length_of_first = [&](CSCD::Weight_rule rule) {
    CSCD::Field_search_settings settings;
    settings.weight_rule = rule;
    const Policies policies(settings);
    Skeletonization skeletonization(traits, policies);
    skeletonization.set_maximum_number_of_sources(number_of_sources);
    skeletonization.find_separators();
    skeletonization.pack_separators();
    return skeletonization.separators()[skeletonization.packed_separators().front()].length;
  };
  EXPECT_LT(length_of_first(CSCD::Weight_rule::shortness), length_of_first(CSCD::Weight_rule::balance_and_roundness));
}

TEST(Published_policies, leave_out_separators_that_cross_where_nodes_are_in_sections)
{
  CSCD::Field_search_settings settings;
  settings.overlap_rule = CSCD::Overlap_rule::crossing;
  expect_two_cycles_of_two_handles(settings);
}

TEST(Published_policies, cut_handles_that_no_source_finds)
{
  Skeleton skeleton;
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::double_torus(0.2));
  const Skeletonization_report report = skeletonize(mesh, skeleton, 0, 1, Policies(), 1);
  EXPECT_GE(report.number_of_handle_cuts, 1u);
  EXPECT_EQ(report.betti_number, 2u);
  EXPECT_EQ(CSCD::test::violated_invariants(mesh, skeleton, report), CSCD::test::Violations{});
}

/// Expects the nodes of a torus of radii 3 and 1 at this distance from its axis, with the tolerance of coarse sectors.
void expect_nodes_at(double radius, const Skeleton& skeleton)
{
  for (const auto node : boost::make_iterator_range(vertices(skeleton))) {
    const Point& p = skeleton[node].point;
    EXPECT_NEAR(std::hypot(p.x(), p.y()), radius, 0.1);
    EXPECT_NEAR(p.z(), 0, 0.1);
  }
}

TEST(Published_policies, place_nodes_at_centroids_as_printed)
{
  const CSCD::Field_search_settings settings = CSCD::Field_search_settings::literal();
  ASSERT_EQ(settings.placement_rule, CSCD::Placement_rule::centroids);
  Skeleton skeleton;
  skeletonize(CSCD::test::to_mesh<Mesh>(CSCD::test::torus(3, 1, 80)), skeleton, 0, 1, Policies(settings), 64);
  expect_nodes_at(3 + 1. / 6, skeleton); // the centroid of a short sector
}

class Multiscale_search : public testing::Test
{
protected:
  /// Of enough vertices for two levels.
  Mesh m_mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::torus(3, 1, 80));
  CSCD::Field_search_settings m_settings;
  Skeleton m_skeleton;

  Skeletonization_report run(bool is_multiscale, unsigned number_of_threads = 1)
  {
    m_settings.is_multiscale = is_multiscale;
    return skeletonize<CGAL::Parallel_if_available_tag>(m_mesh, m_skeleton, 0, number_of_threads, Policies(m_settings),
                                                        64);
  }
};

TEST_F(Multiscale_search, finds_what_a_search_on_the_surface_finds)
{
  const Skeletonization_report expected = run(false);
  const Skeletonization_report report = run(true);
  EXPECT_GT(report.number_of_levels, 1u);
  EXPECT_EQ(report.betti_number, 1u);
  EXPECT_GT(report.number_of_separators, expected.number_of_separators * 9 / 10);
  expect_nodes_at(3, m_skeleton);
}

/// For any separators, even without any.
class Published_method_on_hard_shapes : public Published_method
{
};

TEST_P(Published_method_on_hard_shapes, keeps_the_invariants)
{
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(GetParam().make());
  Skeleton skeleton;
  const Skeletonization_report report = skeletonize(mesh, skeleton, 0, 1, Policies(), few_sources);
  EXPECT_EQ(CSCD::test::violated_invariants(mesh, skeleton, report), CSCD::test::Violations{});
}

INSTANTIATE_TEST_SUITE_P(Closed, Published_method_on_hard_shapes, testing::ValuesIn(CSCD::test::hard_closed_shapes()),
                         testing::PrintToStringParamName());
INSTANTIATE_TEST_SUITE_P(Open, Published_method_on_hard_shapes, testing::ValuesIn(CSCD::test::open_shapes()),
                         testing::PrintToStringParamName());

class Published_invariance : public testing::TestWithParam<Shape_maker>
{
protected:
  static Plain_skeleton skeletonized(const Shape& shape)
  {
    const Mesh mesh = CSCD::test::to_mesh<Mesh>(shape);
    Skeleton skeleton;
    skeletonize(mesh, skeleton, 0, 1, Policies(), few_sources);
    return CSCD::test::plain(mesh, skeleton);
  }

  /// Distances that may be due to rounding, relative to the diagonal of the bounding box.
  static constexpr double relative_tolerance = 1e-6;

  Shape m_shape = GetParam().make();
};

INSTANTIATE_TEST_SUITE_P(Asymmetric, Published_invariance, testing::ValuesIn(CSCD::test::asymmetric_shapes()),
                         testing::PrintToStringParamName());

TEST_P(Published_invariance, under_renumbering)
{
  const CSCD::test::Renumbered_shape other = CSCD::test::renumbered(m_shape, 1);
  const Plain_skeleton expected = renamed(skeletonized(m_shape), other.new_number);
  EXPECT_EQ(difference(expected, skeletonized(other.shape), relative_tolerance * diagonal(m_shape)), "");
}

struct Stopping_visitor : CSCD::Default_skeletonization_visitor
{
  void progress(double fraction) { m_fraction = fraction; }
  bool go_further() const { return m_fraction < 0.3; }
  double m_fraction = 0;
};

TEST(Published_policies, can_be_stopped)
{
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::y_tube(0.2));
  const Traits traits(mesh);
  CSCD::Curve_skeletonization<Traits, Policies, Stopping_visitor> skeletonization(traits);
  EXPECT_THROW(skeletonization.find_separators(), CSCD::Cancelled_error);
  EXPECT_LT(skeletonization.report().number_of_sources, Policies::default_number_of_sources / 2);
}

} // namespace
