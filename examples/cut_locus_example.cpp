// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cut locus of a vertex of a mesh, or of a point of a cloud, which is not made into a surface: the points of the
// surface that two different shortest paths from it reach. Writes its curves as cut_locus.polylines.txt and, of a mesh,
// as cut_locus.html, a page to look at, where three.js is installed. A file of points has the ending .xyz.
// Usage: cut_locus_example [mesh or point file [number of the vertex or point]]

#include "write_html_page.h"
#include <CSCD/IO/read_points.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/IO/write_file.h>
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/Measure/split_into_branches.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/extract_cut_locus.h>
#include <CSCD/extract_cut_locus_from_points.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <exception>
#include <filesystem>
#include <iostream>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
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

template <class Graph>
void write_curves(const Graph& cut_locus)
{
  CSCD::write_file("cut_locus.polylines.txt", [&](std::ostream& out) { CSCD::write_polylines(out, cut_locus); });
}

void write_cut_locus_on_mesh(const std::string& filename, std::size_t number)
{
  Mesh mesh;
  CSCD::read_triangle_mesh(filename, mesh);
  if (number >= mesh.number_of_vertices()) {
    throw std::out_of_range("vertex " + std::to_string(number) + " does not exist: name one of the mesh");
  }
  const Vertex source{Mesh::size_type(number)};
  //! [The cut locus of a vertex]
  Cut_locus cut_locus;
  CSCD::extract_cut_locus(mesh, source, cut_locus);
  //! [The cut locus of a vertex]
  write_curves(cut_locus);
  if (CSCD::has_three_js()) {
    write_page("cut_locus.html", mesh, source, cut_locus);
  }
  // Connected, as the mesh is.
  std::cout << num_vertices(cut_locus) << " points, " << num_edges(cut_locus) + 1 - num_vertices(cut_locus)
            << " cycles\n";
}

void write_cut_locus_on_points(const std::string& filename, std::size_t source)
{
  std::vector<Point> points;
  std::vector<Kernel::Vector_3> normals;
  CSCD::read_points(filename, points, normals);
  CSCD::Point_cut_locus_graph<Point> cut_locus;
  CSCD::extract_cut_locus(points, source, cut_locus);
  write_curves(cut_locus);
  std::cout << num_vertices(cut_locus) << " points\n";
}

} // namespace

int main(int argc, char** argv)
try {
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  const std::size_t source = argc > 2 ? std::stoul(argv[2]) : 0;
  if (std::filesystem::path(filename).extension() == ".xyz") {
    write_cut_locus_on_points(filename, source);
  } else {
    write_cut_locus_on_mesh(filename, source);
  }
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
