// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A point complex with a distance field, as what the points of its cut locus move on.

#ifndef CSCD_CUT_LOCUS_POINT_GROUND_H
#define CSCD_CUT_LOCUS_POINT_GROUND_H

#include <CSCD/Cut_locus/Point_cut_measures.h>
#include <CSCD/Cut_locus/Point_frames.h>
#include <CSCD/Point_cloud/Point_complex.h>
#include <CSCD/internal/Vector_3.h>

#include <cmath>

namespace CSCD::internal {

/// A point near the vertices of a point complex.
struct Cloud_point
{
  Index nearest = no_index; ///< the nearest vertex, sought along edges
  Vector_3 position;
};

/// The ground of `Cut_locus_smoothing` on a point complex: points move freely, and then back to the surface that the
/// tangent planes of the nearest vertex and its neighbors make.
class Point_ground
{
public:
  using Point = Cloud_point;

  /// \param measures is referred to and must outlive this object
  explicit Point_ground(const Point_cut_measures& measures)
      : m_measures(measures), m_complex(measures.frames().triangulation())
  {
  }

  double mean_edge_length() const { return m_complex.mean_edge_length(); }
  static const Vector_3& position(const Cloud_point& point) { return point.position; }

  Cloud_point moved(const Cloud_point& point, const Vector_3& displacement) const
  {
    Cloud_point result{point.nearest, point.position + displacement};
    result.nearest = nearest(result);
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
  /// Where what a vertex says has fallen to 1/e, in mean edge lengths: about the distance of the neighbors.
  static constexpr double reach = 1;

  /// Goes from the vertex nearest so far to nearer neighbors.
  Index nearest(const Cloud_point& point) const
  {
    Index vertex = point.nearest;
    double least = (m_complex.point(vertex) - point.position).squaredNorm();
    for (Index center = no_index; center != vertex;) {
      center = vertex;
      for (const Index h : m_complex.outgoing(center)) {
        const double distance = (m_complex.point(m_complex.target(h)) - point.position).squaredNorm();
        if (distance < least) {
          least = distance;
          vertex = m_complex.target(h);
        }
      }
    }
    return vertex;
  }

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

  const Point_cut_measures& m_measures;
  const Point_complex& m_complex;
};

} // namespace CSCD::internal

#endif // CSCD_CUT_LOCUS_POINT_GROUND_H
