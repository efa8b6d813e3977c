// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Volumes as input of `cscd skeletonize`: one body, or one for each label.

#include "types.h"
#include <CSCD/IO/read_volume.h>
#include <CSCD/IO/write_nrrd.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Volume/Voxel_surface.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/parallel.h>

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace cscd {

namespace {

CSCD::Voxel_surface_settings settings_of(const Volume_options& options)
{
  CSCD::Voxel_surface_settings settings;
  settings.connectivity =
      options.connectivity == 6 ? CSCD::Voxel_connectivity::six : CSCD::Voxel_connectivity::twenty_six;
  settings.fills_cavities = !options.keeps_cavities;
  return settings;
}

/// `filename` with `label` before its ending.
std::string insert_label(const std::string& filename, CSCD::Voxel_label label)
{
  const char* const polylines = ".polylines.txt"; // the only ending with two dots
  const std::size_t end = boost::algorithm::iends_with(filename, polylines)
                              ? filename.size() - std::string(polylines).size()
                              : std::min(filename.rfind('.'), filename.size());
  return filename.substr(0, end) + "_" + std::to_string(label) + filename.substr(end);
}

Skeletonize_options options_of_body(const Skeletonize_options& options, CSCD::Voxel_label label)
{
  Skeletonize_options result = options;
  result.outputs.erase(std::remove_if(result.outputs.begin(), result.outputs.end(), is_node_volume),
                       result.outputs.end());
  if (options.volume.separates_labels) {
    for (std::string& output : result.outputs) {
      output = insert_label(output, label);
    }
    for (const auto& [option, file] : other_files(result)) {
      *file = file->empty() ? "" : insert_label(*file, label);
    }
  }
  return result;
}

bool has_node_volume(const Skeletonize_options& options)
{
  return std::any_of(options.outputs.begin(), options.outputs.end(), is_node_volume);
}

/// Whether `options` name files, and all are there.
bool is_done(const Skeletonize_options& options)
{
  std::vector<std::string> files = options.outputs;
  for (const auto& [option, file] : given_files(options)) {
    files.push_back(file);
  }
  return !files.empty() &&
         std::all_of(files.begin(), files.end(), [](const std::string& file) { return std::filesystem::exists(file); });
}

/// A body that has been read.
struct Waiting_body
{
  CSCD::Voxel_surface surface; ///< perhaps without its triangles
  Input input;
  Skeletonize_options options;
  Skeletonization_result result; ///< set by `skeletonize_bodies()`
};

/// Skeletonizes several bodies at once, with one thread for each, or one body with all threads.
void skeletonize_bodies(std::vector<Waiting_body>& bodies, unsigned number_of_threads)
{
  if (bodies.size() == 1) {
    bodies.front().result = skeletonize_with_progress(bodies.front().input, bodies.front().options);
    return;
  }
  CSCD::internal::For_each_index<char> for_each([] { return '\0'; }, number_of_threads);
  for_each(CSCD::Index(bodies.size()), [&bodies](CSCD::Index i, char&) {
    Skeletonize_options options = bodies[i].options;
    options.number_of_threads = 1;
    bodies[i].result = skeletonize_input(bodies[i].input, options, nullptr);
  });
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
  if (!is_volume(options) && has_node_volume(options)) {
    throw Usage_error("--output .nrrd: does not apply to meshes, points or graphs; use --correspondence");
  }
  if (int(volume.label.has_value()) + int(volume.threshold.has_value()) + int(volume.separates_labels) > 1) {
    throw Usage_error("--label, --threshold and --all-labels exclude each other; give one of them");
  }
  if (volume.separates_labels && number_of_results_on_standard_output(options) > 0) {
    throw Usage_error("--all-labels: has several results of a kind, which cannot go to standard output; name files");
  }
  if (volume.resumes && !volume.separates_labels) {
    throw Usage_error("--resume: continues --all-labels; add that, or leave it out");
  }
  if (volume.resumes && has_node_volume(options)) {
    throw Usage_error("--resume: a volume of nodes needs all labels; leave it out");
  }
}

void skeletonize_volume(CSCD::File_group& files, const Skeletonize_options& options)
{
  constexpr std::size_t large_size = 20000;        // vertices: a larger body has all threads for itself
  constexpr std::size_t max_number_of_bodies = 64; // that wait for their threads: these are kept in memory
  const bool keeps_surfaces = has_node_volume(options);
  std::vector<CSCD::Voxel_surface> surfaces; // for a volume of nodes
  std::vector<std::vector<std::uint32_t>> node_of_vertex;
  bool is_empty = true;
  std::vector<Waiting_body> waiting;
  const auto skeletonize_waiting = [&] {
    skeletonize_bodies(waiting, options.number_of_threads);
    for (Waiting_body& body : waiting) {
      tell_and_write(files, body.input, body.result, body.options);
      if (options.volume.separates_labels) {
        files.publish();
      }
      if (keeps_surfaces) {
        node_of_vertex.push_back(assigned_surface(body.input, body.result.skeleton).node_of_vertex);
        for (std::uint32_t& number : node_of_vertex.back()) {
          ++number; // 0 where there is none
        }
        surfaces.push_back(std::move(body.surface));
      }
    }
    waiting.clear();
  };
  const auto take_surface = [&](CSCD::Voxel_surface&& surface) {
    is_empty = false;
    const Skeletonize_options options_of_this = options_of_body(options, surface.label);
    if (options.volume.resumes && is_done(options_of_this)) {
      return;
    }
    surface.turn_cavities();
    const bool is_large = surface.triangles.points.size() > large_size;
    if (is_large) {
      skeletonize_waiting();
    }
    Input input =
        make_input(keeps_surfaces ? CSCD::Indexed_triangles(surface.triangles) : std::move(surface.triangles));
    input.volume = {surface.label, surface.number_of_voxels, surface.number_of_cavities};
    waiting.push_back({std::move(surface), std::move(input), options_of_this, {}});
    if (is_large || waiting.size() == max_number_of_bodies) {
      skeletonize_waiting();
    }
  };
  CSCD::for_each_voxel_surface(options.input, options.volume, settings_of(options.volume), take_surface);
  skeletonize_waiting();
  if (is_empty) {
    throw CSCD::Input_error(options.input + ": no voxel is of a body; choose another label or threshold");
  }
  for (const std::string& output : options.outputs) {
    if (is_node_volume(output)) {
      CSCD::Volume_reader reader(options.input, options.volume);
      files.write(output, [&](std::ostream& out) { CSCD::write_node_volume(out, reader, surfaces, node_of_vertex); });
    }
  }
}

} // namespace cscd
