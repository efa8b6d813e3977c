// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances between two skeletons, their features at the same place, and whether they are joined in the same way.

#include "Measure/skeleton_tools.h"
#include <CSCD/Measure/compare_skeletons.h>
#include <CSCD/Measure/distance_to_edges.h>
#include <CSCD/Measure/split_into_branches.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/Box_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {
namespace {

/// A graph whose vertices are the nodes of a skeleton that do not have two edges, and whose edges are the branches
/// between them. Closed cycles without such a node are set apart.
struct Branch_graph
{
  /// Linear.
  explicit Branch_graph(const Skeleton& skeleton)
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

/// Divides the vertices of a graph into the coarsest classes such that the vertices of a class have equally many edges
/// to each class: the color refinement of B. Weisfeiler and A. Leman. Each round only examines vertices with a neighbor
/// whose class has changed.
/// \return the class of each vertex
std::vector<Index> refine_colors(const std::vector<std::vector<Index>>& neighbors)
{
  std::vector<Index> color(neighbors.size(), 0);
  std::vector<std::size_t> size{neighbors.size()}; // of each class
  std::vector<Index> touched(neighbors.size());
  std::iota(touched.begin(), touched.end(), Index(0));
  while (!touched.empty()) {
    std::map<Index, std::map<std::vector<Index>, std::vector<Index>>> groups; // by class and classes of neighbors
    for (const Index v : touched) {
      std::vector<Index> around;
      for (const Index w : neighbors[v]) {
        around.push_back(color[w]);
      }
      std::sort(around.begin(), around.end());
      groups[color[v]][around].push_back(v);
    }
    std::vector<Index> changed;
    for (const auto& [old_color, pieces] : groups) {
      std::size_t number_touched = 0;
      std::size_t largest = 0;
      for (const auto& [around, piece] : pieces) {
        number_touched += piece.size();
        largest = std::max(largest, piece.size());
      }
      // Vertices that are not touched keep their class; without any, the largest piece does.
      bool is_kept = number_touched < size[old_color];
      for (const auto& [around, piece] : pieces) {
        if (!is_kept && piece.size() == largest) {
          is_kept = true;
          continue;
        }
        size[old_color] -= piece.size();
        for (const Index v : piece) {
          color[v] = Index(size.size());
        }
        size.push_back(piece.size());
        changed.insert(changed.end(), piece.begin(), piece.end());
      }
    }
    touched.clear();
    for (const Index v : changed) {
      touched.insert(touched.end(), neighbors[v].begin(), neighbors[v].end());
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  }
  return color;
}

/// Whether the branches of two skeletons are joined in the same way, by color refinement of both at once: that decides
/// it for forests, and for graphs with cycles unless they are of a regularity that skeletons do not have.
bool have_same_structure(const Branch_graph& a, const Branch_graph& b)
{
  if (a.nodes.size() != b.nodes.size() || a.edges.size() != b.edges.size() ||
      a.number_of_closed_cycles != b.number_of_closed_cycles) {
    return false;
  }
  const auto number_of_nodes = Index(a.nodes.size());
  std::vector<std::vector<Index>> neighbors(std::size_t(2) * number_of_nodes);
  for (const Branch_graph* graph : {&a, &b}) {
    const Index first = graph == &a ? 0 : number_of_nodes;
    for (const auto& [u, v] : graph->edges) {
      neighbors[first + u].push_back(first + v);
      neighbors[first + v].push_back(first + u);
    }
  }
  const std::vector<Index> colors = refine_colors(neighbors);
  std::vector<std::ptrdiff_t> excess(neighbors.size(), 0); // of nodes of `a` in each class
  for (Index v = 0; v < colors.size(); ++v) {
    excess[colors[v]] += v < number_of_nodes ? 1 : -1;
  }
  return std::all_of(excess.begin(), excess.end(), [](std::ptrdiff_t number) { return number == 0; });
}

/// A branch as a curve of its own.
class Branch_curve
{
public:
  /// \param path nodes of `skeleton`
  Branch_curve(const Skeleton& skeleton, const std::vector<Index>& path)
  {
    constexpr std::size_t number_of_samples = 32; // enough for a mean that is compared with a bound
    Skeleton curve;
    double length = 0;
    for (Index i = 0; i < path.size(); ++i) {
      curve.points.push_back(skeleton.points[path[i]]);
      m_box.extend(curve.points.back());
      if (i > 0) {
        curve.edges.push_back({i - 1, i});
        length += curve.length(curve.edges.back());
      }
    }
    if (length > 0) {
      for (const Edge_sample& sample : sample_edges(curve, length / double(number_of_samples))) {
        m_samples.push_back(sample.point);
      }
    }
    m_samples.resize(number_of_samples, curve.points.back()); // by rounding, one can be missing
    m_points = std::move(curve.points);
  }

  const Bounding_box& box() const { return m_box; }

  /// The greater one of the mean distances of each curve from the other, if it is at most `max_distance`, and otherwise
  /// infinity.
  double distance(const Branch_curve& other, double max_distance) const
  {
    const double result = mean_distance(other, max_distance);
    return result <= max_distance ? std::max(result, other.mean_distance(*this, max_distance)) : result;
  }

private:
  double distance(const Vector_3& point) const
  {
    double result = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < m_points.size(); ++i) {
      result = std::min(result, distance_to_segment(point, m_points[i - 1], m_points[i]));
    }
    return result;
  }

  /// \return infinity if it is more than `max_distance`
  double mean_distance(const Branch_curve& other, double max_distance) const
  {
    constexpr std::size_t stride = 13; // has no divisor in common with the number: soon somewhere far from a common end
    const std::size_t number = m_samples.size();
    const double max_sum = max_distance * double(number);
    double sum = 0;
    for (std::size_t i = 0; i < number && sum <= max_sum; ++i) {
      sum += other.distance(m_samples[i * stride % number]);
    }
    return sum <= max_sum ? sum / double(number) : std::numeric_limits<double>::infinity();
  }

  std::vector<Vector_3> m_points;
  std::vector<Vector_3> m_samples;
  Bounding_box m_box;
};

Bounding_box box_of(const Vector_3& point)
{
  Bounding_box box;
  box.extend(point);
  return box;
}
const Bounding_box& box_of(const Branch_curve& curve)
{
  return curve.box();
}

double distance_up_to(const Vector_3& a, const Vector_3& b, double /* max_distance */)
{
  return (a - b).norm();
}
double distance_up_to(const Branch_curve& a, const Branch_curve& b, double max_distance)
{
  return a.distance(b, max_distance);
}

/// Matches points, or curves, that are not farther apart than `match_distance`, each at most once: the nearest first,
/// on ties those of least numbers. \throw Input_error if too many are near each other
template <class Object>
Match_count match(const std::vector<Object>& first, const std::vector<Object>& second, double match_distance)
{
  constexpr std::size_t most = std::size_t(1) << 22; // some seconds; skeletons of bodies have some thousand
  std::vector<Bounding_box> boxes;
  std::transform(second.begin(), second.end(), std::back_inserter(boxes),
                 [](const Object& object) { return box_of(object); });
  const Box_tree tree(boxes);
  std::vector<std::tuple<double, Index, Index>> pairs;
  std::size_t number_compared = 0;
  for (Index i = 0; i < first.size(); ++i) {
    // Where the boxes are farther apart, no point of one is nearer to the other.
    const auto is_near = [&, box = box_of(first[i])](const Bounding_box& b) {
      return box.distance(b) <= match_distance;
    };
    tree.visit(is_near, [&](Index j) {
      if (!is_near(boxes[j])) {
        return;
      }
      if (++number_compared > most) {
        throw Input_error("too many tips, junctions or branches of the skeletons are near each other to be matched: "
                          "choose a smaller match distance or simplify the skeletons first");
      }
      const double distance = distance_up_to(first[i], second[j], match_distance);
      if (distance <= match_distance) {
        pairs.emplace_back(distance, i, j);
      }
    });
  }
  return {first.size(), second.size(), take_nearest_pairs(std::move(pairs)).size()};
}

/// A skeleton prepared for comparison; lengths are relative to the common diagonal.
struct Compared_skeleton
{
  /// \pre the skeleton has nodes
  explicit Compared_skeleton(Skeleton&& its_skeleton)
      : skeleton(std::move(its_skeleton)), graph(skeleton), tree(skeleton)
  {
    for (const std::vector<Index>& branch : graph.branches) {
      curves.emplace_back(skeleton, branch);
    }
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
      if (graph.degrees[i] > 0) {
        (graph.degrees[i] == 1 ? tips : junctions).push_back(skeleton.points[graph.nodes[i]]);
      }
    }
  }

  /// Measures how far this skeleton is from `other`.
  /// \throw Input_error if there are too many edges near each other
  Skeleton_distance distance(const Compared_skeleton& other, double match_distance) const
  {
    constexpr double spacing = 1. / 1000;
    constexpr std::size_t max_number_of_samples = 1 << 16; // a mean over more would not be better
    std::vector<Vector_3> samples;                         // of the edges; the nodes if these have no length
    for (const Edge_sample& sample : sample_edges(skeleton, spacing, max_number_of_samples)) {
      samples.push_back(sample.point);
    }
    if (samples.empty()) {
      samples = skeleton.points;
    }
    Skeleton_distance result;
    Work_limit work;
    std::size_t number_matched = 0;
    for (const Vector_3& sample : samples) {
      const double d = other.tree.nearest(sample, work).distance;
      result.mean += d;
      result.maximum = std::max(result.maximum, d);
      number_matched += d <= match_distance ? 1 : 0;
    }
    result.mean /= double(samples.size());
    result.fraction_matched = double(number_matched) / double(samples.size());
    for (const Vector_3& point : skeleton.points) {
      result.maximum = std::max(result.maximum, other.tree.nearest(point, work).distance);
    }
    return result;
  }

  Skeleton skeleton;
  Branch_graph graph;
  Segment_tree tree;
  std::vector<Branch_curve> curves;
  std::vector<Vector_3> tips;
  std::vector<Vector_3> junctions;
};

/// \throw Input_error if `skeleton`, called `name`, has no nodes or one that is not finite
void check_skeleton(const Skeleton& skeleton, const std::string& name)
{
  if (skeleton.number_of_nodes() == 0) {
    throw Input_error("the " + name + " skeleton has no nodes: there is nothing to compare");
  }
  for (std::size_t v = 0; v < skeleton.number_of_nodes(); ++v) {
    check_finite(skeleton, v, name + ' ');
  }
}

/// The coordinates where the bounding box of both skeletons has a diagonal of 1; any, if it is a point.
/// \throw Input_error if the coordinates are too large
Normalization common_normalization(const Skeleton& a, const Skeleton& b)
{
  Bounding_box box;
  for (const Skeleton* skeleton : {&a, &b}) {
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

} // namespace

Skeleton_comparison compare_skeletons(Skeleton&& first, Skeleton&& second, double match_distance)
{
  if (!(match_distance >= 0)) {
    throw Input_error("the match distance is negative or no number: 0.02 will do in most cases");
  }
  check_skeleton(first, "first");
  check_skeleton(second, "second");
  const Normalization normalization = common_normalization(first, second);
  for (Skeleton* skeleton : {&first, &second}) {
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
  result.tips = match(a.tips, b.tips, match_distance);
  result.junctions = match(a.junctions, b.junctions, match_distance);
  result.branches = match(a.curves, b.curves, match_distance);
  result.has_same_structure = have_same_structure(a.graph, b.graph);
  return result;
}

} // namespace CSCD::internal
