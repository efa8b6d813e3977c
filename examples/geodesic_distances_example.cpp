// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The distance of every vertex of a mesh, or point of a set, from the first one along the surface: writes them as
// distances.ply, with bands of equal distance in two colors. A file of points has the ending .xyz.

#include <CSCD/IO/read_points.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/estimate_geodesic_distances.h>
#include <CSCD/estimate_geodesic_distances_on_points.h>

#include <CGAL/IO/Color.h>
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

/// Calls `set_color(element, color)` for all elements at a finite distance. \return the largest finite distance
template <class Elements, class Distance_map, class Set_color>
double color_bands(const Elements& elements, const Distance_map& distance, const Set_color& set_color)
{
  constexpr double number_of_bands = 30;
  double largest = 0;
  for (const auto& element : elements) {
    largest = std::isfinite(distance[element]) ? std::max(largest, distance[element]) : largest;
  }
  const double width = largest / number_of_bands;
  for (const auto& element : elements) {
    if (std::isfinite(distance[element])) {
      const bool is_even = std::fmod(distance[element], 2 * width) < width;
      set_color(element, is_even ? CGAL::IO::Color(250, 250, 250) : CGAL::IO::Color(200, 60, 40));
    }
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

  auto colors = mesh.add_property_map<Mesh::Vertex_index>("v:color", CGAL::IO::gray()).first;
  const double largest = color_bands(mesh.vertices(), distance,
                                     [&](auto vertex, const CGAL::IO::Color& color) { colors[vertex] = color; });
  CGAL::IO::write_PLY("distances.ply", mesh);
  return largest;
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

  auto red = points.add_property_map<unsigned char>("red", 128).first;
  auto green = points.add_property_map<unsigned char>("green", 128).first;
  auto blue = points.add_property_map<unsigned char>("blue", 128).first;
  const double largest = color_bands(points, distance, [&](auto point, const CGAL::IO::Color& color) {
    red[point] = color.red();
    green[point] = color.green();
    blue[point] = color.blue();
  });
  CGAL::IO::write_PLY("distances.ply", points);
  return largest;
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
