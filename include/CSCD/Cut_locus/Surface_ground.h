// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A triangulation with a distance field, as what the points of its cut locus move on.

#ifndef CSCD_CUT_LOCUS_SURFACE_GROUND_H
#define CSCD_CUT_LOCUS_SURFACE_GROUND_H

#include <CSCD/Cut_locus/Cut_measures.h>
#include <CSCD/Cut_locus/Surface_walk.h>
#include <CSCD/Traits/Open_triangulation.h>
#include <CSCD/internal/Vector_3.h>

#include <complex>

namespace CSCD::internal {

/// The ground of `Cut_locus_smoothing` on a triangulation: points move straight on over its faces.
class Surface_ground
{
public:
  using Point = Face_point;
  using Measures = Cut_measures<Open_triangulation>;

  /// \param measures is referred to and must outlive this object
  explicit Surface_ground(const Measures& measures) : m_measures(measures), m_walk(measures.frames()) {}

  double mean_edge_length() const { return m_measures.frames().mean_edge_length(); }
  Vector_3 position(const Face_point& point) const { return m_walk.position(point); }
  Face_point moved(const Face_point& point, const Vector_3& displacement) const { return m_walk(point, displacement); }

  /// The mean unit gradient around `point`, in space; short where fronts meet.
  Vector_3 gradient(const Face_point& point) const
  {
    Vector_3 gradient = Vector_3::Zero();
    for (Index k = 0; k < 3; ++k) {
      if (point.weights[k] > 0) {
        const Index vertex = m_measures.frames().triangulation().origin(3 * point.face + k);
        gradient += point.weights[k] * vertex_gradient(vertex);
      }
    }
    return gradient;
  }

private:
  /// The mean unit gradient of the faces around `vertex`, in space; short where they disagree, as on the ridge.
  Vector_3 vertex_gradient(Index vertex) const
  {
    const Open_triangulation& surface = m_measures.frames().triangulation();
    Vector_3 sum = Vector_3::Zero();
    double number = 0;
    m_measures.frames().for_each_outgoing(vertex, [&](Index h) {
      const auto& corner = m_measures.frames().corner(h);
      if (corner.sine == 0) {
        return;
      }
      const std::complex<double> local = m_measures.face_direction(h) / corner.turn;
      const Vector_3 x = (surface.point(surface.target(h)) - surface.point(vertex)) / corner.length;
      const Index last = Open_triangulation::previous(h);
      const Vector_3 spoke = surface.point(surface.origin(last)) - surface.point(vertex);
      const Vector_3 y = (spoke - spoke.dot(x) * x).normalized();
      sum += local.real() * x + local.imag() * y;
      number += 1;
    });
    return number > 0 ? Vector_3(sum / number) : Vector_3::Zero();
  }

  const Measures& m_measures;
  Surface_walk m_walk;
};

} // namespace CSCD::internal

#endif // CSCD_CUT_LOCUS_SURFACE_GROUND_H
