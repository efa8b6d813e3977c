// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The shortest use: the nodes of a mesh's skeleton, printed. README.md shows the code below.

#include <CSCD/Skeleton_graph.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <exception>
#include <iostream>

using Point = CGAL::Simple_cartesian<double>::Point_3;

int main()
try {
  CGAL::Surface_mesh<Point> mesh;
  CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/elephant.off"), mesh);
  CSCD::Skeleton_graph<Point, CGAL::SM_Vertex_index> skeleton;
  CSCD::extract_curve_skeleton(mesh, skeleton);
  for (const auto node : CGAL::make_range(vertices(skeleton))) {
    std::cout << skeleton[node].point << ' ' << skeleton[node].radius << '\n';
  }
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
