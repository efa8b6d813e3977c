// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One of two skeletons that are compared.

#ifndef CSCD_MEASURE_COMPARISON_SIDE_H
#define CSCD_MEASURE_COMPARISON_SIDE_H

#include <CSCD/Measure/Branch_graph.h>
#include <CSCD/Measure/Segment_tree.h>
#include <CSCD/Measure/Skeleton_comparison.h>
#include <CSCD/Measure/match_greedily.h>
#include <CSCD/Measure/sample_edges.h>
#include <CSCD/Measure/segment_ends.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/internal/Vector_3.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// A branch as a curve of its own.
class Branch_curve
{
public:
  /// \param path nodes of `skeleton`
  Branch_curve(const Indexed_skeleton& skeleton, const std::vector<Index>& path)
      : Branch_curve(sub_skeleton(skeleton, path))
  {
  }

  /// The greater one of the mean distances of each curve from the other; infinite where their bounding boxes are
  /// farther apart than `match_distance`, since then no point is nearer.
  double distance(const Branch_curve& other, double match_distance) const
  {
    if (m_box.exteriorDistance(other.m_box) > match_distance) {
      return std::numeric_limits<double>::infinity();
    }
    return std::max(mean_distance(other), other.mean_distance(*this));
  }

private:
  explicit Branch_curve(const Indexed_skeleton& curve) : m_tree(segment_tree(curve, curve.edges))
  {
    double length = 0;
    for (const auto& edge : curve.edges) {
      length += curve.length(edge);
    }
    constexpr double number_of_samples = 32; // for a mean that is compared with a bound
    if (length > 0) {
      for (const Edge_sample& sample : sample_edges(curve, length / number_of_samples)) {
        m_samples.push_back(sample.point);
      }
    } else {
      m_samples.push_back(curve.points.front());
    }
    for (const Vector_3& point : curve.points) {
      m_box.extend(point);
    }
  }

  static Indexed_skeleton sub_skeleton(const Indexed_skeleton& skeleton, const std::vector<Index>& path)
  {
    Indexed_skeleton curve;
    for (Index i = 0; i < path.size(); ++i) {
      curve.points.push_back(skeleton.points[path[i]]);
      if (i > 0) {
        curve.edges.push_back({i - 1, i});
      }
    }
    return curve;
  }

  double mean_distance(const Branch_curve& other) const
  {
    double sum = 0;
    for (const Vector_3& sample : m_samples) {
      sum += other.m_tree.nearest(sample).distance;
    }
    return sum / double(m_samples.size());
  }

  Segment_tree m_tree;
  std::vector<Vector_3> m_samples;
  Eigen::AlignedBox3d m_box;
};

/// A skeleton prepared for comparison, in coordinates in which lengths are relative to the common diagonal.
class Comparison_side
{
public:
  /// \pre the skeleton has nodes
  explicit Comparison_side(Indexed_skeleton skeleton)
      : m_skeleton(std::move(skeleton)), m_graph(m_skeleton), m_tree(segment_tree(m_skeleton, segment_ends(m_skeleton)))
  {
    for (const std::vector<Index>& branch : m_graph.branches) {
      m_curves.emplace_back(m_skeleton, branch);
    }
  }

  const Branch_graph& graph() const { return m_graph; }

  /// Measures how far this skeleton is from `other`.
  Skeleton_distance distance(const Comparison_side& other, double match_distance) const
  {
    constexpr double spacing = 1. / 1000; // of samples
    Skeleton_distance result;
    std::size_t number_matched = 0;
    const std::vector<Vector_3> samples = sample_by_length(spacing);
    for (const Vector_3& sample : samples) {
      const double d = other.m_tree.nearest(sample).distance;
      result.mean += d;
      result.maximum = std::max(result.maximum, d);
      number_matched += d <= match_distance ? 1 : 0;
    }
    result.mean /= double(samples.size());
    result.fraction_matched = double(number_matched) / double(samples.size());
    for (const Vector_3& point : m_skeleton.points) {
      result.maximum = std::max(result.maximum, other.m_tree.nearest(point).distance);
    }
    return result;
  }

  /// Matches nodes whose degrees fulfil `is_chosen` by their positions.
  Match_count match_nodes(const Comparison_side& other, const std::function<bool(std::size_t)>& is_chosen,
                          double match_distance) const
  {
    const std::vector<Vector_3> mine = chosen_points(is_chosen);
    const std::vector<Vector_3> theirs = other.chosen_points(is_chosen);
    return match_greedily(
        mine.size(), theirs.size(), [&](Index i, Index j) { return (mine[i] - theirs[j]).norm(); }, match_distance);
  }

  /// Matches branches by the distances of their curves.
  Match_count match_branches(const Comparison_side& other, double match_distance) const
  {
    return match_greedily(
        m_curves.size(), other.m_curves.size(),
        [&](Index i, Index j) { return m_curves[i].distance(other.m_curves[j], match_distance); }, match_distance);
  }

private:
  /// Samples of the edges; the nodes where there is no length.
  std::vector<Vector_3> sample_by_length(double spacing) const
  {
    std::vector<Vector_3> samples;
    for (const Edge_sample& sample : sample_edges(m_skeleton, spacing)) {
      samples.push_back(sample.point);
    }
    return samples.empty() ? m_skeleton.points : samples;
  }

  std::vector<Vector_3> chosen_points(const std::function<bool(std::size_t)>& is_chosen) const
  {
    std::vector<Vector_3> points;
    for (std::size_t i = 0; i < m_graph.nodes.size(); ++i) {
      if (is_chosen(m_graph.degrees[i])) {
        points.push_back(m_skeleton.points[m_graph.nodes[i]]);
      }
    }
    return points;
  }

  Indexed_skeleton m_skeleton;
  Branch_graph m_graph;
  Segment_tree m_tree;
  std::vector<Branch_curve> m_curves;
};

} // namespace CSCD::internal

#endif // CSCD_MEASURE_COMPARISON_SIDE_H
