// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geodesic distance from vertices, asked once.

#ifndef CSCD_GEODESIC_DISTANCES_FROM_VERTICES_H
#define CSCD_GEODESIC_DISTANCES_FROM_VERTICES_H

#include <CSCD/Geodesic/Geodesic_source.h>
#include <CSCD/Geodesic/Heat_field.h>
#include <CSCD/Geodesic/Heat_method.h>
#include <CSCD/internal/Vector_3.h>

#include <utility>
#include <vector>

namespace CSCD::internal {

/// Estimates the distance of every vertex from the nearest one of `sources` by the heat method, for callers that ask
/// once; infinite on components without a source. O(n^1.5), and usually nearly linear.
/// \tparam Triangulation Delaunay; see `Cotangent_elements`
/// \throw Input_error if the equations cannot be factored
template <class Triangulation>
std::vector<double> distances_from_vertices(const Triangulation& triangulation, const std::vector<Index>& sources)
{
  std::vector<Geodesic_source> geodesic_sources;
  geodesic_sources.reserve(sources.size());
  for (const Index source : sources) {
    geodesic_sources.push_back(Geodesic_source::at_vertex(source));
  }
  Heat_field field;
  Heat_method::Workspace workspace;
  const Heat_method method(triangulation);
  method(geodesic_sources, field, workspace);
  return std::move(field.distances);
}

} // namespace CSCD::internal

#endif // CSCD_GEODESIC_DISTANCES_FROM_VERTICES_H
