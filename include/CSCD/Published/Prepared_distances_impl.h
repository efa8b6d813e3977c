// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of Prepared_distances.h.

#ifndef CSCD_PUBLISHED_PREPARED_DISTANCES_IMPL_H
#define CSCD_PUBLISHED_PREPARED_DISTANCES_IMPL_H

#include <CSCD/Points/Point_solid.h>
#include <CSCD/Published/Heat_method.h>
#include <CSCD/Published/Intrinsic_triangulation.h>
#include <CSCD/Published/Prepared_distances.h>
#include <CSCD/Published/Tangent_frames.h>
#include <CSCD/Surface/Triangulated_surface.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CSCD::internal {

CSCD_INLINE Prepared_distances::Prepared_distances(Indexed_triangles&& triangles, Halfedge_pairing&& pairing,
                                                   double time_step_factor)
    : m_surface(std::make_shared<const Triangulated_surface>(std::move(triangles), std::move(pairing))),
      m_method(std::make_shared<const Heat_method>(make_intrinsic_delaunay(*m_surface), time_step_factor))
{
}

CSCD_INLINE Prepared_distances::Prepared_distances(const Point_cloud& cloud, double time_step_factor)
{
  const Point_complex complex = build_point_complex(cloud);
  m_method = std::make_shared<const Heat_method>(make_intrinsic_delaunay(Tufted_cover(complex)), time_step_factor);
}

CSCD_INLINE void Prepared_distances::estimate_each(const std::vector<std::vector<Distance_source>>& source_sets,
                                                   const Use& use) const
{
  std::vector<std::vector<Geodesic_source>> geodesic_sources;
  for (const std::vector<Distance_source>& sources : source_sets) {
    geodesic_sources.emplace_back();
    for (const Distance_source& source : sources) {
      geodesic_sources.back().push_back(source.vertex != no_index
                                            ? Geodesic_source::at_vertex(source.vertex)
                                            : Geodesic_source::in_face(*m_surface, source.face, source.coordinates));
    }
  }
  Heat_workspace()(*m_method, geodesic_sources,
                   [&use](std::size_t, const std::vector<double>& distances) { use(distances); });
}

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_PREPARED_DISTANCES_IMPL_H
