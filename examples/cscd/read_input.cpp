// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading the mesh; a file of its own, as the code for it takes long to compile.

#include "read_input.h"

#include "Usage_error.h"
#include <CSCD/IO/Mesh_format.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/exceptions.h>

#include <fstream>
#include <iostream>

namespace cscd {

CSCD::Mesh_repair_report read_input(const Skeletonize_options& options, Mesh& mesh)
{
  if (options.input == standard_stream) {
    if (options.format.empty()) {
      throw Usage_error("standard input has no ending: name its format by --format off, obj, ply or stl");
    }
    return CSCD::read_triangle_mesh(std::cin, CSCD::mesh_format("." + options.format), "standard input", mesh);
  }
  if (options.format.empty()) {
    return CSCD::read_triangle_mesh(options.input, mesh);
  }
  std::ifstream in(options.input, std::ios::binary);
  if (!in) {
    throw CSCD::File_error(options.input + ": cannot be opened; check the name and the permissions");
  }
  return CSCD::read_triangle_mesh(in, CSCD::mesh_format("." + options.format), options.input, mesh);
}

} // namespace cscd
