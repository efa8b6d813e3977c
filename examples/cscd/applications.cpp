// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands `cscd diameter` and `cscd segment`: from arguments to files.

#include "applications.h"

#include "commands.h"
#include "compute_skeleton.h"
#include "types.h"
#include <CSCD/Application/estimate_shape_diameters.h>
#include <CSCD/Application/segment_mesh.h>
#include <CSCD/IO/write_file.h>
#include <CSCD/exceptions.h>

#include <CGAL/mesh_segmentation.h>

#include <cstddef>
#include <iostream>
#include <limits>
#include <ostream>
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

Skeletonized_input skeletonized_input(const Application_options& options)
{
  check_is_not_input(options.output, options.input, "--output");
  Input input = read_mesh(options.input, options.format, options.is_quiet);
  try {
    Skeletonization_result result = compute_skeleton(input, Skeletonize_options(), nullptr);
    return {std::move(input.mesh), std::move(result.skeleton)};
  } catch (const CSCD::Input_error& error) {
    throw CSCD::Input_error(name_of(options.input) + ": " + error.what());
  }
}

/// Calls `write(out)` with a stream to the output.
template <class Write>
void write_output(const Application_options& options, const Write& write)
{
  if (options.output == standard_stream) {
    write(static_cast<std::ostream&>(std::cout));
  } else {
    CSCD::write_file(options.output, write);
  }
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

} // namespace

void segment(const Segment_options& options)
{
  if (options.by == by_diameter && options.number_of_parts > 0) {
    throw Usage_error("--parts: only a segmentation by the skeleton has a choice of parts; leave out --by diameter");
  }
  Skeletonized_input input = skeletonized_input(options);
  const auto labels = input.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:part").first;
  const std::size_t number_of_parts =
      options.by == by_diameter ? segment_by_diameter(input, labels)
                                : CSCD::segment_mesh(input.mesh, input.skeleton, labels,
                                                     CSCD::parameters::default_values(), options.number_of_parts);
  write_output(options, [&](std::ostream& out) {
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
  write_output(options, [&](std::ostream& out) {
    out.precision(std::numeric_limits<double>::max_digits10);
    for (const Mesh::Vertex_index vertex : input.mesh.vertices()) {
      out << diameters[vertex] << '\n';
    }
  });
}

} // namespace cscd
