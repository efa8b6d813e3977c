// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// extract_curve_skeleton() accepts the named parameters that it uses, CGAL's and the library's, in any order.

#include <CSCD/Skeleton_graph.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

void function(const Mesh& mesh, CSCD::Skeleton_graph<Mesh::Point, Mesh::Vertex_index>& skeleton)
{
  CSCD::extract_curve_skeleton(mesh, skeleton, CSCD::parameters::number_of_threads(2).random_seed(7u));
  CSCD::extract_curve_skeleton(mesh, skeleton, CSCD::parameters::random_seed(7u).maximum_number_of_sources(100));
  CSCD::extract_curve_skeleton(mesh, skeleton, CGAL::parameters::vertex_point_map(mesh.points()));
}
