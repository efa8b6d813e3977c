// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The fields whose level sets reconstruct a body from its skeleton.

#ifndef CSCD_SRC_MEASURE_RECONSTRUCTION_FIELDS_H
#define CSCD_SRC_MEASURE_RECONSTRUCTION_FIELDS_H

#include "Measure/skeleton_tools.h"
#include <CSCD/Skeleton.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/Box_tree.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/assertions.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CSCD::internal {

/// A round cone, the convex hull of the balls around two points; a ball if it has no length.
struct Round_cone
{
  Vector3 source, direction;
  double length, source_radius, target_radius;
  double sine, cosine; ///< of the angle between the axis and the straight lines of the surface

  Round_cone(const Vector3& from, const Vector3& to, double from_radius, double to_radius)
      : source(from), direction(Vector3::Zero()), length((to - from).norm()), source_radius(from_radius),
        target_radius(to_radius), sine(length > 0 ? (from_radius - to_radius) / length : 1), cosine(0)
  {
    if (std::abs(sine) < 1) {
      direction = (to - from) / length;
      cosine = std::sqrt(1 - sine * sine);
    } else { // one ball holds the other
      source = from_radius >= to_radius ? from : to;
      source_radius = target_radius = std::max(from_radius, to_radius);
      length = sine = 0;
      cosine = 1;
    }
  }

  /// Negative inside, exact outside, and inside no greater in magnitude than the distance from the surface.
  double signed_distance(const Vector3& point) const
  {
    const Vector3 to_point = point - source;
    const double x = to_point.dot(direction);
    const double y2 = std::max(to_point.squaredNorm() - x * x, 0.);
    const double y = std::sqrt(y2);
    // Coordinate along the straight line of the surface below the point, 0 where it leaves the first ball.
    const double along = x * cosine - y * sine;
    if (along <= 0) {
      return std::sqrt(x * x + y2) - source_radius;
    }
    if (along >= length * cosine) {
      return std::sqrt((x - length) * (x - length) + y2) - target_radius;
    }
    return x * sine + y * cosine - source_radius;
  }
};

/// The signed distance from the union of round cones, the convex hulls of the balls around the two ends of each edge:
/// negative inside, exact outside, and inside no greater in magnitude than the distance from the surface.
/// Unlike a convolution it neither shortens tips nor swells junctions. A node without edges is a ball.
class Round_cone_field
{
public:
  /// \pre `skeleton` has nodes, and radii, which are positive or zero
  explicit Round_cone_field(const Skeleton& skeleton)
  {
    CGAL_precondition(skeleton.has_radii());
    const std::vector<std::array<Index, 2>> ends = segment_ends(skeleton);
    std::vector<Bounding_box> boxes(ends.size());
    m_cones.reserve(ends.size());
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const auto& [u, v] = ends[i];
      m_cones.emplace_back(skeleton.points[u], skeleton.points[v], skeleton.radii[u], skeleton.radii[v]);
      for (const Index node : ends[i]) {
        boxes[i].extend(skeleton.points[node] - Vector3::Constant(skeleton.radii[node]));
        boxes[i].extend(skeleton.points[node] + Vector3::Constant(skeleton.radii[node]));
      }
    }
    m_tree = Box_tree(boxes);
  }

  /// The signed distance of `point`; O(log n) where the cones are well spread.
  double operator()(const Vector3& point) const
  {
    double least = std::numeric_limits<double>::infinity();
    std::size_t steps = 0;
    m_tree.minimize([&](const Bounding_box& box) { return bound(box, point); },
                    [&](Index i) {
                      ++steps;
                      const double distance = m_cones[i].signed_distance(point);
                      least = std::min(least, distance);
                      return distance;
                    });
    m_work.add(steps);
    return least;
  }

private:
  /// At most the signed distance of `point` from the content of `box`: inside it, the distance from its nearest side.
  static double bound(const Bounding_box& box, const Vector3& point)
  {
    constexpr double slack = 1e-12; // far above rounding
    const double square = box.squared_distance(point);
    const double distance =
        square > 0 ? std::sqrt(square) : -std::min((point - box.min()).minCoeff(), (box.max() - point).minCoeff());
    return distance - slack * std::abs(distance);
  }

  std::vector<Round_cone> m_cones;
  Box_tree m_tree;
  mutable Work_limit m_work;
};

/// The convolution of a skeleton with the inverse quartic kernel.
///
/// The surface is where F = 1 for F(p) = 2/pi times the integral of r(x)^3 / |p - x|^4 over all edges, with the radius
/// r varying linearly along each edge. An endless straight line of constant radius r thereby gives the cylinder of
/// radius r exactly, whatever r is, and the surface depends on the union of the edges only, not on how many nodes
/// divide them. The kernel is the limit of the Cauchy kernel for great widths; those that decay more slowly let distant
/// limbs swell each other. A node without edges is a ball of its radius. See A. Sherstyuk, Kernel functions in
/// convolution surfaces (The Visual Computer, 1999).
class Convolution_field
{
public:
  /// \pre `skeleton` has radii, which are positive or zero
  explicit Convolution_field(const Skeleton& skeleton)
  {
    CGAL_precondition(skeleton.has_radii());
    Disjoint_sets places(skeleton.number_of_nodes()); // of nodes that edges of length zero join
    for (const std::array<Index, 2>& edge : skeleton.edges) {
      const double length = skeleton.length(edge);
      if (length > 0) {
        const Vector3& source = skeleton.points[edge[0]];
        m_edges.push_back({source, (skeleton.points[edge[1]] - source) / length, length, skeleton.radii[edge[0]],
                           skeleton.radii[edge[1]]});
      } else {
        places.join(edge[0], edge[1]);
      }
    }
    add_balls(skeleton, places);
  }

  /// F at `point`. Linear in the number of edges.
  double convolution(const Vector3& point) const
  {
    double sum = 0;
    for (const Edge& edge : m_edges) {
      sum += integral(edge, point);
    }
    sum *= boost::math::double_constants::two_div_pi;
    for (const Ball& ball : m_balls) {
      sum += value(ball, point);
    }
    return sum;
  }

  /// A function that is negative inside the surface and grows evenly across it: F^(-1/3) - 1, which for an endless line
  /// is the distance from it over its radius, less 1.
  double operator()(const Vector3& point) const
  {
    constexpr double min_convolution = 1e-30; // far from everything; keeps the result finite
    return 1 / std::cbrt(std::max(convolution(point), min_convolution)) - 1;
  }

private:
  struct Edge
  {
    Vector3 source, direction;
    double length, source_radius, target_radius;
  };
  struct Ball
  {
    Vector3 center;
    double radius;
  };

  static double value(const Ball& ball, const Vector3& point)
  {
    const double ratio = ball.radius * ball.radius / std::max((point - ball.center).squaredNorm(), min_square);
    return ratio * ratio;
  }

  /// Adds a ball for each place without an edge of any length, of the greatest radius of its nodes.
  void add_balls(const Skeleton& skeleton, Disjoint_sets& places)
  {
    std::vector<char> has_length(skeleton.number_of_nodes(), 0);
    for (const std::array<Index, 2>& edge : skeleton.edges) {
      if (skeleton.length(edge) > 0) {
        has_length[places.find(edge[0])] = has_length[places.find(edge[1])] = 1;
      }
    }
    std::vector<double> radius(skeleton.number_of_nodes(), 0.);
    for (Index v = 0; v < skeleton.number_of_nodes(); ++v) {
      radius[places.find(v)] = std::max(radius[places.find(v)], skeleton.radii[v]);
    }
    for (Index v = 0; v < skeleton.number_of_nodes(); ++v) {
      if (places.find(v) == v && has_length[v] == 0) {
        m_balls.push_back({skeleton.points[v], radius[v]});
      }
    }
  }

  /// Squared distances below this, in squared units of the skeleton's coordinates, count as this: the kernel has a
  /// pole.
  static constexpr double min_square = 1e-14;

  /// The integral of r(x)^3 / |point - x|^4 along `edge`.
  static double integral(const Edge& edge, const Vector3& point)
  {
    const Vector3 to_point = point - edge.source;
    const double foot = to_point.dot(edge.direction);
    const double x0 = -foot;
    const double x1 = edge.length - foot;
    const double square = std::max(to_point.squaredNorm() - foot * foot, 0.); // of the distance from the line
    const double gap = std::max({0., x0, -x1});                               // from the foot to the edge
    constexpr double far = 3;                                                 // in lengths of the edge
    return square + gap * gap > far * far * edge.length * edge.length ? integral_from_afar(edge, x0, square)
                                                                      : exact_integral(edge, x0, x1, square);
  }

  /// By Gauss's formula of three points, whose relative error is below 1e-4 where it is used.
  static double integral_from_afar(const Edge& edge, double x0, double square)
  {
    constexpr double offset = 0.38729833462074169; // of the outer points from the middle, in lengths: sqrt(3/20)
    const double slope = (edge.target_radius - edge.source_radius) / edge.length;
    const auto integrand = [&](double t) {
      const double x = x0 + t * edge.length;
      const double radius = edge.source_radius + slope * t * edge.length;
      const double q = x * x + square;
      return radius * radius * radius / (q * q);
    };
    return edge.length / 18 * (5 * integrand(0.5 - offset) + 8 * integrand(0.5) + 5 * integrand(0.5 + offset));
  }

  /// In closed form. Let x run along the line, 0 at the foot of the point, let h be its distance from the line,
  /// q = x^2 + h^2 and r = a + b x. Then the primitive functions of x^k / q^2 are, for k = 0 to 3, (x/q + atan(x/h)/h)
  /// / (2 h^2), -1 / (2 q), (atan(x/h)/h - x/q) / 2 and (ln q + h^2/q) / 2.
  static double exact_integral(const Edge& edge, double x0, double x1, double square)
  {
    // Closer to the line than this, in the greater distance to an end, F is great and needs no digits.
    constexpr double relative_min_square = 1e-6;
    const double h2 = std::max({square, relative_min_square * std::max(x0 * x0, x1 * x1), min_square});
    const double h = std::sqrt(h2);
    const double q0 = x0 * x0 + h2;
    const double q1 = x1 * x1 + h2;
    const double b = (edge.target_radius - edge.source_radius) / edge.length;
    const double a = edge.source_radius - b * x0;
    const double angle = std::atan2(h * edge.length, h2 + x0 * x1) / h; // atan(x1/h) - atan(x0/h), divided by h
    const double ratio = x1 / q1 - x0 / q0;
    const double reciprocal = 1 / q1 - 1 / q0;
    double sum = a * a * a * (ratio + angle) / h2 - 3 * a * a * b * reciprocal + 3 * a * b * b * (angle - ratio);
    if (b != 0) {
      sum += b * b * b * (std::log(q1 / q0) + h2 * reciprocal);
    }
    return std::max(sum / 2, 0.);
  }

  std::vector<Edge> m_edges;
  std::vector<Ball> m_balls;
};

} // namespace CSCD::internal

#endif // CSCD_SRC_MEASURE_RECONSTRUCTION_FIELDS_H
