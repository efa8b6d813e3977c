// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangle meshes from files, mended where they need it.

#ifndef CSCD_IO_READ_TRIANGLE_MESH_H
#define CSCD_IO_READ_TRIANGLE_MESH_H

#include <CSCD/IO/Mesh_format.h>
#include <CSCD/IO/Mesh_repair_report.h>
#include <CSCD/IO/internal/Polygon_soup.h>
#include <CSCD/IO/internal/Triangle_mesh_builder.h>
#include <CSCD/IO/internal/parse_obj.h>
#include <CSCD/IO/internal/parse_off.h>
#include <CSCD/IO/internal/parse_ply.h>
#include <CSCD/IO/internal/parse_stl.h>
#include <CSCD/IO/internal/read_content.h>
#include <CSCD/IO/internal/repair_triangle_soup.h>
#include <CSCD/IO/internal/triangulate_polygon_soup.h>
#include <CSCD/Surface/Halfedge_pairing.h>
#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Surface/Surface_components.h>
#include <CSCD/Traits/collect_triangles.h>
#include <CSCD/exceptions.h>

#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace CSCD {

namespace internal {

/// Reads the polygons of a file of which `content` is the content.
/// \throw File_error if it is malformed or has no polygons
inline Polygon_soup parse_polygon_soup(std::string_view content, Mesh_format format, const std::string& filename)
{
  if (content.empty()) {
    throw File_error(filename + ": the file is empty; fetch or write it again");
  }
  Polygon_soup soup = format == Mesh_format::off   ? parse_off(content, filename)
                      : format == Mesh_format::obj ? parse_obj(content, filename)
                      : format == Mesh_format::ply ? parse_ply(content, filename)
                                                   : parse_stl(content, filename);
  if (soup.number_of_polygons() == 0) {
    throw File_error(filename + ": the file has no faces; a triangle mesh is needed");
  }
  return soup;
}

/// Makes a mesh of the polygons of a file.
template <class TriangleMesh>
Mesh_repair_report convert_to_triangle_mesh(Polygon_soup&& polygons, const std::string& filename, TriangleMesh& mesh)
{
  Mesh_repair_report report;
  report.number_of_triangulated_polygons = polygons.number_of_polygons_larger_than_triangles();
  Indexed_triangles triangles = triangulate_polygon_soup(std::move(polygons));
  if (triangles.faces.size() > maximum_number_of_faces) {
    throw Input_error(filename + ": the mesh has more than 2^28 triangles; simplify it first");
  }
  std::optional<Halfedge_pairing> pairing = pair_manifold(triangles);
  if (!pairing || pairing->has_border()) {
    pairing = repair_triangle_soup(triangles, report);
  }
  if (!pairing) {
    throw Input_error(filename + ": the faces do not form a surface and could not be repaired; mend the mesh with a "
                                 "modelling program");
  }
  if (!pairing->has_border()) {
    Surface_components components(triangles, *pairing);
    report.number_of_turned_components = orient_outwards(triangles, *pairing, components);
  }
  Triangle_mesh_builder<TriangleMesh>(triangles, *pairing, mesh).build();
  return report;
}

} // namespace internal

/// reads the triangle mesh that the file `filename` holds, as OFF, OBJ, PLY or STL by its ending, and mends it.
/// Polygons are cut into triangles; if the triangles do not form an oriented closed manifold, points of equal
/// coordinates are merged; if they still form no manifold, degenerate and duplicate faces are removed, faces turned to
/// agree with their neighbours, and points duplicated where the surface is no manifold. If the surface is closed,
/// components that face inwards are turned. Vertices and faces are numbered as in the file, as far as nothing had to be
/// mended; vertices without a face are kept then. Near linear.
/// \tparam TriangleMesh a model of `MutableFaceGraph` with an internal vertex point map
/// \param mesh is replaced; when an exception is thrown it is as it was
/// \return what was mended
/// \throw File_error if the file cannot be read, is malformed, or has no faces
/// \throw Input_error if the faces cannot be made a surface
template <class TriangleMesh>
Mesh_repair_report read_triangle_mesh(const std::string& filename, TriangleMesh& mesh)
{
  const Mesh_format format = mesh_format(filename);
  internal::Polygon_soup soup = internal::parse_polygon_soup(internal::read_content(filename), format, filename);
  return internal::convert_to_triangle_mesh(std::move(soup), filename, mesh);
}

/// reads a triangle mesh from a stream, which for binary formats must not translate line ends; see the function for
/// files.
/// \param name what to call the stream in messages
template <class TriangleMesh>
Mesh_repair_report read_triangle_mesh(std::istream& in, Mesh_format format, const std::string& name, TriangleMesh& mesh)
{
  internal::Polygon_soup soup = internal::parse_polygon_soup(internal::read_content(in, name), format, name);
  return internal::convert_to_triangle_mesh(std::move(soup), name, mesh);
}

} // namespace CSCD

#endif // CSCD_IO_READ_TRIANGLE_MESH_H
