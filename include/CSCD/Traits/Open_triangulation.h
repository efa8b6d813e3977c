// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The triangles of the input as they are, borders left open.

#ifndef CSCD_TRAITS_OPEN_TRIANGULATION_H
#define CSCD_TRAITS_OPEN_TRIANGULATION_H

#include <CSCD/Traits/Halfedge_pairing.h>
#include <CSCD/Traits/Indexed_triangles.h>
#include <CSCD/internal/Triangle_halfedges.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/assertions.h>

#include <utility>
#include <vector>

namespace CSCD::internal {

/// An oriented 2-manifold of triangles with halfedges, with or without borders, immutable, in the coordinates of the
/// input. A halfedge has no twin where the surface ends.
class Open_triangulation : public Triangle_halfedges
{
public:
  /// Takes over checked triangles; linear.
  /// \pre `pairing` is that of the faces of `triangles` and has no conflict, and the faces of each vertex form one fan
  Open_triangulation(Indexed_triangles&& triangles, Halfedge_pairing&& pairing) : m_points(std::move(triangles.points))
  {
    CGAL_precondition(pairing.conflict() == no_index);
    CGAL_precondition(pairing.number_of_halfedges() == 3 * triangles.faces.size());
    m_twin = std::move(pairing).twins();
    m_origin.reserve(3 * triangles.faces.size());
    for (const auto& face : triangles.faces) {
      m_origin.insert(m_origin.end(), face.begin(), face.end());
    }
  }

  Index number_of_vertices() const { return Index(m_points.size()); }
  Index number_of_halfedges() const { return Index(m_origin.size()); }
  Index number_of_faces() const { return Index(m_origin.size() / 3); }

  Index origin(Index halfedge) const { return m_origin[halfedge]; }
  Index target(Index halfedge) const { return m_origin[next(halfedge)]; }
  /// The oppositely directed halfedge of the same edge, `no_index` on a border.
  Index twin(Index halfedge) const { return m_twin[halfedge]; }

  const std::vector<Vector_3>& points() const { return m_points; }
  const Vector_3& point(Index vertex) const { return m_points[vertex]; }
  double length(Index halfedge) const { return (point(target(halfedge)) - point(origin(halfedge))).norm(); }

private:
  std::vector<Vector_3> m_points;
  std::vector<Index> m_origin;
  std::vector<Index> m_twin;
};

} // namespace CSCD::internal

#endif // CSCD_TRAITS_OPEN_TRIANGULATION_H
