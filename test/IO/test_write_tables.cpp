// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of the table of branches and of labels of vertices, of meshes, points and repaired files, as CSV.

#include "sample_skeleton.h"
#include "support/convert_shape.h"
#include "support/limb_shapes.h"
#include "write_in_foreign_locale.h"
#include <CSCD/IO/write_correspondence.h>
#include <CSCD/IO/write_tables.h>
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Vector3.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace test_support;
using CSCD::no_index, CSCD::Vector3, CSCD::Vertex_label;

using Table_rows = std::vector<std::map<std::string, std::string>>;

std::vector<std::string> csv_fields(const std::string& line)
{
  std::vector<std::string> result(1);
  for (const char c : line) {
    if (c == ',') {
      result.emplace_back();
    } else {
      result.back() += c;
    }
  }
  return result;
}

Table_rows parse_table(const std::string& text)
{
  std::istringstream in(text);
  std::string line;
  EXPECT_TRUE(std::getline(in, line));
  const std::vector<std::string> names = csv_fields(line);
  Table_rows result;
  while (std::getline(in, line)) {
    const std::vector<std::string> fields = csv_fields(line);
    EXPECT_EQ(names.size(), fields.size()) << line;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      result.resize(result.size() + (i == 0 ? 1 : 0));
      result.back()[names.at(i)] = fields[i];
    }
  }
  return result;
}

template <class SampleSkeleton>
Table_rows sample_table(const std::vector<CSCD::Index>& roots)
{
  return parse_table(write_in_foreign_locale(
      [&](std::ostream& out, const SampleSkeleton& s) {
        CSCD::write_branch_table(out, CSCD::measure_branches(s, roots));
      },
      sample_skeleton<SampleSkeleton>()));
}

TEST(Write_branch_table, has_a_line_for_each_branch)
{
  const CSCD::Skeleton_branches branches = CSCD::measure_branches(sample_skeleton<Skeleton>(), {0});
  const Table_rows table = sample_table<Skeleton>({0});
  ASSERT_EQ(branches.branches.size(), table.size());
  for (std::size_t b = 0; b < table.size(); ++b) {
    const CSCD::Skeleton_branch& branch = branches.branches[b];
    EXPECT_EQ(std::to_string(b), table[b].at("branch"));
    EXPECT_EQ(std::to_string(branch.nodes.front()), table[b].at("first_node"));
    EXPECT_EQ(std::to_string(branch.nodes.back()), table[b].at("last_node"));
    EXPECT_EQ(name(branch.ends[1]), table[b].at("last_end"));
    EXPECT_EQ(branch.length, std::stod(table[b].at("length"))); // exactly
    EXPECT_EQ(branch.mean_radius, std::stod(table[b].at("mean_radius")));
    EXPECT_EQ(branch.significance, std::stod(table[b].at("significance")));
    EXPECT_EQ(branch.parent ? std::to_string(*branch.parent) : "", table[b].at("parent"));
    EXPECT_EQ(std::to_string(*branch.order), table[b].at("order"));
  }
}

TEST(Write_branch_table, leaves_empty_what_is_not_known)
{
  for (const auto& row : sample_table<Skeleton_without_radius>({})) {
    for (const std::string name : {"min_radius", "mean_radius", "max_radius", "first_radius", "last_radius",
                                   "cone_area", "cone_volume", "surface_area", "volume", "parent", "order", "limb"}) {
      EXPECT_EQ("", row.at(name)) << name;
    }
    EXPECT_NE("", row.at("length"));
  }
}

TEST(Label_vertices, agrees_with_the_skeleton)
{
  using Mesh = CGAL::Surface_mesh<Point>;
  const auto mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::y_tube(0.2));
  CSCD::Skeleton_graph<Point, Mesh::Vertex_index> skeleton;
  CSCD::extract_curve_skeleton(mesh, skeleton);
  const CSCD::Skeleton_branches branches = CSCD::measure_branches(skeleton, mesh);
  const std::vector<Vertex_label> labels = label_vertices(mesh, skeleton, branches);
  ASSERT_EQ(num_vertices(mesh), labels.size());
  std::size_t number_of_labels = 0;
  for (std::size_t node = 0; node < num_vertices(skeleton); ++node) {
    for (const Mesh::Vertex_index vertex : skeleton[node].vertices) {
      const Vertex_label& label = labels[std::size_t(vertex)];
      EXPECT_EQ(node, label.node);
      EXPECT_EQ(branches.branch_of_node[node], label.branch);
      ++number_of_labels;
    }
  }
  EXPECT_EQ(labels.size(), number_of_labels);
}

TEST(Write_correspondence, leaves_fields_of_vertices_without_a_node_empty)
{
  std::ostringstream out;
  CSCD::write_correspondence(out, {{1, 0}, {no_index, no_index}, {1, 0}});
  EXPECT_EQ("vertex,node,branch\n0,1,0\n1,,\n2,1,0\n", out.str());
}

TEST(Labels_of_file, follow_points_that_were_merged_doubled_and_dropped)
{
  const Vector3 a(0, 0, 0);
  const Vector3 b(1, 0, 0);
  const Vector3 c(2, 0, 0);
  const Vector3 minus_a(-0., 0, -0.);
  // b is doubled in the mesh and its first copy has no node; a is twice in the file, c was dropped.
  const std::vector<Vertex_label> labels{{0, 0}, {no_index, 0}, {2, 0}};
  const std::vector<Vertex_label> result = CSCD::internal::labels_of_file({a, b, c, minus_a}, {a, b, b}, labels);
  ASSERT_EQ(4u, result.size());
  EXPECT_EQ(0u, result[0].node);
  EXPECT_EQ(2u, result[1].node);
  EXPECT_EQ(no_index, result[2].node);
  EXPECT_EQ(0u, result[3].node);
}

} // namespace
