// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of compare_skeletons.h.

#ifndef CSCD_MEASURE_COMPARE_SKELETONS_IMPL_H
#define CSCD_MEASURE_COMPARE_SKELETONS_IMPL_H

#include <CSCD/Measure/Part_tree.h>
#include <CSCD/Measure/Position_measurement.h>
#include <CSCD/Measure/Segment_bvh.h>
#include <CSCD/Measure/compare_skeletons.h>
#include <CSCD/Measure/distance_to_edges.h>
#include <CSCD/Measure/split_into_branches.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
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
#include <memory>
#include <string>
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

/// Divides the vertices of a graph into the coarsest classes such that the vertices of a class have equally many edges
/// to each class: the color refinement of B. Weisfeiler and A. Leman. A class is split by the edges that lead to
/// another one, and of its pieces all but the largest then split others: C. Berkholz, P. Bonsma and M. Grohe, Tight
/// lower and upper bounds for the complexity of canonical colour refinement (2017). O((n + m) log n) for n vertices, m
/// edges.
class Color_refinement
{
public:
  /// \param neighbors of each vertex; the first classes are those of equal number of neighbors
  explicit Color_refinement(const std::vector<std::vector<Index>>& neighbors)
      : m_neighbors(neighbors), m_order(neighbors.size()), m_place(neighbors.size()), m_class(neighbors.size(), 0),
        m_number_of_edges(neighbors.size(), 0), m_classes{{0, Index(neighbors.size())}}, m_to_do{0}, m_is_to_do{1}
  {
    std::vector<Index> vertices(neighbors.size());
    for (Index v = 0; v < neighbors.size(); ++v) {
      m_order[v] = m_place[v] = vertices[v] = v;
      m_number_of_edges[v] = Index(neighbors[v].size());
    }
    split(vertices);
    while (!m_to_do.empty()) {
      const Index splitter = m_to_do.back();
      m_to_do.pop_back();
      m_is_to_do[splitter] = 0;
      split_by(splitter);
    }
  }

  /// The class of each vertex.
  const std::vector<Index>& classes() const { return m_class; }
  std::size_t number_of_classes() const { return m_classes.size(); }

private:
  struct Range
  {
    Index begin, end;
  };

  void split_by(Index splitter)
  {
    std::vector<Index> touched;
    for (Index i = m_classes[splitter].begin; i < m_classes[splitter].end; ++i) {
      for (const Index v : m_neighbors[m_order[i]]) {
        if (m_number_of_edges[v]++ == 0) {
          touched.push_back(v);
        }
      }
    }
    split(touched);
  }

  /// Splits the classes of the vertices by `m_number_of_edges`, which is 0 for others, and resets it.
  void split(std::vector<Index>& vertices)
  {
    const auto key = [this](Index v) { return std::pair(m_class[v], m_number_of_edges[v]); };
    std::sort(vertices.begin(), vertices.end(), [&](Index v, Index w) { return key(v) < key(w); });
    for (std::size_t begin = 0; begin < vertices.size();) {
      std::size_t end = begin;
      const Index split_class = m_class[vertices[begin]];
      while (end < vertices.size() && m_class[vertices[end]] == split_class) {
        ++end;
      }
      split_class_of(vertices.data() + begin, vertices.data() + end);
      begin = end;
    }
    for (const Index v : vertices) {
      m_number_of_edges[v] = 0;
    }
  }

  /// Gives each piece of a class but one a new number, from the end of its range on.
  void split_class_of(const Index* begin, const Index* end)
  {
    const Index old = m_class[*begin];
    std::vector<Index> pieces{old};
    while (begin != end && m_number_of_edges[*begin] != m_number_of_edges[*(end - 1)]) {
      end = move_last_piece(begin, end, old, pieces);
    }
    if (begin != end && Index(end - begin) < m_classes[old].end - m_classes[old].begin) {
      move_last_piece(begin, end, old, pieces);
    }
    const bool was_to_do = m_is_to_do[old] != 0;
    const Index largest = *std::max_element(pieces.begin(), pieces.end(), [this](Index a, Index b) {
      return m_classes[a].end - m_classes[a].begin < m_classes[b].end - m_classes[b].begin;
    });
    for (const Index piece : pieces) {
      if ((was_to_do || piece != largest) && m_is_to_do[piece] == 0) {
        m_is_to_do[piece] = 1;
        m_to_do.push_back(piece);
      }
    }
  }

  /// Makes a class of the vertices at the end that have equally many edges. \return where the others end
  const Index* move_last_piece(const Index* begin, const Index* end, Index old, std::vector<Index>& pieces)
  {
    const Index number_of_edges = m_number_of_edges[*(end - 1)];
    const auto number = Index(m_classes.size());
    Range range{m_classes[old].end, m_classes[old].end};
    while (end != begin && m_number_of_edges[*(end - 1)] == number_of_edges) {
      const Index v = *--end;
      const Index w = m_order[--range.begin];
      std::swap(m_order[m_place[v]], m_order[range.begin]);
      m_place[w] = m_place[v];
      m_place[v] = range.begin;
      m_class[v] = number;
    }
    m_classes[old].end = range.begin;
    m_classes.push_back(range);
    m_is_to_do.push_back(0);
    pieces.push_back(number);
    return end;
  }

  const std::vector<std::vector<Index>>& m_neighbors;
  std::vector<Index> m_order; ///< the vertices, class by class
  std::vector<Index> m_place; ///< of each vertex in `m_order`
  std::vector<Index> m_class;
  std::vector<Index> m_number_of_edges; ///< of each vertex to the class that splits
  std::vector<Range> m_classes;         ///< in `m_order`
  std::vector<Index> m_to_do;           ///< classes that may split others
  std::vector<char> m_is_to_do;
};

/// Whether the branches of two skeletons are joined in the same way, by color refinement of both at once: that decides
/// it for forests, and for graphs with cycles unless they are of a regularity that skeletons do not have.
/// O(n log n) for n nodes that do not have two edges and branches between them.
inline bool have_same_structure(const Branch_graph& a, const Branch_graph& b)
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
  const Color_refinement refinement(neighbors);
  std::vector<std::ptrdiff_t> excess(refinement.number_of_classes(), 0); // of nodes of `a` in each class
  for (Index v = 0; v < neighbors.size(); ++v) {
    excess[refinement.classes()[v]] += v < number_of_nodes ? 1 : -1;
  }
  return std::all_of(excess.begin(), excess.end(), [](std::ptrdiff_t number) { return number == 0; });
}

/// Matches the objects of two trees, each at most once, nearest pairs first, on ties those of least numbers. From any
/// object the path to the nearest of the other side, from there back to the nearest, and so on, gets shorter with every
/// step until two are the nearest of each other; these are matched, whatever the others do. So O(m + n) objects are
/// searched for, from objects of the first tree in random order. When that has become too much work, those that were
/// begun with stand for all.
/// \param distance `distance(i, j, most)` of object `i` of the first tree and `j` of the second if it is at most `most`,
///        and else more than that
/// \param bound_in_second `bound_in_second(i, node)` is at most the distance of `i` from each object of the node
/// \param bound_in_first likewise, for objects of the second tree and nodes of the first
/// \param match_distance maximum distance of a pair
/// \param max_work how many distances and bounds may be computed
template <class Tree, class Distance, class Bound1, class Bound2>
Match_count match_nearest_first(Tree first, std::size_t m, Tree second, std::size_t n, const Distance& distance,
                                const Bound1& bound_in_second, const Bound2& bound_in_first, double match_distance,
                                std::size_t max_work)
{
  std::size_t work = 0;
  const auto to_second = [&](Index i, const typename Tree::Candidate& best) {
    return second.minimize([&](Index node) { return ++work, bound_in_second(i, second.nodes()[node]); },
                           [&](Index j, double least) { return ++work, distance(i, j, least); }, best);
  };
  const auto to_first = [&](Index j, const typename Tree::Candidate& best) {
    return first.minimize([&](Index node) { return ++work, bound_in_first(j, first.nodes()[node]); },
                          [&](Index i, double least) { return ++work, distance(i, j, least); }, best);
  };
  enum State : char
  {
    open,
    alone,
    matched
  };
  std::vector<State> state(m, open);
  std::vector<Index> path; // objects of the first and the second tree in turn
  std::size_t number_begun = 0;
  std::size_t number_matched = 0; // of those that were begun with
  for (const Index start : in_random_order(m)) {
    if (work > max_work) {
      break;
    }
    while (state[start] == open) {
      if (path.empty()) {
        path.push_back(start);
      }
      const Index last = path.back();
      const bool is_in_first = path.size() % 2 == 1;
      typename Tree::Candidate best{match_distance, no_index};
      if (path.size() > 1) { // the one before is near; that keeps the path from going in circles where others are too
        const Index previous = path[path.size() - 2];
        best = {is_in_first ? distance(last, previous, match_distance) : distance(previous, last, match_distance),
                previous};
      }
      best = is_in_first ? to_second(last, best) : to_first(last, best);
      if (best.object == no_index) {
        first.remove(last);
        state[last] = alone;
        path.pop_back();
      } else if (path.size() > 1 && best.object == path[path.size() - 2]) {
        const Index i = is_in_first ? last : best.object;
        first.remove(i);
        second.remove(is_in_first ? best.object : last);
        state[i] = matched;
        path.resize(path.size() - 2);
      } else {
        path.push_back(best.object);
      }
    }
    ++number_begun;
    number_matched += std::size_t(state[start] == matched ? 1 : 0);
  }
  if (number_begun < m) {
    const double fraction = double(number_matched) / double(number_begun);
    return {m, n, std::min(std::size_t(std::llround(fraction * double(m))), n), true};
  }
  return {m, n, number_matched, false};
}

/// A branch as a curve of its own.
class Branch_curve
{
public:
  static constexpr std::size_t number_of_pieces = 4; // tell the curves around a hub apart, with few boxes
  /// Over the samples of each piece of a curve, and the whole curve.
  using Tree = Part_tree<number_of_pieces + 1>;

  /// \param path nodes of `skeleton`
  /// \param number_of_samples for means, a multiple of `number_of_pieces`
  Branch_curve(const Indexed_skeleton& skeleton, const std::vector<Index>& path, std::size_t number_of_samples)
  {
    Indexed_skeleton curve;
    for (Index i = 0; i < path.size(); ++i) {
      curve.points.push_back(skeleton.points[path[i]]);
      m_box.extend(curve.points.back());
      if (i > 0) {
        curve.edges.push_back({i - 1, i});
      }
    }
    sample(curve, number_of_samples);
    if (curve.edges.size() > max_number_without_tree) {
      m_tree = std::make_unique<const Segment_bvh>(segment_tree(curve, curve.edges));
    } else {
      m_points = std::move(curve.points);
    }
  }

  /// The greater one of the mean distances of each curve from the other, if it is at most `max_distance`, and otherwise
  /// infinity.
  double distance(const Branch_curve& other, double max_distance) const
  {
    double result = std::numeric_limits<double>::infinity();
    if (m_box.distance(other.m_box) <= max_distance) { // otherwise no point is nearer
      result = mean_distance(other, max_distance);
    }
    return result <= max_distance ? std::max(result, other.mean_distance(*this, max_distance)) : result;
  }

  /// As an object of the tree.
  Tree::Parts parts() const
  {
    Tree::Parts parts;
    for (std::size_t i = 0; i < m_samples.size(); ++i) {
      parts[i * number_of_pieces / m_samples.size()].extend(m_samples[i]);
    }
    parts.back() = m_box;
    return parts;
  }

  /// No more than the distance from any of the curves of a node.
  double bound(const Tree::Node& node) const
  {
    double from_node = 0;
    for (std::size_t piece = 0; piece < number_of_pieces; ++piece) {
      const Bounding_box& box = node.boxes[piece];
      from_node += std::max(distance((box.min() + box.max()) / 2) - box.diagonal() / 2, 0.);
    }
    double to_node = 0;
    for (const Vector_3& sample : m_samples) {
      to_node += std::sqrt(node.boxes.back().squared_distance(sample));
    }
    return std::max(from_node / double(number_of_pieces), to_node / double(m_samples.size()));
  }

private:
  /// Few segments are faster looked at one by one, and a tree for each of a million takes gigabytes.
  static constexpr std::size_t max_number_without_tree = 4;

  void sample(const Indexed_skeleton& curve, std::size_t number_of_samples)
  {
    m_samples.reserve(number_of_samples);
    double length = 0;
    for (const auto& edge : curve.edges) {
      length += curve.length(edge);
    }
    if (length > 0) {
      for (const Edge_sample& sample : sample_edges(curve, length / double(number_of_samples))) {
        m_samples.push_back(sample.point);
      }
    }
    m_samples.resize(number_of_samples, curve.points.back()); // by rounding, one can be missing
    if (std::lexicographical_compare(curve.points.back().begin(), curve.points.back().end(),
                                     curve.points.front().begin(), curve.points.front().end())) {
      std::reverse(m_samples.begin(), m_samples.end()); // so that the pieces of curves side by side are, too
    }
  }

  double distance(const Vector_3& point) const
  {
    if (m_tree) {
      return m_tree->nearest(point).distance;
    }
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

  std::vector<Vector_3> m_points;            ///< without tree
  std::unique_ptr<const Segment_bvh> m_tree; ///< of many segments
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
    constexpr std::size_t enough_samples = 32;             // of a branch, for a mean that is compared with a bound
    constexpr std::size_t max_number_of_samples = 1 << 20; // of all branches, as long as each has some
    const std::size_t number_of_samples = std::min(
        enough_samples, std::max<std::size_t>(
                            max_number_of_samples / (m_graph.branches.size() + 1) / Branch_curve::number_of_pieces, 1) *
                            Branch_curve::number_of_pieces);
    m_curves.reserve(m_graph.branches.size());
    for (const std::vector<Index>& branch : m_graph.branches) {
      m_curves.emplace_back(m_skeleton, branch, number_of_samples);
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
    std::size_t number = 0;
    std::size_t work = 0;
    for (const Index i : in_random_order(samples.size())) {
      const double d = other.m_tree.nearest(samples[i], 0, &work).distance;
      result.mean += d;
      result.maximum = std::max(result.maximum, d);
      number_matched += d <= match_distance ? 1 : 0;
      ++number;
      if (work > Segment_bvh::enough_work) {
        result.is_estimate = number < samples.size();
        break;
      }
    }
    result.mean /= double(number);
    result.fraction_matched = double(number_matched) / double(number);
    if (!m_skeleton.edges.empty()) { // otherwise the samples are the nodes
      work = 0;
      for (const Index node : in_random_order(m_skeleton.points.size())) {
        if (work > Segment_bvh::enough_work) {
          result.is_estimate = true;
          break;
        }
        const double d = other.m_tree.nearest(m_skeleton.points[node], result.maximum, &work).distance;
        result.maximum = std::max(result.maximum, d);
      }
    }
    return result;
  }

  /// Matches nodes whose degrees fulfil `is_chosen` by their positions.
  Match_count match_nodes(const Compared_skeleton& other, const std::function<bool(std::size_t)>& is_chosen,
                          double match_distance) const
  {
    using Tree = Part_tree<1>;
    const std::vector<Vector_3> mine = chosen_points(is_chosen);
    const std::vector<Vector_3> theirs = other.chosen_points(is_chosen);
    const auto tree_of = [](const std::vector<Vector_3>& points) {
      std::vector<Tree::Parts> parts(points.size());
      for (std::size_t i = 0; i < points.size(); ++i) {
        parts[i][0].extend(points[i]);
      }
      return Tree(parts);
    };
    const auto bound = [](const std::vector<Vector_3>& points) {
      return
          [&points](Index i, const Tree::Node& node) { return std::sqrt(node.boxes[0].squared_distance(points[i])); };
    };
    return match_nearest_first(
        tree_of(mine), mine.size(), tree_of(theirs), theirs.size(),
        [&](Index i, Index j, double) { return (mine[i] - theirs[j]).norm(); }, bound(mine), bound(theirs),
        match_distance, max_work_for_nodes);
  }

  /// Matches branches by the distances of their curves.
  Match_count match_branches(const Compared_skeleton& other, double match_distance) const
  {
    using Tree = Branch_curve::Tree;
    const auto tree_of = [](const std::vector<Branch_curve>& curves) {
      std::vector<Tree::Parts> parts;
      parts.reserve(curves.size());
      for (const Branch_curve& curve : curves) {
        parts.push_back(curve.parts());
      }
      return Tree(parts);
    };
    const auto bound = [](const std::vector<Branch_curve>& curves) {
      return [&curves](Index i, const Tree::Node& node) { return curves[i].bound(node); };
    };
    return match_nearest_first(
        tree_of(m_curves), m_curves.size(), tree_of(other.m_curves), other.m_curves.size(),
        [&](Index i, Index j, double most) { return m_curves[i].distance(other.m_curves[j], most); }, bound(m_curves),
        bound(other.m_curves), match_distance, max_work_for_branches);
  }

private:
  /// Distances and bounds that are computed to match nodes, which takes some seconds; and branches. Bodies need some
  /// thousand, a hub of 10,000 arms some million.
  static constexpr std::size_t max_work_for_nodes = std::size_t(1) << 27;
  static constexpr std::size_t max_work_for_branches = std::size_t(1) << 21;

  /// Samples of the edges; the nodes where there is no length.
  std::vector<Vector_3> sample_by_length(double spacing) const
  {
    std::vector<Vector_3> samples;
    constexpr std::size_t max_number_of_samples = 1 << 16; // a mean over more would be no better
    for (const Edge_sample& sample :
         sample_edges(m_skeleton, bounded_spacing(m_skeleton, spacing, max_number_of_samples))) {
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
