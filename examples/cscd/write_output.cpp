// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writing the results; a file of its own, as the code for it takes long to compile.

#include "write_output.h"

#include "Skeletonize_options.h"
#include "Usage_error.h"
#include "three_js_source.h"
#include <CSCD/IO/write_file.h>
#include <CSCD/IO/write_gel_graph.h>
#include <CSCD/IO/write_html_page.h>
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/exceptions.h>

#include <iostream>
#include <ostream>

namespace cscd {

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
  CSCD::write_file(filename, [&](std::ostream& out) {
    CSCD::write_html_page(out, input.mesh, result.skeleton, result.separators, CSCD::three_js_source(), title);
  });
}

} // namespace cscd
