// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Brings points back to a surface by going to the nearest point.

#ifndef CSCD_SEPARATOR_CLOSEST_POINT_PROJECTION_H
#define CSCD_SEPARATOR_CLOSEST_POINT_PROJECTION_H

#include <CSCD/Traits/Solid_queries.h>
#include <CSCD/Traits/Triangulated_surface.h>
#include <CSCD/internal/Vector_3.h>

namespace CSCD::internal {

/// A point of a surface as `Variational_shortening` needs it.
struct Projected_point
{
  Vector_3 point = Vector_3::Zero();
  Vector_3 normal = Vector_3::Zero(); ///< of unit length; zero where there is none
  Index site = no_index;              ///< where the search for a nearby point may begin: here the face
};

/// Projects points to the nearest point of a triangulated surface, with the normal of its face: the nearest one of all,
/// or the one that is nearest around a face. The latter does not jump to another part of the surface, and is faster.
/// Const and thread safe.
class Closest_point_projection
{
public:
  /// \param queries those of `surface`; both are referred to and must outlive this object
  Closest_point_projection(const Triangulated_surface& surface, const Solid_queries& queries)
      : m_surface(&surface), m_queries(&queries)
  {
  }

  /// O(log n), or O(k) for k faces on the way.
  /// \param near the face of a point nearby, from which the distance is followed downwards; `no_index` for none
  Projected_point operator()(const Vector_3& point, Index near) const
  {
    const Surface_point nearest = near == no_index ? m_queries->closest_point(point) : descend(point, near);
    const Vector_3 vector = m_surface->face_vector(nearest.face);
    const double norm = vector.norm();
    return {nearest.point, norm > 0 ? Vector_3(vector / norm) : Vector_3(Vector_3::Zero()), nearest.face};
  }

private:
  /// Goes on to the nearest face around the last one until none is nearer.
  Surface_point descend(const Vector_3& point, Index face) const
  {
    Surface_point nearest{m_queries->closest_point_of_face(face, point), face};
    double least = (nearest.point - point).squaredNorm();
    for (Index center = no_index; center != nearest.face;) {
      center = nearest.face;
      for (Index corner = 3 * center; corner < 3 * center + 3; ++corner) {
        for (const Index h : m_surface->outgoing(m_surface->origin(corner))) {
          const Vector_3 candidate = m_queries->closest_point_of_face(Triangulated_surface::face(h), point);
          const double distance = (candidate - point).squaredNorm();
          if (distance < least) {
            least = distance;
            nearest = {candidate, Triangulated_surface::face(h)};
          }
        }
      }
    }
    return nearest;
  }

  const Triangulated_surface* m_surface;
  const Solid_queries* m_queries;
};

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_CLOSEST_POINT_PROJECTION_H
