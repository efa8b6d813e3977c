// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether two skeletons are the same: bit by bit, or up to names and rounding.

#ifndef CSCD_TEST_SUPPORT_SKELETON_COMPARISON_H
#define CSCD_TEST_SUPPORT_SKELETON_COMPARISON_H

#include "Shape.h"
#include "Similarity.h"
#include "convert_shape.h"

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CSCD::test {

/// A skeleton without the types of its mesh: vertices are numbers.
struct Plain_skeleton
{
  std::vector<Triple> points;
  std::vector<std::vector<std::size_t>> sites;            ///< of every node, sorted
  std::vector<std::pair<std::size_t, std::size_t>> edges; ///< in the order of the graph
};

inline bool operator==(const Plain_skeleton& a, const Plain_skeleton& b)
{
  return a.points == b.points && a.sites == b.sites && a.edges == b.edges;
}

/// The edges of a skeleton in the order of the graph, the lower end first.
template <class Skeleton>
std::vector<std::pair<std::size_t, std::size_t>> plain_edges(const Skeleton& skeleton)
{
  std::vector<std::pair<std::size_t, std::size_t>> result;
  const auto range = boost::edges(skeleton);
  for (auto e = range.first; e != range.second; ++e) {
    result.emplace_back(std::minmax(source(*e, skeleton), target(*e, skeleton)));
  }
  return result;
}

/// `skeleton` with the vertices of `mesh` numbered in their order.
template <class Mesh, class Skeleton>
Plain_skeleton plain(const Mesh& mesh, const Skeleton& skeleton)
{
  const auto number = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  std::size_t count = 0;
  for (const auto v : vertices(mesh)) {
    put(number, v, count++);
  }
  Plain_skeleton result;
  for (std::size_t node = 0; node < num_vertices(skeleton); ++node) {
    result.points.push_back(to_triple(skeleton[node].point));
    result.sites.emplace_back();
    for (const auto v : skeleton[node].vertices) {
      result.sites.back().push_back(get(number, v));
    }
    std::sort(result.sites.back().begin(), result.sites.back().end());
  }
  result.edges = plain_edges(skeleton);
  return result;
}

inline Plain_skeleton moved(Plain_skeleton skeleton, const Similarity& motion)
{
  skeleton.points = moved(std::move(skeleton.points), motion);
  return skeleton;
}

/// `skeleton`, whose site `i` is named `names[i]` instead.
inline Plain_skeleton renamed(Plain_skeleton skeleton, const std::vector<std::size_t>& names)
{
  for (std::vector<std::size_t>& sites : skeleton.sites) {
    for (std::size_t& site : sites) {
      site = names[site];
    }
    std::sort(sites.begin(), sites.end());
  }
  return skeleton;
}

/// The reason why `a` and `b` differ by more than the order of nodes and edges and `tolerance` in position; empty if
/// they do not. Every node of `a` is compared with the nearest of `b`.
inline std::string difference(const Plain_skeleton& a, const Plain_skeleton& b, double tolerance)
{
  if (a.points.size() != b.points.size() || a.edges.size() != b.edges.size()) {
    return std::to_string(a.points.size()) + " nodes and " + std::to_string(a.edges.size()) + " edges against " +
           std::to_string(b.points.size()) + " and " + std::to_string(b.edges.size());
  }
  std::vector<std::size_t> match;
  std::vector<bool> is_matched(b.points.size(), false);
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const auto nearest = std::min_element(b.points.begin(), b.points.end(), [&](const Triple& p, const Triple& q) {
      return norm(p - a.points[i]) < norm(q - a.points[i]);
    });
    const std::size_t j = static_cast<std::size_t>(nearest - b.points.begin());
    if (!(norm(*nearest - a.points[i]) <= tolerance) || is_matched[j]) {
      return "node " + std::to_string(i) + " has no counterpart nearer than " +
             std::to_string(norm(*nearest - a.points[i]));
    }
    is_matched[j] = true;
    match.push_back(j);
    if (a.sites[i] != b.sites[j]) {
      return "node " + std::to_string(i) + " has other sites";
    }
  }
  std::vector<std::pair<std::size_t, std::size_t>> edges_of_a;
  for (const auto& [source, target] : a.edges) {
    edges_of_a.emplace_back(std::minmax(match[source], match[target]));
  }
  std::vector<std::pair<std::size_t, std::size_t>> edges_of_b = b.edges;
  std::sort(edges_of_a.begin(), edges_of_a.end());
  std::sort(edges_of_b.begin(), edges_of_b.end());
  return edges_of_a == edges_of_b ? "" : "edges join other nodes";
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_SKELETON_COMPARISON_H
