// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A mesh as skeletons are measured against it: every face as it is, none coarsened or refined.

#ifndef CSCD_MEASURE_MEASURED_BODY_H
#define CSCD_MEASURE_MEASURED_BODY_H

#include <CSCD/Surface/Halfedge_pairing.h>
#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Surface/Surface_components.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Surface/bridge_borders.h>
#include <CSCD/Surface/canonical_order.h>
#include <CSCD/Surface/refine_large_faces.h>
#include <CSCD/Traits/collect_triangles.h>
#include <CSCD/Vector_3.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The surface of a mesh in coordinates in which the diagonal of its bounding box is 1, and the body that it bounds.
/// Borders are bridged, so that there is a body; components that look inwards are turned.
class Measured_body
{
public:
  /// Near linear. The mesh is not referred to later.
  /// \throw Input_error naming the element and the remedy if the mesh has no faces, faces that are no triangles, edges or
  ///        vertices where it is no oriented manifold, coordinates that are not finite, or no extent
  template <class TriangleMesh, class VertexPointMap>
  Measured_body(const TriangleMesh& mesh, const VertexPointMap& point_map)
  {
    auto collected = collect_triangles(mesh, point_map);
    Indexed_triangles& triangles = collected.triangles;
    Halfedge_pairing& pairing = collected.pairing;
    m_normalization = normalize_diagonal(triangles.points);
    const std::size_t number_of_points = triangles.points.size();
    m_number_of_borders = bridge_borders(triangles, pairing);
    if (pairing.has_border()) {
      pairing = Halfedge_pairing(triangles.faces, triangles.points.size());
    }
    Surface_components components(triangles, pairing);
    orient_outwards(triangles, pairing, components);
    split_two_face_components(triangles, pairing, components);
    m_number_of_components = components.number();
    // What has near numbers should be near in space, for the queries' sake.
    const std::vector<Index> order = canonical_order(triangles, pairing, components).vertices;
    m_points.reserve(number_of_points);
    for (const Index vertex : order) {
      if (vertex < number_of_points) {
        m_points.push_back(triangles.points[vertex]);
      }
    }
    renumber(triangles, order);
    m_surface = Triangulated_surface(std::move(triangles));
    CGAL_postcondition(!m_surface.defect());
    m_queries.emplace(m_surface);
  }
  Measured_body(const Measured_body&) = delete;
  Measured_body& operator=(const Measured_body&) = delete;
  ~Measured_body() = default;

  const Normalization& normalization() const { return m_normalization; }
  /// The vertices that have a face, neighbours near each other.
  const std::vector<Vector_3>& points() const { return m_points; }
  const Solid_queries& queries() const { return *m_queries; }

  std::size_t number_of_components() const { return m_number_of_components; }
  std::size_t number_of_borders() const { return m_number_of_borders; }
  /// The number of handles of the bridged surface, over all components.
  std::size_t genus() const
  {
    return genus_of_closed_surface(m_number_of_components, m_surface.number_of_vertices(), m_surface.number_of_faces());
  }

private:
  Normalization m_normalization;
  std::vector<Vector_3> m_points;
  std::size_t m_number_of_components = 0;
  std::size_t m_number_of_borders = 0;
  Triangulated_surface m_surface;
  std::optional<Solid_queries> m_queries;
};

} // namespace CSCD::internal

#endif // CSCD_MEASURE_MEASURED_BODY_H
