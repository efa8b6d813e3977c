// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The shortest use: a mesh file in, a skeleton file out. README.md shows the code below.

#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <exception>
#include <iostream>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main(int argc, char** argv)
try {
  Mesh mesh;
  CSCD::read_triangle_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off"), mesh);
  CSCD::Skeleton_graph<Point, Mesh::Vertex_index> skeleton;
  const auto report = CSCD::extract_curve_skeleton(mesh, skeleton);
  CSCD::write_skeleton("skeleton.graph", skeleton);
  std::cout << report.number_of_nodes << " nodes, " << report.betti_number << " cycles\n";
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
