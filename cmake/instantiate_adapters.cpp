// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Instances of the templates of the pipeline, for clang-tidy alone: both kinds of input, both methods.

#include <CSCD/Published_policies.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Tree/extract_tree_skeleton.h>
#include <CSCD/extract_curve_skeleton.h>
#include <CSCD/extract_curve_skeleton_from_points.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <vector>

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Points = std::vector<Point>;

} // namespace

void skeletonize(const Mesh& mesh, CSCD::Skeleton_graph<Point, Mesh::Vertex_index>& skeleton)
{
  CSCD::extract_curve_skeleton(mesh, skeleton);
  CSCD::extract_curve_skeleton(mesh, skeleton, CSCD::parameters::policies(CSCD::Published_policies()));
}

void skeletonize(const Points& points, CSCD::Skeleton_graph<Point, std::size_t>& skeleton)
{
  CSCD::extract_curve_skeleton(points, skeleton);
  CSCD::extract_curve_skeleton(points, skeleton, CSCD::parameters::policies(CSCD::Published_policies()));
  CSCD::extract_tree_skeleton(points, skeleton);
}
