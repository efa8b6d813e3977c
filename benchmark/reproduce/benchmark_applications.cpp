// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Applications of skeletons on one mesh, compared with other methods, for benchmark/reproduce/applications.py.
//
// Usage: benchmark_applications MESH METHOD [FOLDER]
// Methods: `skeleton`, CSCD::segment_mesh() and our shape diameters; `diameter`, CGAL's segmentation by our shape
// diameters; `rays`, CGAL's segmentation by its own shape diameters, which are found by rays; `mcf`, our shape
// diameters of CGAL's skeleton by mean curvature flow, without a segmentation. FOLDER holds segmentations by people.
// Writes one JSON object: CPU seconds, shape diameters of the vertices, the mean errors of the segmentation
// over the people, and for segment_mesh() the boundaries compared with separators.

#include "compare_segmentations.h"
#include <CSCD/Application/estimate_shape_diameters.h>
#include <CSCD/Application/segment_mesh.h>
#include <CSCD/Curve_skeletonization.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/Measure/distance_to_edges.h>
#include <CSCD/Traits/Triangle_mesh_traits.h>
#include <CSCD/Vector_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/extract_mean_curvature_flow_skeleton.h>
#include <CGAL/mesh_segmentation.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Skeletonization = CSCD::Curve_skeletonization<CSCD::Triangle_mesh_traits<Mesh>>;
using Curve = std::vector<CSCD::Vector_3>; // closed
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

CSCD::Vector_3 to_vector(const Mesh::Point& point)
{
  return {point.x(), point.y(), point.z()};
}

double length(const Curve& curve)
{
  double sum = 0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    sum += (curve[(i + 1) % curve.size()] - curve[i]).norm();
  }
  return sum;
}

/// The mean distance of the points of a curve from another.
double mean_distance(const Curve& curve, const Curve& other)
{
  double sum = 0;
  for (const CSCD::Vector_3& point : curve) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < other.size(); ++i) {
      least = std::min(least, CSCD::internal::distance_to_segment(point, other[i], other[(i + 1) % other.size()]));
    }
    sum += least;
  }
  return sum / double(curve.size());
}

/// The boundaries of parts; where three parts meet, the number is less than that of all their edges.
struct Boundaries
{
  std::vector<Curve> closed;
  std::size_t number_of_edges = 0;
};

Boundaries find_boundaries(const Mesh& mesh, const Labels& labels)
{
  const auto is_boundary = [&](Mesh::Halfedge_index h) {
    const Mesh::Halfedge_index twin = mesh.opposite(h);
    return !mesh.is_border(h) && !mesh.is_border(twin) && labels[mesh.face(h)] < labels[mesh.face(twin)];
  };
  std::vector<std::vector<Mesh::Halfedge_index>> from(mesh.number_of_vertices());
  Boundaries result;
  for (const Mesh::Halfedge_index h : mesh.halfedges()) {
    if (is_boundary(h)) {
      from[mesh.source(h)].push_back(h);
      ++result.number_of_edges;
    }
  }
  std::vector<char> is_seen(mesh.number_of_halfedges(), 0);
  for (const Mesh::Halfedge_index start : mesh.halfedges()) {
    Curve curve;
    Mesh::Halfedge_index h = start;
    while (is_boundary(h) && is_seen[h] == 0 && from[mesh.target(h)].size() == 1) {
      is_seen[h] = 1;
      curve.push_back(to_vector(mesh.point(mesh.source(h))));
      h = from[mesh.target(h)].front();
    }
    if (h == start && !curve.empty()) {
      result.closed.push_back(std::move(curve));
    }
  }
  return result;
}

/// Compares the boundaries that are closed curves with the nearest packed separators: both lengths, and the mean
/// distances of both, relative to the radius of a circle of that length.
Json compare_with_separators(const Skeletonization& skeletonization, const Mesh& mesh, const Labels& labels)
{
  std::vector<Curve> separators;
  for (const auto position : skeletonization.packed_separators()) {
    const auto polyline = skeletonization.polyline(skeletonization.separators()[position]);
    Curve curve;
    std::transform(polyline.begin(), polyline.end(), std::back_inserter(curve), to_vector);
    separators.push_back(std::move(curve));
  }
  const Boundaries boundaries = find_boundaries(mesh, labels);
  Json result = Json::array();
  for (const Curve& boundary : boundaries.closed) {
    double distance = std::numeric_limits<double>::infinity();
    double length_of_nearest = 0;
    for (const Curve& separator : separators) {
      if (const double one = mean_distance(boundary, separator); one < distance) {
        distance = one;
        length_of_nearest = length(separator);
      }
    }
    if (length_of_nearest > 0) {
      result.push_back({{"edges", boundary.size()},
                        {"length_ratio", length(boundary) / length_of_nearest},
                        {"distance", 2 * CGAL_PI * distance / length_of_nearest}});
    }
  }
  return {{"boundary_edges", boundaries.number_of_edges}, {"closed_boundaries", std::move(result)}};
}

/// Measures the mesh by this method. \return the number of parts; 0 without a segmentation
std::size_t measure(const std::string& method, Mesh& mesh, Labels labels, Json& result)
{
  const Vertex_values diameters = mesh.add_property_map<Mesh::Vertex_index, double>().first;
  const Face_values face_diameters = mesh.add_property_map<Mesh::Face_index, double>().first;
  const double start = cpu_seconds();
  double skeleton_end = start;
  double diameter_end = start;
  double segmentation_end = 0;
  std::size_t number_of_parts = 0;
  if (method == "rays") {
    CGAL::sdf_values(mesh, face_diameters, 2. / 3 * CGAL_PI, 25, false); // the defaults, except no postprocessing
    diameter_end = cpu_seconds();
    to_vertices(mesh, face_diameters, diameters);
    number_of_parts = segment_by_diameters(mesh, face_diameters, 0.26, labels); // CGAL's default
  } else if (method == "mcf") {
    CGAL::Mean_curvature_flow_skeletonization<Mesh>::Skeleton skeleton;
    CGAL::extract_mean_curvature_flow_skeleton(mesh, skeleton);
    skeleton_end = cpu_seconds();
    CSCD::estimate_vertex_shape_diameters(mesh, skeleton, diameters);
    diameter_end = cpu_seconds();
  } else if (method == "skeleton" || method == "diameter") {
    const CSCD::Triangle_mesh_traits<Mesh> traits(mesh);
    Skeletonization skeletonization(traits);
    Skeletonization::Skeleton skeleton;
    skeletonization.find_separators();
    skeletonization.pack_separators();
    skeletonization.convert_to_skeleton(skeleton);
    skeleton_end = cpu_seconds();
    CSCD::estimate_vertex_shape_diameters(mesh, skeleton, diameters);
    diameter_end = cpu_seconds();
    if (method == "skeleton") {
      number_of_parts = CSCD::segment_mesh(mesh, skeleton, labels);
      segmentation_end = cpu_seconds();
      result.update(compare_with_separators(skeletonization, mesh, labels));
    } else {
      CSCD::estimate_face_shape_diameters(mesh, skeleton, face_diameters);
      number_of_parts =
          segment_by_diameters(mesh, face_diameters, 0.1, labels); // less than CGAL's 0.26, for smoother values
    }
  } else {
    throw std::invalid_argument(method + ": the methods are skeleton, diameter, rays and mcf");
  }
  result["skeleton_seconds"] = skeleton_end - start;
  result["diameter_seconds"] = diameter_end - skeleton_end;
  result["segmentation_seconds"] = (segmentation_end > 0 ? segmentation_end : cpu_seconds()) - diameter_end;
  for (const Mesh::Vertex_index vertex : mesh.vertices()) {
    result["diameters"].push_back(diameters[vertex]);
  }
  return number_of_parts;
}

Labels read_labels(const std::filesystem::path& file, Mesh& mesh)
{
  const Labels labels = mesh.add_property_map<Mesh::Face_index, std::size_t>().first;
  std::ifstream in(file);
  for (const Mesh::Face_index face : mesh.faces()) {
    if (!(in >> labels[face])) {
      throw std::runtime_error(file.string() + ": has not a label for each face");
    }
  }
  return labels;
}

/// The means over the segmentations by people.
Json compare_with_people(const std::filesystem::path& folder, const Mesh& mesh, const Labels& labels)
{
  double people = 0;
  double people_with_cuts = 0;
  benchmark_applications::Segmentation_comparison sum{};
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    Mesh copy = mesh;
    const benchmark_applications::Segmentation_comparison one =
        benchmark_applications::compare_segmentations(mesh, labels, read_labels(entry.path(), copy));
    people += 1;
    sum.rand_error += one.rand_error;
    sum.hamming_distance += one.hamming_distance;
    sum.global_consistency_error += one.global_consistency_error;
    sum.local_consistency_error += one.local_consistency_error;
    if (!std::isnan(one.cut_discrepancy)) {
      sum.cut_discrepancy = (people_with_cuts == 0 ? 0 : sum.cut_discrepancy) + one.cut_discrepancy;
      people_with_cuts += 1;
    }
  }
  return {{"rand_error", sum.rand_error / people},
          {"cut_discrepancy", people_with_cuts > 0 ? Json(sum.cut_discrepancy / people_with_cuts) : Json()},
          {"hamming_distance", sum.hamming_distance / people},
          {"global_consistency_error", sum.global_consistency_error / people},
          {"local_consistency_error", sum.local_consistency_error / people}};
}

} // namespace

int main(int argc, char** argv)
try {
  if (argc < 3) {
    std::cerr << "usage: benchmark_applications MESH METHOD [FOLDER]\n";
    return 1;
  }
  Mesh mesh;
  CSCD::read_triangle_mesh(argv[1], mesh);
  const Labels labels = mesh.add_property_map<Mesh::Face_index, std::size_t>().first;
  Json result{{"vertices", mesh.number_of_vertices()}};
  result["parts"] = measure(argv[2], mesh, labels, result);
  if (argc > 3 && result["parts"] > 0) {
    result.update(compare_with_people(argv[3], mesh, labels));
  }
  std::cout << result << '\n';
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
