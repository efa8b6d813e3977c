// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Roots of a skeleton, and the forest that grows from them.

#ifndef CSCD_MEASURE_ROOTED_FOREST_H
#define CSCD_MEASURE_ROOTED_FOREST_H

#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/Disjoint_sets.h>

#include <CGAL/double.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CSCD {

/// Which node of each component of a skeleton is its root.
enum class Root_rule
{
  thickest, ///< the node of the greatest radius
  lowest,   ///< the node of the least third coordinate
  longest   ///< of both ends of the longest path the thicker one; cycles count as if they were cut where they are
            ///< thinnest
};

namespace internal {

/// A spanning forest of a skeleton, each tree grown depth first from its root, and the edges that it leaves out: every
/// cycle is cut at its thinnest edge. O(n log n).
class Rooted_forest
{
public:
  /// \param roots come first; components without any begin at their first node. More than one of a component is one too
  ///        many: the first counts
  explicit Rooted_forest(const Indexed_skeleton& skeleton, const std::vector<Index>& roots = {})
      : m_parent(skeleton.number_of_nodes(), no_index)
  {
    m_order.reserve(skeleton.number_of_nodes());
    const std::vector<std::vector<Index>> neighbors = cut_cycles(skeleton);
    for (const Index root : roots) {
      grow_from(root, neighbors);
    }
    for (Index node = 0; node < m_parent.size(); ++node) {
      grow_from(node, neighbors);
    }
  }

  /// All nodes, each after its parent and each branch in one piece.
  const std::vector<Index>& order() const { return m_order; }
  /// The parent of `node`; a root is its own.
  Index parent(Index node) const { return m_parent[node]; }
  bool is_root(Index node) const { return m_parent[node] == node; }
  /// The edges that are not in the forest; each of them closes a cycle.
  const std::vector<std::array<Index, 2>>& loops() const { return m_loops; }

private:
  /// Takes edges, the thickest first, as long as they close no cycle. \return the neighbors of each node by these
  std::vector<std::vector<Index>> cut_cycles(const Indexed_skeleton& skeleton)
  {
    std::vector<Index> edges(skeleton.edges.size());
    std::iota(edges.begin(), edges.end(), Index(0));
    if (skeleton.has_radii()) {
      const auto thickness = [&skeleton](Index e) {
        return skeleton.radii[skeleton.edges[e][0]] + skeleton.radii[skeleton.edges[e][1]];
      };
      std::stable_sort(edges.begin(), edges.end(), [&](Index a, Index b) { return thickness(a) > thickness(b); });
    }
    Disjoint_sets trees(skeleton.number_of_nodes());
    std::vector<char> is_loop(skeleton.edges.size(), 0);
    for (const Index e : edges) {
      is_loop[e] = trees.join(skeleton.edges[e][0], skeleton.edges[e][1]) ? 0 : 1;
    }
    std::vector<std::vector<Index>> neighbors(skeleton.number_of_nodes());
    for (std::size_t e = 0; e < skeleton.edges.size(); ++e) {
      const auto& [u, v] = skeleton.edges[e];
      if (is_loop[e] != 0) {
        m_loops.push_back({u, v});
      } else {
        neighbors[u].push_back(v);
        neighbors[v].push_back(u);
      }
    }
    return neighbors;
  }

  void grow_from(Index root, const std::vector<std::vector<Index>>& neighbors)
  {
    if (m_parent[root] != no_index) {
      return;
    }
    m_parent[root] = root;
    std::vector<Index> open{root};
    while (!open.empty()) {
      const Index node = open.back();
      open.pop_back();
      m_order.push_back(node);
      for (const Index neighbor : neighbors[node]) {
        if (m_parent[neighbor] == no_index) {
          m_parent[neighbor] = node;
          open.push_back(neighbor);
        }
      }
    }
  }

  std::vector<Index> m_parent;
  std::vector<Index> m_order;
  std::vector<std::array<Index, 2>> m_loops;
};

/// For each node the root of its tree in a forest.
inline std::vector<Index> roots_of_nodes(const Rooted_forest& forest)
{
  std::vector<Index> root(forest.order().size());
  for (const Index node : forest.order()) {
    root[node] = forest.is_root(node) ? node : root[forest.parent(node)];
  }
  return root;
}

/// Of each component the node for which `cost(node)` is least; the first of several.
template <class Cost>
std::vector<Index> least_nodes(const Rooted_forest& forest, const Cost& cost)
{
  const std::vector<Index> root = roots_of_nodes(forest);
  std::vector<Index> best(root.size(), no_index); // of the component with this root
  for (Index node = 0; node < root.size(); ++node) {
    Index& its_best = best[root[node]];
    if (its_best == no_index || cost(node) < cost(its_best)) {
      its_best = node;
    }
  }
  best.erase(std::remove(best.begin(), best.end(), no_index), best.end());
  return best;
}

/// Of each tree the node that is farthest from its root.
inline std::vector<Index> farthest_nodes(const Indexed_skeleton& skeleton, const Rooted_forest& forest)
{
  std::vector<double> distance(skeleton.number_of_nodes(), 0);
  for (const Index node : forest.order()) {
    const Index parent = forest.parent(node);
    distance[node] = distance[parent] + skeleton.length({parent, node});
  }
  return least_nodes(forest, [&](Index node) { return -distance[node]; });
}

inline std::vector<Index> find_roots(const Indexed_skeleton& skeleton, Root_rule rule)
{
  if (rule == Root_rule::thickest && !skeleton.has_radii()) {
    throw Input_error("the skeleton has no radii, so that no node is the thickest: choose another root");
  }
  const Rooted_forest forest(skeleton);
  if (rule != Root_rule::longest) {
    return least_nodes(forest, [&](Index node) {
      return rule == Root_rule::lowest ? skeleton.points[node].z() : -skeleton.radii[node];
    });
  }
  std::vector<Index> one_end = farthest_nodes(skeleton, forest);
  const Rooted_forest forest_from_end(skeleton, one_end);
  const std::vector<Index> root = roots_of_nodes(forest_from_end);
  std::vector<Index> result;
  result.reserve(one_end.size());
  for (const Index other_end : farthest_nodes(skeleton, forest_from_end)) {
    const Index end = root[other_end];
    const bool is_thicker = skeleton.has_radii() && skeleton.radii[other_end] > skeleton.radii[end];
    result.push_back(is_thicker ? other_end : end);
  }
  return result;
}

} // namespace internal

/// chooses a root in each component of `skeleton`.
/// O(n log n) for n nodes.
/// \tparam Skeleton a model of `CurveSkeletonGraph`
/// \return the numbers of the roots, nodes counted from 0 in the order of the graph
/// \throw Input_error if the thickest nodes are asked for and the nodes have no radius
template <class Skeleton>
std::vector<Index> find_roots(const Skeleton& skeleton, Root_rule rule)
{
  return internal::find_roots(internal::index_skeleton(skeleton), rule);
}

/// chooses in each component of `skeleton` the node that is nearest to `point` as its root.
/// O(n log n) for n nodes.
/// \tparam Skeleton a model of `CurveSkeletonGraph`
/// \tparam Point a type with coordinates `x()`, `y()`, `z()`
/// \return the numbers of the roots, nodes counted from 0 in the order of the graph
template <class Skeleton, class Point>
std::vector<Index> find_roots(const Skeleton& skeleton, const Point& point)
{
  const internal::Indexed_skeleton indexed = internal::index_skeleton(skeleton);
  const Vector_3 place(CGAL::to_double(point.x()), CGAL::to_double(point.y()), CGAL::to_double(point.z()));
  return internal::least_nodes(internal::Rooted_forest(indexed),
                               [&](Index node) { return (indexed.points[node] - place).squaredNorm(); });
}

} // namespace CSCD

#endif // CSCD_MEASURE_ROOTED_FOREST_H
