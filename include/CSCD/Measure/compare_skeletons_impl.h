// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of compare_skeletons.h.

#ifndef CSCD_MEASURE_COMPARE_SKELETONS_IMPL_H
#define CSCD_MEASURE_COMPARE_SKELETONS_IMPL_H

#include <CSCD/Measure/Position_measurement.h>
#include <CSCD/Measure/Segment_bvh.h>
#include <CSCD/Measure/compare_skeletons.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Skeleton/split_into_branches.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/Box_tree.h>
#include <CSCD/internal/config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The graph of which the vertices are the nodes of a skeleton that do not have two edges, and the edges the branches
/// between them. Closed cycles without such a node are set apart.
struct Branch_graph
{
  /// Linear.
  explicit Branch_graph(const Indexed_skeleton& skeleton)
  {
    const std::vector<std::vector<Index>> neighbors = node_neighbors(skeleton);
    std::vector<Index> number(skeleton.number_of_nodes(), no_index);
    for (Index v = 0; v < number.size(); ++v) {
      if (neighbors[v].size() != 2) {
        number[v] = Index(nodes.size());
        nodes.push_back(v);
        degrees.push_back(neighbors[v].size());
      }
    }
    for (std::vector<Index>& path : split_into_branches(neighbors)) {
      if (path.size() == 1) {
        continue; // an isolated node
      }
      const Index source = number[path.front()];
      const Index target = number[path.back()];
      branches.push_back(std::move(path));
      if (source == no_index) {
        ++number_of_closed_cycles;
      } else {
        edges.push_back({source, target});
      }
    }
  }

  std::vector<Index> nodes;                 ///< of the skeleton: isolated ones, tips and junctions
  std::vector<std::size_t> degrees;         ///< of `nodes`
  std::vector<std::array<Index, 2>> edges;  ///< between `nodes`, as positions there
  std::vector<std::vector<Index>> branches; ///< the nodes of the skeleton along each branch, closed cycles included
  std::size_t number_of_closed_cycles = 0;
};

/// Labels the vertices of several branch graphs by their surroundings, farther with every refinement: the color
/// refinement of B. Weisfeiler and A. Leman.
class Branch_labels
{
public:
  explicit Branch_labels(const Branch_graph& graph) : m_neighbors(graph.nodes.size())
  {
    for (const auto& [u, v] : graph.edges) {
      m_neighbors[u].push_back(v);
      m_neighbors[v].push_back(u);
    }
    m_labels.assign(graph.degrees.begin(), graph.degrees.end());
  }

  /// What a label stands for, and the label; shared by the graphs that are compared.
  using Dictionary = std::map<std::vector<std::size_t>, std::size_t>;

  /// Replaces the label of each vertex by one for its label and those of its neighbors.
  void refine(Dictionary& dictionary)
  {
    std::vector<std::size_t> refined;
    refined.reserve(m_labels.size());
    for (std::size_t v = 0; v < m_labels.size(); ++v) {
      std::vector<std::size_t> surroundings;
      for (const Index w : m_neighbors[v]) {
        surroundings.push_back(m_labels[w]);
      }
      std::sort(surroundings.begin(), surroundings.end());
      surroundings.push_back(m_labels[v]);
      refined.push_back(dictionary.try_emplace(std::move(surroundings), dictionary.size()).first->second);
    }
    m_labels = std::move(refined);
  }

  std::vector<std::size_t> sorted() const
  {
    std::vector<std::size_t> result = m_labels;
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  std::vector<std::vector<Index>> m_neighbors;
  std::vector<std::size_t> m_labels;
};

/// Whether the branches of two skeletons are joined in the same way, by color refinement: that decides it for forests,
/// and for graphs with cycles unless they are of a regularity that skeletons do not have. O(r n log n) for n nodes that
/// do not have two edges and r refinements, no more than the farthest of them are branches apart.
inline bool have_same_structure(const Branch_graph& a, const Branch_graph& b)
{
  if (a.nodes.size() != b.nodes.size() || a.edges.size() != b.edges.size() ||
      a.number_of_closed_cycles != b.number_of_closed_cycles) {
    return false;
  }
  Branch_labels labels_of_a(a);
  Branch_labels labels_of_b(b);
  std::size_t number_of_labels = 0;
  while (true) {
    if (labels_of_a.sorted() != labels_of_b.sorted()) {
      return false;
    }
    Branch_labels::Dictionary dictionary;
    labels_of_a.refine(dictionary);
    labels_of_b.refine(dictionary);
    if (dictionary.size() == number_of_labels) {
      return labels_of_a.sorted() == labels_of_b.sorted();
    }
    number_of_labels = dictionary.size();
  }
}

/// Matches the indices 0 to m - 1 with 0 to n - 1, each at most once, nearest pairs first.
/// O(m n) calls of `distance`, and O(p log p) for p pairs that are near enough.
/// \param distance of two indices
/// \param match_distance maximum distance of a pair
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
    if (m_box.distance(other.m_box) > match_distance) {
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
  Bounding_box m_box;
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

/// \throw Input_error if `skeleton`, called `name`, has no nodes or one that is not finite
inline void check_skeleton(const Indexed_skeleton& skeleton, const std::string& name)
{
  if (skeleton.number_of_nodes() == 0) {
    throw Input_error("the " + name + " skeleton has no nodes: there is nothing to compare");
  }
  for (std::size_t v = 0; v < skeleton.number_of_nodes(); ++v) {
    if (!skeleton.points[v].allFinite()) {
      throw Input_error("node " + std::to_string(v) + " of the " + name +
                        " skeleton has a coordinate that is not finite: correct it or remove the node");
    }
  }
}

/// The coordinates in which the bounding box of both skeletons has a diagonal of 1; any, where it is a point.
/// \throw Input_error if the coordinates are too large
inline Normalization common_normalization(const Indexed_skeleton& a, const Indexed_skeleton& b)
{
  Bounding_box box;
  for (const Indexed_skeleton* skeleton : {&a, &b}) {
    for (const Vector_3& point : skeleton->points) {
      box.extend(point);
    }
  }
  const Vector_3 extent = box.max() - box.min();
  const double diagonal = std::hypot(extent.x(), extent.y(), extent.z());
  if (!std::isfinite(diagonal)) {
    throw Input_error("the skeletons are too large to be measured: scale the coordinates");
  }
  return {box.min(), diagonal > 0 ? diagonal : 1};
}

CSCD_INLINE Skeleton_comparison compare_skeletons(Indexed_skeleton&& first, Indexed_skeleton&& second,
                                                  double match_distance)
{
  if (!(match_distance >= 0)) {
    throw Input_error("the match distance is negative or no number: 0.02 will do in most cases");
  }
  check_skeleton(first, "first");
  check_skeleton(second, "second");
  const Normalization normalization = common_normalization(first, second);
  for (Indexed_skeleton* skeleton : {&first, &second}) {
    for (Vector_3& point : skeleton->points) {
      point = normalization.from_input(point);
    }
  }
  const Compared_skeleton a(std::move(first));
  const Compared_skeleton b(std::move(second));
  Skeleton_comparison result;
  result.diagonal = normalization.unit;
  result.match_distance = match_distance;
  result.from_first_to_second = a.distance(b, match_distance);
  result.from_second_to_first = b.distance(a, match_distance);
  result.tips = a.match_nodes(
      b, [](std::size_t degree) { return degree == 1; }, match_distance);
  result.junctions = a.match_nodes(
      b, [](std::size_t degree) { return degree > 2; }, match_distance);
  result.branches = a.match_branches(b, match_distance);
  result.has_same_structure = have_same_structure(a.graph(), b.graph());
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_MEASURE_COMPARE_SKELETONS_IMPL_H
