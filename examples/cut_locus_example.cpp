// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cut locus of a vertex: the points of the surface that two different shortest paths from it reach.
// Writes its curves as cut_locus.polylines.txt, and as cut_locus.html, a page to look at, where three.js is installed.
// Usage: cut_locus_example [mesh file [number of the vertex]]

#include "write_html_page.h"
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/IO/write_file.h>
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/Measure/split_into_branches.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/extract_cut_locus.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <exception>
#include <iostream>
#include <ostream>
#include <string>
#include <vector>

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Cut_locus = CSCD::Cut_locus_graph<Point, Mesh::Face_index>;

/// Draws the curves on the mesh and the source as a node.
void write_page(const std::string& filename, const Mesh& mesh, Vertex source, const Cut_locus& cut_locus)
{
  CSCD::Skeleton_graph<Point, Vertex> node(1);
  node[0].point = mesh.point(source);
  // The page shows closed curves: there and back.
  std::vector<std::vector<Point>> curves;
  for (const auto& branch : CSCD::split_into_branches(cut_locus)) {
    std::vector<Point> curve;
    for (auto v : branch) {
      curve.push_back(cut_locus[v].point);
    }
    for (std::size_t i = branch.size(); i-- > 2;) {
      curve.push_back(cut_locus[branch[i - 1]].point);
    }
    curves.push_back(curve);
  }
  CSCD::write_file(filename, [&](std::ostream& out) { CSCD::write_html_page(out, mesh, node, curves, "Cut locus"); });
}

} // namespace

int main(int argc, char** argv)
try {
  Mesh mesh;
  CSCD::read_triangle_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off"), mesh);
  const std::size_t number = argc > 2 ? std::stoul(argv[2]) : 0;
  if (number >= mesh.number_of_vertices()) {
    std::cerr << "there is no vertex " << number << '\n';
    return 1;
  }
  const Vertex source{Mesh::size_type(number)};

  //! [The cut locus of a vertex]
  Cut_locus cut_locus;
  CSCD::extract_cut_locus(mesh, source, cut_locus);

  CSCD::write_file("cut_locus.polylines.txt", [&](std::ostream& out) { CSCD::write_polylines(out, cut_locus); });
  //! [The cut locus of a vertex]
  if (CSCD::has_three_js()) {
    write_page("cut_locus.html", mesh, source, cut_locus);
  }
  // Connected, as the mesh is.
  std::cout << num_vertices(cut_locus) << " points, " << num_edges(cut_locus) + 1 - num_vertices(cut_locus)
            << " cycles\n";
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
