// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangle meshes to files.

#ifndef CSCD_IO_WRITE_TRIANGLE_MESH_H
#define CSCD_IO_WRITE_TRIANGLE_MESH_H

#include <CSCD/IO/Mesh_format.h>
#include <CSCD/IO/internal/Skeleton_content.h>
#include <CSCD/IO/write_file.h>
#include <CSCD/exceptions.h>

#include <CGAL/boost/graph/IO/OBJ.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/boost/graph/IO/PLY.h>
#include <CGAL/boost/graph/IO/STL.h>

#include <ostream>
#include <string>

namespace CSCD {

/// writes `mesh` by CGAL's functions, as ASCII OFF, OBJ, PLY or STL by the ending of `filename`. A failure leaves no
/// new file. Linear.
/// \tparam TriangleMesh a model of `FaceListGraph` with triangular faces and an internal vertex point map
/// \throw File_error if the ending is unknown or the file cannot be written
template <class TriangleMesh>
void write_triangle_mesh(const std::string& filename, const TriangleMesh& mesh)
{
  const Mesh_format format = written_mesh_format(filename);
  write_file(filename, [&](std::ostream& out) {
    internal::Exact_format exact(out);
    const auto digits = CGAL::parameters::stream_precision(int(out.precision()));
    const bool is_written = format == Mesh_format::off   ? CGAL::IO::write_OFF(out, mesh, digits)
                            : format == Mesh_format::obj ? CGAL::IO::write_OBJ(out, mesh, digits)
                            : format == Mesh_format::ply ? CGAL::IO::write_PLY(out, mesh, digits)
                                                         : CGAL::IO::write_STL(out, mesh, digits);
    if (!is_written) {
      throw File_error(filename + ": cannot be written; check the disk");
    }
    exact.finish();
  });
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_TRIANGLE_MESH_H
