// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The fields whose level sets reconstruct a body from its skeleton.

#ifndef CSCD_MEASURE_RECONSTRUCTION_FIELDS_H
#define CSCD_MEASURE_RECONSTRUCTION_FIELDS_H

#include <CSCD/Measure/Part_tree.h>
#include <CSCD/Measure/Segment_bvh.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Box_tree.h>
#include <CSCD/internal/Disjoint_sets.h>

#include <CGAL/assertions.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
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
    const std::vector<std::array<Index, 2>> ends = segment_ends(skeleton);
    std::vector<Segment_bvh::Segment> segments;
    std::vector<double> radii;
    segments.reserve(ends.size());
    radii.reserve(ends.size());
    m_cones.reserve(ends.size());
    for (const auto& [u, v] : ends) {
      segments.push_back({skeleton.points[u], skeleton.points[v]});
      radii.push_back(std::max(skeleton.radii[u], skeleton.radii[v]));
      m_cones.emplace_back(skeleton.points[u], skeleton.points[v], skeleton.radii[u], skeleton.radii[v]);
    }
    m_tree = Segment_bvh(std::move(segments), radii);
  }

  /// The signed distance of `point`; O(log n) where the cones are well spread.
  double operator()(const Vector_3& point) const
  {
    return m_tree.least_value(point, [&](Index i) { return m_cones[i].signed_distance(point); });
  }

private:
  std::vector<Round_cone> m_cones;
  Segment_bvh m_tree{{}};
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
  explicit Convolution_field(const Indexed_skeleton& skeleton)
  {
    CGAL_precondition(skeleton.has_radii());
    Disjoint_sets places(skeleton.number_of_nodes()); // of nodes that edges of length zero join
    for (const std::array<Index, 2>& edge : skeleton.edges) {
      const double length = skeleton.length(edge);
      if (length > 0) {
        const Vector_3& source = skeleton.points[edge[0]];
        m_edges.push_back({source, (skeleton.points[edge[1]] - source) / length, length, skeleton.radii[edge[0]],
                           skeleton.radii[edge[1]]});
      } else {
        places.join(edge[0], edge[1]);
      }
    }
    add_balls(skeleton, places);
    if (m_edges.size() + m_balls.size() > max_number_summed) {
      build_clusters();
    }
  }

  /// F at `point`. Linear in the number of edges up to some thousands; of more, those that are far and near each other
  /// count as one place, which changes their part of F by some percent. The cost is O(log n) where they are well
  /// spread, and bounded in tangles, where edges count as one place that are not far.
  double convolution(const Vector_3& point) const
  {
    if (!m_clusters.empty()) {
      return sum_of_clusters(point);
    }
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
  double operator()(const Vector_3& point) const
  {
    constexpr double min_convolution = 1e-30; // far from everything; keeps the result finite
    return 1 / std::cbrt(std::max(convolution(point), min_convolution)) - 1;
  }

private:
  struct Edge
  {
    Vector_3 source, direction;
    double length, source_radius, target_radius;
  };
  struct Ball
  {
    Vector_3 center;
    double radius;
  };
  /// The edges and balls of a node of the tree, seen from afar.
  struct Cluster
  {
    Vector_3 center = Vector_3::Zero(); ///< of mass
    double radius = 0;                  ///< of a ball around the center that holds them
    double mass = 0;                    ///< F is about this over the fourth power of the distance
    double spread = 0;                  ///< mean square of the distances from the center, by mass
  };

  /// Above this, sums over all edges would take minutes. Skeletons of bodies have fewer.
  static constexpr std::size_t max_number_summed = 4096;

  static double value(const Ball& ball, const Vector_3& point)
  {
    const double ratio = ball.radius * ball.radius / std::max((point - ball.center).squaredNorm(), min_square);
    return ratio * ratio;
  }

  /// The mass of an object of the tree, an edge or a ball, at its middle.
  Cluster cluster_of(Index object) const
  {
    if (object >= m_edges.size()) {
      const Ball& ball = m_balls[object - m_edges.size()];
      return {ball.center, 0, ball.radius * ball.radius * ball.radius * ball.radius, 0};
    }
    const Edge& edge = m_edges[object];
    const double a = edge.source_radius;
    const double b = edge.target_radius;
    const double mean_cube = (a + b) * (a * a + b * b) / 4; // of the radius along the edge
    return {edge.source + edge.length / 2 * edge.direction, 0,
            boost::math::double_constants::two_div_pi * edge.length * mean_cube, edge.length * edge.length / 12};
  }

  void build_clusters()
  {
    std::vector<Part_tree<2>::Parts> ends(m_edges.size() + m_balls.size());
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const bool is_edge = i < m_edges.size();
      const Vector_3& source = is_edge ? m_edges[i].source : m_balls[i - m_edges.size()].center;
      ends[i][0].extend(source);
      ends[i][1].extend(is_edge ? Vector_3(source + m_edges[i].length * m_edges[i].direction) : source);
    }
    m_tree = Part_tree<2>(ends);
    m_clusters.resize(m_tree.nodes().size());
    for (Index n = Index(m_clusters.size()); n-- > 0;) {
      const auto& node = m_tree.nodes()[n];
      Cluster& cluster = m_clusters[n]; // until here, centers and squares from the origin were summed times masses
      for (Index i = node.begin; node.second_child == no_index && i < node.end; ++i) {
        const Cluster object = cluster_of(m_tree.objects()[i]);
        cluster.center += object.mass * object.center;
        cluster.mass += object.mass;
        cluster.spread += object.mass * (object.center.squaredNorm() + object.spread);
      }
      if (node.parent != no_index) {
        m_clusters[node.parent].center += cluster.center;
        m_clusters[node.parent].mass += cluster.mass;
        m_clusters[node.parent].spread += cluster.spread;
      }
      Bounding_box box = node.boxes[0];
      box.extend(node.boxes[1]);
      cluster.center = cluster.mass > 0 ? Vector_3(cluster.center / cluster.mass) : box.min();
      cluster.spread =
          cluster.mass > 0 ? std::max(cluster.spread / cluster.mass - cluster.center.squaredNorm(), 0.) : 0;
      cluster.radius = (cluster.center - box.min()).cwiseMax(box.max() - cluster.center).norm();
    }
  }

  /// What is near is divided first, and what is left when enough was divided counts as if it were far.
  double sum_of_clusters(const Vector_3& point) const
  {
    constexpr double far = 4;                        // in radii of the cluster: its part of F is right to some percent
    constexpr std::size_t max_number_divided = 1024; // of well spread edges there are some hundred; of tangles, no end
    const auto square_to = [&](Index n) { return (point - m_clusters[n].center).squaredNorm(); };
    double sum = 0;
    double sum_of_edges = 0;
    std::size_t number_divided = 0;
    std::vector<Index> to_do{0};
    while (!to_do.empty()) {
      const Index n = to_do.back();
      to_do.pop_back();
      const Cluster& cluster = m_clusters[n];
      const auto& node = m_tree.nodes()[n];
      const double square = square_to(n);
      const bool is_far = square > far * far * cluster.radius * cluster.radius && square > min_square;
      if (is_far || number_divided == max_number_divided) {
        const double limited = std::max({square, cluster.radius * cluster.radius, min_square});
        // The second term of the expansion around the center, averaged over all directions, is the spread's.
        sum += cluster.mass / (limited * limited) * (1 + 2 * cluster.spread / limited);
        continue;
      }
      ++number_divided;
      if (node.second_child != no_index) {
        const bool is_first_nearer = square_to(n + 1) < square_to(node.second_child);
        to_do.push_back(is_first_nearer ? node.second_child : n + 1);
        to_do.push_back(is_first_nearer ? n + 1 : node.second_child);
        continue;
      }
      for (Index i = node.begin; i < node.end; ++i) {
        const Index object = m_tree.objects()[i];
        if (object < m_edges.size()) {
          sum_of_edges += integral(m_edges[object], point);
        } else {
          sum += value(m_balls[object - m_edges.size()], point);
        }
      }
    }
    return sum + boost::math::double_constants::two_div_pi * sum_of_edges;
  }

  /// Adds a ball for each place without an edge of any length, of the greatest radius of its nodes.
  void add_balls(const Indexed_skeleton& skeleton, Disjoint_sets& places)
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
  static double integral(const Edge& edge, const Vector_3& point)
  {
    const Vector_3 to_point = point - edge.source;
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
  Part_tree<2> m_tree{{}};         ///< over edges and then balls, if there are many
  std::vector<Cluster> m_clusters; ///< of the nodes of the tree
};

} // namespace CSCD::internal

#endif // CSCD_MEASURE_RECONSTRUCTION_FIELDS_H
