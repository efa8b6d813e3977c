// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The published method on point clouds, end to end: topology on generated shapes, invariance of the skeleton, and input
// that does not sample a surface.

#include "support/Shape.h"
#include "support/Similarity.h"
#include "support/Skeleton_comparison.h"
#include "support/invariants.h"
#include "support/point_skeletons.h"
#include "support/sampling.h"
#include "support/shapes.h"
#include <CSCD/Curve_skeletonization.h>
#include <CSCD/Local_policies.h>
#include <CSCD/Points/Point_complex.h>
#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Published_policies.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Traits/Point_set_traits.h>
#include <CSCD/Traits/Triangle_mesh_traits.h>
#include <CSCD/Vector3.h>
#include <CSCD/concepts.h>
#include <CSCD/exceptions.h>
#include <CSCD/extract_curve_skeleton_from_points.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Points = std::vector<Point>;
using CSCD::Index, CSCD::Vector3;
using Traits = CSCD::Point_set_traits<Points>;
using Policies = CSCD::Published_policies;
using Skeletonization = CSCD::Curve_skeletonization<Traits, Policies>;
using Skeleton = Skeletonization::Skeleton;
using CSCD::test::Plain_skeleton, CSCD::test::Shape, CSCD::test::Shape_maker, CSCD::test::Similarity,
    CSCD::test::Triple;

constexpr std::size_t number_of_points = 3000;
constexpr std::size_t number_of_sources = 160;
/// Enough for properties that hold for all separators.
constexpr std::size_t few_sources = 32;

struct Outcome
{
  Skeleton skeleton;
  CSCD::Skeletonization_report report;
};

/// Skeletonizes and checks properties that hold for every point set.
template <class ConcurrencyTag = CGAL::Sequential_tag>
Outcome skeletonize(const std::vector<Triple>& triples, std::size_t max_sources = number_of_sources,
                    unsigned number_of_threads = 1, const CSCD::Field_search_settings& settings = {})
{
  const Points points = CSCD::test::to_points<Point>(triples);
  const Traits traits(points);
  Skeletonization skeletonization(traits, Policies(settings));
  skeletonization.set_maximum_number_of_sources(max_sources).set_number_of_threads(number_of_threads);
  Outcome outcome;
  outcome.report = skeletonization.run<ConcurrencyTag>(outcome.skeleton);
  CSCD::test::expect_partition(outcome.skeleton, points.size());
  EXPECT_EQ(points.size(), outcome.report.number_of_input_vertices);
  EXPECT_FALSE(outcome.report.genus.has_value()) << "nobody knows it";
  EXPECT_EQ(outcome.report.number_of_skeleton_components, outcome.report.number_of_surface_components);
  EXPECT_EQ(CSCD::test::Violations{}, CSCD::test::violations_of_graph(outcome.skeleton));
  for (const auto packed : skeletonization.packed_separators()) {
    EXPECT_GE(skeletonization.polyline(skeletonization.separators()[packed]).size(), 3u);
  }
  return outcome;
}

TEST(Point_set_traits, know_the_body)
{
  const Points points = CSCD::test::to_points<Point>(sampled(CSCD::test::torus(3, 1, 48), 4000, 1));
  const Traits traits(points);
  const double unit = traits.normalization().unit;
  const auto normalized = [&](double x, double y, double z) {
    return traits.normalization().from_input(Vector3(x, y, z));
  };
  EXPECT_TRUE(traits.surface().is_inside(normalized(3, 0, 0)));
  EXPECT_FALSE(traits.surface().is_inside(normalized(0, 0, 0)));
  EXPECT_FALSE(traits.surface().is_inside(normalized(3, 0, 1.3)));
  const auto middle = traits.surface().middle_behind(normalized(3, 0, 1.3));
  ASSERT_TRUE(middle);
  EXPECT_LT((*middle - normalized(3, 0, 0)).norm() * unit, 0.2);
  std::vector<double> distances;
  traits.surface().crossings(normalized(0, 0, 0), normalized(6, 0, 0), distances);
  ASSERT_EQ(distances.size(), 2u);
  EXPECT_NEAR(distances[0] * unit, 2, 0.1);
  EXPECT_NEAR(distances[1] * unit, 4, 0.1);
  traits.surface().crossings(normalized(0, 0, 0), normalized(0, 0, 0), distances);
  EXPECT_TRUE(distances.empty());
}

std::vector<Shape_maker> shapes()
{
  using namespace CSCD::test;
  return {{"capsule", [] { return capsule(8, 1, 24); }},
          {"torus", [] { return torus(3, 1, 24); }},
          {"trefoil_knot", [] { return trefoil_knot(0.4, 16); }},
          {"y_tube", [] { return y_tube(0.15); }},
          {"double_torus", [] { return double_torus(0.12); }},
          {"sphere", [] { return sphere(4); }},
          {"two_components", [] {
             return merged("", {capsule(8, 1, 16), translated(torus(3, 1, 16), {0, 10, 0})});
           }}};
}

class Sampled_cloud : public testing::TestWithParam<Shape_maker>
{
protected:
  void expect_topology(const Outcome& outcome) const
  {
    EXPECT_EQ(m_shape.number_of_components, outcome.report.number_of_skeleton_components);
    EXPECT_EQ(m_shape.genus, outcome.report.betti_number);
  }

  Shape m_shape = GetParam().make();
};

INSTANTIATE_TEST_SUITE_P(All, Sampled_cloud, testing::ValuesIn(shapes()), testing::PrintToStringParamName());

TEST_P(Sampled_cloud, has_the_topology_of_the_shape)
{
  for (const unsigned seed : {1u, 2u}) {
    SCOPED_TRACE(seed);
    expect_topology(skeletonize(sampled(m_shape, number_of_points, seed)));
  }
}

TEST_P(Sampled_cloud, has_nearly_the_skeleton_of_the_mesh)
{
  if (m_shape.name == CSCD::test::sphere(4).name) {
    GTEST_SKIP() << "a ball has no natural curve skeleton";
  }
  using Mesh = CGAL::Surface_mesh<Point>;
  using Mesh_traits = CSCD::Triangle_mesh_traits<Mesh>;
  using Mesh_skeletonization = CSCD::Curve_skeletonization<Mesh_traits, CSCD::Published_policies>;
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(m_shape);
  const Mesh_traits traits(mesh);
  Mesh_skeletonization skeletonization(traits);
  Mesh_skeletonization::Skeleton expected;
  skeletonization.set_maximum_number_of_sources(number_of_sources).run(expected);
  const std::vector<Triple> of_mesh = CSCD::test::plain(mesh, expected).points;
  const std::vector<Triple> of_points =
      CSCD::test::plain(skeletonize(sampled(m_shape, number_of_points, 1)).skeleton).points;
  // Separators are drawn from other sources, and nodes are farther from each other than those of the local method.
  const double tolerance = 0.03 * diagonal(m_shape);
  EXPECT_LT(CSCD::test::mean_distance(of_points, of_mesh), tolerance);
  EXPECT_LT(CSCD::test::mean_distance(of_mesh, of_points), tolerance);
}

TEST(Point_cloud_skeleton, refuses_overlap_by_crossings)
{
  CSCD::Field_search_settings settings;
  settings.overlap_rule = CSCD::Overlap_rule::crossing;
  const std::vector<Triple> points = sampled(CSCD::test::capsule(8, 1, 24), 500, 1);
  EXPECT_THROW(skeletonize(points, 1, 1, settings), CSCD::Input_error);
}

std::vector<Triple> some_points()
{
  return sampled(CSCD::test::double_torus(0.2), number_of_points, 1);
}

TEST(Point_cloud_skeleton, comes_by_the_named_parameter_policies)
{
  const std::vector<Triple> triples = some_points();
  const Outcome expected = skeletonize(triples, few_sources);
  const Points points = CSCD::test::to_points<Point>(triples);
  Skeleton skeleton;
  const CSCD::Skeletonization_report report = CSCD::extract_curve_skeleton(
      points, skeleton, CSCD::parameters::policies(Policies()).maximum_number_of_sources(few_sources));
  EXPECT_EQ(CSCD::test::plain(skeleton), CSCD::test::plain(expected.skeleton));
  EXPECT_FALSE(report.genus.has_value()) << "no surface is made of the points";
  EXPECT_FALSE(report.reconstruction.has_value());
  EXPECT_EQ(report.number_of_rejections, expected.report.number_of_rejections);
}

} // namespace
