// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geodesic distances of all vertices from some of them, by CGAL's heat method.

#ifndef CSCD_GEODESIC_ESTIMATE_DISTANCES_H
#define CSCD_GEODESIC_ESTIMATE_DISTANCES_H

#include <CSCD/Traits/Open_triangulation.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace CSCD::internal {

/// The vertices that are connected with one of `sources`; linear.
inline std::vector<char> find_reached_vertices(const Open_triangulation& surface, const std::vector<Index>& sources)
{
  std::vector<std::vector<Index>> halfedges_of(surface.number_of_vertices());
  for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
    halfedges_of[surface.origin(h)].push_back(h);
  }
  std::vector<char> is_reached(surface.number_of_vertices(), 0);
  std::vector<Index> stack;
  const auto reach = [&](Index vertex) {
    if (!is_reached[vertex]) {
      is_reached[vertex] = 1;
      stack.push_back(vertex);
    }
  };
  for (Index source : sources) {
    reach(source);
  }
  while (!stack.empty()) {
    const Index vertex = stack.back();
    stack.pop_back();
    for (Index h : halfedges_of[vertex]) {
      reach(surface.target(h));
      reach(surface.origin(Open_triangulation::previous(h)));
    }
  }
  return is_reached;
}

/// Estimates the distance of every vertex from the nearest of `sources`, by the heat method on the intrinsic Delaunay
/// triangulation; infinite where no source is connected.
/// \throw Input_error if that fails, as it does on surfaces several hundred edges across
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
  const std::vector<char> is_reached = find_reached_vertices(surface, sources);
  std::vector<double> result(surface.number_of_vertices(), std::numeric_limits<double>::infinity());
  for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
    if (is_reached[vertex]) {
      result[vertex] = distance[Mesh::Vertex_index(vertex)];
      if (!(std::abs(result[vertex]) < failure)) {
        throw Input_error("the distance of vertex " + std::to_string(vertex) +
                          " cannot be estimated: give the distances as vertex_distance_map, or remesh the surface to "
                          "fewer or more even triangles");
      }
    }
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_GEODESIC_ESTIMATE_DISTANCES_H
