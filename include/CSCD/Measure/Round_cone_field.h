// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The union of the round cones of a skeleton as an implicit function.

#ifndef CSCD_MEASURE_ROUND_CONE_FIELD_H
#define CSCD_MEASURE_ROUND_CONE_FIELD_H

#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CSCD::internal {

/// The signed distance from the union of round cones, the convex hulls of the balls around the two ends of each edge:
/// negative inside, exact outside, and inside no greater in magnitude than the distance from the surface.
/// Unlike a convolution it neither shortens tips nor swells junctions. A node without edges is a ball.
class Round_cone_field
{
public:
  /// \pre `skeleton` has nodes, and radii, which are positive or zero
  explicit Round_cone_field(const Indexed_skeleton& skeleton)
  {
    CGAL_precondition(skeleton.has_radii());
    std::vector<char> has_edge(skeleton.number_of_nodes(), 0);
    for (const std::array<Index, 2>& edge : skeleton.edges) {
      add_cone(skeleton.points[edge[0]], skeleton.points[edge[1]], skeleton.radii[edge[0]], skeleton.radii[edge[1]]);
      has_edge[edge[0]] = has_edge[edge[1]] = 1;
    }
    for (Index v = 0; v < skeleton.number_of_nodes(); ++v) {
      if (!has_edge[v]) {
        add_cone(skeleton.points[v], skeleton.points[v], skeleton.radii[v], skeleton.radii[v]);
      }
    }
  }

  /// The signed distance of `point`; linear in the number of edges.
  double operator()(const Vector_3& point) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const Cone& cone : m_cones) {
      least = std::min(least, signed_distance(cone, point));
    }
    return least;
  }

private:
  /// A ball is a cone of length zero.
  struct Cone
  {
    Vector_3 source, direction;
    double length, source_radius, target_radius;
    double sine, cosine; // of the angle between the axis and the straight lines of the surface
  };

  void add_cone(const Vector_3& source, const Vector_3& target, double source_radius, double target_radius)
  {
    const double length = (target - source).norm();
    const double sine = length > 0 ? (source_radius - target_radius) / length : 1;
    if (std::abs(sine) < 1) {
      m_cones.push_back(
          {source, (target - source) / length, length, source_radius, target_radius, sine, std::sqrt(1 - sine * sine)});
    } else { // one ball holds the other
      const bool is_source = source_radius >= target_radius;
      const double radius = std::max(source_radius, target_radius);
      m_cones.push_back({is_source ? source : target, Vector_3::Zero(), 0, radius, radius, 0, 1});
    }
  }

  static double signed_distance(const Cone& cone, const Vector_3& point)
  {
    const Vector_3 to_point = point - cone.source;
    const double x = to_point.dot(cone.direction);
    const double y2 = std::max(to_point.squaredNorm() - x * x, 0.);
    const double y = std::sqrt(y2);
    // Coordinate along the straight line of the surface below the point, 0 where it leaves the first ball.
    const double along = x * cone.cosine - y * cone.sine;
    if (along <= 0) {
      return std::sqrt(x * x + y2) - cone.source_radius;
    }
    if (along >= cone.length * cone.cosine) {
      return std::sqrt((x - cone.length) * (x - cone.length) + y2) - cone.target_radius;
    }
    return x * cone.sine + y * cone.cosine - cone.source_radius;
  }

  std::vector<Cone> m_cones;
};

} // namespace CSCD::internal

#endif // CSCD_MEASURE_ROUND_CONE_FIELD_H
