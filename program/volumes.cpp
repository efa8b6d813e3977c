// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Volumes as input of `cscd skeletonize`: one body, or one for each label.

#include "volumes.h"

#include <CSCD/IO/read_volume.h>
#include <CSCD/IO/write_nrrd.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Volume/Voxel_surface.h>
#include <CSCD/exceptions.h>

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace cscd {

namespace {

CSCD::Voxel_selection selection_of(const Volume_options& options)
{
  CSCD::Voxel_selection result;
  result.threshold = options.threshold;
  result.label = options.label;
  result.separates_labels = options.has_all_labels;
  return result;
}

std::vector<CSCD::Voxel_surface> read_surfaces(const Skeletonize_options& options)
{
  CSCD::Voxel_surface_settings settings;
  settings.connectivity =
      options.volume.connectivity == 6 ? CSCD::Voxel_connectivity::six : CSCD::Voxel_connectivity::twenty_six;
  settings.fills_cavities = !options.volume.keeps_cavities;
  std::vector<CSCD::Voxel_surface> result =
      CSCD::read_voxel_surfaces(options.input, selection_of(options.volume), settings);
  if (result.empty()) {
    throw CSCD::Input_error(options.input + ": no voxel is of a body; choose another label or threshold");
  }
  return result;
}

/// `filename` with `label` before its ending.
std::string insert_label(const std::string& filename, std::uint32_t label)
{
  const char* const polylines = ".polylines.txt"; // the only ending with two dots
  const std::size_t end = boost::algorithm::iends_with(filename, polylines)
                              ? filename.size() - std::string(polylines).size()
                              : std::min(filename.rfind('.'), filename.size());
  return filename.substr(0, end) + "_" + std::to_string(label) + filename.substr(end);
}

Skeletonize_options options_of_body(const Skeletonize_options& options, std::uint32_t label)
{
  Skeletonize_options result = options;
  result.outputs.erase(std::remove_if(result.outputs.begin(), result.outputs.end(), is_node_volume),
                       result.outputs.end());
  if (options.volume.has_all_labels) {
    for (std::string& output : result.outputs) {
      output = insert_label(output, label);
    }
    for (const auto& [option, file] : other_files(result)) {
      *file = file->empty() ? "" : insert_label(*file, label);
    }
  }
  return result;
}

} // namespace

bool is_volume(const Skeletonize_options& options)
{
  return options.format.empty() && CSCD::is_volume_filename(options.input);
}

bool is_node_volume(const std::string& output)
{
  return boost::algorithm::iends_with(output, ".nrrd");
}

void check_volume_options(const Skeletonize_options& options)
{
  const Volume_options& volume = options.volume;
  if (!is_volume(options) && std::any_of(options.outputs.begin(), options.outputs.end(), is_node_volume)) {
    throw Usage_error("--output .nrrd: does not apply to meshes, points or graphs; use --correspondence");
  }
  if (int(volume.label.has_value()) + int(volume.threshold.has_value()) + int(volume.has_all_labels) > 1) {
    throw Usage_error("--label, --threshold and --all-labels exclude each other; give one of them");
  }
  if (volume.has_all_labels && number_of_results_on_standard_output(options) > 0) {
    throw Usage_error("--all-labels: has several results of a kind, which cannot go to standard output; name files");
  }
}

void skeletonize_volume(CSCD::File_group& files, const Skeletonize_options& options,
                        const Skeletonize_body& skeletonize_body)
{
  std::vector<CSCD::Voxel_surface> surfaces = read_surfaces(options);
  const bool has_node_volume = std::any_of(options.outputs.begin(), options.outputs.end(), is_node_volume);
  std::vector<std::vector<std::uint32_t>> node_of_vertex;
  for (CSCD::Voxel_surface& surface : surfaces) {
    surface.turn_cavities();
    surface.pairing = {};
    // As many labels as there are need not be in memory twice.
    Input body =
        make_input(has_node_volume ? CSCD::Indexed_triangles(surface.triangles) : std::move(surface.triangles));
    body.volume = {surface.label, surface.number_of_voxels, surface.number_of_cavities};
    const Skeletonization_result result = skeletonize_body(files, body, options_of_body(options, surface.label));
    if (has_node_volume) {
      node_of_vertex.push_back(assigned_surface(body, result.skeleton).node_of_vertex);
      for (std::uint32_t& number : node_of_vertex.back()) {
        ++number; // 0 where there is none
      }
    }
  }
  for (const std::string& output : options.outputs) {
    if (is_node_volume(output)) {
      CSCD::Volume_reader reader(options.input, selection_of(options.volume));
      files.write(output, [&](std::ostream& out) { CSCD::write_node_volume(out, reader, surfaces, node_of_vertex); });
    }
  }
}

} // namespace cscd
