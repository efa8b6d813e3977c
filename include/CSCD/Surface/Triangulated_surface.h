// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A closed triangulated surface in flat arrays, and the fans of its vertices.

#ifndef CSCD_SURFACE_TRIANGULATED_SURFACE_H
#define CSCD_SURFACE_TRIANGULATED_SURFACE_H

#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD {

/// A point where a curve crosses an edge of the surface.
/// The curve passes with the origin of the halfedge on its right and the target on its left, and goes on into the face
/// of the halfedge's twin.
struct Edge_crossing
{
  /// The halfedge that is crossed.
  Index halfedge;
  /// In (0, 1): from the origin of `halfedge` to its target.
  double position;
};

/// The vertices of a simple closed curve along edges, in order; the last one and the first are neighbors.
using Vertex_loop = std::vector<Index>;

/// A point of a surface.
struct Surface_point
{
  /// Its place.
  Vector3 point = Vector3::Zero();
  /// The face that it is on.
  Index face = no_index;
};

/// Where a ray first meets a surface.
struct Surface_hit : Surface_point
{
  double distance = 0; ///< from the origin of the ray
};

/// An oriented 2-manifold of triangles with halfedges, with or without borders, immutable. A halfedge of a border has
/// no twin. The outgoing halfedges of a vertex are stored in counterclockwise order; at a border, the first one of the
/// fan comes first.
class Triangulated_surface : public Triangle_halfedges
{
public:
  Triangulated_surface() = default;

  /// Compiles `triangles` to a closed surface; linear. Where they are not a closed oriented manifold, only
  /// `has_defect()` may be called.
  /// \param number_of_threads 0 for as many as TBB allows
  explicit Triangulated_surface(Indexed_triangles&& triangles, unsigned number_of_threads = 1)
      : Triangulated_surface(true, std::move(triangles),
                             Halfedge_pairing(triangles.faces, triangles.points.size(), number_of_threads))
  {
  }

  /// Compiles `triangles` to a surface with or without borders, after they have been checked; linear.
  /// \pre `pairing` is that of the faces of `triangles` and has no conflict, and the faces of each vertex form one fan
  Triangulated_surface(Indexed_triangles&& triangles, Halfedge_pairing&& pairing)
      : Triangulated_surface(false, std::move(triangles), std::move(pairing))
  {
    CGAL_precondition(!m_has_defect);
  }

  /// \name Combinatorics
  /// @{

  /// Whether the triangles are not a surface.
  bool has_defect() const { return m_has_defect; }

  /// The number of vertices.
  Index number_of_vertices() const { return Index(m_points.size()); }
  /// The number of halfedges.
  Index number_of_halfedges() const { return Index(m_origin.size()); }
  /// The number of faces.
  Index number_of_faces() const { return Index(m_origin.size() / 3); }

  /// The vertex where `halfedge` starts.
  Index origin(Index halfedge) const { return m_origin[halfedge]; }
  /// The vertex where `halfedge` ends.
  Index target(Index halfedge) const { return m_origin[next(halfedge)]; }
  /// The corner of the halfedge's face that the halfedge does not touch.
  Index opposite_vertex(Index halfedge) const { return m_origin[previous(halfedge)]; }
  /// The oppositely directed halfedge of the same edge, `no_index` on a border.
  Index twin(Index halfedge) const { return m_twin[halfedge]; }
  /// The halfedge that stands for the edge: the smaller one of the two.
  Index edge(Index halfedge) const { return std::min(halfedge, m_twin[halfedge]); }

  /// The next outgoing halfedge of the same origin, counterclockwise; `no_index` where a border comes before.
  Index next_around_origin(Index halfedge) const { return m_twin[previous(halfedge)]; }
  /// The next outgoing halfedge of the same origin, clockwise. \pre `halfedge` is not on a border
  Index previous_around_origin(Index halfedge) const { return next(m_twin[halfedge]); }

  /// The sides of `face`, one after the other.
  static std::array<Index, 3> face_halfedges(Index face) { return {3 * face, 3 * face + 1, 3 * face + 2}; }

  /// The outgoing halfedges of `vertex`, counterclockwise.
  CGAL::Iterator_range<const Index*> outgoing(Index vertex) const { return m_outgoing[vertex]; }
  /// The number of outgoing halfedges of `vertex`.
  Index degree(Index vertex) const { return m_outgoing.size(vertex); }

  /// The halfedge from `source` to `target`, or `no_index`; linear in the degree of `source`.
  Index find_halfedge(Index source, Index target) const
  {
    for (Index halfedge : outgoing(source)) {
      if (this->target(halfedge) == target) {
        return halfedge;
      }
    }
    return no_index;
  }
  /// @}

  /// \name Geometry
  /// @{

  /// All positions.
  const std::vector<Vector3>& points() const { return m_points; }
  /// The position of `vertex`.
  const Vector3& point(Index vertex) const { return m_points[vertex]; }
  /// The length of `halfedge`.
  double length(Index halfedge) const { return (point(target(halfedge)) - point(origin(halfedge))).norm(); }

  /// Area of the face; 0 for faces that bridge a border.
  float face_area(Index face) const { return m_face_area[face]; }
  /// A third of the area of the incident faces.
  float vertex_area(Index vertex) const { return m_vertex_area[vertex]; }
  /// Area-weighted mean of the normals of the incident faces, of unit length.
  Vector3 vertex_normal(Index vertex) const
  {
    const auto& [x, y, z] = m_vertex_normal[vertex];
    return {x, y, z};
  }
  /// Twice the area times the normal of the face, bridging or not.
  Vector3 face_vector(Index face) const
  {
    return internal::triangle_vector(point(origin(3 * face)), point(origin(3 * face + 1)), point(origin(3 * face + 2)));
  }
  /// The unit normal of `face`; zero where the area is not more than rounding leaves of collinear corners.
  /// \pre the coordinates are about 1
  Vector3 face_normal(Index face) const
  {
    constexpr double least = 1e-14; // twice the area
    const Vector3 vector = face_vector(face);
    return vector.norm() > least ? vector.normalized() : Vector3::Zero();
  }
  /// From this face on, faces only close borders.
  bool is_hole_filling(Index face) const { return face >= m_first_hole_filling_face; }
  /// From this face on, faces only close borders.
  Index first_hole_filling_face() const { return m_first_hole_filling_face; }
  /// The area of all faces that do not only close borders.
  double total_area() const { return m_total_area; }
  /// @}

private:
  Triangulated_surface(bool must_be_closed, Indexed_triangles&& triangles, Halfedge_pairing&& pairing)
      : m_points(std::move(triangles.points)), m_first_hole_filling_face(Index(triangles.first_hole_filling_face))
  {
    CGAL_precondition(pairing.number_of_halfedges() == 3 * triangles.faces.size());
    m_origin.reserve(3 * triangles.faces.size());
    for (const std::array<Index, 3>& face : triangles.faces) {
      m_origin.insert(m_origin.end(), face.begin(), face.end());
    }
    std::vector<std::array<Index, 3>>().swap(triangles.faces);
    m_has_defect = pairing.conflict() != no_index || pairing.pinched_vertex() != no_index ||
                   (must_be_closed && pairing.has_border());
    std::move(pairing).move_to(m_twin, m_outgoing);
    if (!m_has_defect) {
      measure_faces();
    }
  }

  void measure_faces()
  {
    m_face_area.resize(number_of_faces());
    m_vertex_area.assign(m_points.size(), 0.f);
    m_vertex_normal.assign(m_points.size(), {0.f, 0.f, 0.f});
    for (Index f = 0; f < number_of_faces(); ++f) {
      const Vector3 vector = face_vector(f);
      const double area = is_hole_filling(f) ? 0. : vector.norm() / 2;
      m_face_area[f] = float(area);
      m_total_area += area;
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        m_vertex_area[m_origin[h]] += float(area / 3);
        for (std::size_t i = 0; i < 3; ++i) {
          m_vertex_normal[m_origin[h]][i] += float(vector[i]);
        }
      }
    }
    for (auto& [x, y, z] : m_vertex_normal) {
      const float norm = std::sqrt(x * x + (y * y + z * z));
      if (norm > 0) {
        x /= norm;
        y /= norm;
        z /= norm;
      }
    }
  }

  std::vector<Vector3> m_points;
  std::vector<Index> m_origin;
  std::vector<Index> m_twin;
  internal::Compressed_rows<Index> m_outgoing; // of every vertex
  std::vector<float> m_face_area;
  std::vector<float> m_vertex_area;
  std::vector<std::array<float, 3>> m_vertex_normal;
  Index m_first_hole_filling_face = 0;
  double m_total_area = 0;
  bool m_has_defect = false;
};

/// One corner of a vertex `v`: the triangle between an outgoing edge and the next one counterclockwise.
struct Corner
{
  Index neighbor; ///< the target of the outgoing edge
  float length;   ///< of the outgoing edge
  float cosine;   ///< of the angle at `v`
  float sine;     ///< of the angle at `v`
};

/// The corners of all vertices of a surface. 16 bytes a corner: a front that visits `v` reads a single short stream,
/// instead of following halfedges to points.
class Vertex_fan_table
{
public:
  Vertex_fan_table() = default;

  /// Computes all corners of `surface`; linear.
  explicit Vertex_fan_table(const Triangulated_surface& surface)
  {
    const Index n = surface.number_of_vertices();
    m_begin.resize(std::size_t(n) + 1);
    m_corners.reserve(std::size_t(surface.number_of_halfedges()) + n);
    for (Index vertex = 0; vertex < n; ++vertex) {
      m_begin[vertex] = Index(m_corners.size());
      append_fan(surface, vertex);
    }
    m_begin[n] = Index(m_corners.size());
  }

  /// The corners of `vertex` in counterclockwise order; the first one stands again at the end, so that corner `i + 1`
  /// is the next one without wrapping around. The degree of `vertex` is therefore the size less one.
  CGAL::Iterator_range<const Corner*> fan(Index vertex) const
  {
    return {m_corners.data() + m_begin[vertex], m_corners.data() + m_begin[vertex + 1]};
  }
  /// The same without the repetition.
  CGAL::Iterator_range<const Corner*> neighbors(Index vertex) const
  {
    return {m_corners.data() + m_begin[vertex], m_corners.data() + m_begin[vertex + 1] - 1};
  }

  /// Asks the processor for the corners of `vertex`, which are read soon: walks from vertex to neighbor spend up to
  /// half of their time waiting for the first corner.
  void prefetch([[maybe_unused]] Index vertex) const
  {
#if defined(__GNUC__)
    constexpr std::size_t cache_line = 64;
    const char* corner = reinterpret_cast<const char*>(m_corners.data() + m_begin[vertex]);
    __builtin_prefetch(corner);
    __builtin_prefetch(corner + cache_line);
#endif
  }

private:
  void append_fan(const Triangulated_surface& surface, Index vertex)
  {
    const Vector3& center = surface.point(vertex);
    for (Index halfedge : surface.outgoing(vertex)) {
      const Index neighbor = surface.target(halfedge);
      const Vector3 incident_edge = surface.point(neighbor) - center;
      const Vector3 next_incident_edge = surface.point(surface.opposite_vertex(halfedge)) - center;
      const double length = incident_edge.norm();
      const double product = length * next_incident_edge.norm();
      // An incident edge of no length spans no angle.
      const double cosine = product > 0 ? incident_edge.dot(next_incident_edge) / product : 1.;
      const double sine = product > 0 ? incident_edge.cross(next_incident_edge).norm() / product : 0.;
      m_corners.push_back({neighbor, float(length), float(cosine), float(sine)});
    }
    m_corners.push_back(m_corners[m_begin[vertex]]);
  }

  std::vector<Corner> m_corners;
  std::vector<Index> m_begin;
};

} // namespace CSCD

#endif // CSCD_SURFACE_TRIANGULATED_SURFACE_H
