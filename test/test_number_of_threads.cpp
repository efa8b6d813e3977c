// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The answer is the same to the last bit from run to run, for any number of threads, and during other calls.

#include "support/Allow_threads.h"
#include "support/Skeleton_comparison.h"
#include "support/shapes.h"
#include <CSCD/Published_policies.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <future>
#include <vector>

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Skeleton = CSCD::Skeleton_graph<Point, Mesh::Vertex_index>;
using CSCD::test::Plain_skeleton;
using CSCD::test::Shape_maker;

/// Arbitrary, but not the default.
constexpr unsigned seed = 5;

/// Expects the use of the requested number of threads, if given.
template <class ConcurrencyTag>
Plain_skeleton skeletonize(const Mesh& mesh, unsigned number_of_threads)
{
  Skeleton skeleton;
  const CSCD::Skeletonization_report report = CSCD::extract_curve_skeleton<ConcurrencyTag>(
      mesh, skeleton, CSCD::parameters::random_seed(seed).number_of_threads(number_of_threads));
  if (number_of_threads > 0) {
    EXPECT_EQ(report.number_of_threads, number_of_threads);
  }
  return CSCD::test::plain(mesh, skeleton);
}

std::vector<Shape_maker> shapes_of_many_sources()
{
  using namespace CSCD::test;
  return {{"noisy_y_tube", [] { return noisy(y_tube(0.2), 0.05, 1); }},
          {"comb", [] { return comb(6, 0.2); }},
          {"chain", [] { return chain_of_rings(3, 12); }},
          {"capsule_with_holes", [] { return with_small_holes(capsule(8, 1, 24), 5, 7); }},
          // Of more vertices than loops over vertices pass at once.
          {"fine_torus_with_holes", [] { return with_small_holes(torus(3, 1, 80), 5, 7); }}};
}

class Number_of_threads : public testing::TestWithParam<Shape_maker>
{
};

TEST_P(Number_of_threads, changes_nothing)
{
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(GetParam().make());
  const Plain_skeleton expected = skeletonize<CGAL::Sequential_tag>(mesh, 1);
  EXPECT_EQ(expected, skeletonize<CGAL::Sequential_tag>(mesh, 1)) << "from run to run";
  EXPECT_EQ(expected, skeletonize<CGAL::Parallel_if_available_tag>(mesh, 0));
#ifdef CGAL_LINKED_WITH_TBB
  const unsigned max_threads = 4;
  const CSCD::test::Allow_threads allow(max_threads);
  for (unsigned number_of_threads = 1; number_of_threads <= max_threads; ++number_of_threads) {
    SCOPED_TRACE(number_of_threads);
    EXPECT_EQ(expected, skeletonize<CGAL::Parallel_tag>(mesh, number_of_threads));
  }
#endif
}

/// Two calls at once, by both methods, give the same results as each alone.
TEST(Calls_from_two_threads, do_not_disturb_each_other)
{
  const Mesh comb = CSCD::test::to_mesh<Mesh>(CSCD::test::comb(6, 0.2));
  const Mesh torus = CSCD::test::to_mesh<Mesh>(CSCD::test::torus(3, 1, 16));
  const auto by_default = [&] { return skeletonize<CGAL::Sequential_tag>(comb, 1); };
  const auto as_published = [&] {
    Skeleton skeleton;
    CSCD::extract_curve_skeleton(torus, skeleton,
                                 CSCD::parameters::policies(CSCD::Published_policies()).maximum_number_of_sources(16));
    return CSCD::test::plain(torus, skeleton);
  };
  const Plain_skeleton expected_by_default = by_default();
  const Plain_skeleton expected_as_published = as_published();
  for (int round = 0; round < 3; ++round) {
    auto first = std::async(std::launch::async, by_default);
    auto second = std::async(std::launch::async, by_default);
    auto third = std::async(std::launch::async, as_published);
    EXPECT_EQ(expected_as_published, as_published());
    EXPECT_EQ(expected_by_default, first.get());
    EXPECT_EQ(expected_by_default, second.get());
    EXPECT_EQ(expected_as_published, third.get());
  }
}

INSTANTIATE_TEST_SUITE_P(All, Number_of_threads, testing::ValuesIn(shapes_of_many_sources()),
                         testing::PrintToStringParamName());

} // namespace
