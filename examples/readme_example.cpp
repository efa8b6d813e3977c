// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The shortest use: the skeleton of a mesh file, printed. README.md shows the code below.

#include <CSCD/Skeleton_graph.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <exception>
#include <iostream>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main(int argc, char** argv)
try {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off"), mesh)) {
    std::cerr << "the mesh cannot be read\n";
    return 1;
  }
  CSCD::Skeleton_graph<Point, Mesh::Vertex_index> skeleton;
  const auto report = CSCD::extract_curve_skeleton(mesh, skeleton);
  for (const auto node : CGAL::make_range(vertices(skeleton))) {
    std::cout << skeleton[node].point << ' ' << skeleton[node].radius << '\n';
  }
  std::cout << report.number_of_nodes << " nodes, " << report.betti_number << " cycles\n";
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
