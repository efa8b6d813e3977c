// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segmentations of the meshes of the Princeton segmentation benchmark against those of people, by classes.
//
// Usage: benchmark_segmentation FOLDER [skeleton] [diameter] [rays]
// FOLDER holds off/N.off and seg/Benchmark/N/N_*.seg. Methods: CSCD::segment_mesh(); CGAL's segmentation by our shape
// diameters; CGAL's segmentation by its own, which are found by rays. Writes tables in Markdown.

#include <CSCD/Application/estimate_shape_diameters.h>
#include <CSCD/Application/segment_mesh.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/Measure/compare_segmentations.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/mesh_segmentation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Skeleton = CSCD::Skeleton_graph<Mesh::Point, Mesh::Vertex_index>;
using Labels = Mesh::Property_map<Mesh::Face_index, std::size_t>;

// Twenty consecutive numbers are a class; the fourteenth was withdrawn.
constexpr std::size_t class_size = 20;
constexpr std::size_t number_of_classes = 20;
constexpr std::array<const char*, number_of_classes> class_names{
    "human",           "cup",     "glasses", "airplane",   "ant",  "chair", "octopus",   "table",
    "teddy",           "hand",    "pliers",  "fish",       "bird", "",      "armadillo", "bust",
    "mechanical part", "bearing", "vase",    "four-legged"};

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

/// CGAL's segmentation of shape diameters. \param smoothness the weight of short boundaries
std::size_t segment_by_diameters(const Mesh& mesh, Mesh::Property_map<Mesh::Face_index, double> diameters,
                                 double smoothness, Labels labels)
{
  constexpr std::size_t number_of_clusters = 5; // CGAL's default
  CGAL::sdf_values_postprocessing(mesh, diameters);
  return CGAL::segmentation_from_sdf_values(mesh, diameters, labels, number_of_clusters, smoothness);
}

/// Segments a mesh by the method of this name. \return the number of parts
std::size_t segment(const std::string& method, Mesh& mesh, Labels labels)
{
  const auto diameters = mesh.add_property_map<Mesh::Face_index, double>().first;
  if (method == "rays") {
    CGAL::sdf_values(mesh, diameters, 2. / 3 * CGAL_PI, 25, false); // the defaults but for the postprocessing
    return segment_by_diameters(mesh, diameters, 0.26, labels);     // CGAL's default
  }
  Skeleton skeleton;
  CSCD::extract_curve_skeleton(mesh, skeleton);
  if (method == "skeleton") {
    return CSCD::segment_mesh(mesh, skeleton, labels);
  }
  if (method != "diameter") {
    throw std::invalid_argument(method + ": the methods are skeleton, diameter and rays");
  }
  CSCD::estimate_face_shape_diameters(mesh, skeleton, diameters);
  return segment_by_diameters(mesh, diameters, 0.1, labels); // as `cscd segment --by diameter`
}

/// Sums over meshes of a class or of all.
struct Sums
{
  double number_of_meshes = 0;
  double rand_error = 0;
  double cut_discrepancy = 0;
  double number_with_cuts = 0;
  double hamming_distance = 0;
  double global_consistency_error = 0;
  double local_consistency_error = 0;
  double number_of_parts = 0;
  double seconds = 0;

  void add(const Sums& other)
  {
    number_of_meshes += other.number_of_meshes;
    rand_error += other.rand_error;
    cut_discrepancy += other.cut_discrepancy;
    number_with_cuts += other.number_with_cuts;
    hamming_distance += other.hamming_distance;
    global_consistency_error += other.global_consistency_error;
    local_consistency_error += other.local_consistency_error;
    number_of_parts += other.number_of_parts;
    seconds += other.seconds;
  }

  void write(const std::string& name) const
  {
    const double n = number_of_meshes;
    std::printf("| %s | %.3f | %.3f | %.3f | %.3f | %.3f | %.1f | %.2f |\n", name.c_str(), rand_error / n,
                cut_discrepancy / std::max(1., number_with_cuts), hamming_distance / n, global_consistency_error / n,
                local_consistency_error / n, number_of_parts / n, seconds / n);
  }
};

/// The means over the segmentations by people of a mesh.
Sums compare_with_people(const std::filesystem::path& folder, std::size_t number, const std::string& method)
{
  Mesh mesh;
  CSCD::read_triangle_mesh((folder / "off" / (std::to_string(number) + ".off")).string(), mesh);
  const Labels labels = mesh.add_property_map<Mesh::Face_index, std::size_t>().first;
  CGAL::Real_timer timer;
  timer.start();
  Sums result;
  result.number_of_parts = double(segment(method, mesh, labels));
  result.seconds = timer.time();
  result.number_of_meshes = 1;
  double people = 0;
  double people_with_cuts = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "seg/Benchmark" / std::to_string(number))) {
    Mesh copy = mesh;
    const CSCD::Segmentation_comparison comparison =
        CSCD::compare_segmentations(mesh, labels, read_labels(entry.path(), copy));
    people += 1;
    result.rand_error += comparison.rand_error;
    result.hamming_distance += comparison.hamming_distance;
    result.global_consistency_error += comparison.global_consistency_error;
    result.local_consistency_error += comparison.local_consistency_error;
    if (!std::isnan(comparison.cut_discrepancy)) {
      result.cut_discrepancy += comparison.cut_discrepancy;
      people_with_cuts += 1;
    }
  }
  result.rand_error /= people;
  result.hamming_distance /= people;
  result.global_consistency_error /= people;
  result.local_consistency_error /= people;
  result.number_with_cuts = people_with_cuts > 0 ? 1 : 0;
  result.cut_discrepancy /= std::max(1., people_with_cuts);
  return result;
}

void write_table(const std::filesystem::path& folder, const std::string& method)
{
  std::array<Sums, number_of_classes> of_class;
  std::array<Sums, 2> of_parity; // even, odd
  for (std::size_t number = 1; number <= class_size * number_of_classes; ++number) {
    if (!std::filesystem::exists(folder / "off" / (std::to_string(number) + ".off"))) {
      continue;
    }
    const Sums sums = compare_with_people(folder, number, method);
    std::fprintf(stderr, "%zu %.4f %.0f\n", number, sums.rand_error, sums.number_of_parts);
    of_parity[number % 2].add(sums);
    if (number % 2 == 0) {
      of_class[(number - 1) / class_size].add(sums);
    }
  }
  std::printf("\nMethod `%s`; classes: even-numbered meshes only.\n\n", method.c_str());
  std::printf(
      "| meshes | 1 - Rand index | cut discrepancy | Hamming | global consistency | local consistency | parts | "
      "seconds |\n|---|---|---|---|---|---|---|---|\n");
  for (std::size_t i = 0; i < number_of_classes; ++i) {
    if (of_class[i].number_of_meshes > 0) {
      of_class[i].write(class_names[i]);
    }
  }
  of_parity[0].write("**all even-numbered**");
  of_parity[1].write("all odd-numbered");
}

} // namespace

int main(int argc, char** argv)
try {
  if (argc < 2) {
    std::cerr << "usage: benchmark_segmentation FOLDER [skeleton] [diameter] [rays]\n";
    return 1;
  }
  const std::vector<std::string> arguments(argv + 2, argv + argc);
  const std::vector<std::string> all_fast{"skeleton", "diameter"};
  for (const std::string& method : arguments.empty() ? all_fast : arguments) {
    write_table(argv[1], method);
  }
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
