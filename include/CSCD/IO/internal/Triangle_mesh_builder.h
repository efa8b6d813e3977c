// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From indexed triangles to a halfedge mesh.

#ifndef CSCD_IO_INTERNAL_TRIANGLE_MESH_BUILDER_H
#define CSCD_IO_INTERNAL_TRIANGLE_MESH_BUILDER_H

#include <CSCD/Surface/Halfedge_pairing.h>
#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Vector_3.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// Builds a mesh from triangles whose neighbours are known, in linear time; `CGAL::Euler::add_faces()` looks for them
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

  /// Links borders; a vertex on a border refers to the halfedge on it, as `Surface_mesh` wants it.
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

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_TRIANGLE_MESH_BUILDER_H
