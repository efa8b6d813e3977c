// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangle meshes from files, repaired where they need it.

#ifndef CSCD_IO_READ_TRIANGLE_MESH_H
#define CSCD_IO_READ_TRIANGLE_MESH_H

#include <CSCD/IO/Shape_file.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector_3.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CSCD {

/// The repairs of `read_triangle_mesh()` until the polygons of a file became an oriented manifold triangle mesh.
struct Mesh_repair_report
{
  std::size_t number_of_triangulated_polygons = 0; ///< faces of more than three vertices, cut into triangles
  std::size_t number_of_merged_points = 0;         ///< points that repeated the position of another one
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
  Halfedge_pairing pairing;
  Mesh_repair_report report;
};

/// Reads the polygons of a file.
/// \throw File_error if it cannot be read, is malformed or has no polygons
Shape_file read_polygons(const std::string& filename);
Shape_file read_polygons(std::istream& in, const std::string& ending, const std::string& name);

/// Reads the polygons or the points of a stream in the format that `ending` names.
/// \throw File_error if it cannot be read, is malformed or has no points, or if no format has this ending
Shape_file read_polygons_or_points(std::istream& in, const std::string& ending, const std::string& name);

/// Cuts polygons into triangles and repairs these.
/// \param filename for messages
/// \param number_of_threads 0 for as many as TBB allows; the result is the same for any number
/// \throw Input_error if they are too many or cannot be made a surface
Manifold_triangles make_manifold(Shape_file&& polygons, const std::string& filename, unsigned number_of_threads = 1);

/// The correspondence between the faces of a mesh and the polygons of its file.
struct Faces_of_file
{
  std::vector<Index> polygon_of_face; ///< for each face of the mesh
  /// For each polygon of the file, the largest of its triangles that is a face of the mesh; if none is, some face at
  /// one of its points; `no_index` if there is none either.
  std::vector<Index> face_of_polygon;
};

/// Finds them by the places of their corners, as repairs never move a point. O(n log n).
/// \param file the argument of `make_manifold()`
/// \param points, faces of the mesh
Faces_of_file match_faces(const Shape_file& file, const std::vector<Vector_3>& points,
                          const std::vector<std::array<Index, 3>>& faces);

/// Builds a mesh from triangles whose neighbors are known, in linear time; `CGAL::Euler::add_faces()` looks for them
/// once more, at several times the cost.
template <class TriangleMesh>
class Triangle_mesh_builder
{
public:
  Triangle_mesh_builder(const Indexed_triangles& triangles, const Halfedge_pairing& pairing, TriangleMesh& mesh)
      : m_triangles(triangles), m_pairing(pairing), m_mesh(mesh)
  {
  }

  void build()
  {
    CGAL::clear(m_mesh);
    reserve(m_mesh, static_cast<typename Graph_traits::vertices_size_type>(m_triangles.points.size()),
            static_cast<typename Graph_traits::edges_size_type>(number_of_edges()),
            static_cast<typename Graph_traits::faces_size_type>(m_triangles.faces.size()));
    add_vertices();
    add_edges();
    add_faces();
    link_borders();
  }

private:
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;

  Index origin(Index side) const { return m_triangles.faces[side / 3][side % 3]; }

  std::size_t number_of_edges() const
  {
    std::size_t number = 0;
    for (Index side = 0; side < m_pairing.number_of_halfedges(); ++side) {
      number += m_pairing.twin(side) > side ? 1 : 0;
    }
    return number;
  }

  void add_vertices()
  {
    auto point_map = get(CGAL::vertex_point, m_mesh);
    using Point = typename boost::property_traits<decltype(point_map)>::value_type;
    m_vertices.reserve(m_triangles.points.size());
    for (const Vector_3& p : m_triangles.points) {
      m_vertices.push_back(add_vertex(m_mesh));
      put(point_map, m_vertices.back(), Point(p.x(), p.y(), p.z()));
    }
  }

  void add_edges()
  {
    m_halfedges.resize(3 * m_triangles.faces.size());
    m_border_from.assign(m_triangles.points.size(), Graph_traits::null_halfedge());
    for (Index side = 0; side < m_pairing.number_of_halfedges(); ++side) {
      const Index other = m_pairing.twin(side);
      if (other < side) {
        continue; // this edge stands already
      }
      const halfedge_descriptor h = halfedge(add_edge(m_mesh), m_mesh);
      m_halfedges[side] = h;
      set_target(h, m_vertices[origin(Halfedge_pairing::next(side))], m_mesh);
      set_target(opposite(h, m_mesh), m_vertices[origin(side)], m_mesh);
      if (other != no_index) {
        m_halfedges[other] = opposite(h, m_mesh);
      } else {
        set_face(opposite(h, m_mesh), Graph_traits::null_face(), m_mesh);
        m_border_from[origin(Halfedge_pairing::next(side))] = opposite(h, m_mesh);
      }
    }
  }

  void add_faces()
  {
    for (Index side = 0; side < m_pairing.number_of_halfedges(); side += 3) {
      const face_descriptor f = add_face(m_mesh);
      set_halfedge(f, m_halfedges[side], m_mesh);
      for (Index s = side; s < side + 3; ++s) {
        set_face(m_halfedges[s], f, m_mesh);
        set_next(m_halfedges[s], m_halfedges[Halfedge_pairing::next(s)], m_mesh);
        set_halfedge(m_vertices[origin(Halfedge_pairing::next(s))], m_halfedges[s], m_mesh);
      }
    }
  }

  /// Links borders; a vertex on a border refers to the halfedge on it, as in every `Surface_mesh`.
  void link_borders()
  {
    for (Index side = 0; side < m_pairing.number_of_halfedges(); ++side) {
      if (m_pairing.twin(side) == no_index) {
        const Index target = origin(side);
        const halfedge_descriptor h = opposite(m_halfedges[side], m_mesh);
        set_next(h, m_border_from[target], m_mesh);
        set_halfedge(m_vertices[target], h, m_mesh);
      }
    }
  }

  const Indexed_triangles& m_triangles;
  const Halfedge_pairing& m_pairing;
  TriangleMesh& m_mesh;
  std::vector<vertex_descriptor> m_vertices;
  std::vector<halfedge_descriptor> m_halfedges;
  std::vector<halfedge_descriptor> m_border_from; ///< for each vertex, the border halfedge that leaves it
};

/// Makes a mesh of the polygons of a file.
template <class TriangleMesh>
Mesh_repair_report convert_to_triangle_mesh(Shape_file&& polygons, const std::string& filename, TriangleMesh& mesh,
                                            unsigned number_of_threads = 1)
{
  const Manifold_triangles manifold = make_manifold(std::move(polygons), filename, number_of_threads);
  Triangle_mesh_builder<TriangleMesh>(manifold.triangles, manifold.pairing, mesh).build();
  return manifold.report;
}

} // namespace internal

/// reads the triangle mesh that the file `filename` holds and repairs it. Its ending, in lower or upper case, names the
/// format: `.off`, `.obj`, `.ply`, `.stl`, `.vtp` and `.vtk` of VTK's PolyData, `.glb` and `.gltf`. With a further
/// ending `.gz` it is decompressed by zlib first. Polygons are cut into triangles. If these do not form an oriented
/// closed manifold, points of equal coordinates are merged. If they still do not form a manifold, degenerate and
/// duplicate faces and small flaps are removed, faces turned to agree with their neighbors, and points duplicated where
/// the surface is not a manifold. If it is closed, components that face inwards are turned, except cavities. Vertices
/// and faces are numbered as in the file, as far as nothing had to be repaired; vertices without a face are kept then.
/// Near linear. \tparam TriangleMesh a model of `MutableFaceGraph` with an internal vertex point map
/// \param mesh is replaced; when an exception is thrown it is as it was
/// \return the repairs that were made
/// \throw File_error if the file cannot be read, is malformed, or has no faces
/// \throw Input_error if the faces cannot be made a surface
template <class TriangleMesh>
Mesh_repair_report read_triangle_mesh(const std::string& filename, TriangleMesh& mesh)
{
  return internal::convert_to_triangle_mesh(internal::read_polygons(filename), filename, mesh);
}

/// reads a triangle mesh from a stream, which for binary formats must not translate line ends; see the function for
/// files.
/// \param ending of the format, such as `.off`
/// \param name the name of the stream in messages
template <class TriangleMesh>
Mesh_repair_report read_triangle_mesh(std::istream& in, const std::string& ending, const std::string& name,
                                      TriangleMesh& mesh)
{
  return internal::convert_to_triangle_mesh(internal::read_polygons(in, ending, name), name, mesh);
}

} // namespace CSCD

#endif // CSCD_IO_READ_TRIANGLE_MESH_H
