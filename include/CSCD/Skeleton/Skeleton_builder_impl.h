// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of Skeleton_builder.h.

#ifndef CSCD_SKELETON_SKELETON_BUILDER_IMPL_H
#define CSCD_SKELETON_SKELETON_BUILDER_IMPL_H

#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CSCD::internal {

inline void warn_of_skeleton(Skeletonization_report& report)
{
  if (report.genus && report.betti_number != *report.genus) {
    report.warnings.push_back("the skeleton has " + counted(report.betti_number, "independent cycle") +
                              ", the surface " + counted(*report.genus, "handle"));
  }
  const std::size_t nodes = report.number_of_nodes_outside;
  const std::size_t edges = report.number_of_edges_outside;
  if (nodes + edges > 0) {
    report.warnings.push_back((nodes > 0 ? counted(nodes, "node") : std::string()) +
                              (nodes > 0 && edges > 0 ? " and " : "") +
                              (edges > 0 ? counted(edges, "edge") : std::string()) +
                              (nodes + edges == 1 ? " is" : " are") + " not wholly inside the body");
  }
}

} // namespace CSCD::internal

namespace CSCD {

CSCD_INLINE void Skeleton_builder::contract(Index node, Index into)
{
  CGAL_precondition(std::count(m_nodes[node].neighbors.begin(), m_nodes[node].neighbors.end(), node) == 0);
  std::vector<Index> moved;
  for (Index neighbor : m_nodes[node].neighbors) {
    if (neighbor != into) {
      moved.push_back(neighbor);
    }
  }
  std::vector<Index>& kept = m_nodes[into].neighbors;
  kept.erase(std::remove(kept.begin(), kept.end(), node), kept.end());
  for (Index neighbor : moved) {
    replace_one(m_nodes[neighbor].neighbors, node, into);
    kept.push_back(neighbor);
  }
  remove(node, into);
}

CSCD_INLINE void Skeleton_builder::compact()
{
  std::vector<Index> number(m_nodes.size(), no_index);
  Index count = 0;
  for (Index node = 0; node < m_nodes.size(); ++node) {
    if (!m_nodes[node].is_removed) {
      number[node] = count++;
    }
  }
  m_nodes.erase(std::remove_if(m_nodes.begin(), m_nodes.end(), [](const Node& node) { return node.is_removed; }),
                m_nodes.end());
  for (Node& node : m_nodes) {
    for (Index& neighbor : node.neighbors) {
      neighbor = number[neighbor];
    }
  }
}

CSCD_INLINE void make_simple(Skeleton_builder& builder)
{
  std::vector<std::pair<Index, Index>> edges;
  builder.for_each_edge([&](Index a, Index b) { edges.emplace_back(a, b); });
  std::set<std::pair<Index, Index>> seen;
  for (const auto& [a, b] : edges) {
    const double radius = (builder[a].radius + builder[b].radius) / 2;
    const Vector_3 along = builder[b].position - builder[a].position;
    if (a == b) {
      const Index first = builder.split_edge(a, a, builder[a].position + radius * Vector_3::UnitX() / 2, radius);
      builder.split_edge(first, a, builder[a].position + radius * Vector_3::UnitY() / 2, radius);
    } else if (!seen.insert({a, b}).second) {
      const Vector_3 aside = along.norm() > 0 ? Vector_3(along.unitOrthogonal()) : Vector_3(Vector_3::UnitX());
      builder.split_edge(a, b, builder[a].position + along / 2 + radius / 2 * aside, radius);
    }
  }
}

CSCD_INLINE void describe_skeleton(const Skeleton_builder& skeleton, Skeletonization_report& report)
{
  internal::Disjoint_sets components(skeleton.size());
  report.number_of_nodes = skeleton.size();
  report.number_of_edges = 0;
  skeleton.for_each_edge([&](Index a, Index b) {
    ++report.number_of_edges;
    components.join(a, b);
  });
  report.number_of_skeleton_components = 0;
  for (Index node = 0; node < skeleton.size(); ++node) {
    report.number_of_skeleton_components += components.find(node) == node ? 1 : 0;
  }
  report.betti_number = report.number_of_edges + report.number_of_skeleton_components - report.number_of_nodes;
  report.number_of_tips = 0;
  report.number_of_junctions = 0;
  report.number_of_openings = 0;
  for (Index node = 0; node < skeleton.size(); ++node) {
    report.number_of_tips += skeleton.degree(node) == 1 ? 1 : 0;
    report.number_of_junctions += skeleton.is_junction(node) ? 1 : 0;
    report.number_of_openings += skeleton[node].is_opening ? 1 : 0;
  }
  internal::warn_of_skeleton(report);
}

} // namespace CSCD

#endif // CSCD_SKELETON_SKELETON_BUILDER_IMPL_H
