// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `cscd skeletonize`: from arguments to files.

#include "skeletonize.h"

#include "Input.h"
#include "Progress_bar.h"
#include "Skeletonization_result.h"
#include "Usage_error.h"
#include "compute_skeleton.h"
#include "read_input.h"
#include "write_output.h"
#include "write_report.h"
#include <CSCD/IO/write_file.h>
#include <CSCD/exceptions.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <ostream>
#include <string>
#include <unistd.h>

namespace cscd {

namespace {

void check_options(const Skeletonize_options& options)
{
  if (options.method != published_method && !options.target.empty()) {
    throw Usage_error("--target: only the published method has a choice of targets; add --method published");
  }
  if (options.method != published_method && !options.shortening.empty()) {
    throw Usage_error("--shortening: only the published method has a choice of shortenings; add --method published");
  }
  if (options.method == published_method && options.shape == tree_shape) {
    throw Usage_error("--shape tree: only surfaces have a choice of methods; leave out --method published");
  }
  if (options.method == published_method && options.shape == tree_shape) {
    throw Usage_error("--shape tree: trees have a method of their own; leave out --method published");
  }
  if (!options.root.empty() && options.shape == surface_shape) {
    throw Usage_error("--root: only a tree has a root; leave out --shape surface");
  }
  for (const std::string& output : options.outputs) {
    check_output(output);
  }
  if (!options.html.empty() && !has_viewer_page()) {
    throw Usage_error("--html: this program was built without three.js; install libjs-three and build it again");
  }
}

/// What the input is called in messages.
std::string name_of_input(const Skeletonize_options& options)
{
  return options.input == standard_stream ? "standard input" : options.input;
}

void say(const Skeletonize_options& options, const std::string& sentence)
{
  if (!options.is_quiet) {
    std::cerr << "cscd: " << name_of_input(options) << ": " << sentence << '\n';
  }
}

Skeletonization_result compute(Input& input, const Skeletonize_options& options)
{
  std::optional<Progress_bar> bar;
  if (!options.is_quiet && isatty(STDERR_FILENO) == 1) {
    bar.emplace(std::cerr);
  }
  try {
    return compute_skeleton(input, options, bar ? &*bar : nullptr);
  } catch (const CSCD::Input_error& error) {
    throw CSCD::Input_error(name_of_input(options) + ": " + error.what());
  }
}

/// The name of the input file without its folder, which means nothing to whom the page is given.
std::string title(const Skeletonize_options& options, const Skeletonization_result& result)
{
  const std::string name = std::filesystem::path(name_of_input(options)).filename().string();
  return result.tree ? name + ", taken for a scan of trees" : name;
}

void write_results(const Input& input, const Skeletonization_result& result, const Skeletonize_options& options)
{
  for (const std::string& output : options.outputs) {
    write_output(output, result.skeleton);
  }
  if (!options.html.empty()) {
    write_viewer_page(options.html, input, result, title(options, result));
  }
  if (!options.report.empty()) {
    CSCD::write_file(options.report, [&](std::ostream& out) { write_report(out, options, input.repairs, result); });
  }
  const bool is_output_taken =
      std::find(options.outputs.begin(), options.outputs.end(), standard_stream) != options.outputs.end();
  if (!options.is_quiet && !is_output_taken) {
    write_summary(std::cout, options, result);
  }
}

} // namespace

void skeletonize(const Skeletonize_options& options)
{
  check_options(options);
  Input input = read_input(options);
  if (!input.is_point_set && (options.shape == tree_shape || !options.root.empty())) {
    throw Usage_error(name_of_input(options) + ": is a mesh; only points can be a tree: leave out --shape and --root");
  }
  for (const std::string& sentence : input.repairs.sentences()) {
    say(options, sentence);
  }
  if (input.is_point_set && options.shortening == flip_shortening) {
    throw Usage_error("--shortening flips: points have no edges to be flipped; leave the option out");
  }
  const Skeletonization_result result = compute(input, options);
  for (const std::string& warning : result.warnings()) {
    say(options, warning);
  }
  write_results(input, result, options);
}

} // namespace cscd
