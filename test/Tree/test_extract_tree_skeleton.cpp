// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons of scans of trees that are known exactly: limbs found, orders, lengths and radii; their invariance, and
// degenerate scans. Cylinders and measures of drawn trees, and their table.

#include "support/Similarity.h"
#include "support/Skeleton_comparison.h"
#include "support/Synthetic_tree.h"
#include "support/Tree_match.h"
#include "support/convert_shape.h"
#include "support/invariants.h"
#include "support/point_skeletons.h"
#include "support/sampling.h"
#include "support/shape_operations.h"
#include "support/swept_shapes.h"
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/IO/write_tables.h>
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Tree/Tree_cylinders.h>
#include <CSCD/Tree/Tree_report.h>
#include <CSCD/Tree/extract_tree_skeleton.h>
#include <CSCD/exceptions.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using Tree_point = CGAL::Simple_cartesian<double>::Point_3;
using Tree_points = std::vector<Tree_point>;
using Tree_graph = CSCD::Skeleton_graph<Tree_point, std::size_t>;
using CSCD::test::pi, CSCD::test::Triple;
using CSCD::test::Plain_skeleton, CSCD::test::Similarity, CSCD::test::Synthetic_tree, CSCD::test::Tree_match;
using CSCD::test::operator+;
using CSCD::test::operator-;

struct Tree_outcome
{
  Tree_graph skeleton;
  CSCD::Tree_report report;
};

/// Checks properties of the branches of every report.
void expect_branches(const Tree_outcome& outcome)
{
  std::vector<bool> is_end(num_vertices(outcome.skeleton), false); // of an edge of a branch
  std::size_t number_of_trunks = 0;
  for (std::size_t b = 0; b < outcome.report.branches.size(); ++b) {
    const CSCD::Tree_branch& branch = outcome.report.branches[b];
    double length = 0;
    for (std::size_t i = 1; i < branch.nodes.size(); ++i) {
      EXPECT_TRUE(edge(branch.nodes[i - 1], branch.nodes[i], outcome.skeleton).second);
      EXPECT_FALSE(is_end[branch.nodes[i]]);
      is_end[branch.nodes[i]] = true;
      length += std::sqrt(
          CGAL::squared_distance(outcome.skeleton[branch.nodes[i - 1]].point, outcome.skeleton[branch.nodes[i]].point));
      if (i > 1) {
        EXPECT_LE(outcome.skeleton[branch.nodes[i]].radius, outcome.skeleton[branch.nodes[i - 1]].radius);
      }
    }
    EXPECT_NEAR(length, branch.length, 1e-9 * length);
    if (branch.parent == CSCD::no_branch) {
      EXPECT_EQ(0u, branch.order);
      EXPECT_EQ(number_of_trunks++, branch.object);
    } else {
      ASSERT_LT(branch.parent, b);
      const CSCD::Tree_branch& parent = outcome.report.branches[branch.parent];
      EXPECT_EQ(parent.order + 1, branch.order);
      EXPECT_EQ(parent.object, branch.object);
      EXPECT_LE(branch.strahler_order, parent.strahler_order);
      EXPECT_EQ(1, std::count(parent.nodes.begin(), parent.nodes.end(), branch.nodes.front()));
    }
  }
  EXPECT_EQ(outcome.report.number_of_objects, number_of_trunks);
}

/// Skeletonizes and checks properties that hold for every scan.
Tree_outcome tree_of(const std::vector<Triple>& triples)
{
  Tree_outcome outcome;
  outcome.report = CSCD::extract_tree_skeleton(CSCD::test::to_points<Tree_point>(triples), outcome.skeleton);
  CSCD::test::expect_partition(outcome.skeleton, triples.size());
  const CSCD::test::Skeleton_facts facts = CSCD::test::skeleton_facts(outcome.skeleton);
  EXPECT_EQ(CSCD::test::Violations{}, CSCD::test::violations_of_graph(outcome.skeleton));
  EXPECT_EQ(0u, facts.betti_number);
  EXPECT_EQ(outcome.report.number_of_objects, facts.number_of_components);
  EXPECT_EQ(outcome.report.number_of_nodes, facts.number_of_nodes);
  EXPECT_EQ(outcome.report.number_of_edges, facts.number_of_edges);
  EXPECT_EQ(outcome.report.number_of_points, triples.size());
  expect_branches(outcome);
  return outcome;
}

/// Compares with a tree of ten meters. Its limbs count from 0.3 m beyond their parent.
Tree_match match(const Synthetic_tree& tree, const Tree_outcome& outcome)
{
  return CSCD::test::Tree_matching(tree.limbs(), CSCD::test::found_branches(outcome.skeleton, outcome.report), 0.3,
                                   0.05, 0.02)
      .result();
}

/// Expects the minimum for any scan; the other bounds are typical of a good one.
void expect_match(const Tree_match& match, double min_found)
{
  const auto limbs = double(match.number_of_limbs);
  EXPECT_GE(double(match.found), min_found * limbs);
  EXPECT_LE(double(match.superfluous), 0.2 * limbs);
  EXPECT_GE(double(match.right_parents), 0.8 * double(match.found));
  EXPECT_GE(double(match.right_orders), 0.8 * double(match.found));
  EXPECT_LE(match.length_error, 0.15);
  EXPECT_LE(match.radius_error, 0.15);
  EXPECT_LE(match.distance, 0.35);
}

class Scanned_tree : public testing::TestWithParam<unsigned>
{
protected:
  static constexpr std::size_t number = 15000;
  static CSCD::test::Tree_settings settings()
  {
    CSCD::test::Tree_settings result;
    result.seed = GetParam();
    return result;
  }
  Synthetic_tree m_tree{settings()};
};

INSTANTIATE_TEST_SUITE_P(Seeds, Scanned_tree, testing::Values(101u, 102u));

TEST_P(Scanned_tree, is_found)
{
  const Tree_outcome outcome = tree_of(m_tree.scanned(number, 1, 1));
  EXPECT_EQ(1u, outcome.report.number_of_objects);
  expect_match(match(m_tree, outcome), 0.8);
}

TEST_P(Scanned_tree, is_found_where_points_get_fewer_upwards)
{
  const Tree_outcome outcome = tree_of(m_tree.scanned(number, 0.15, 1));
  EXPECT_EQ(1u, outcome.report.number_of_objects);
  expect_match(match(m_tree, outcome), 0.7);
}

TEST_P(Scanned_tree, is_found_under_noise)
{
  const Tree_outcome outcome = tree_of(CSCD::test::shaken(m_tree.scanned(number, 1, 1), 0.008, 2));
  EXPECT_EQ(1u, outcome.report.number_of_objects);
  expect_match(match(m_tree, outcome), 0.75);
}

TEST_P(Scanned_tree, is_found_from_one_side)
{
  const std::vector<Triple> seen = CSCD::test::seen_from(m_tree.scanned(2 * number, 0.5, 1), {12, 0, 1.5}, 0.0015, 0.1);
  const Tree_outcome outcome = tree_of(CSCD::test::shaken(seen, 0.004, 2));
  EXPECT_EQ(1u, outcome.report.number_of_objects);
  expect_match(match(m_tree, outcome), 0.75);
}

TEST_P(Scanned_tree, is_found_across_gaps)
{
  std::vector<Triple> points = m_tree.scanned(number, 1, 1);
  std::size_t number_of_gaps = 0;
  for (const CSCD::test::Tree_limb& limb : m_tree.limbs()) {
    if (limb.order == 1) {
      points = CSCD::test::without_ball(std::move(points), limb.axis[12], 0.2);
      ++number_of_gaps;
    }
  }
  const Tree_outcome outcome = tree_of(points);
  EXPECT_EQ(1u, outcome.report.number_of_objects);
  EXPECT_LE(number_of_gaps, outcome.report.gaps.size());
  for (const CSCD::Tree_gap& gap : outcome.report.gaps) {
    EXPECT_NEAR(gap.length, CSCD::test::norm(Triple(gap.to) - Triple(gap.from)), 1e-9);
  }
  expect_match(match(m_tree, outcome), 0.7);
}

TEST(Tree_skeleton, keeps_two_trees_apart)
{
  const Synthetic_tree tree{CSCD::test::Tree_settings{}};
  std::vector<Triple> points = tree.scanned(8000, 1, 1);
  const std::size_t number = points.size();
  for (const Triple& p : tree.scanned(6000, 1, 2)) {
    points.push_back(p + Triple{20, 0, 0.3});
  }
  const Tree_outcome outcome = tree_of(points);
  ASSERT_EQ(2u, outcome.report.number_of_objects);
  for (std::size_t node = 0; node < num_vertices(outcome.skeleton); ++node) {
    for (std::size_t point : outcome.skeleton[node].vertices) {
      EXPECT_EQ(point < number, outcome.skeleton[node].point.x() < 10);
    }
  }
}

std::vector<Triple> some_scan()
{
  return Synthetic_tree(CSCD::test::Tree_settings{}).scanned(6000, 0.5, 1);
}

TEST(Tree_skeleton, is_the_same_from_call_to_call_and_for_any_order)
{
  const std::vector<Triple> points = some_scan();
  const Plain_skeleton expected = CSCD::test::plain(tree_of(points).skeleton);
  EXPECT_EQ(expected, CSCD::test::plain(tree_of(points).skeleton));
  std::mt19937_64 random(1);
  const std::vector<std::size_t> order = CSCD::test::random_permutation(points.size(), random);
  EXPECT_EQ(expected, renamed(CSCD::test::plain(tree_of(CSCD::test::permuted(points, order)).skeleton), order));
}

/// A trunk with a limb that has a limb.
TEST(Tree_skeleton, counts_orders)
{
  using CSCD::test::Tree_limb;
  const auto straight = [](const Triple& from, const Triple& to, double radius) {
    return Tree_limb{{from, to}, {radius, 0.8 * radius}, std::nullopt, 0};
  };
  std::vector<Tree_limb> limbs{straight({0, 0, 0}, {0, 0, 9}, 0.1), straight({0, 0, 3}, {0, 2.5, 4.5}, 0.06),
                               straight({0, 1.25, 3.75}, {1.5, 1.5, 4}, 0.05)};
  limbs[1].parent = 0;
  limbs[2].parent = 1;
  const Tree_outcome outcome = tree_of(Synthetic_tree(limbs).scanned(6000, 1, 1));
  ASSERT_EQ(3u, outcome.report.branches.size());
  const std::vector<CSCD::Tree_branch>& branches = outcome.report.branches;
  const double lengths[] = {9, std::hypot(2.5, 1.5), std::hypot(1.5, 0.25, 0.25)};
  const double radii[] = {0.1, 0.06, 0.05};
  for (std::size_t b = 0; b < 3; ++b) {
    EXPECT_EQ(b, branches[b].order);
    EXPECT_NEAR(lengths[b], branches[b].length, 0.15);
    EXPECT_NEAR(radii[b], branches[b].radius_at_base, 0.1 * radii[b]);
    // The last sections are rough.
    EXPECT_LT(0, branches[b].radius_at_tip);
    EXPECT_LE(branches[b].radius_at_tip, branches[b].radius_at_base);
  }
  EXPECT_EQ(2u, branches[0].strahler_order);
  EXPECT_EQ(2u, branches[1].strahler_order);
  EXPECT_EQ(1u, branches[2].strahler_order);
}

TEST(Tree_skeleton, begins_at_the_given_root)
{
  const Synthetic_tree tree({{{{0, 0, 0}, {0, 0, 5}}, {0.1, 0.1}, std::nullopt, 0}});
  const Tree_points points = CSCD::test::to_points<Tree_point>(tree.scanned(3000, 1, 1));
  Tree_graph skeleton;
  CSCD::extract_tree_skeleton(points, skeleton);
  EXPECT_LT(skeleton[0].point.z(), 0.2);
  CSCD::extract_tree_skeleton(points, skeleton, CSCD::parameters::root(Tree_point(0, 0, 5)));
  EXPECT_GT(skeleton[0].point.z(), 4.8);
  EXPECT_THROW(CSCD::extract_tree_skeleton(points, skeleton, CSCD::parameters::root(Tree_point(0, std::nan(""), 5))),
               CSCD::Input_error);
  EXPECT_GT(skeleton[0].point.z(), 4.8);
}

/// The roots come first, so that the parents in SWC are those of the branches.
TEST(Tree_skeleton, has_its_parents_in_swc)
{
  const Tree_outcome outcome = tree_of(some_scan());
  std::ostringstream out;
  CSCD::write_swc(out, outcome.skeleton);
  EXPECT_EQ(std::string::npos, out.str().find("loop"));
  std::istringstream in(out.str());
  std::string line;
  std::getline(in, line);
  std::vector<double> root(7);
  for (double& number : root) {
    in >> number;
  }
  EXPECT_EQ(-1, root[6]);
  EXPECT_EQ(outcome.skeleton[outcome.report.branches.front().nodes.front()].point,
            Tree_point(root[2], root[3], root[4]));
}

TEST(Tree_skeleton, handles_hardly_any_points)
{
  EXPECT_EQ(1u, tree_of({{1, 2, 3}}).report.number_of_nodes);
  const Tree_outcome duplicates = tree_of(std::vector<Triple>(50, {1, 2, 3}));
  EXPECT_EQ(1u, duplicates.report.number_of_nodes);
  EXPECT_EQ(49u, duplicates.report.number_of_duplicates);
  EXPECT_EQ(1u, tree_of({{0, 0, 0}, {0, 0, 1}}).report.number_of_objects);
  EXPECT_EQ(1u, tree_of({{0, 0, 0}, {1, 0, 0}}).report.number_of_objects);
  EXPECT_EQ(1u, tree_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).report.number_of_objects);
  Tree_graph skeleton;
  EXPECT_THROW(CSCD::extract_tree_skeleton(Tree_points{}, skeleton), CSCD::Input_error);
  EXPECT_THROW(
      CSCD::extract_tree_skeleton(Tree_points{{0, 0, 0}, {0, std::numeric_limits<double>::infinity(), 0}}, skeleton),
      CSCD::Input_error);
}

TEST(Tree_skeleton, of_a_line_is_the_line)
{
  for (const Triple& direction : {Triple{0, 0, 1}, Triple{1, 0, 0}, Triple{0.6, 0, 0.8}}) {
    std::vector<Triple> points;
    for (int i = 0; i <= 300; ++i) {
      points.push_back({0.01 * i * direction[0], 0.01 * i * direction[1], 0.01 * i * direction[2]});
    }
    const Tree_outcome outcome = tree_of(points);
    ASSERT_EQ(1u, outcome.report.branches.size());
    EXPECT_NEAR(3, outcome.report.branches.front().length, 0.01);
    EXPECT_NEAR(0, outcome.report.branches.front().radius_at_base, 1e-6);
  }
}

/// A trunk from z = 10 to 14 that tapers from radius 0.4 to 0.2 in two pieces, and from its middle, of radius 0.3, a
/// limb of radius 0.1 along x, to 1.3 in two pieces.
Tree_graph drawn_tree()
{
  return CSCD::test::to_graph<Tree_graph>({{0, 0, 10}, {0, 0, 12}, {0, 0, 14}, {0.8, 0, 12}, {1.3, 0, 12}},
                                          {{0, 1}, {1, 2}, {1, 3}, {3, 4}}, {0.4, 0.3, 0.2, 0.1, 0.1});
}

CSCD::Tree_report drawn_tree_report()
{
  CSCD::Tree_report report;
  report.number_of_objects = 1;
  report.branches.resize(2);
  report.branches[0].nodes = {0, 1, 2};
  report.branches[0].length = 4;
  report.branches[1].nodes = {1, 3, 4};
  report.branches[1].length = 1.3;
  report.branches[1].parent = 0;
  report.branches[1].order = 1;
  return report;
}

constexpr double cylinder_tolerance = 1e-12;

TEST(Tree_cylinders, limbs_begin_at_the_bark_of_their_parent)
{
  const std::vector<CSCD::Tree_cylinder> cylinders = make_tree_cylinders(drawn_tree(), drawn_tree_report());
  ASSERT_EQ(4u, cylinders.size());
  EXPECT_NEAR(0.35, cylinders[0].radius, cylinder_tolerance);
  EXPECT_NEAR(2, cylinders[0].length, cylinder_tolerance);
  EXPECT_EQ(1, cylinders[0].axis.z());
  EXPECT_NEAR(0.3, cylinders[2].start.x(), cylinder_tolerance);
  EXPECT_NEAR(0.5, cylinders[2].length, cylinder_tolerance);
  EXPECT_NEAR(0.1, cylinders[2].radius, cylinder_tolerance); // that of the limb, not of the trunk
  EXPECT_EQ(std::nullopt, cylinders[0].parent);
  EXPECT_EQ(0u, cylinders[1].parent);
  EXPECT_EQ(1u, cylinders[0].extension);
  EXPECT_EQ(std::nullopt, cylinders[1].extension);
  EXPECT_EQ(0u, cylinders[2].parent); // the cylinder that ends where the limb begins
  EXPECT_EQ(2u, cylinders[3].parent);
  EXPECT_EQ(1u, cylinders[3].position);
}

TEST(Tree_cylinders, what_is_within_the_parent_is_none)
{
  Tree_graph tree = drawn_tree();
  tree[3].point = Tree_point(0.2, 0, 12);
  const std::vector<CSCD::Tree_cylinder> cylinders = make_tree_cylinders(tree, drawn_tree_report());
  ASSERT_EQ(3u, cylinders.size());
  EXPECT_EQ(0u, cylinders[2].parent);
  EXPECT_EQ(0u, cylinders[2].position);
}

TEST(Measure_trees, gives_what_foresters_read)
{
  const double trunk = pi * 2 * (0.35 * 0.35 + 0.25 * 0.25);
  CSCD::Tree_report report = drawn_tree_report();
  const CSCD::Tree_measures tree = measure_trees(drawn_tree(), report).at(0);
  EXPECT_NEAR(4, tree.height, cylinder_tolerance);
  EXPECT_NEAR(5.3, tree.length, cylinder_tolerance);
  EXPECT_NEAR(trunk, tree.trunk_volume, cylinder_tolerance);
  EXPECT_NEAR(trunk + pi * 0.01, tree.volume, cylinder_tolerance);
  EXPECT_NEAR(2 * (0.4 - 0.05 * 1.3), tree.diameter_at_breast_height, cylinder_tolerance);
  EXPECT_NEAR(0.5, measure_trees(drawn_tree(), report, 3).at(0).diameter_at_breast_height, cylinder_tolerance);
  EXPECT_TRUE(std::isnan(measure_trees(drawn_tree(), report, 5).at(0).diameter_at_breast_height));
}

TEST(Assign_limbs, gives_each_branch_its_limb)
{
  CSCD::Skeleton_branches branches = measure_branches(drawn_tree(), {0});
  assign_limbs(drawn_tree_report(), branches);
  ASSERT_EQ(3u, branches.branches.size()); // the trunk is two branches
  for (const CSCD::Skeleton_branch& branch : branches.branches) {
    EXPECT_EQ(branch.nodes.back() == 4 ? 1u : 0u, branch.limb);
  }
}

TEST(Write_cylinders, has_the_columns_of_tree_qsm)
{
  std::ostringstream out;
  write_cylinders(out, make_tree_cylinders(drawn_tree(), drawn_tree_report()), drawn_tree_report());
  std::istringstream in(out.str());
  std::string line;
  ASSERT_TRUE(std::getline(in, line));
  EXPECT_EQ("radius_m,length_m,start_X,start_Y,start_Z,axis_X,axis_Y,axis_Z,parent,extension,branch,branch_order,"
            "position_in_branch,mad,SurfCov,added,UnmodRadius_m",
            line);
  std::vector<std::string> tails;
  for (std::size_t expected_fields = 17; std::getline(in, line);) {
    std::vector<std::string> fields;
    std::istringstream words(line);
    for (std::string field; std::getline(words, field, ',');) {
      fields.push_back(field);
    }
    ASSERT_EQ(expected_fields, fields.size()) << line;
    tails.push_back(fields[8] + ' ' + fields[9] + ' ' + fields[10] + ' ' + fields[11] + ' ' + fields[12]);
  }
  EXPECT_EQ((std::vector<std::string>{"0 2 1 0 1", "1 0 1 0 2", "1 4 2 1 1", "3 0 2 1 2"}), tails);
}

} // namespace
