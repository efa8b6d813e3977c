// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Brings points back to a surface.

#ifndef CSCD_PUBLISHED_SURFACE_PROJECTION_H
#define CSCD_PUBLISHED_SURFACE_PROJECTION_H

#include <CSCD/Points/Point_complex.h>
#include <CSCD/Points/Point_neighborhoods.h>
#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <CGAL/assertions.h>

#include <cmath>

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
  /// Whether it has to be given the site of a point nearby.
  static constexpr bool needs_site = false;

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

/// Projects points to the moving least squares surface of a point complex, for `Variational_shortening`; the site is
/// the nearest vertex.
///
/// The surface is where the weighted mean of (n + n_i) . (x - p_i) vanishes, over the points p_i near x with their
/// normals n_i, n being the weighted mean of these. That is a plane fit with oriented normals, but for n beside n_i: a
/// chord of a circle is perpendicular to the sum of the normals at its ends, so a sphere is met exactly where a plane
/// fit alone is too small (the same sum serves S. Rusinkiewicz, "A symmetric objective function for ICP", 2019).
/// Only points of the sheet of the site count, which is sought over edges from the last one: so no point jumps to
/// another sheet. Const and thread safe; copies are cheap.
class Moving_least_squares_projection
{
public:
  /// Whether it has to be given the site of a point nearby.
  static constexpr bool needs_site = true;

  /// \param neighborhoods those of `complex`; both are referred to and must outlive this object
  Moving_least_squares_projection(const Point_complex& complex, const Point_neighborhoods& neighborhoods)
      : m_complex(&complex), m_neighborhoods(&neighborhoods)
  {
  }

  /// O(k) for k points around the site, and the steps to it. Where no point is near enough, as over a hole of the
  /// cloud, the nearest one is the projection.
  /// \param near a vertex from which the distance to `point` is followed downwards \pre it is one
  Projected_point operator()(const Vector_3& point, Index near) const
  {
    CGAL_precondition(near != no_index);
    Projected_point result{point, Vector_3::Zero(), nearest(point, near)};
    const double small_height = min_height * m_neighborhoods->spacing(result.site);
    for (int i = 0; i < max_iterations; ++i) {
      const double height = fit(result);
      result.point -= height * result.normal;
      if (std::abs(height) <= small_height) {
        break;
      }
    }
    return result;
  }

private:
  static constexpr int max_iterations = 4; // of a projection
  /// Less is not worth an iteration, relative to the spacing of the points.
  static constexpr double min_height = 1e-2;

  /// Goes on to the nearest neighbor that looks to the same side until none is nearer.
  Index nearest(const Vector_3& point, Index vertex) const
  {
    return descend_to_nearest(*m_complex, point, vertex, [this](Index from, Index to) {
      return m_complex->normal(to).dot(m_complex->normal(from)) > 0;
    });
  }

  /// Sets the normal of the surface at the point of `projected`. The weight at distance d from a point of radius r is
  /// (1 - d^2/r^2)^4, nearly exp(-d^2/h^2) for h = r/2, but smooth where it ends; r follows the local spacing.
  /// \return how high above the surface it is
  double fit(Projected_point& projected) const
  {
    double sum = 0;
    double height = 0; // of the point above the tangent planes
    Vector_3 offset = Vector_3::Zero();
    Vector_3 normal = Vector_3::Zero();
    for (const Index vertex : m_neighborhoods->neighbors(projected.site)) {
      const Vector_3 difference = projected.point - m_complex->point(vertex);
      const double radius = m_neighborhoods->radius(vertex);
      const double rest = 1 - difference.squaredNorm() / (radius * radius);
      if (rest > 0) {
        const double weight = rest * rest * rest * rest;
        const Vector_3& n = m_complex->normal(vertex);
        sum += weight;
        height += weight * n.dot(difference);
        offset += weight * difference;
        normal += weight * n;
      }
    }
    const double norm = normal.norm();
    if (!(norm > 0)) {
      projected.point = m_complex->point(projected.site);
      projected.normal = m_complex->normal(projected.site);
      return 0;
    }
    projected.normal = normal / norm;
    return (height + projected.normal.dot(offset)) / (norm + sum);
  }

  const Point_complex* m_complex;
  const Point_neighborhoods* m_neighborhoods;
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_SURFACE_PROJECTION_H
