// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The skeleton of a tetrahedron, in the shortest way, by two threads if oneTBB is there.

#include <CSCD/Skeleton_graph.h>
#include <CSCD/extract_curve_skeleton.h>
#include <CSCD/extract_curve_skeleton_from_points.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

int main()
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  Mesh mesh;
  CGAL::make_tetrahedron(Mesh::Point(0, 0, 0), Mesh::Point(1, 0, 0), Mesh::Point(0, 1, 0), Mesh::Point(0, 0, 1), mesh);
  CSCD::Skeleton_graph<Mesh::Point, Mesh::Vertex_index> skeleton;
  const auto report = CSCD::extract_curve_skeleton<CGAL::Parallel_if_available_tag>(
      mesh, skeleton, CSCD::parameters::number_of_threads(2));
  return report.number_of_nodes == num_vertices(skeleton) && report.number_of_nodes > 0 ? 0 : 1;
}
