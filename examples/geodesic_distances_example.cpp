// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The distance of every vertex of a mesh, or point of a set, from the first one along the surface: writes them as the
// property `distance` of distances.ply. A file of points has the ending .xyz.

#include <CSCD/IO/read_points.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/estimate_geodesic_distances.h>
#include <CSCD/estimate_geodesic_distances_on_points.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Point_set = CGAL::Point_set_3<Kernel::Point_3>;

template <class Elements, class Distance_map>
double largest_finite_distance(const Elements& elements, const Distance_map& distance)
{
  double largest = 0;
  for (const auto& element : elements) {
    largest = std::isfinite(distance[element]) ? std::max(largest, distance[element]) : largest;
  }
  return largest;
}

/// \return the largest distance
double write_distances_on_mesh(const std::string& filename)
{
  Mesh mesh;
  CSCD::read_triangle_mesh(filename, mesh);
  //! [Distances from a vertex]
  const Mesh::Vertex_index source = *mesh.vertices().begin();
  auto distance = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance").first;
  CSCD::estimate_geodesic_distances(mesh, source, distance);
  //! [Distances from a vertex]
  CGAL::IO::write_PLY("distances.ply", mesh);
  return largest_finite_distance(mesh.vertices(), distance);
}

/// \return the largest distance
double write_distances_on_points(const std::string& filename)
{
  std::vector<Kernel::Point_3> positions;
  std::vector<Kernel::Vector_3> normals;
  CSCD::read_points(filename, positions, normals);
  Point_set points;
  for (const Kernel::Point_3& position : positions) {
    points.insert(position);
  }
  const Point_set::Index source = *points.begin();
  auto distance = points.add_property_map<double>("distance", 0).first;
  CSCD::estimate_geodesic_distances(points, source, distance);
  CGAL::IO::write_PLY("distances.ply", points);
  return largest_finite_distance(points, distance);
}

} // namespace

int main(int argc, char** argv)
try {
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  const bool has_faces = std::filesystem::path(filename).extension() != ".xyz";
  const double largest = has_faces ? write_distances_on_mesh(filename) : write_distances_on_points(filename);
  std::cout << "distances.ply: the farthest " << (has_faces ? "vertex" : "point") << " is " << largest << " away\n";
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
