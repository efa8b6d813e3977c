// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances from points to the skeleton, as radii of its nodes.

#include "Measure/Segment_tree.h"
#include <CSCD/Measure/estimate_radii.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <CGAL/assertions.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {
namespace {

/// Gives the nodes that `is_known` leaves out the radii of the harmonic function on the edges, weighted by the
/// reciprocals of their lengths, that has the known radii: along a branch it is linear in length.
class Radius_interpolation
{
public:
  Radius_interpolation(const Skeleton& skeleton, std::vector<char> is_known, double default_radius)
      : m_skeleton(skeleton), m_is_known(std::move(is_known)), m_default_radius(default_radius),
        m_neighbors(node_neighbors(skeleton))
  {
  }

  void operator()(std::vector<double>& radii)
  {
    settle_parts_without_known(radii);
    std::vector<Index> unknown(radii.size(), no_index);
    std::vector<Index> nodes;
    for (Index v = 0; v < radii.size(); ++v) {
      if (m_is_known[v] == 0) {
        unknown[v] = Index(nodes.size());
        nodes.push_back(v);
      }
    }
    constexpr std::size_t max_number_of_cycles = 1 << 11; // factors have at most the square of it more entries
    if (m_skeleton.edges.size() > m_skeleton.number_of_nodes() + max_number_of_cycles) {
      throw Input_error("the skeleton has more than 2048 cycles, too many to estimate its radii: simplify it first");
    }
    if (!nodes.empty()) {
      solve(nodes, unknown, radii);
    }
  }

private:
  /// A connected part of the skeleton in which nothing is known gets the default.
  void settle_parts_without_known(std::vector<double>& radii)
  {
    std::vector<char> is_reached = m_is_known;
    std::vector<Index> stack;
    for (Index v = 0; v < radii.size(); ++v) {
      if (m_is_known[v] != 0) {
        stack.push_back(v);
      }
    }
    while (!stack.empty()) {
      const Index v = stack.back();
      stack.pop_back();
      for (const Index w : m_neighbors[v]) {
        if (is_reached[w] == 0) {
          is_reached[w] = 1;
          stack.push_back(w);
        }
      }
    }
    for (std::size_t v = 0; v < radii.size(); ++v) {
      if (is_reached[v] == 0) {
        radii[v] = m_default_radius;
        m_is_known[v] = 1;
      }
    }
  }

  double weight(Index v, Index w) const
  {
    constexpr double min_length = 1e-9; // in the coordinates of the skeleton: equal nodes have equal radii
    return 1 / std::max((m_skeleton.points[v] - m_skeleton.points[w]).norm(), min_length);
  }

  void solve(const std::vector<Index>& nodes, const std::vector<Index>& unknown, std::vector<double>& radii) const
  {
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(Eigen::Index(nodes.size()));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (const Index w : m_neighbors[nodes[i]]) {
        if (w == nodes[i]) {
          continue;
        }
        const double factor = weight(nodes[i], w);
        entries.emplace_back(int(i), int(i), factor);
        if (unknown[w] != no_index) {
          entries.emplace_back(int(i), int(unknown[w]), -factor);
        } else {
          right[Eigen::Index(i)] += factor * radii[w];
        }
      }
    }
    Eigen::SparseMatrix<double> laplacian(Eigen::Index(nodes.size()), Eigen::Index(nodes.size()));
    laplacian.setFromTriplets(entries.begin(), entries.end());
    const Eigen::VectorXd solution = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(laplacian).solve(right);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      radii[nodes[i]] = std::max(solution[Eigen::Index(i)], 0.);
    }
  }

  const Skeleton& m_skeleton;
  std::vector<char> m_is_known;
  double m_default_radius;
  std::vector<std::vector<Index>> m_neighbors;
};

} // namespace

std::vector<double> estimate_radii(const std::vector<Vector_3>& points, const Skeleton& skeleton)
{
  CGAL_precondition(!points.empty() && skeleton.number_of_nodes() > 0);
  const std::vector<std::array<Index, 2>> ends = segment_ends(skeleton);
  const Segment_tree tree(skeleton, ends);
  std::vector<double> sum(skeleton.number_of_nodes(), 0.);
  std::vector<double> weight(skeleton.number_of_nodes(), 0.);
  double total = 0;
  Work_limit work;
  for (const Vector_3& point : points) {
    const Segment_point nearest = tree.nearest(point, work);
    const double t = nearest.parameter;
    const auto& [source, target] = ends[nearest.segment];
    sum[source] += (1 - t) * nearest.distance;
    weight[source] += 1 - t;
    sum[target] += t * nearest.distance;
    weight[target] += t;
    total += nearest.distance;
  }
  constexpr double min_weight = 1e-9; // in points
  std::vector<double> radii(skeleton.number_of_nodes(), 0.);
  std::vector<char> is_known(skeleton.number_of_nodes(), 0);
  for (std::size_t v = 0; v < radii.size(); ++v) {
    if (weight[v] > min_weight) {
      radii[v] = sum[v] / weight[v];
      is_known[v] = 1;
    }
  }
  Radius_interpolation(skeleton, is_known, total / double(points.size()))(radii);
  return radii;
}

} // namespace CSCD::internal
