// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every vertex of the mesh belongs to one node of the skeleton, and nodes form branches: colors the mesh by branch and
// writes it as branches.ply. Vertices of junctions, where branches meet, stay gray.

#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/Measure/split_into_branches.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Skeleton = CSCD::Skeleton_graph<Point, Vertex>;

/// Colors that differ well for any number: hues turn by the golden angle.
CGAL::IO::Color branch_color(std::size_t branch)
{
  constexpr double golden_angle = 137.508;
  CGAL::IO::Color color;
  color.set_hsv(std::fmod(double(branch) * golden_angle, 360.0), 65, 90);
  return color;
}

//! [Color by branch]
/// Colors the mesh by branch. \return the number of branches
std::size_t color_by_branch(const Skeleton& skeleton, Mesh& mesh)
{
  auto color = mesh.add_property_map<Vertex>("v:color", CGAL::IO::gray()).first;
  const auto branches = CSCD::split_into_branches(skeleton);
  for (std::size_t branch = 0; branch < branches.size(); ++branch) {
    for (auto node : branches[branch]) {
      if (out_degree(node, skeleton) <= 2) {
        for (Vertex vertex : skeleton[node].vertices) {
          color[vertex] = branch_color(branch);
        }
      }
    }
  }
  return branches.size();
}
//! [Color by branch]

} // namespace

int main(int argc, char** argv)
try {
  Mesh mesh;
  CSCD::read_triangle_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/armadillo.off"), mesh);
  Skeleton skeleton;
  CSCD::extract_curve_skeleton(mesh, skeleton);
  const std::size_t number_of_branches = color_by_branch(skeleton, mesh);
  if (!CGAL::IO::write_PLY("branches.ply", mesh)) {
    std::cerr << "branches.ply: cannot be written\n";
    return 1;
  }
  std::cout << "branches.ply: the mesh in " << number_of_branches << " colors\n";
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
