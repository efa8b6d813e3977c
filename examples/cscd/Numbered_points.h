// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The points of the input as the library takes them, and the surfaces made of them as a mesh.

#ifndef CSCD_PROGRAM_NUMBERED_POINTS_H
#define CSCD_PROGRAM_NUMBERED_POINTS_H

#include "types.h"
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Vector_3.h>

#include <CGAL/property_map.h>

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace cscd {

/// The numbers of points, as a range, with the map that gives the points.
class Numbered_points
{
public:
  using Numbers = std::vector<std::size_t>;
  using Point_map = CGAL::Pointer_property_map<Point>::const_type;
  using Normal_map = CGAL::Pointer_property_map<Vector>::const_type;
  /// A skeleton whose nodes hold numbers of points.
  using Skeleton = CSCD::Skeleton_graph<Point, std::size_t>;

  /// \param points, normals are referred to; there may be no normals
  Numbered_points(const std::vector<Point>& points, const std::vector<Vector>& normals)
      : m_numbers(points.size()), m_points(points), m_normals(normals)
  {
    std::iota(m_numbers.begin(), m_numbers.end(), std::size_t(0));
  }

  /// Makes surface traits of the points, and of the normals if there are any.
  template <class Traits>
  Traits make_traits() const
  {
    const Point_map point_map = CGAL::make_property_map(m_points);
    return m_normals.empty() ? Traits(m_numbers, point_map)
                             : Traits(m_numbers, point_map, Normal_map(CGAL::make_property_map(m_normals)));
  }

  /// The surface of `traits`, which were made of these points; its first vertices are the points, the others were
  /// inserted. Triangles at which it would not be a surface are left out.
  template <class Traits>
  Mesh make_mesh(const Traits& traits) const
  {
    Mesh mesh;
    for (const Point& point : m_points) {
      mesh.add_vertex(point);
    }
    const auto& triangulation = traits.surface().triangulation();
    std::vector<Mesh::Vertex_index> mesh_vertex;
    for (CSCD::Index vertex = 0; vertex < triangulation.number_of_vertices(); ++vertex) {
      const auto numbers = traits.descriptors(vertex);
      mesh_vertex.push_back(numbers.begin() == numbers.end()
                                ? mesh.add_vertex(traits.to_input_point(triangulation.point(vertex)))
                                : Mesh::Vertex_index(static_cast<Mesh::size_type>(*numbers.begin())));
    }
    for (CSCD::Index face = 0; face < triangulation.number_of_faces(); ++face) {
      const auto [a, b, c] = triangulation.face_halfedges(face);
      mesh.add_face(mesh_vertex[triangulation.origin(a)], mesh_vertex[triangulation.origin(b)],
                    mesh_vertex[triangulation.origin(c)]);
    }
    return mesh;
  }

private:
  Numbers m_numbers;
  const std::vector<Point>& m_points;
  const std::vector<Vector>& m_normals;
};

} // namespace cscd

#endif // CSCD_PROGRAM_NUMBERED_POINTS_H
