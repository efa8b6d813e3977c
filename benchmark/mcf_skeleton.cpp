// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the skeleton by CGAL's mean curvature flow, with its default parameters, of a closed connected mesh:
// mcf_skeleton MESH SKELETON

#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/IO/write_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/extract_mean_curvature_flow_skeleton.h>

#include <exception>
#include <iostream>

int main(int argc, char* argv[])
try {
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  if (argc != 3) {
    std::cerr << "Usage: mcf_skeleton MESH SKELETON\n";
    return 1;
  }
  Mesh mesh;
  CSCD::read_triangle_mesh(argv[1], mesh);
  CGAL::Mean_curvature_flow_skeletonization<Mesh>::Skeleton skeleton;
  CGAL::extract_mean_curvature_flow_skeleton(mesh, skeleton);
  CSCD::write_skeleton(argv[2], skeleton);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
