// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A minimal FaceListGraph for the library: no vertex point map of its own, no order on descriptors.

#ifndef CSCD_TEST_ARCHETYPES_TRIANGLE_MESH_ARCHETYPE_H
#define CSCD_TEST_ARCHETYPES_TRIANGLE_MESH_ARCHETYPE_H

#include "Point_archetype.h"
#include "support/Shape.h"

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <functional>
#include <vector>

namespace CSCD::test {

/// A type that can be compared for equality, hashed and copied. `Kind` keeps vertices, halfedges and faces apart.
template <class Kind>
class Descriptor_archetype
{
public:
  Descriptor_archetype() = default;
  explicit Descriptor_archetype(std::size_t number) : m_number(number) {}

  std::size_t number() const { return m_number; }

  friend bool operator==(const Descriptor_archetype& a, const Descriptor_archetype& b)
  {
    return a.m_number == b.m_number;
  }
  friend bool operator!=(const Descriptor_archetype& a, const Descriptor_archetype& b) { return !(a == b); }

private:
  std::size_t m_number = 0;
};

/// The triangles of a shape; halfedge `h` runs along side `h % 3` of face `h / 3`. It has no opposites, which the
/// library does not require.
class Triangle_mesh_archetype
{
public:
  struct Vertex_kind;
  struct Halfedge_kind;
  struct Face_kind;
  using Vertex = Descriptor_archetype<Vertex_kind>;
  using Halfedge = Descriptor_archetype<Halfedge_kind>;
  using Face = Descriptor_archetype<Face_kind>;

  explicit Triangle_mesh_archetype(const Shape& shape) : m_shape(shape)
  {
    for (std::size_t v = 0; v < shape.points.size(); ++v) {
      m_vertices.emplace_back(v);
    }
    for (std::size_t f = 0; f < shape.triangles.size(); ++f) {
      m_faces.emplace_back(f);
    }
  }
  Triangle_mesh_archetype(const Triangle_mesh_archetype&) = delete;
  Triangle_mesh_archetype& operator=(const Triangle_mesh_archetype&) = delete;
  ~Triangle_mesh_archetype() = default;

  const Shape& shape() const { return m_shape; }

  friend CGAL::Iterator_range<std::vector<Vertex>::const_iterator> vertices(const Triangle_mesh_archetype& mesh)
  {
    return CGAL::make_range(mesh.m_vertices.begin(), mesh.m_vertices.end());
  }
  friend CGAL::Iterator_range<std::vector<Face>::const_iterator> faces(const Triangle_mesh_archetype& mesh)
  {
    return CGAL::make_range(mesh.m_faces.begin(), mesh.m_faces.end());
  }
  friend std::size_t num_vertices(const Triangle_mesh_archetype& mesh) { return mesh.m_vertices.size(); }
  friend std::size_t num_faces(const Triangle_mesh_archetype& mesh) { return mesh.m_faces.size(); }
  friend std::size_t num_halfedges(const Triangle_mesh_archetype& mesh) { return 3 * mesh.m_faces.size(); }

  friend Halfedge halfedge(const Face& f, const Triangle_mesh_archetype& /* mesh */)
  {
    return Halfedge(3 * f.number());
  }
  friend Halfedge next(const Halfedge& h, const Triangle_mesh_archetype& /* mesh */)
  {
    return Halfedge(h.number() % 3 == 2 ? h.number() - 2 : h.number() + 1);
  }
  friend Vertex source(const Halfedge& h, const Triangle_mesh_archetype& mesh)
  {
    return Vertex(mesh.m_shape.triangles[h.number() / 3][h.number() % 3]);
  }
  friend Vertex target(const Halfedge& h, const Triangle_mesh_archetype& mesh) { return source(next(h, mesh), mesh); }

private:
  Shape m_shape;
  std::vector<Vertex> m_vertices;
  std::vector<Face> m_faces;
};

/// A readable map from the vertices of a mesh to their points, which it makes when asked.
class Vertex_point_map_archetype
{
public:
  using key_type = Triangle_mesh_archetype::Vertex;
  using value_type = Point_archetype;
  using reference = Point_archetype;
  using category = boost::readable_property_map_tag;

  explicit Vertex_point_map_archetype(const Triangle_mesh_archetype& mesh) : m_mesh(&mesh) {}

  friend Point_archetype get(const Vertex_point_map_archetype& map, const key_type& v)
  {
    const Triple& p = map.m_mesh->shape().points[v.number()];
    return {p[0], p[1], p[2]};
  }

private:
  const Triangle_mesh_archetype* m_mesh;
};

} // namespace CSCD::test

namespace boost {

template <>
struct graph_traits<CSCD::test::Triangle_mesh_archetype>
{
  using vertex_descriptor = CSCD::test::Triangle_mesh_archetype::Vertex;
  using halfedge_descriptor = CSCD::test::Triangle_mesh_archetype::Halfedge;
  using face_descriptor = CSCD::test::Triangle_mesh_archetype::Face;
  using vertices_size_type = std::size_t;
  using halfedges_size_type = std::size_t;
  using faces_size_type = std::size_t;
};

} // namespace boost

namespace std {

template <class Kind>
struct hash<CSCD::test::Descriptor_archetype<Kind>>
{
  std::size_t operator()(const CSCD::test::Descriptor_archetype<Kind>& d) const { return d.number(); }
};

} // namespace std

#endif // CSCD_TEST_ARCHETYPES_TRIANGLE_MESH_ARCHETYPE_H
