// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fuzz target: any bytes, read as a mesh file. The result is a valid triangle mesh, or the content is refused in one
// line that names the file; everything else is a bug and aborts.
//
// The bytes: the format, then the content of the file.

#include "Bytes.h"
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/exceptions.h>

#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <sstream>
#include <string>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

constexpr std::array<const char*, 7> endings_of_meshes{".off", ".obj", ".ply", ".stl", ".vtk", ".glb", ".vtp"};
const std::string name_of_file = "fuzz";

void check_message(const std::exception& error, const Mesh& mesh)
{
  const std::string message = error.what();
  const bool is_one_line_with_name =
      message.find('\n') == std::string::npos && message.find(name_of_file) != std::string::npos;
  if (!is_one_line_with_name || !mesh.is_empty()) {
    std::cerr << "refused badly: " << message << '\n';
    std::abort();
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  CSCD::test::Bytes bytes(data, size);
  const char* const format = endings_of_meshes[bytes.take() % endings_of_meshes.size()];
  std::istringstream in(bytes.rest());
  Mesh mesh;
  try {
    CSCD::read_triangle_mesh(in, format, name_of_file, mesh);
  } catch (const CSCD::File_error& error) {
    check_message(error, mesh);
    return 0;
  } catch (const CSCD::Input_error& error) {
    check_message(error, mesh);
    return 0;
  }
  CGAL::Polygon_mesh_processing::remove_isolated_vertices(mesh);
  if (!CGAL::is_valid_polygon_mesh(mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty()) {
    std::cerr << "not a triangle mesh\n";
    std::abort();
  }
  return 0;
}
