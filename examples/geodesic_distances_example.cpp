// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The distance of every vertex of a mesh from the first one along the surface: writes the mesh as distances.ply, with
// bands of equal distance in two colors.

#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/estimate_geodesic_distances.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Vertex = Mesh::Vertex_index;

/// The largest distance that is finite.
double eccentricity(const Mesh& mesh, const Mesh::Property_map<Vertex, double>& distance)
{
  double largest = 0;
  for (const Vertex vertex : mesh.vertices()) {
    largest = std::isfinite(distance[vertex]) ? std::max(largest, distance[vertex]) : largest;
  }
  return largest;
}

void color_bands(Mesh& mesh, const Mesh::Property_map<Vertex, double>& distance, double width)
{
  auto color = mesh.add_property_map<Vertex>("v:color", CGAL::IO::gray()).first;
  for (const Vertex vertex : mesh.vertices()) {
    if (std::isfinite(distance[vertex])) {
      const bool is_even = std::fmod(distance[vertex], 2 * width) < width;
      color[vertex] = is_even ? CGAL::IO::Color(250, 250, 250) : CGAL::IO::Color(200, 60, 40);
    }
  }
}

} // namespace

int main(int argc, char** argv)
try {
  Mesh mesh;
  CSCD::read_triangle_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off"), mesh);
  //! [Distances from a vertex]
  const Vertex source = *mesh.vertices().begin();
  auto distance = mesh.add_property_map<Vertex, double>("v:distance").first;
  CSCD::estimate_geodesic_distances(mesh, source, distance);
  //! [Distances from a vertex]

  const double farthest = eccentricity(mesh, distance);
  constexpr double number_of_bands = 30;
  color_bands(mesh, distance, farthest / number_of_bands);
  if (!CGAL::IO::write_PLY("distances.ply", mesh)) {
    std::cerr << "distances.ply: cannot be written\n";
    return 1;
  }
  std::cout << "distances.ply: the farthest vertex is " << farthest << " away\n";
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
