// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Replaces CGAL's mean curvature flow skeletonization: its mesh and skeleton types stay, one call changes, and code
// that reads the skeleton reads ours. Writes the skeleton and the correspondence as CGAL's own example does.

#include <CSCD/IO/write_skeleton.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Mean_curvature_flow_skeletonization.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <exception>
#include <fstream>
#include <iostream>
#include <string>

namespace {

using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;
using Skeleton = CGAL::Mean_curvature_flow_skeletonization<Polyhedron>::Skeleton;
using Node = boost::graph_traits<Skeleton>::vertex_descriptor;

/// Writes a segment from every vertex of the mesh to its node.
void write_correspondence(const Polyhedron& mesh, const Skeleton& skeleton, const char* filename)
{
  std::ofstream out(filename);
  for (Node node : CGAL::make_range(vertices(skeleton))) {
    for (auto vertex : skeleton[node].vertices) {
      out << "2 " << skeleton[node].point << ' ' << get(CGAL::vertex_point, mesh, vertex) << '\n';
    }
  }
}

} // namespace

int main(int argc, char** argv)
try {
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Polyhedron mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << filename << ": not a mesh that a Polyhedron_3 can hold\n";
    return 1;
  }

  //! [In the place of CGAL's function]
  Skeleton skeleton;
  CSCD::extract_curve_skeleton(mesh, skeleton); // not CGAL::extract_mean_curvature_flow_skeleton()

  CSCD::write_skeleton("skeleton.polylines.txt", skeleton);
  //! [In the place of CGAL's function]
  write_correspondence(mesh, skeleton, "correspondence.polylines.txt");
  std::cout << "Number of vertices of the skeleton: " << num_vertices(skeleton) << '\n'
            << "Number of edges of the skeleton: " << num_edges(skeleton) << '\n';
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
