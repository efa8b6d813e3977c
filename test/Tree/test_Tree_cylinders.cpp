// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cylinders and measures of drawn trees, and their table.

#include "support/convert_shape.h"
#include "support/swept_shapes.h"
#include <CSCD/IO/write_tables.h>
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Tree/Tree_cylinders.h>
#include <CSCD/Tree/Tree_report.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace {

using CSCD::test::pi;
using Drawn_tree_point = CGAL::Simple_cartesian<double>::Point_3;
using Drawn_tree = CSCD::Skeleton_graph<Drawn_tree_point, std::size_t>;

/// A trunk from z = 10 to 14 that tapers from radius 0.4 to 0.2 in two pieces, and from its middle, of radius 0.3, a
/// limb of radius 0.1 along x, to 1.3 in two pieces.
Drawn_tree drawn_tree()
{
  return CSCD::test::to_graph<Drawn_tree>({{0, 0, 10}, {0, 0, 12}, {0, 0, 14}, {0.8, 0, 12}, {1.3, 0, 12}},
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
  Drawn_tree tree = drawn_tree();
  tree[3].point = Drawn_tree_point(0.2, 0, 12);
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
