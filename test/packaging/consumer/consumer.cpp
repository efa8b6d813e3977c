// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Usage: consumer MESH
// The skeleton of the elephant of CGAL's data, which is closed, connected and of genus 3; by two threads if oneTBB is
// there. The exit status is the number of faults.

#include <CSCD/Skeleton_graph.h>
#include <CSCD/extract_curve_skeleton.h>
#include <CSCD/extract_curve_skeleton_from_points.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstddef>
#include <iostream>

int main(int argc, char** argv)
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
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
  return number_of_faults;
}
