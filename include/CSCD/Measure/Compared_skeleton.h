// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One of two skeletons that are compared, and the result of the comparison.

#ifndef CSCD_MEASURE_COMPARED_SKELETON_H
#define CSCD_MEASURE_COMPARED_SKELETON_H

#include <CSCD/Measure/Branch_graph.h>
#include <CSCD/Measure/Position_measurement.h>
#include <CSCD/Measure/Segment_bvh.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Vector_3.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD {

/// How far the points of one skeleton are from another one. Lengths are relative to the diagonal of the bounding box of
/// both skeletons.
struct Skeleton_distance
{
  double mean = 0;             ///< over the length of the edges
  double maximum = 0;          ///< over edges and nodes
  double fraction_matched = 0; ///< of the length: what is not farther away than the match distance
};

/// How many features of two skeletons are at the same place.
struct Match_count
{
  std::size_t number_in_first = 0;  ///< features of the first skeleton
  std::size_t number_in_second = 0; ///< features of the second skeleton
  std::size_t number_matched = 0;   ///< pairs of features at the same place; each is in one pair at most

  /// 1 if all are matched, 0 if none are; 1 if there are none.
  double fraction() const
  {
    const std::size_t sum = number_in_first + number_in_second;
    return sum > 0 ? 2 * double(number_matched) / double(sum) : 1;
  }
};

/// How alike two skeletons are.
struct Skeleton_comparison
{
  double diagonal = 0;                    ///< of the bounding box of both, in their unit
  double match_distance = 0;              ///< up to which features count as the same, relative to the diagonal
  Skeleton_distance from_first_to_second; ///< of the points of the first from the second
  Skeleton_distance from_second_to_first; ///< of the points of the second from the first
  Match_count tips;                       ///< nodes with one edge
  Match_count junctions;                  ///< nodes with three edges or more
  Match_count branches;                   ///< paths between nodes that have not two edges, and cycles
  /// Whether branches are joined in the same way, wherever they are: the skeletons of a body in two poses should agree.
  bool has_same_structure = false;

  /// The mean of both mean distances.
  double mean_distance() const { return (from_first_to_second.mean + from_second_to_first.mean) / 2; }
  /// The greater one of both maxima.
  double hausdorff_distance() const { return std::max(from_first_to_second.maximum, from_second_to_first.maximum); }
};

} // namespace CSCD

namespace CSCD::internal {

/// Matches the indices 0 to m - 1 with 0 to n - 1, each at most once, nearest pairs first.
/// O(m n) calls of `distance`, and O(p log p) for p pairs that are near enough.
/// \param distance of two indices
/// \param match_distance greatest distance of a pair
template <class Distance>
Match_count match_greedily(std::size_t m, std::size_t n, const Distance& distance, double match_distance)
{
  std::vector<std::tuple<double, Index, Index>> pairs;
  for (Index i = 0; i < m; ++i) {
    for (Index j = 0; j < n; ++j) {
      const double d = distance(i, j);
      if (d <= match_distance) {
        pairs.emplace_back(d, i, j);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  Match_count result{m, n, 0};
  std::vector<char> is_first_taken(m, 0);
  std::vector<char> is_second_taken(n, 0);
  for (const auto& [d, i, j] : pairs) {
    if (is_first_taken[i] == 0 && is_second_taken[j] == 0) {
      is_first_taken[i] = is_second_taken[j] = 1;
      ++result.number_matched;
    }
  }
  return result;
}

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

  Segment_bvh m_tree;
  std::vector<Vector_3> m_samples;
  Eigen::AlignedBox3d m_box;
};

/// A skeleton prepared for comparison, in coordinates in which lengths are relative to the common diagonal.
class Compared_skeleton
{
public:
  /// \pre the skeleton has nodes
  explicit Compared_skeleton(Indexed_skeleton skeleton)
      : m_skeleton(std::move(skeleton)), m_graph(m_skeleton), m_tree(segment_tree(m_skeleton, segment_ends(m_skeleton)))
  {
    for (const std::vector<Index>& branch : m_graph.branches) {
      m_curves.emplace_back(m_skeleton, branch);
    }
  }

  const Branch_graph& graph() const { return m_graph; }

  /// Measures how far this skeleton is from `other`.
  Skeleton_distance distance(const Compared_skeleton& other, double match_distance) const
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
  Match_count match_nodes(const Compared_skeleton& other, const std::function<bool(std::size_t)>& is_chosen,
                          double match_distance) const
  {
    const std::vector<Vector_3> mine = chosen_points(is_chosen);
    const std::vector<Vector_3> theirs = other.chosen_points(is_chosen);
    return match_greedily(
        mine.size(), theirs.size(), [&](Index i, Index j) { return (mine[i] - theirs[j]).norm(); }, match_distance);
  }

  /// Matches branches by the distances of their curves.
  Match_count match_branches(const Compared_skeleton& other, double match_distance) const
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
  Segment_bvh m_tree;
  std::vector<Branch_curve> m_curves;
};

} // namespace CSCD::internal

#endif // CSCD_MEASURE_COMPARED_SKELETON_H
