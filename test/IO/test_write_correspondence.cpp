// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of labels of vertices: of meshes, points and repaired files, as CSV.

#include "support/convert_shape.h"
#include "support/limb_shapes.h"
#include <CSCD/IO/write_correspondence.h>
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Vector3.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <sstream>
#include <vector>

namespace {

using CSCD::Index, CSCD::no_index, CSCD::Vector3, CSCD::Vertex_label;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Skeleton = CSCD::Skeleton_graph<Point, Mesh::Vertex_index>;

struct Labelled_mesh
{
  Mesh mesh;
  Skeleton skeleton;
  CSCD::Skeleton_branches branches;
  std::vector<Vertex_label> labels;
};

Labelled_mesh labelled_y_tube()
{
  Labelled_mesh result;
  result.mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::y_tube(0.2));
  CSCD::extract_curve_skeleton(result.mesh, result.skeleton);
  result.branches = CSCD::measure_branches(result.skeleton, result.mesh);
  result.labels = label_vertices(result.mesh, result.skeleton, result.branches);
  return result;
}

TEST(Label_vertices, agrees_with_the_skeleton)
{
  const Labelled_mesh y = labelled_y_tube();
  ASSERT_EQ(num_vertices(y.mesh), y.labels.size());
  std::size_t number_of_labels = 0;
  for (std::size_t node = 0; node < num_vertices(y.skeleton); ++node) {
    for (const Mesh::Vertex_index vertex : y.skeleton[node].vertices) {
      const Vertex_label& label = y.labels[std::size_t(vertex)];
      EXPECT_EQ(node, label.node);
      EXPECT_EQ(y.branches.branch_of_node[node], label.branch);
      ++number_of_labels;
    }
  }
  EXPECT_EQ(y.labels.size(), number_of_labels);
}

TEST(Write_correspondence, leaves_fields_of_vertices_without_a_node_empty)
{
  std::ostringstream out;
  CSCD::write_correspondence(out, {{1, 0}, {no_index, no_index}, {1, 0}});
  EXPECT_EQ("vertex,node,branch\n0,1,0\n1,,\n2,1,0\n", out.str());
}

std::vector<Vertex_label> numbered_labels(std::size_t size)
{
  std::vector<Vertex_label> result(size);
  for (Index i = 0; i < size; ++i) {
    result[i].node = i;
  }
  return result;
}

TEST(Labels_of_file, follow_points_that_were_merged_doubled_and_dropped)
{
  const Vector3 a(0, 0, 0);
  const Vector3 b(1, 0, 0);
  const Vector3 c(2, 0, 0);
  const Vector3 minus_a(-0., 0, -0.);
  std::vector<Vertex_label> labels = numbered_labels(3);
  // b is doubled in the mesh and its first copy has no node; a is twice in the file, c was dropped.
  labels[1].node = no_index;
  const std::vector<Vertex_label> result = CSCD::internal::labels_of_file({a, b, c, minus_a}, {a, b, b}, labels);
  ASSERT_EQ(4u, result.size());
  EXPECT_EQ(0u, result[0].node);
  EXPECT_EQ(2u, result[1].node);
  EXPECT_EQ(no_index, result[2].node);
  EXPECT_EQ(0u, result[3].node);
}

} // namespace
