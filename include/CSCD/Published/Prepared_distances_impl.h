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

#include <algorithm>
#include <utility>

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
  Heat_workspace workspace;
  std::vector<std::vector<double>> distances;
  std::vector<std::vector<Geodesic_source>> batch;
  for (std::size_t begin = 0; begin < source_sets.size(); begin += Heat_workspace::batch_size) {
    batch.clear();
    for (std::size_t i = begin; i < std::min(begin + Heat_workspace::batch_size, source_sets.size()); ++i) {
      batch.emplace_back();
      for (const Distance_source& source : source_sets[i]) {
        batch.back().push_back(source.vertex != no_index
                                   ? Geodesic_source::at_vertex(source.vertex)
                                   : Geodesic_source::in_face(*m_surface, source.face, source.coordinates));
      }
    }
    workspace(*m_method, batch, distances);
    for (std::size_t i = 0; i < batch.size(); ++i) {
      use(distances[i]);
    }
  }
}

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_PREPARED_DISTANCES_IMPL_H
