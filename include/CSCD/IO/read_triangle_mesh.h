// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangle meshes from files, repaired where they need it.

#ifndef CSCD_IO_READ_TRIANGLE_MESH_H
#define CSCD_IO_READ_TRIANGLE_MESH_H

#include <CSCD/IO/Shape_file.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector3.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <istream>
#include <string>
#include <utility>
#include <vector>

namespace CSCD {

/// The repairs of `read_triangle_mesh()` until the polygons of a file became an oriented manifold triangle mesh.
struct Mesh_repair_report
{
  std::size_t number_of_triangulated_polygons = 0; ///< faces of more than three vertices, cut into triangles
  std::size_t number_of_merged_points = 0;         ///< points at the place of another one, at borders up to rounding
  std::size_t number_of_removed_faces = 0;         ///< triangles that named a vertex twice or repeated another triangle
  /// Triangles of small parts that hung on the surface where three faces or more met at an edge.
  std::size_t number_of_removed_flap_faces = 0;
  std::size_t number_of_removed_points = 0;    ///< points left without any face by the repair
  std::size_t number_of_turned_faces = 0;      ///< triangles turned to agree with their neighbors
  std::size_t number_of_duplicated_points = 0; ///< points doubled where the surface was not a manifold
  std::size_t number_of_turned_components = 0; ///< closed components turned outwards, except cavities

  /// Whether the mesh is the file's, face by face.
  bool is_empty() const { return sentences().empty(); }

  /// The repairs that were made, a sentence each, without a full stop.
  std::vector<std::string> sentences() const;
};

namespace internal {

/// The triangles of a file, an oriented manifold.
struct Manifold_triangles
{
  Indexed_triangles triangles;
  Mesh_repair_report report;
  /// Where the points of the file are now, if some at borders were merged that only rounding parted; else empty.
  std::vector<Vector3> places_in_file;
};

/// Cuts polygons into triangles and repairs these.
/// \param filename for messages
/// \param number_of_threads 0 for as many as TBB allows; the result is the same for any number
/// \throw Input_error if they are too many or cannot be made a surface
Manifold_triangles make_manifold(Shape_file&& polygons, const std::string& filename, unsigned number_of_threads = 1);

/// For each polygon of a file, the largest of its triangles that is a face of the mesh that was made from the file; if
/// none is, some face at one of its points; `no_index` if there is none either. Faces are found by the places of their
/// corners. O(n log n).
/// \param file the argument of `make_manifold()`, whose points are the `places_in_file` of the result if it has any
/// \param points, faces of the mesh
std::vector<Index> faces_of_polygons(const Shape_file& file, const std::vector<Vector3>& points,
                                     const std::vector<std::array<Index, 3>>& faces);

/// Makes a mesh of the polygons of a file.
template <class TriangleMesh>
Mesh_repair_report convert_to_triangle_mesh(Shape_file&& polygons, const std::string& filename, TriangleMesh& mesh)
{
  using Point_map = typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::type;
  const Manifold_triangles manifold = make_manifold(std::move(polygons), filename);
  const auto points = make_triples<typename boost::property_traits<Point_map>::value_type>(manifold.triangles.points);
  CGAL::clear(mesh);
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, manifold.triangles.faces, mesh);
  return manifold.report;
}

} // namespace internal

/// reads the triangle mesh that the file `filename` holds and repairs it. Its ending, in lower or upper case, names the
/// format: `.off`, `.obj`, `.ply`, `.stl`, `.vtp` and `.vtk` of VTK's PolyData, `.glb` and `.gltf`. With a further
/// ending `.gz` it is decompressed by zlib first. Polygons are cut into triangles. If these do not form an oriented
/// closed manifold, points of equal coordinates are merged, at borders also those that only rounding to single
/// precision parts. If they still do not form a manifold, degenerate and duplicate faces and small flaps are removed,
/// faces turned to agree with their neighbors, and points duplicated where the surface is not a manifold. If it is
/// closed, components that face inwards are turned, except cavities. Vertices and faces are numbered as in the file, as
/// far as nothing had to be repaired; vertices without a face are kept then. Near linear.
/// \tparam TriangleMesh a model of `MutableFaceGraph` with an internal vertex point map
/// \param mesh is replaced; when an exception is thrown it is as it was
/// \return the repairs that were made
/// \throw File_error if the file cannot be read, is malformed, or has no faces
/// \throw Input_error if the faces cannot be made a surface
template <class TriangleMesh>
Mesh_repair_report read_triangle_mesh(const std::string& filename, TriangleMesh& mesh)
{
  return internal::convert_to_triangle_mesh(internal::read_shape(filename, internal::mesh_content), filename, mesh);
}

/// reads a triangle mesh from a stream, which for binary formats must not translate line ends; see the function for
/// files.
/// \param ending of the format, such as `.off`
/// \param name the name of the stream in messages
template <class TriangleMesh>
Mesh_repair_report read_triangle_mesh(std::istream& in, const std::string& ending, const std::string& name,
                                      TriangleMesh& mesh)
{
  return internal::convert_to_triangle_mesh(internal::read_shape(in, ending, name, internal::mesh_content), name, mesh);
}

} // namespace CSCD

#endif // CSCD_IO_READ_TRIANGLE_MESH_H
