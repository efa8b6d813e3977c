// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `cscd evaluate`: from arguments to measures.

#include "evaluate.h"

#include "Input.h"
#include "Skeletonize_options.h"
#include "Usage_error.h"
#include "read_input.h"
#include "read_skeleton_argument.h"
#include "types.h"
#include "write_measures.h"
#include <CSCD/IO/Mesh_format.h>
#include <CSCD/IO/write_triangle_mesh.h>
#include <CSCD/Measure/Skeleton_measures.h>
#include <CSCD/Measure/evaluate_skeleton.h>
#include <CSCD/Measure/reconstruct_surface.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/exceptions.h>

#include <iostream>
#include <string>

namespace cscd {

namespace {

void check_mesh_output(const std::string& filename)
{
  try {
    CSCD::mesh_format(filename);
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
    }
  }
}

Input read(const Evaluate_options& options)
{
  Skeletonize_options input_options;
  input_options.input = options.input;
  input_options.format = options.format;
  Input input = read_input(input_options);
  if (!options.is_quiet) {
    for (const std::string& sentence : input.repairs.sentences()) {
      std::cerr << "cscd: " << (options.input == standard_stream ? "standard input" : options.input) << ": " << sentence
                << '\n';
    }
  }
  return input;
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

void evaluate(const Evaluate_options& options)
{
  check_options(options);
  const Input input = read(options);
  const Skeleton skeleton = read_skeleton_argument(options.skeleton);
  const CSCD::Skeleton_measures measures =
      input.is_point_set ? measure(input.points, skeleton, options) : measure(input.mesh, skeleton, options);
  if (options.is_json) {
    write_measures_as_json(std::cout, options, measures);
  } else {
    write_measures(std::cout, options, measures);
  }
}

} // namespace cscd
