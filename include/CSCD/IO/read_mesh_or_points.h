// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes and point sets from files that may hold either.

#ifndef CSCD_IO_READ_MESH_OR_POINTS_H
#define CSCD_IO_READ_MESH_OR_POINTS_H

#include <CSCD/IO/Shape_file.h>
#include <CSCD/IO/read_points.h>
#include <CSCD/IO/read_triangle_mesh.h>

#include <istream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CSCD {

/// reads a stream that holds a triangle mesh, or points, if it has no faces.
/// \tparam TriangleMesh a model of `MutableFaceGraph` with an internal vertex point map
/// \tparam Point, Vector constructible from three coordinates
/// \param format the ending of a file name, with or without what stands before it: one of those of `Mesh_format` and
///        `Point_format`
/// \param name what to call the stream in messages
/// \param mesh is replaced if there are faces
/// \param points, normals are replaced if there are none
/// \return what was repaired, if there are faces
/// \throw File_error if the stream cannot be read, is malformed, or has neither faces nor points
/// \throw Input_error if the faces cannot be made a surface
template <class TriangleMesh, class Point, class Vector>
std::optional<Mesh_repair_report> read_mesh_or_points(std::istream& in, const std::string& format,
                                                      const std::string& name, TriangleMesh& mesh,
                                                      std::vector<Point>& points, std::vector<Vector>& normals)
{
  Shape_file file = internal::read_polygons_or_points(in, format, name);
  if (file.number_of_polygons() == 0) {
    internal::convert_to_points(file, points, normals);
    return std::nullopt;
  }
  return internal::convert_to_triangle_mesh(std::move(file), name, mesh);
}

} // namespace CSCD

#endif // CSCD_IO_READ_MESH_OR_POINTS_H
