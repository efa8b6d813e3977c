// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A geodesic over the faces of a mesh: the shortest path along edges from the first vertex to the last one, by Boost's
// search, is shortened. Writes the geodesic as geodesic.polylines.txt.
// Usage: shorten_curve_example [mesh file]

#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/shorten_curve.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <cstddef>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

double distance(const Point& a, const Point& b)
{
  return std::sqrt(CGAL::squared_distance(a, b));
}

} // namespace

int main(int argc, char** argv)
try {
  Mesh mesh;
  CSCD::read_triangle_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off"), mesh);

  auto predecessor = mesh.add_property_map<Vertex, Vertex>("v:predecessor").first;
  auto length_along_edges = mesh.add_property_map<Vertex, double>("v:distance").first;
  const auto edge_length = boost::make_function_property_map<Mesh::Edge_index>([&mesh](Mesh::Edge_index edge) {
    return distance(mesh.point(mesh.vertex(edge, 0)), mesh.point(mesh.vertex(edge, 1)));
  });
  boost::dijkstra_shortest_paths(
      mesh, Vertex(0), boost::predecessor_map(predecessor).distance_map(length_along_edges).weight_map(edge_length));
  std::vector<Vertex> path{Vertex(Mesh::size_type(mesh.number_of_vertices() - 1))};
  while (predecessor[path.back()] != path.back()) {
    path.push_back(predecessor[path.back()]);
  }
  if (path.size() == 1) {
    std::cerr << "no path along edges leads from the first vertex to the last one\n";
    return 1;
  }

  //! [A geodesic]
  std::vector<Point> geodesic;
  constexpr bool is_closed = false;
  CSCD::shorten_curve(mesh, path, is_closed, std::back_inserter(geodesic));
  //! [A geodesic]

  std::ofstream file("geodesic.polylines.txt");
  file << geodesic.size();
  double length = 0;
  for (std::size_t i = 0; i < geodesic.size(); ++i) {
    file << ' ' << geodesic[i];
    length += i > 0 ? distance(geodesic[i - 1], geodesic[i]) : 0;
  }
  file << '\n';
  std::cout << "along edges " << length_along_edges[path.front()] << ", over faces " << length << '\n';
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
