// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two copies of each triangle of a complex, glued so that every edge has two faces.

#ifndef CSCD_PUBLISHED_TUFTED_COVER_H
#define CSCD_PUBLISHED_TUFTED_COVER_H

#include <CSCD/Points/Point_complex.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector_3.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CSCD::internal {

/// The tufted cover of a point complex (N. Sharp, K. Crane, "A Laplacian for Nonmanifold Triangle Meshes", 2020): each
/// triangle has a front, face 2f, and a back, face 2f + 1, turned the other way. At an edge, what looks into the space
/// between two neighboring triangles is glued together; at an edge with one triangle, its front and its back. So no
/// edge is a border, whatever the complex is, and edges can be flipped until all are Delaunay, which gives the points a
/// Laplacian with a maximum principle.
///
/// It is an input of `Intrinsic_triangulation`. Its vertices are
/// those of the complex: the fronts and the backs around a vertex are two fans, or more. So walks around a vertex see
/// one of them only, and masses and stiffnesses of its elements are twice those of the complex.
class Tufted_cover : public Triangle_halfedges
{
public:
  /// Glues the copies; O(n log n).
  /// \param complex is referred to and must outlive this object
  explicit Tufted_cover(const Point_complex& complex) : m_complex(complex)
  {
    m_sides.reserve(6 * std::size_t(complex.number_of_faces()));
    for (Index f = 0; f < complex.number_of_faces(); ++f) {
      const auto [a, b, c] = complex.face_halfedges(f);
      m_sides.insert(m_sides.end(), {a, b, c, complex.twin(c), complex.twin(b), complex.twin(a)});
    }
    glue();
  }
  explicit Tufted_cover(Point_complex&&) = delete;

  const Point_complex& complex() const { return m_complex; }
  Index number_of_vertices() const { return m_complex.number_of_vertices(); }
  Index number_of_halfedges() const { return Index(m_sides.size()); }
  Index number_of_faces() const { return Index(m_sides.size() / 3); }

  Index origin(Index halfedge) const { return m_complex.origin(m_sides[halfedge]); }
  Index target(Index halfedge) const { return m_complex.target(m_sides[halfedge]); }
  Index twin(Index halfedge) const { return m_twins[halfedge]; }
  double length(Index halfedge) const { return m_complex.length(m_sides[halfedge]); }
  /// The halfedge of the complex along which `halfedge` runs.
  Index complex_halfedge(Index halfedge) const { return m_sides[halfedge]; }
  /// The same side of the other copy of the face.
  static Index other_copy(Index halfedge) { return 6 * (halfedge / 6) + 5 - halfedge % 6; }

private:
  /// A triangle at an edge.
  struct Wing
  {
    Index edge;
    double angle;   // around the edge, counterclockwise for who looks against its direction
    Index halfedge; // of the copy that runs with the edge: it looks to where the angle grows

    bool operator<(const Wing& other) const
    {
      return std::tie(edge, angle, halfedge) < std::tie(other.edge, other.angle, other.halfedge);
    }
  };

  void glue()
  {
    std::vector<Wing> wings;
    wings.reserve(m_sides.size() / 2);
    for (Index h = 0; h < number_of_halfedges(); ++h) {
      if (m_complex.edge(m_sides[h]) == m_sides[h]) {
        wings.push_back({m_sides[h], angle(h), h});
      }
    }
    std::sort(wings.begin(), wings.end());
    m_twins.resize(m_sides.size());
    for (auto begin = wings.cbegin(); begin != wings.cend();) {
      const auto end = std::find_if(begin, wings.cend(), [&](const Wing& wing) { return wing.edge != begin->edge; });
      for (auto wing = begin; wing != end; ++wing) {
        const Index next = other_copy((wing + 1 == end ? begin : wing + 1)->halfedge);
        m_twins[wing->halfedge] = next;
        m_twins[next] = wing->halfedge;
      }
      begin = end;
    }
  }

  /// The angle of the face of `halfedge` around it, from a direction that is the same for all faces of the edge.
  double angle(Index halfedge) const
  {
    const Vector_3& from = m_complex.point(origin(halfedge));
    const Vector_3 axis = m_complex.point(target(halfedge)) - from;
    const Vector_3 x = axis.unitOrthogonal();
    const Vector_3 to_apex = m_complex.point(origin(previous(halfedge))) - from;
    return std::atan2(axis.normalized().cross(x).dot(to_apex), x.dot(to_apex));
  }

  const Point_complex& m_complex;
  std::vector<Index> m_sides; // of every halfedge, the one of the complex
  std::vector<Index> m_twins; // of every halfedge
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_TUFTED_COVER_H
