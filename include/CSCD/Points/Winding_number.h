// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The generalized winding number of oriented points.

#ifndef CSCD_POINTS_WINDING_NUMBER_H
#define CSCD_POINTS_WINDING_NUMBER_H

#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Vector_3.h>

#include <CGAL/assertions.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CSCD::internal {

/// The generalized winding number of points that each stand for a piece of an oriented surface: nearly 1 inside of a
/// closed one, nearly 0 outside, and in between near holes (G. Barill, N. Dickson, R. Schmidt, D. Levin, A. Jacobson,
/// "Fast winding numbers for soups and clouds", 2018).
///
/// Points that are far away together count as one, by the first moments of their dipoles. The points are sorted along a
/// Hilbert curve by medians; the halves of that order, their halves, and so on, are compact, and so are a search tree:
/// only the moments are to be kept. CGAL's octree carries no data at its nodes. Const and thread safe; the same answer
/// always.
class Winding_number
{
public:
  /// \param points the places of the pieces
  /// \param area_vectors their outward normals, as long as their areas
  /// \pre as many of these as of points. O(n log n)
  Winding_number(const std::vector<Vector_3>& points, const std::vector<Vector_3>& area_vectors)
  {
    CGAL_precondition(points.size() == area_vectors.size());
    std::vector<Index> order(points.size());
    std::iota(order.begin(), order.end(), Index(0));
    sort_along_curve(points, order);
    for (const Index i : order) {
      m_dipoles.push_back({points[i], area_vectors[i]});
    }
    std::size_t number_of_leaves = 1;
    while (number_of_leaves * max_in_leaf < m_dipoles.size()) {
      number_of_leaves *= 2;
    }
    m_nodes.resize(2 * number_of_leaves);
    build(1, 0, m_dipoles.size());
  }

  /// The winding number at `query`, to about a hundredth; O(log n) in expectation. A piece at the very place of
  /// `query` does not count.
  double operator()(const Vector_3& query) const
  {
    std::array<Range, max_levels> stack;
    std::size_t size = 1;
    stack[0] = {1, 0, m_dipoles.size()};
    double sum = 0;
    while (size > 0) {
      const Range range = stack[--size];
      const Node& node = m_nodes[range.node];
      const Vector_3 offset = node.center - query;
      const double squared_distance = offset.squaredNorm();
      if (squared_distance > node.squared_reach) {
        sum += far_field(node, offset, squared_distance);
      } else if (is_leaf(range.node)) {
        sum += near_field(range, query);
      } else {
        const std::size_t middle = range.begin + (range.end - range.begin) / 2;
        stack[size++] = {2 * range.node + 1, middle, range.end};
        stack[size++] = {2 * range.node, range.begin, middle};
      }
    }
    return sum / (4 * boost::math::double_constants::pi);
  }

private:
  struct Dipole
  {
    Vector_3 point;
    Vector_3 area_vector;
  };

  /// Taylor's polynomial of degree two of the field of some dipoles, seen from r away from their center: the field of
  /// one with area vector a is a . r / |r|^3; the vector d from the center to its point is short compared with r.
  struct Node
  {
    Vector_3 center = Vector_3::Zero();                         // of the points, by area
    double squared_reach = 0;                                   // from farther away, the polynomial is good enough
    Vector_3 area_vector = Vector_3::Zero();                    // sum of a
    Eigen::Matrix3d first = Eigen::Matrix3d::Zero();            // sum of (a . d) I - 3 d a^T
    std::array<Eigen::Matrix3d, 3> second{first, first, first}; // half the sum of 15 d_k d a^T - 3 (2 (a . d) d_k +
                                                                // |d|^2 a_k) I
  };

  struct Range
  {
    std::size_t node; // the children of node i are 2 i and 2 i + 1, the root is 1
    std::size_t begin;
    std::size_t end;
  };

  static constexpr std::size_t max_in_leaf = 8;
  /// Enough for all points that can be indexed.
  static constexpr std::size_t max_levels = 64;
  /// How far a node must be to count as one, relative to its radius; that of Barill et al.
  static constexpr double reach = 2;

  bool is_leaf(std::size_t node) const { return 2 * node >= m_nodes.size(); }

  void build(std::size_t node, std::size_t begin, std::size_t end)
  {
    measure(m_nodes[node], begin, end);
    if (!is_leaf(node)) {
      const std::size_t middle = begin + (end - begin) / 2;
      build(2 * node, begin, middle);
      build(2 * node + 1, middle, end);
    }
  }

  void measure(Node& node, std::size_t begin, std::size_t end)
  {
    double area = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const double weight = m_dipoles[i].area_vector.norm();
      area += weight;
      node.center += weight * m_dipoles[i].point;
    }
    if (!(area > 0)) {
      return; // never farther away than its reach would matter: it is empty, or has no dipoles
    }
    node.center /= area;
    double squared_radius = 0;
    for (std::size_t i = begin; i < end; ++i) {
      squared_radius = std::max(squared_radius, (m_dipoles[i].point - node.center).squaredNorm());
      add_moments(m_dipoles[i], node);
    }
    node.squared_reach = reach * reach * squared_radius;
  }

  static void add_moments(const Dipole& dipole, Node& node)
  {
    const Vector_3 offset = dipole.point - node.center;
    const Vector_3& area_vector = dipole.area_vector;
    const Eigen::Matrix3d unit = Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d product = to_eigen(offset) * to_eigen(area_vector).transpose();
    const double trace = area_vector.dot(offset);
    node.area_vector += area_vector;
    node.first += trace * unit - 3 * product;
    for (int k = 0; k < 3; ++k) {
      node.second[std::size_t(k)] +=
          (15 * offset[k] * product - 3 * (2 * trace * offset[k] + offset.squaredNorm() * area_vector[k]) * unit) / 2;
    }
  }

  static double far_field(const Node& node, const Vector_3& offset, double squared_distance)
  {
    const Eigen::Vector3d eigen_offset = to_eigen(offset);
    double second = 0;
    for (int k = 0; k < 3; ++k) {
      second += offset[k] * eigen_offset.dot(node.second[std::size_t(k)] * eigen_offset);
    }
    const double first = eigen_offset.dot(node.first * eigen_offset) + second / squared_distance;
    return (node.area_vector.dot(offset) + first / squared_distance) / (squared_distance * std::sqrt(squared_distance));
  }

  double near_field(const Range& range, const Vector_3& query) const
  {
    double sum = 0;
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const Vector_3 offset = m_dipoles[i].point - query;
      const double squared_distance = offset.squaredNorm();
      if (squared_distance > 0) {
        sum += m_dipoles[i].area_vector.dot(offset) / (squared_distance * std::sqrt(squared_distance));
      }
    }
    return sum;
  }

  std::vector<Dipole> m_dipoles; // along the Hilbert curve
  std::vector<Node> m_nodes;     // the first is none
};

} // namespace CSCD::internal

#endif // CSCD_POINTS_WINDING_NUMBER_H
