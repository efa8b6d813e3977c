// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A skeleton in the making.

#ifndef CSCD_SKELETON_SKELETON_BUILDER_H
#define CSCD_SKELETON_SKELETON_BUILDER_H

#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton/Branch_hierarchy.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CSCD {

namespace internal {

/// A ball in the body, or a disc across a branch.
struct Ball
{
  Vector3 center = Vector3::Zero();
  double radius = 0;
};

} // namespace internal

/// Nodes and edges that can be inserted, merged and removed, in the normalized frame of the traits object.
/// Parallel edges and loops may occur in between.
class Skeleton_builder
{
public:
  /// A node of the skeleton.
  struct Node
  {
    /// In the coordinates of the surface.
    Vector3 position = Vector3::Zero();
    /// Radius of the body around the node.
    double radius = 0;
    /// The pieces of the cut surface, or the regions of packed separators, whose vertices may belong to the node.
    std::vector<Index> pieces;
    /// Adjacent nodes; a node that is adjacent by two edges stands twice.
    std::vector<Index> neighbors;
    /// The component of the surface that the node is in; `no_index` where queries do not tell components apart.
    Index component = no_index;
    /// Whether the node is in the middle of a border of the input where a limb ends; its radius is that of the border.
    bool is_opening = false;
    /// Whether the node lies in the middle of a sheet, which has no inside to be centered in.
    bool is_on_sheet = false;
    /// About how many vertices of the surface belong to the node; 0 where that was not counted.
    double number_of_vertices = 0;
    /// The node that it was merged into; `no_index` unless it was.
    Index heir = no_index;

    /// Whether the node was merged into another one.
    bool is_removed() const { return heir != no_index; }
  };

  /// Adds a node without edges. \return its number
  Index add_node(const Vector3& position, double radius)
  {
    m_nodes.emplace_back();
    m_nodes.back().position = position;
    m_nodes.back().radius = radius;
    return Index(m_nodes.size() - 1);
  }

  /// Adds an edge.
  void add_edge(Index a, Index b)
  {
    m_nodes[a].neighbors.push_back(b);
    m_nodes[b].neighbors.push_back(a);
  }

  /// Replaces one edge between `a` and `b` by a path over the new node at `position`. \return the new node
  Index split_edge(Index a, Index b, const Vector3& position, double radius)
  {
    const Index node = add_node(position, radius);
    replace_one(m_nodes[a].neighbors, b, node);
    replace_one(m_nodes[b].neighbors, a, node);
    m_nodes[node].neighbors = {a, b};
    m_nodes[node].is_on_sheet = m_nodes[a].is_on_sheet;
    m_nodes[node].component = m_nodes[a].component;
    return node;
  }

  /// Adds a node that is joined to `from`, and on its sheet. \return its number
  Index extend(Index from, const Vector3& position, double radius)
  {
    const Index node = add_node(position, radius);
    m_nodes[node].is_on_sheet = m_nodes[from].is_on_sheet;
    m_nodes[node].component = m_nodes[from].component;
    add_edge(from, node);
    return node;
  }

  /// Removes `node`, of degree 2, and joins its neighbors.
  void bypass(Index node)
  {
    const Index a = m_nodes[node].neighbors[0];
    const Index b = m_nodes[node].neighbors[1];
    replace_one(m_nodes[a].neighbors, node, b);
    replace_one(m_nodes[b].neighbors, node, a);
    remove(node, a);
  }

  /// Joins `node` to `into`: edges between the two disappear, all others move.
  /// \pre `node` has no loop
  void contract(Index node, Index into)
  {
    std::vector<Index>& kept = m_nodes[into].neighbors;
    kept.erase(std::remove(kept.begin(), kept.end(), node), kept.end());
    for (Index neighbor : m_nodes[node].neighbors) {
      CGAL_precondition(neighbor != node);
      if (neighbor != into) {
        replace_one(m_nodes[neighbor].neighbors, node, into);
        kept.push_back(neighbor);
      }
    }
    remove(node, into);
  }

  /// The number of nodes.
  Index size() const { return Index(m_nodes.size()); }
  /// The node of number `node`.
  Node& operator[](Index node) { return m_nodes[node]; }
  /// The node of number `node`.
  const Node& operator[](Index node) const { return m_nodes[node]; }
  /// The node that stands for `node` now: itself, or the one that it was merged into.
  Index last_heir(Index node) const
  {
    while (m_nodes[node].is_removed()) {
      node = m_nodes[node].heir;
    }
    return node;
  }
  /// The number of edges at `node`.
  std::size_t degree(Index node) const { return m_nodes[node].neighbors.size(); }

  /// Whether `node` is inside a branch.
  bool is_regular(Index node) const { return degree(node) == 2; }
  /// Whether `node` has three edges or more.
  bool is_junction(Index node) const { return degree(node) >= 3; }

  /// The neighbor across the regular `node` from its `neighbor`, to follow branches.
  Index other_neighbor(Index node, Index neighbor) const
  {
    const std::vector<Index>& neighbors = m_nodes[node].neighbors;
    return neighbors[0] == neighbor ? neighbors[1] : neighbors[0];
  }

  /// The length of the edge from `a` to `b`.
  double edge_length(Index a, Index b) const { return (m_nodes[a].position - m_nodes[b].position).norm(); }

  /// The middle of the nodes that are adjacent to `node`. \pre it has one
  Vector3 middle_of_neighbors(Index node) const
  {
    Vector3 sum = Vector3::Zero();
    for (Index neighbor : m_nodes[node].neighbors) {
      sum += m_nodes[neighbor].position;
    }
    return sum / double(degree(node));
  }

  /// Whether the graph stays simple if the regular `node` is bypassed.
  bool is_bypassable(Index node) const
  {
    const Index a = m_nodes[node].neighbors[0];
    const Index b = m_nodes[node].neighbors[1];
    const std::vector<Index>& around = m_nodes[a].neighbors;
    return a != b && std::find(around.begin(), around.end(), b) == around.end();
  }

  /// All edges in a fixed order, as two adjacent nodes, the smaller number first. A loop of one node counts once.
  std::vector<std::array<Index, 2>> edges() const
  {
    std::vector<std::array<Index, 2>> result;
    for (Index a = 0; a < m_nodes.size(); ++a) {
      std::size_t loop_ends = 0;
      for (Index b : m_nodes[a].neighbors) {
        if (a < b || (a == b && ++loop_ends % 2 == 1)) {
          result.push_back({a, b});
        }
      }
    }
    return result;
  }

  /// Drops the removed nodes; the others are renumbered in order. \return their old numbers
  std::vector<Index> compact()
  {
    std::vector<Index> kept;
    std::vector<Index> number(m_nodes.size(), no_index);
    for (Index node = 0; node < m_nodes.size(); ++node) {
      if (!m_nodes[node].is_removed()) {
        number[node] = Index(kept.size());
        kept.push_back(node);
      }
    }
    m_nodes = internal::reordered(m_nodes, kept);
    for (Node& node : m_nodes) {
      for (Index& neighbor : node.neighbors) {
        neighbor = number[neighbor];
      }
    }
    return kept;
  }

private:
  /// Marks `node` as removed; no neighbor refers to it any more. `heir` gets its pieces.
  void remove(Index node, Index heir)
  {
    std::vector<Index>& pieces = m_nodes[heir].pieces;
    pieces.insert(pieces.end(), m_nodes[node].pieces.begin(), m_nodes[node].pieces.end());
    m_nodes[node] = Node();
    m_nodes[node].heir = heir;
  }

  static void replace_one(std::vector<Index>& list, Index old_value, Index new_value)
  {
    *std::find(list.begin(), list.end(), old_value) = new_value;
  }

  std::vector<Node> m_nodes;
};

/// Nodes and edges in the normalized frame of the traits object, and the part of the surface that belongs to each node.
struct Embedded_skeleton
{
  /// Nodes and edges; none is removed.
  Skeleton_builder graph;
  /// For each vertex of the surface, the node that it belongs to.
  std::vector<Index> node_of_vertex;
  /// For each node, the radius of the body around it.
  std::vector<double> radius;
};

/// Divides loops and all but one of parallel edges by further nodes, so that every cycle has at least three nodes.
/// A divided edge is bent aside, since its two ends may lie in one place or be joined by a straight edge already.
inline void make_simple(Skeleton_builder& builder)
{
  for (const auto& [a, b] : builder.edges()) {
    const double radius = (builder[a].radius + builder[b].radius) / 2;
    const Vector3 along = builder[b].position - builder[a].position;
    const std::vector<Index>& neighbors = builder[a].neighbors;
    if (a == b) {
      const Index first = builder.split_edge(a, a, builder[a].position + radius * Vector3::UnitX() / 2, radius);
      builder.split_edge(first, a, builder[a].position + radius * Vector3::UnitY() / 2, radius);
    } else if (std::count(neighbors.begin(), neighbors.end(), b) > 1) {
      const Vector3 aside = along.norm() > 0 ? Vector3(along.unitOrthogonal()) : Vector3(Vector3::UnitX());
      builder.split_edge(a, b, builder[a].position + along / 2 + radius / 2 * aside, radius);
    }
  }
}

/// Writes the counts of `skeleton` to `report`, and warnings of its faults. \pre no node is removed
inline void describe_skeleton(const Skeleton_builder& skeleton, Skeletonization_report& report)
{
  const auto edges = skeleton.edges();
  internal::Disjoint_sets components(skeleton.size(), edges);
  report.number_of_nodes = skeleton.size();
  report.number_of_edges = edges.size();
  report.number_of_skeleton_components = 0;
  report.number_of_tips = 0;
  report.number_of_junctions = 0;
  report.number_of_openings = 0;
  for (Index node = 0; node < skeleton.size(); ++node) {
    report.number_of_skeleton_components += components.find(node) == node ? 1 : 0;
    report.number_of_tips += skeleton.degree(node) == 1 ? 1 : 0;
    report.number_of_junctions += skeleton.is_junction(node) ? 1 : 0;
    report.number_of_openings += skeleton[node].is_opening ? 1 : 0;
  }
  report.betti_number = report.number_of_edges + report.number_of_skeleton_components - report.number_of_nodes;
  using internal::counted;
  if (report.genus && report.betti_number != *report.genus) {
    report.warnings.push_back("the skeleton has " + counted(report.betti_number, "independent cycle") +
                              ", the surface " + counted(*report.genus, "handle"));
  }
  const std::size_t nodes = report.number_of_nodes_outside;
  const std::size_t edges_outside = report.number_of_edges_outside;
  if (nodes + edges_outside > 0) {
    report.warnings.push_back((nodes > 0 ? counted(nodes, "node") : std::string()) +
                              (nodes > 0 && edges_outside > 0 ? " and " : "") +
                              (edges_outside > 0 ? counted(edges_outside, "edge") : std::string()) +
                              (nodes + edges_outside == 1 ? " is" : " are") + " not wholly inside the body");
  }
}

namespace internal {

/// The skeleton `embedded` in the coordinates of the input.
/// \param for_each_input_vertex `for_each_input_vertex(v, add)` calls `add(number)` for the vertices of the input that
///        vertex `v` of the surface represents
template <class ForEachInputVertex>
Skeleton to_input(const Embedded_skeleton& embedded, const Normalization& normalization,
                  const ForEachInputVertex& for_each_input_vertex)
{
  const Skeleton_builder& builder = embedded.graph;
  Skeleton result;
  for (Index node = 0; node < builder.size(); ++node) {
    result.points.push_back(normalization.to_input(builder[node].position));
    result.radii.push_back(embedded.radius[node] * normalization.unit);
    result.is_opening.push_back(builder[node].is_opening ? 1 : 0);
  }
  result.edges = builder.edges();
  result.is_joined.assign(result.edges.size(), 0);
  result.significance = significance_levels(result);
  result.vertices.resize(builder.size());
  for (Index vertex = 0; vertex < embedded.node_of_vertex.size(); ++vertex) {
    std::vector<Index>& of_node = result.vertices[embedded.node_of_vertex[vertex]];
    for_each_input_vertex(vertex, [&of_node](Index number) { of_node.push_back(number); });
  }
  return result;
}

} // namespace internal
} // namespace CSCD

#endif // CSCD_SKELETON_SKELETON_BUILDER_H
