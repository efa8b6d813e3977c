// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// For every kind of input and both methods, a visitor is notified of each stage, and can stop the work.

#include "support/expect_skeleton.h"
#include "support/sampling.h"
#include "support/shapes.h"
#include <CSCD/Published_policies.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/exceptions.h>
#include <CSCD/extract_curve_skeleton.h>
#include <CSCD/extract_curve_skeleton_from_graph.h>
#include <CSCD/extract_curve_skeleton_from_points.h>
#include <CSCD/extract_curve_skeleton_from_volume.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/adjacency_list.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Stages = std::vector<CSCD::Skeletonization_stage>;

const Stages all_stages{CSCD::Skeletonization_stage::compile_surface, CSCD::Skeletonization_stage::find_separators,
                        CSCD::Skeletonization_stage::pack_separators, CSCD::Skeletonization_stage::build_skeleton};

struct Record
{
  Stages begun;
  Stages ended;
  std::vector<std::vector<double>> fractions;
  std::size_t number_of_questions = 0;
};

/// Records its notifications, and stops the work at a question, counted from 1; 0: never.
class Recording_visitor
{
public:
  explicit Recording_visitor(Record& record, std::size_t last_question = 0)
      : m_record(&record), m_last_question(last_question)
  {
  }

  void on_stage_begin(CSCD::Skeletonization_stage stage)
  {
    m_record->begun.push_back(stage);
    m_record->fractions.emplace_back();
  }
  void on_stage_end(CSCD::Skeletonization_stage stage) { m_record->ended.push_back(stage); }
  void progress(double fraction) { m_record->fractions.back().push_back(fraction); }
  bool go_further() { return ++m_record->number_of_questions != m_last_question; }

private:
  Record* m_record;
  std::size_t m_last_question;
};

/// \param extract is called with a skeleton and named parameters
template <class Skeleton, class Extract>
void expect_heard_and_obeyed(const Extract& extract)
{
  Record whole;
  Skeleton skeleton;
  extract(skeleton, CSCD::parameters::visitor(Recording_visitor(whole)));
  EXPECT_EQ(whole.begun, all_stages);
  EXPECT_EQ(whole.ended, all_stages);
  for (const std::vector<double>& fractions : whole.fractions) {
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_TRUE(std::all_of(fractions.begin(), fractions.end(), [](double f) { return f >= 0 && f <= 1; }));
  }

  ASSERT_GT(whole.number_of_questions, 0u);
  for (const std::size_t question : {std::size_t(1), whole.number_of_questions}) {
    SCOPED_TRACE(question);
    Skeleton marked = CSCD::test::marked_skeleton<Skeleton>();
    Record record;
    EXPECT_THROW(extract(marked, CSCD::parameters::visitor(Recording_visitor(record, question))),
                 CSCD::Cancelled_error);
    EXPECT_EQ(record.number_of_questions, question) << "asked again after it said no";
    CSCD::test::expect_is_marked(marked);
  }
}

using Skeleton_of_mesh = CSCD::Skeleton_graph<Point, Mesh::Vertex_index>;
using Skeleton_of_numbers = CSCD::Skeleton_graph<Point, std::size_t>;

TEST(Visitor, of_a_mesh)
{
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::y_tube(0.2));
  expect_heard_and_obeyed<Skeleton_of_mesh>(
      [&](auto& skeleton, const auto& np) { CSCD::extract_curve_skeleton(mesh, skeleton, np); });
}

TEST(Visitor, of_any_type_is_copied_without_the_original)
{
  Record record;
  Recording_visitor visitor(record);
  CSCD::Any_skeletonization_visitor original(visitor);
  CSCD::Any_skeletonization_visitor copy(original);
  original.go_further = [] { return false; };
  EXPECT_TRUE(copy.go_further());
  EXPECT_EQ(record.number_of_questions, 1U);
}

TEST(Visitor, of_the_published_method)
{
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::torus(3, 1, 16));
  const CSCD::Published_policies policies;
  expect_heard_and_obeyed<Skeleton_of_mesh>([&](auto& skeleton, const auto& np) {
    CSCD::extract_curve_skeleton(mesh, skeleton, np.policies(policies).maximum_number_of_sources(16));
  });
}

TEST(Visitor, of_points)
{
  std::vector<Point> points;
  for (const auto& [x, y, z] : CSCD::test::torus(3, 1, 24).points) {
    points.emplace_back(x, y, z);
  }
  expect_heard_and_obeyed<Skeleton_of_numbers>(
      [&](auto& skeleton, const auto& np) { CSCD::extract_curve_skeleton(points, skeleton, np); });
}

struct Place
{
  Point point;
};

TEST(Visitor, of_a_graph)
{
  constexpr std::size_t size = 20;
  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Place> graph(size);
  for (std::size_t i = 0; i < size; ++i) {
    const double angle = 2 * CSCD::test::pi * double(i) / double(size);
    graph[i].point = Point(std::cos(angle), std::sin(angle), 0);
    add_edge(i, (i + 1) % size, graph);
  }
  expect_heard_and_obeyed<Skeleton_of_numbers>(
      [&](auto& skeleton, const auto& np) { CSCD::extract_curve_skeleton(graph, skeleton, np); });
}

TEST(Visitor, of_a_volume)
{
  CSCD::Volume bar;
  bar.grid.size = {20, 6, 6};
  for (std::size_t i = 0; i < bar.grid.number_of_voxels(); ++i) {
    bar.labels.push_back(i % 20 % 19 != 0 && i / 20 % 6 % 5 != 0 && i / 120 % 5 != 0 ? 1 : 0);
  }
  const CSCD::Voxel_surface surface = CSCD::make_voxel_surfaces(bar).at(0);
  expect_heard_and_obeyed<Skeleton_of_numbers>(
      [&](auto& skeleton, const auto& np) { CSCD::extract_curve_skeleton(surface, skeleton, np); });
}

} // namespace
