// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading the input; a file of its own, as the code for it takes long to compile.

#include "read_input.h"

#include "Usage_error.h"
#include <CSCD/IO/read_mesh_or_points.h>
#include <CSCD/exceptions.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <istream>
#include <optional>
#include <string>
#include <system_error>

namespace cscd {

namespace {

Input read(std::istream& in, const std::string& format, const std::string& name)
{
  Input input;
  const std::optional<CSCD::Mesh_repair_report> repairs =
      CSCD::read_mesh_or_points(in, format, name, input.mesh, input.points, input.normals);
  input.is_point_set = !repairs;
  if (repairs) {
    input.repairs = *repairs;
  }
  return input;
}

} // namespace

Input read_input(const Skeletonize_options& options)
{
  if (options.input == standard_stream) {
    if (options.format.empty()) {
      throw Usage_error("standard input has no ending: name its format by --format off, obj, ply, stl, xyz or pts");
    }
    return read(std::cin, "." + options.format, "standard input");
  }
  std::error_code error;
  if (std::filesystem::is_directory(options.input, error)) {
    throw CSCD::File_error(options.input + ": is a folder; name a file in it");
  }
  std::ifstream in(options.input, std::ios::binary);
  if (!in) {
    throw CSCD::File_error(options.input + ": cannot be opened; check the name and the permissions");
  }
  return read(in, options.format.empty() ? options.input : "." + options.format, options.input);
}

} // namespace cscd
