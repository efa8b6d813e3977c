// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writing the results; a file of its own, as the code for it takes long to compile.

#include "write_output.h"

#include "Skeletonize_options.h"
#include "Usage_error.h"
#include "three_js_source.h"
#include <CSCD/IO/internal/Html_page_data.h>
#include <CSCD/IO/write_file.h>
#include <CSCD/IO/write_gel_graph.h>
#include <CSCD/IO/write_html_page.h>
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Tree/Tree_report.h>
#include <CSCD/exceptions.h>

#include <iostream>
#include <ostream>
#include <vector>

namespace cscd {

namespace {

std::vector<Point> centers(const std::vector<CSCD::Reconstruction_repair>& repairs)
{
  std::vector<Point> result;
  for (const CSCD::Reconstruction_repair& repair : repairs) {
    result.emplace_back(repair.center[0], repair.center[1], repair.center[2]);
  }
  return result;
}

/// What the page shows of a point set; nothing for a mesh.
CSCD::Html_page_cloud<Point> make_cloud(const Input& input, const Skeletonization_result& result)
{
  if (result.tree) {
    std::vector<Point> gaps;
    for (const CSCD::Tree_gap& gap : result.tree->gaps) {
      gaps.emplace_back((gap.from[0] + gap.to[0]) / 2, (gap.from[1] + gap.to[1]) / 2, (gap.from[2] + gap.to[2]) / 2);
    }
    return {input.points.size(), {}, gaps};
  }
  if (!result.report.reconstruction) {
    return {};
  }
  return {input.points.size(), centers(result.report.reconstruction->cut_handles),
          centers(result.report.reconstruction->joined_gaps)};
}

} // namespace

void check_output(const std::string& filename)
{
  if (filename == standard_stream) {
    return;
  }
  try {
    CSCD::check_skeleton_filename(filename);
  } catch (const CSCD::File_error& error) {
    throw Usage_error(error.what());
  }
}

void write_output(const std::string& filename, const Skeleton& skeleton)
{
  if (filename == standard_stream) {
    CSCD::write_gel_graph(std::cout, skeleton);
  } else {
    CSCD::write_skeleton(filename, skeleton);
  }
}

bool has_viewer_page()
{
  return !CSCD::three_js_source().empty();
}

void write_viewer_page(const std::string& filename, const Input& input, const Skeletonization_result& result,
                       const std::string& title)
{
  const CSCD::Html_page_cloud<Point> cloud = make_cloud(input, result);
  CSCD::write_file(filename, [&](std::ostream& out) {
    CSCD::write_html_page(out, input.mesh, result.skeleton, result.separators, CSCD::three_js_source(), title, cloud);
  });
}

} // namespace cscd
