// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the points of a cut locus move while it is smoothed.

#ifndef CSCD_CUT_LOCUS_SMOOTHING_DOMAINS_H
#define CSCD_CUT_LOCUS_SMOOTHING_DOMAINS_H

#include <CSCD/Cut_locus/Cut_locus_indicators.h>
#include <CSCD/Cut_locus/Point_derivatives.h>
#include <CSCD/Cut_locus/Surface_walk.h>
#include <CSCD/Surface/Point_complex.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <cmath>
#include <complex>

namespace CSCD::internal {

/// The domain of `Cut_locus_smoothing` on a triangulation: points move straight on over its faces.
class Surface_smoothing_domain
{
public:
  using Point = Face_point;
  using Measures = Cut_locus_indicators<Triangulated_surface>;

  /// \param measures is referred to and must outlive this object
  explicit Surface_smoothing_domain(const Measures& measures) : m_measures(measures), m_walk(measures.frames()) {}

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
    const Triangulated_surface& surface = m_measures.frames().triangulation();
    Vector_3 sum = Vector_3::Zero();
    double number = 0;
    m_measures.frames().for_each_outgoing(vertex, [&](Index h) {
      const auto& corner = m_measures.frames().corner(h);
      if (corner.sine == 0) {
        return;
      }
      const std::complex<double> local = m_measures.face_direction(h) / corner.turn;
      const Vector_3 x = (surface.point(surface.target(h)) - surface.point(vertex)) / corner.length;
      const Index last = Triangulated_surface::previous(h);
      const Vector_3 incident_edge = surface.point(surface.origin(last)) - surface.point(vertex);
      const Vector_3 y = (incident_edge - incident_edge.dot(x) * x).normalized();
      sum += local.real() * x + local.imag() * y;
      number += 1;
    });
    return number > 0 ? Vector_3(sum / number) : Vector_3::Zero();
  }

  const Measures& m_measures;
  Surface_walk m_walk;
};

/// A point near the vertices of a point complex.
struct Cloud_point
{
  Index nearest = no_index; ///< the nearest vertex, sought along edges
  Vector_3 position;
};

/// The domain of `Cut_locus_smoothing` on a point complex: points move freely, and then back to the surface that the
/// tangent planes of the nearest vertex and its neighbors make.
class Point_smoothing_domain
{
public:
  using Point = Cloud_point;

  /// \param measures is referred to and must outlive this object
  explicit Point_smoothing_domain(const Point_cut_locus_indicators& measures)
      : m_measures(measures), m_complex(measures.frames().triangulation())
  {
  }

  double mean_edge_length() const { return m_complex.mean_edge_length(); }
  static const Vector_3& position(const Cloud_point& point) { return point.position; }

  Cloud_point moved(const Cloud_point& point, const Vector_3& displacement) const
  {
    Cloud_point result{point.nearest, point.position + displacement};
    result.nearest = descend_to_nearest(m_complex, result.position, point.nearest, [](Index, Index) { return true; });
    Vector_3 normal = Vector_3::Zero();
    double height = 0;
    for_each_weight(result, [&](Index vertex, double weight) {
      normal += weight * m_complex.normal(vertex);
      height += weight * m_complex.normal(vertex).dot(result.position - m_complex.point(vertex));
    });
    // Where normals cancel out, as on a thin sheet, there is no plane to go back to.
    if (normal.squaredNorm() > 0) {
      result.position -= height / normal.squaredNorm() * normal;
    }
    return result;
  }

  /// The mean gradient around `point`, in space; short where fronts meet.
  Vector_3 gradient(const Cloud_point& point) const
  {
    Vector_3 sum = Vector_3::Zero();
    for_each_weight(point, [&](Index vertex, double weight) {
      sum += weight * m_measures.frames().in_space(vertex, m_measures.gradient(vertex));
    });
    return sum;
  }

private:
  /// Where the weight of a vertex has fallen to 1/e, in mean edge lengths: about the distance of the neighbors.
  static constexpr double reach = 1;

  /// Calls `function(vertex, weight)` for the nearest vertex and its neighbors; the weights add up to 1.
  template <class Function>
  void for_each_weight(const Cloud_point& point, const Function& function) const
  {
    const double scale = reach * mean_edge_length();
    const auto weight_of = [&](Index vertex) {
      const double distance = (m_complex.point(vertex) - point.position).norm() - nearest_distance(point);
      return std::exp(-distance * distance / (scale * scale));
    };
    double sum = 1;
    for (const Index h : m_complex.outgoing(point.nearest)) {
      sum += weight_of(m_complex.target(h));
    }
    function(point.nearest, 1 / sum);
    for (const Index h : m_complex.outgoing(point.nearest)) {
      function(m_complex.target(h), weight_of(m_complex.target(h)) / sum);
    }
  }

  double nearest_distance(const Cloud_point& point) const
  {
    return (m_complex.point(point.nearest) - point.position).norm();
  }

  const Point_cut_locus_indicators& m_measures;
  const Point_complex& m_complex;
};

} // namespace CSCD::internal

#endif // CSCD_CUT_LOCUS_SMOOTHING_DOMAINS_H
