// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of Point_solid.h.

#ifndef CSCD_POINTS_POINT_SOLID_IMPL_H
#define CSCD_POINTS_POINT_SOLID_IMPL_H

#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Points/Point_solid.h>
#include <CSCD/Points/build_point_complex.h>

namespace CSCD {

CSCD_INLINE Point_solid::Point_solid(const Point_cloud& cloud)
    : m_complex(drop_fragments(internal::build_point_complex(cloud), m_vertex_of_point)), m_closed(m_complex),
      m_queries(m_closed.surface())
{
  internal::assign_to_nearest(cloud.points, m_vertex_of_point);
}

} // namespace CSCD

#endif // CSCD_POINTS_POINT_SOLID_IMPL_H
