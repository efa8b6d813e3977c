// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segments a mesh in two ways: into the parts that people would see, and by CGAL from the shape diameters of the
// skeleton.

#include <CSCD/Application/estimate_shape_diameters.h>
#include <CSCD/Application/segment_mesh.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/mesh_segmentation.h>

#include <cstddef>
#include <exception>
#include <iostream>

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Face = Mesh::Face_index;
using Skeleton = CSCD::Skeleton_graph<Point, Mesh::Vertex_index>;

} // namespace

int main(int argc, char** argv)
try {
  Mesh mesh;
  CSCD::read_triangle_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off"), mesh);
  Skeleton skeleton;
  CSCD::extract_curve_skeleton(mesh, skeleton);

  //! [Segment]
  auto parts = mesh.add_property_map<Face, std::size_t>("f:part").first;
  const std::size_t number_of_parts = CSCD::segment_mesh(mesh, skeleton, parts);
  //! [Segment]
  std::cout << number_of_parts << " parts by the skeleton\n";

  auto diameters = mesh.add_property_map<Face, double>("f:diameter").first;
  CSCD::estimate_face_shape_diameters(mesh, skeleton, diameters);
  CGAL::sdf_values_postprocessing(mesh, diameters);
  // Five clusters are CGAL's default; its smoothness, 0.26, is for noisier diameters, found by rays.
  std::cout << CGAL::segmentation_from_sdf_values(mesh, diameters, parts, 5, 0.1) << " parts by shape diameters\n";
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
