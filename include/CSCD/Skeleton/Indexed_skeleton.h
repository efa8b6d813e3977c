// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A skeleton of any graph type as flat arrays, the form in which it is measured and read from files.

#ifndef CSCD_SKELETON_INDEXED_SKELETON_H
#define CSCD_SKELETON_INDEXED_SKELETON_H

#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Vector_3.h>

#include <CGAL/double.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range_core.hpp>
#include <boost/unordered_map.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

using Indexed_skeleton = Skeleton;

/// The neighbors of the nodes of `skeleton`, in the order of its edges. An edge from a node to itself counts twice.
inline std::vector<std::vector<Index>> node_neighbors(const Indexed_skeleton& skeleton)
{
  std::vector<std::vector<Index>> neighbors(skeleton.number_of_nodes());
  for (const auto& [u, v] : skeleton.edges) {
    neighbors[u].push_back(v);
    neighbors[v].push_back(u);
  }
  return neighbors;
}

/// Copies `skeleton`, nodes and edges in the order in which the graph iterates them; expectedly linear.
/// \tparam Skeleton a model of `CurveSkeletonGraph`; radii are copied if its nodes have any
template <class Skeleton>
Indexed_skeleton index_skeleton(const Skeleton& skeleton)
{
  using Vertex = typename boost::graph_traits<Skeleton>::vertex_descriptor;
  Indexed_skeleton result;
  boost::unordered_map<Vertex, Index> index;
  for (const Vertex v : boost::make_iterator_range(vertices(skeleton))) {
    index.emplace(v, Index(result.points.size()));
    const auto& point = skeleton[v].point;
    result.points.emplace_back(CGAL::to_double(point.x()), CGAL::to_double(point.y()), CGAL::to_double(point.z()));
    if constexpr (has_is_opening_v<Skeleton>) {
      result.is_opening.push_back(skeleton[v].is_opening ? 1 : 0);
    }
    if constexpr (has_radius_v<Skeleton>) {
      result.radii.push_back(CGAL::to_double(skeleton[v].radius));
    }
  }
  for (const auto e : boost::make_iterator_range(edges(skeleton))) {
    result.edges.push_back({index.at(source(e, skeleton)), index.at(target(e, skeleton))});
    if constexpr (has_is_joined_v<Skeleton>) {
      result.is_joined.push_back(skeleton[e].is_joined ? 1 : 0);
    } else {
      result.is_joined.push_back(0);
    }
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_SKELETON_INDEXED_SKELETON_H
