// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segmentations and shape diameters of one mesh, for benchmark/reproduce/applications.py.
//
// Usage: measure_applications MESH METHOD
// Methods: `skeleton`, CSCD::segment_mesh() and our shape diameters; `diameter`, CGAL's segmentation by our shape
// diameters; `rays`, CGAL's segmentation by its own shape diameters, which are found by rays. Writes one JSON object:
// CPU seconds, shape diameters of the vertices, and the part of each face.

#include <CSCD/Application/estimate_shape_diameters.h>
#include <CSCD/Application/segment_mesh.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/mesh_segmentation.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <ctime>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Labels = Mesh::Property_map<Mesh::Face_index, std::size_t>;
using Vertex_values = Mesh::Property_map<Mesh::Vertex_index, double>;
using Face_values = Mesh::Property_map<Mesh::Face_index, double>;
using Json = nlohmann::ordered_json;

double cpu_seconds()
{
  return double(std::clock()) / CLOCKS_PER_SEC;
}

/// CGAL's segmentation of shape diameters. \param smoothness the weight of short boundaries
std::size_t segment_by_diameters(const Mesh& mesh, Face_values diameters, double smoothness, Labels labels)
{
  constexpr std::size_t number_of_clusters = 5; // CGAL's default
  CGAL::sdf_values_postprocessing(mesh, diameters);
  return CGAL::segmentation_from_sdf_values(mesh, diameters, labels, number_of_clusters, smoothness);
}

/// The means over the faces around each vertex.
void to_vertices(const Mesh& mesh, const Face_values& of_faces, Vertex_values of_vertices)
{
  for (const Mesh::Vertex_index vertex : mesh.vertices()) {
    double number = 0;
    of_vertices[vertex] = 0;
    for (const Mesh::Face_index face : faces_around_target(mesh.halfedge(vertex), mesh)) {
      if (face != Mesh::null_face()) {
        of_vertices[vertex] += of_faces[face];
        number += 1;
      }
    }
    of_vertices[vertex] /= number > 0 ? number : 1;
  }
}

/// Measures the mesh by this method. \return the number of parts; 0 without a segmentation
std::size_t measure(const std::string& method, Mesh& mesh, Labels labels, Json& result)
{
  const Vertex_values diameters = mesh.add_property_map<Mesh::Vertex_index, double>().first;
  const Face_values face_diameters = mesh.add_property_map<Mesh::Face_index, double>().first;
  const double start = cpu_seconds();
  double skeleton_end = start;
  double diameter_end = start;
  std::size_t number_of_parts = 0;
  if (method == "rays") {
    CGAL::sdf_values(mesh, face_diameters, 2. / 3 * CGAL_PI, 25, false); // the defaults, except no postprocessing
    diameter_end = cpu_seconds();
    to_vertices(mesh, face_diameters, diameters);
    number_of_parts = segment_by_diameters(mesh, face_diameters, 0.26, labels); // CGAL's default
  } else if (method == "skeleton" || method == "diameter") {
    CSCD::Skeleton_graph<Mesh::Point, Mesh::Vertex_index> skeleton;
    CSCD::extract_curve_skeleton(mesh, skeleton);
    skeleton_end = cpu_seconds();
    CSCD::estimate_vertex_shape_diameters(mesh, skeleton, diameters);
    diameter_end = cpu_seconds();
    if (method == "skeleton") {
      number_of_parts = CSCD::segment_mesh(mesh, skeleton, labels);
    } else {
      CSCD::estimate_face_shape_diameters(mesh, skeleton, face_diameters);
      number_of_parts =
          segment_by_diameters(mesh, face_diameters, 0.1, labels); // less than CGAL's 0.26, for smoother values
    }
  } else {
    throw std::invalid_argument(method + ": the methods are skeleton, diameter and rays");
  }
  result["skeleton_seconds"] = skeleton_end - start;
  result["diameter_seconds"] = diameter_end - skeleton_end;
  result["segmentation_seconds"] = cpu_seconds() - diameter_end;
  for (const Mesh::Vertex_index vertex : mesh.vertices()) {
    result["diameters"].push_back(diameters[vertex]);
  }
  return number_of_parts;
}

} // namespace

int main(int argc, char** argv)
try {
  if (argc != 3) {
    std::cerr << "usage: measure_applications MESH METHOD\n";
    return 1;
  }
  Mesh mesh;
  CSCD::read_triangle_mesh(argv[1], mesh);
  const Labels labels = mesh.add_property_map<Mesh::Face_index, std::size_t>().first;
  Json result{{"vertices", mesh.number_of_vertices()}};
  result["parts"] = measure(argv[2], mesh, labels, result);
  for (const Mesh::Face_index face : mesh.faces()) {
    result["labels"].push_back(labels[face]);
  }
  std::cout << result << '\n';
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
