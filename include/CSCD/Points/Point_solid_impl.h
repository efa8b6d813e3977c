// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Inside and outside of the body whose surface oriented points sample.

#ifndef CSCD_POINTS_POINT_SOLID_IMPL_H
#define CSCD_POINTS_POINT_SOLID_IMPL_H

#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Points/Point_complex.h>
#include <CSCD/Points/Point_solid.h>
#include <CSCD/Points/Surface_completion.h>
#include <CSCD/Points/build_point_complex.h>
#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Vector3.h>

#include <memory>
#include <optional>
#include <vector>

namespace CSCD {

/// A closed surface, and the queries for its body.
struct Point_solid::Body
{
  /// Closes the surface of `complex`.
  explicit Body(const Point_complex& complex) : closed(complex), queries(closed.surface()) {}

  internal::Closed_complex closed; ///< the surface
  internal::Solid_queries queries; ///< of the surface
};

CSCD_INLINE Point_solid::Point_solid(const Point_cloud& cloud)
    : m_complex(drop_fragments(internal::build_point_complex(cloud), m_vertex_of_point)),
      m_body(std::make_unique<const Body>(m_complex))
{
  internal::assign_to_nearest(cloud.points, m_vertex_of_point);
}

CSCD_INLINE Point_solid::~Point_solid() = default;

CSCD_INLINE bool Point_solid::is_inside(const Vector3& point) const
{
  return m_body->queries.is_inside(point);
}

CSCD_INLINE std::optional<Vector3> Point_solid::middle_behind(const Vector3& point) const
{
  return m_body->queries.middle_behind(point);
}

CSCD_INLINE void Point_solid::crossings(const Vector3& from, const Vector3& to, std::vector<double>& distances) const
{
  m_body->queries.crossings(from, to, distances);
}

} // namespace CSCD

#endif // CSCD_POINTS_POINT_SOLID_IMPL_H
