// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of Point_solid.h.

#ifndef CSCD_POINTS_POINT_SOLID_IMPL_H
#define CSCD_POINTS_POINT_SOLID_IMPL_H

#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Points/Point_complex.h>
#include <CSCD/Points/Point_solid.h>
#include <CSCD/Points/Surface_completion.h>
#include <CSCD/Points/build_point_complex.h>

#include <utility>

namespace CSCD {

CSCD_INLINE internal::Closed_complex::Closed_complex(const Point_complex& complex)
{
  Reconstructed_surface completed;
  completed.triangles.points = complex.points();
  for (Index face = 0; face < complex.number_of_faces(); ++face) {
    completed.triangles.faces.push_back(complex.face_vertices(face));
  }
  Surface_completion complete(completed, Normalization());
  complete.prepare();
  complete();
  surface = Triangulated_surface(std::move(completed.triangles));
  vertex_in_complex = std::move(completed.point_of_vertex);
}

CSCD_INLINE Point_solid::Point_solid(const Point_cloud& cloud)
    : m_complex(drop_fragments(internal::build_point_complex(cloud), m_vertex_of_point)), m_closed(m_complex),
      m_queries(m_closed.surface)
{
  internal::assign_to_nearest(cloud.points, m_vertex_of_point);
}

} // namespace CSCD

#endif // CSCD_POINTS_POINT_SOLID_IMPL_H
