// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fuzz target: any bytes, read as a mesh file. The result is a valid triangle mesh, or the content is refused in one
// line that names the file; everything else is a bug and aborts.
//
// The bytes: the format, then the content of the file.

#include "Coded_file.h"
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/exceptions.h>

#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <cstdint>
#include <exception>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int check_refused(const std::exception& error, const Mesh& mesh)
{
  CSCD::test::check_refusal(error, "fuzz");
  if (!mesh.is_empty()) {
    CSCD::test::fail("refused with an output");
  }
  return 0;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  CSCD::test::Coded_file file({data, size}, CSCD::test::endings_of_meshes);
  Mesh mesh;
  try {
    CSCD::read_triangle_mesh(file.content, file.ending, "fuzz", mesh);
  } catch (const CSCD::File_error& error) {
    return check_refused(error, mesh);
  } catch (const CSCD::Input_error& error) {
    return check_refused(error, mesh);
  }
  CGAL::Polygon_mesh_processing::remove_isolated_vertices(mesh);
  if (!CGAL::is_valid_polygon_mesh(mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty()) {
    CSCD::test::fail("not a triangle mesh");
  }
  return 0;
}
