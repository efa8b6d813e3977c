// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Usage: consumer MESH
// The skeleton of the elephant of CGAL's data, which is closed, connected and of genus 3; by two threads if oneTBB is
// there. Then that of a sheet, whose faces may come in any order, also where a compiler optimizes as for users. The
// exit status is the number of faults.

#include <CSCD/Skeleton_graph.h>
#include <CSCD/extract_curve_skeleton.h>
#include <CSCD/extract_curve_skeleton_from_points.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <vector>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

/// The nodes of a wavy sheet, `width` vertices wide, whose faces are numbered from one end or from the other.
std::vector<Mesh::Point> nodes_of_sheet(std::size_t width, bool is_reversed)
{
  constexpr std::size_t length = 40;
  Mesh mesh;
  for (std::size_t i = 0; i < length * width; ++i) {
    const double x = double(i / width);
    const double y = double(i % width);
    mesh.add_vertex({x, y, std::sin(0.2 * x) + 0.1 * y * y});
  }
  const auto vertex = [](std::size_t i) { return Mesh::Vertex_index(Mesh::size_type(i)); };
  const std::size_t number_of_squares = (length - 1) * (width - 1);
  for (std::size_t i = 0; i < number_of_squares; ++i) {
    const std::size_t square = is_reversed ? number_of_squares - 1 - i : i;
    const std::size_t corner = square / (width - 1) * width + square % (width - 1);
    mesh.add_face(vertex(corner), vertex(corner + width), vertex(corner + 1));
    mesh.add_face(vertex(corner + 1), vertex(corner + width), vertex(corner + width + 1));
  }
  CSCD::Skeleton_graph<Mesh::Point, Mesh::Vertex_index> skeleton;
  CSCD::extract_curve_skeleton(mesh, skeleton);
  std::vector<Mesh::Point> result;
  for (std::size_t node = 0; node < num_vertices(skeleton); ++node) {
    result.push_back(skeleton[node].point);
  }
  return result;
}

} // namespace

int main(int argc, char** argv)
{
  Mesh mesh;
  if (argc != 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "Usage: consumer MESH\n";
    return 1;
  }
  CSCD::Skeleton_graph<Mesh::Point, Mesh::Vertex_index> skeleton;
  const auto report = CSCD::extract_curve_skeleton<CGAL::Parallel_if_available_tag>(
      mesh, skeleton, CSCD::parameters::number_of_threads(2));

  std::size_t number_of_vertices = 0;
  for (std::size_t node = 0; node < num_vertices(skeleton); ++node) {
    number_of_vertices += skeleton[node].vertices.size();
  }
  int number_of_faults = 0;
  const auto expect = [&](std::size_t found, std::size_t expected, const char* name) {
    if (found != expected) {
      std::cerr << name << ": " << found << " instead of " << expected << '\n';
      ++number_of_faults;
    }
  };
  expect(report.betti_number, 3, "cycles");
  expect(report.number_of_skeleton_components, 1, "components");
  expect(report.number_of_nodes_outside, 0, "nodes outside");
  expect(num_edges(skeleton), num_vertices(skeleton) + 2, "edges");
  expect(number_of_vertices, mesh.number_of_vertices(), "vertices of nodes");
  expect(nodes_of_sheet(9, true) == nodes_of_sheet(9, false) ? 1 : 0, 1, "sheets for any order of faces");
  expect(nodes_of_sheet(2, true) == nodes_of_sheet(2, false) ? 1 : 0, 1, "ribbons for any order of faces");
  return number_of_faults;
}
