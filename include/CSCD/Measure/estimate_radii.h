// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Radii for any skeleton, from the surface alone, so that skeletons of all makers can be compared.

#ifndef CSCD_MEASURE_ESTIMATE_RADII_H
#define CSCD_MEASURE_ESTIMATE_RADII_H

#include <CSCD/Measure/Part_tree.h>
#include <CSCD/Measure/Segment_bvh.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Vector_3.h>

#include <CGAL/assertions.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// Gives the nodes that `is_known` leaves out the radii of the harmonic function on the edges, weighted by the
/// reciprocals of their lengths, that has the known radii: along a branch it is linear in length.
class Radius_interpolation
{
public:
  Radius_interpolation(const Indexed_skeleton& skeleton, std::vector<char> is_known, double default_radius)
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
    const Eigen::VectorXd solution = solve(laplacian, right);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      radii[nodes[i]] = std::max(solution[Eigen::Index(i)], 0.);
    }
  }

  /// By factors, where those have about as many entries as the matrix, as trees and graphs of some cycles have; of
  /// others they would fill the memory, but then a bounded number of steps of an iteration leads as near as radii need.
  Eigen::VectorXd solve(const Eigen::SparseMatrix<double>& laplacian, const Eigen::VectorXd& right) const
  {
    constexpr std::size_t max_number_of_cycles = 1 << 11; // the factors have at most the square of it more entries
    if (m_skeleton.edges.size() <= m_skeleton.number_of_nodes() + max_number_of_cycles) {
      return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(laplacian).solve(right);
    }
    constexpr int max_number_of_steps = 300; // bounds the time where the iteration converges slowly
    constexpr double tolerance = 1e-9;       // of the residual
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> iteration(laplacian);
    iteration.setMaxIterations(max_number_of_steps);
    iteration.setTolerance(tolerance);
    return iteration.solveWithGuess(right, Eigen::VectorXd::Constant(right.size(), m_default_radius));
  }

  const Indexed_skeleton& m_skeleton;
  std::vector<char> m_is_known;
  double m_default_radius;
  std::vector<std::vector<Index>> m_neighbors;
};

/// Estimates the radius of each node from points of the surface, and nothing else.
/// Each point is assigned to the nearest point of the skeleton, at distance d and at parameter t of an edge; it counts
/// for the source of the edge with weight 1 - t and for the target with weight t. The radius of a node is the weighted
/// mean of the d's; nodes to which no point was assigned are interpolated from their neighbors.
/// O(p log e) for p points and e edges, where those are well spread; in tangles some points stand for all.
/// \param is_partial if not null, is set to whether some points stood for all
/// \pre there are points and nodes
inline std::vector<double> estimate_radii(const std::vector<Vector_3>& points, const Indexed_skeleton& skeleton,
                                          bool* is_partial = nullptr)
{
  CGAL_precondition(!points.empty() && skeleton.number_of_nodes() > 0);
  const std::vector<std::array<Index, 2>> ends = segment_ends(skeleton);
  const Segment_bvh tree = segment_tree(skeleton, ends);
  std::vector<double> sum(skeleton.number_of_nodes(), 0.);
  std::vector<double> weight(skeleton.number_of_nodes(), 0.);
  double total = 0;
  std::size_t number = 0;
  std::size_t work = 0;
  for (const Index i : in_random_order(points.size())) {
    if (work > Segment_bvh::enough_work) {
      break;
    }
    const Segment_point nearest = tree.nearest(points[i], 0, &work);
    ++number;
    const double t = nearest.parameter;
    const auto& [source, target] = ends[nearest.segment];
    sum[source] += (1 - t) * nearest.distance;
    weight[source] += 1 - t;
    sum[target] += t * nearest.distance;
    weight[target] += t;
    total += nearest.distance;
  }
  if (is_partial != nullptr) {
    *is_partial = number < points.size();
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
  Radius_interpolation(skeleton, is_known, total / double(number))(radii);
  return radii;
}

} // namespace CSCD::internal

#endif // CSCD_MEASURE_ESTIMATE_RADII_H
