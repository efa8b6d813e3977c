// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands `cscd evaluate` and `cscd compare`: from arguments to measures.

#include "commands.h"
#include "types.h"
#include "write_measures.h"
#include <CSCD/IO/Mesh_format.h>
#include <CSCD/IO/read_skeleton.h>
#include <CSCD/IO/write_triangle_mesh.h>
#include <CSCD/Measure/Skeleton_measures.h>
#include <CSCD/Measure/compare_skeletons.h>
#include <CSCD/Measure/evaluate_skeleton.h>
#include <CSCD/Measure/reconstruct_surface.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/exceptions.h>

#include <iostream>
#include <string>

namespace cscd {

void check_skeleton_argument(const std::string& filename)
{
  if (filename == standard_stream) {
    return;
  }
  try {
    CSCD::check_readable_skeleton_filename(filename);
  } catch (const CSCD::File_error& error) {
    throw Usage_error(error.what());
  }
}

bool read_skeleton_argument(const std::string& filename, Skeleton& skeleton)
{
  return filename == standard_stream ? CSCD::read_skeleton(std::cin, ".graph", "standard input", skeleton)
                                     : CSCD::read_skeleton(filename, skeleton);
}

namespace {

Skeleton skeleton_argument(const std::string& filename)
{
  Skeleton skeleton;
  read_skeleton_argument(filename, skeleton);
  return skeleton;
}

void check_mesh_output(const std::string& filename)
{
  try {
    CSCD::written_mesh_format(filename);
  } catch (const CSCD::File_error& error) {
    throw Usage_error(error.what());
  }
}

void check_options(const Evaluate_options& options)
{
  check_skeleton_argument(options.skeleton);
  if (options.input == standard_stream && options.skeleton == standard_stream) {
    throw Usage_error("only one of INPUT and SKELETON can be standard input");
  }
  for (const std::string& filename : {options.convolution_surface, options.round_cones}) {
    if (!filename.empty()) {
      check_mesh_output(filename);
      check_is_not_input(filename, options.input, "reconstructed surface");
      check_is_not_input(filename, options.skeleton, "reconstructed surface");
    }
  }
}

/// \tparam Surface of a mesh or of points
template <class Surface>
void write_reconstruction(const std::string& filename, const Surface& surface, const Skeleton& skeleton,
                          const Evaluate_options& options, CSCD::Reconstruction_method method)
{
  if (filename.empty()) {
    return;
  }
  Mesh reconstruction;
  CSCD::reconstruct_surface(surface, skeleton, reconstruction,
                            CSCD::parameters::resolution(options.resolution)
                                .use_skeleton_radii(options.radii == own_radii)
                                .reconstruction_method(method));
  CSCD::write_triangle_mesh(filename, reconstruction);
}

template <class Surface>
CSCD::Skeleton_measures measure(const Surface& surface, const Skeleton& skeleton, const Evaluate_options& options)
{
  write_reconstruction(options.convolution_surface, surface, skeleton, options,
                       CSCD::Reconstruction_method::convolution);
  write_reconstruction(options.round_cones, surface, skeleton, options, CSCD::Reconstruction_method::round_cones);
  return CSCD::evaluate_skeleton(
      surface, skeleton,
      CSCD::parameters::resolution(options.resolution).use_skeleton_radii(options.radii == own_radii));
}

} // namespace

CSCD::Skeleton_measures measure_skeleton(const Input& input, const Skeleton& skeleton, const Evaluate_options& options)
{
  return input.is_point_set ? measure(input.points, skeleton, options) : measure(input.mesh, skeleton, options);
}

void evaluate(const Evaluate_options& options)
{
  check_options(options);
  const Input input = read_input(options.input, options.format, options.is_quiet);
  const Skeleton skeleton = skeleton_argument(options.skeleton);
  const CSCD::Skeleton_measures measures = measure_skeleton(input, skeleton, options);
  if (options.is_json) {
    write_measures_as_json(std::cout, options, measures);
  } else {
    write_measures(std::cout, options, measures);
  }
}

void compare(const Compare_options& options)
{
  check_skeleton_argument(options.first);
  check_skeleton_argument(options.second);
  if (options.first == standard_stream && options.second == standard_stream) {
    throw Usage_error("only one of the skeletons can be standard input");
  }
  const Skeleton first = skeleton_argument(options.first);
  const Skeleton second = skeleton_argument(options.second);
  const CSCD::Skeleton_comparison comparison =
      CSCD::compare_skeletons(first, second, CSCD::parameters::match_distance(options.match_distance));
  if (options.is_json) {
    write_comparison_as_json(std::cout, options, comparison);
  } else {
    write_comparison(std::cout, options, comparison);
  }
}

} // namespace cscd
