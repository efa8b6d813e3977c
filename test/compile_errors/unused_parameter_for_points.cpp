// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// extract_curve_skeleton() refuses for points a named parameter that only meshes have.
// expected error: CSCD: this named parameter is not used by this function

#include <CSCD/Skeleton_graph.h>
#include <CSCD/extract_curve_skeleton_from_points.h>

#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <vector>

using Point = CGAL::Simple_cartesian<double>::Point_3;

void function(const std::vector<Point>& points, CSCD::Skeleton_graph<Point, std::size_t>& skeleton)
{
  CSCD::extract_curve_skeleton(points, skeleton, CSCD::parameters::random_seed(7u).vertex_point_map(0));
}
