// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands `cscd diameter` and `cscd segment`: from arguments to files.

#include "applications.h"

#include "commands.h"
#include "compute_skeleton.h"
#include "types.h"
#include <CSCD/Application/estimate_shape_diameters.h>
#include <CSCD/Application/match_skeletons.h>
#include <CSCD/Application/segment_mesh.h>
#include <CSCD/exceptions.h>

#include <CGAL/mesh_segmentation.h>

#include <cstddef>
#include <fstream>
#include <iostream>
#include <limits>
#include <ostream>
#include <set>
#include <string>
#include <utility>

namespace cscd {

namespace {

/// A mesh and its skeleton.
struct Skeletonized_input
{
  Mesh mesh;
  Skeleton skeleton;
};

Skeletonized_input skeletonized_mesh(const std::string& name, const std::string& format, bool is_quiet)
{
  Input input = read_mesh(name, format, is_quiet);
  try {
    Skeletonization_result result = compute_skeleton(input, Skeletonize_options(), nullptr);
    return {std::move(input.mesh), std::move(result.skeleton)};
  } catch (const CSCD::Input_error& error) {
    throw CSCD::Input_error(name_of(name) + ": " + error.what());
  }
}

Skeletonized_input skeletonized_input(const Application_options& options)
{
  check_is_not_input(options.output, options.input, "--output");
  return skeletonized_mesh(options.input, options.format, options.is_quiet);
}

/// CGAL's segmentation of shape diameters: the number of thicknesses that it tells apart is its default. Its default of
/// the weight of short boundaries, 0.26, is for noisier diameters, found by rays: with ours, most bodies stay in one
/// part.
constexpr std::size_t number_of_clusters = 5;
constexpr double smoothness = 0.1;

/// CGAL's segmentation, by the shape diameters of the faces. \return the number of parts
template <class FaceLabelMap>
std::size_t segment_by_diameter(Skeletonized_input& input, FaceLabelMap labels)
{
  const auto diameters = input.mesh.add_property_map<Mesh::Face_index, double>("f:diameter").first;
  CSCD::estimate_face_shape_diameters(input.mesh, input.skeleton, diameters);
  CGAL::sdf_values_postprocessing(input.mesh, diameters);
  return CGAL::segmentation_from_sdf_values(input.mesh, diameters, labels, number_of_clusters, smoothness);
}

using Labels = Mesh::Property_map<Mesh::Face_index, std::size_t>;

/// Reads a label for each face of `mesh`.
void read_labels(const std::string& filename, const Mesh& mesh, Labels labels)
{
  std::ifstream in(filename);
  if (!in) {
    throw CSCD::File_error(filename + ": cannot be read; check the name and the permissions");
  }
  for (const Mesh::Face_index face : mesh.faces()) {
    if (!(in >> labels[face])) {
      throw CSCD::Input_error(filename + ": has not a label for each of the " + std::to_string(mesh.number_of_faces()) +
                              " faces of the mesh of --like; write one number a line");
    }
  }
  if (std::string rest; in >> rest) {
    throw CSCD::Input_error(filename + ": has more labels than the mesh of --like has faces");
  }
}

/// Carries the parts of the mesh of `--like` over. \return the number of parts
std::size_t segment_like(const Segment_options& options, const Skeletonized_input& input, Labels labels)
{
  Skeletonized_input other = skeletonized_mesh(options.like, "", options.is_quiet);
  const Labels parts = other.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:part").first;
  if (options.labels.empty()) {
    CSCD::segment_mesh(other.mesh, other.skeleton, parts, CSCD::parameters::default_values(), options.number_of_parts);
  } else {
    read_labels(options.labels, other.mesh, parts);
  }
  CSCD::carry_labels(other.mesh, other.skeleton, parts, input.mesh, input.skeleton, labels);
  return std::set<std::size_t>(labels.begin(), labels.end()).size();
}

/// Checks options that exclude each other.
void check(const Segment_options& options)
{
  if (options.by == by_diameter && options.number_of_parts > 0) {
    throw Usage_error("--parts: only a segmentation by the skeleton has a choice of parts; leave out --by diameter");
  }
  if (!options.like.empty() && options.by == by_diameter) {
    throw Usage_error("--like: the parts of the other mesh are carried over by skeletons; leave out --by diameter");
  }
  if (options.like.empty() && !options.labels.empty()) {
    throw Usage_error("--labels: are of the faces of another mesh; name it by --like");
  }
  if (!options.labels.empty() && options.number_of_parts > 0) {
    throw Usage_error("--parts: the labels are what decides; leave out --parts or --labels");
  }
}

} // namespace

void segment(const Segment_options& options)
{
  check(options);
  Skeletonized_input input = skeletonized_input(options);
  const Labels labels = input.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:part").first;
  const std::size_t number_of_parts =
      !options.like.empty()       ? segment_like(options, input, labels)
      : options.by == by_diameter ? segment_by_diameter(input, labels)
                                  : CSCD::segment_mesh(input.mesh, input.skeleton, labels,
                                                       CSCD::parameters::default_values(), options.number_of_parts);
  write_output(options.output, [&](std::ostream& out) {
    for (const Mesh::Face_index face : input.mesh.faces()) {
      out << labels[face] << '\n';
    }
  });
  if (!options.is_quiet && options.output != standard_stream) {
    std::cout << options.output << ": " << number_of_parts << " parts\n";
  }
}

void write_diameters(const Application_options& options)
{
  Skeletonized_input input = skeletonized_input(options);
  const auto diameters = input.mesh.add_property_map<Mesh::Vertex_index, double>("v:diameter").first;
  CSCD::estimate_vertex_shape_diameters(input.mesh, input.skeleton, diameters);
  write_output(options.output, [&](std::ostream& out) {
    out.precision(std::numeric_limits<double>::max_digits10);
    for (const Mesh::Vertex_index vertex : input.mesh.vertices()) {
      out << diameters[vertex] << '\n';
    }
  });
}

} // namespace cscd
