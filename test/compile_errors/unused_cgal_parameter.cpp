// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// extract_curve_skeleton() refuses a named parameter of CGAL that it does not use, in the midst of those that it does.
// expected error: CSCD: this named parameter is not used by this function

#include <CSCD/Skeleton_graph.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

void function(const Mesh& mesh, CSCD::Skeleton_graph<Mesh::Point, Mesh::Vertex_index>& skeleton)
{
  CSCD::extract_curve_skeleton(mesh, skeleton, CSCD::parameters::number_of_threads(2).verbose(true).random_seed(7u));
}
