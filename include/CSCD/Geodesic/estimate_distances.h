// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geodesic distances of all vertices from some of them, by CGAL's heat method.

#ifndef CSCD_GEODESIC_ESTIMATE_DISTANCES_H
#define CSCD_GEODESIC_ESTIMATE_DISTANCES_H

#include <CSCD/Traits/Open_triangulation.h>
#include <CSCD/internal/Distance_front.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The length of the shortest way along edges from the nearest of `sources` to every vertex; infinite where there is
/// none. O(n log n) for n vertices.
inline std::vector<double> distances_along_edges(const Open_triangulation& surface, const std::vector<Index>& sources)
{
  std::vector<std::vector<std::pair<Index, float>>> neighbors(surface.number_of_vertices());
  for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
    // Where there is a twin, it adds the other direction.
    const float length = float(surface.length(h));
    neighbors[surface.origin(h)].emplace_back(surface.target(h), length);
    if (surface.twin(h) == no_index) {
      neighbors[surface.target(h)].emplace_back(surface.origin(h), length);
    }
  }
  Distance_front front(surface.number_of_vertices());
  for (Index source : sources) {
    front.reach(source, 0);
  }
  std::vector<double> result(surface.number_of_vertices(), std::numeric_limits<double>::infinity());
  front.spread([&](Index vertex, float distance) {
    result[vertex] = distance;
    for (const auto& [neighbor, length] : neighbors[vertex]) {
      front.reach(neighbor, distance + length);
    }
  });
  return result;
}

/// Estimates the distance of every vertex from the nearest of `sources`, by the heat method on the intrinsic Delaunay
/// triangulation; infinite where no source is connected. Where CGAL's heat method gives up, as it does on surfaces
/// several hundred edges across and on some of few faces, these are distances along edges.
inline std::vector<double> estimate_distances(const Open_triangulation& surface, const std::vector<Index>& sources)
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  Mesh mesh;
  for (const Vector_3& p : surface.points()) {
    mesh.add_vertex({p.x(), p.y(), p.z()});
  }
  for (Index h = 0; h < surface.number_of_halfedges(); h += 3) {
    mesh.add_face(Mesh::Vertex_index(surface.origin(h)), Mesh::Vertex_index(surface.origin(h + 1)),
                  Mesh::Vertex_index(surface.origin(h + 2)));
  }
  auto distance = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance", 0).first;
  CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh, CGAL::Heat_method_3::Intrinsic_Delaunay> heat(mesh);
  for (Index source : sources) {
    heat.add_source(Mesh::Vertex_index(source));
  }
  heat.estimate_geodesic_distances(distance);

  // What CGAL gives where the heat underflows.
  constexpr double failure = 1e300;
  const std::vector<double> along_edges = distances_along_edges(surface, sources);
  std::vector<double> result(along_edges.size());
  for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
    const bool is_reached = std::isfinite(along_edges[vertex]);
    result[vertex] = is_reached ? distance[Mesh::Vertex_index(vertex)] : along_edges[vertex];
    if (is_reached && !(std::abs(result[vertex]) < failure)) {
      return along_edges;
    }
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_GEODESIC_ESTIMATE_DISTANCES_H
