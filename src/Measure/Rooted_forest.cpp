// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The branches of a skeleton, its roots, and forests that grow from them.

#include <CSCD/Measure/Rooted_forest.h>
#include <CSCD/Measure/split_into_branches.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CSCD::internal {

std::vector<std::vector<Index>> split_into_branches(const std::vector<std::vector<Index>>& neighbors)
{
  std::vector<std::vector<Index>> branches;
  std::vector<char> is_walked(neighbors.size(), 0);
  const auto is_inner = [&neighbors](Index v) { return neighbors[v].size() == 2; };
  const auto walk = [&](Index previous, Index current) {
    std::vector<Index> branch{previous};
    while (is_inner(current) && is_walked[current] == 0) {
      is_walked[current] = 1;
      branch.push_back(current);
      const Index next = neighbors[current][neighbors[current][0] == previous ? 1 : 0];
      previous = std::exchange(current, next);
    }
    branch.push_back(current);
    branches.push_back(std::move(branch));
  };
  for (Index end = 0; end < neighbors.size(); ++end) {
    if (is_inner(end)) {
      continue;
    }
    if (neighbors[end].empty()) {
      branches.push_back({end});
    }
    std::size_t number_of_loop_ends = 0; // an edge from a node to itself is listed twice among its edges
    for (const Index next : neighbors[end]) {
      if (!is_inner(next) && (end < next || (end == next && number_of_loop_ends++ % 2 == 0))) {
        branches.push_back({end, next});
      } else if (is_inner(next) && is_walked[next] == 0) {
        walk(end, next);
      }
    }
  }
  for (Index v = 0; v < neighbors.size(); ++v) { // cycles
    if (is_inner(v) && is_walked[v] == 0) {
      is_walked[v] = 1;
      walk(v, neighbors[v][0]);
    }
  }
  return branches;
}

Rooted_forest::Rooted_forest(const Skeleton& skeleton, const std::vector<Index>& roots)
    : m_parent(skeleton.number_of_nodes(), no_index), m_root(skeleton.number_of_nodes())
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

std::vector<std::vector<Index>> Rooted_forest::cut_cycles(const Skeleton& skeleton)
{
  std::vector<Index> edges = all_indices(skeleton.edges.size());
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
  Skeleton forest{skeleton.points};
  for (std::size_t e = 0; e < skeleton.edges.size(); ++e) {
    (is_loop[e] != 0 ? m_loops : forest.edges).push_back(skeleton.edges[e]);
  }
  return node_neighbors(forest);
}

void Rooted_forest::grow_from(Index root, const std::vector<std::vector<Index>>& neighbors)
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
    m_root[node] = root;
    for (const Index neighbor : neighbors[node]) {
      if (m_parent[neighbor] == no_index) {
        m_parent[neighbor] = node;
        open.push_back(neighbor);
      }
    }
  }
}

namespace {

/// Of each component, the node whose `cost(node)` is least; the first of several.
std::vector<Index> least_nodes(const Rooted_forest& forest, const std::function<double(Index)>& cost)
{
  std::vector<Index> best(forest.order().size(), no_index); // of the component with this root
  for (Index node = 0; node < best.size(); ++node) {
    Index& its_best = best[forest.root(node)];
    if (its_best == no_index || cost(node) < cost(its_best)) {
      its_best = node;
    }
  }
  best.erase(std::remove(best.begin(), best.end(), no_index), best.end());
  return best;
}

/// Of each tree the node that is farthest from its root.
std::vector<Index> farthest_nodes(const Skeleton& skeleton, const Rooted_forest& forest)
{
  std::vector<double> distance(skeleton.number_of_nodes(), 0);
  for (const Index node : forest.order()) {
    const Index parent = forest.parent(node);
    distance[node] = distance[parent] + skeleton.length({parent, node});
  }
  return least_nodes(forest, [&](Index node) { return -distance[node]; });
}

} // namespace

std::vector<Index> find_roots(const Skeleton& skeleton, Root_rule rule)
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
  const Rooted_forest forest_from_end(skeleton, farthest_nodes(skeleton, forest));
  std::vector<Index> ends = farthest_nodes(skeleton, forest_from_end);
  for (Index& end : ends) {
    const Index other_end = forest_from_end.root(end);
    const bool is_thicker = skeleton.has_radii() && skeleton.radii[end] > skeleton.radii[other_end];
    end = is_thicker ? end : other_end;
  }
  return ends;
}

std::vector<Index> find_roots(const Skeleton& skeleton, const Vector3& point)
{
  return least_nodes(Rooted_forest(skeleton),
                     [&](Index node) { return (skeleton.points[node] - point).squaredNorm(); });
}

} // namespace CSCD::internal
