// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nodes and branches of the skeleton of a tree.

#ifndef CSCD_TREE_TREE_NODES_H
#define CSCD_TREE_TREE_NODES_H

#include <CSCD/Tree/Limb.h>
#include <CSCD/Tree/Tree_report.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// A node of the skeleton of a tree.
struct Tree_node
{
  Vector_3 position;
  double radius;
  Index parent; ///< stands before it; `no_index` for a root
};

/// Makes a node of each section of a limb, one where a trunk begins, and one at the tip of each limb.
class Tree_nodes
{
public:
  Tree_nodes(const std::vector<Vector_3>& points, const std::vector<Slice>& slices,
             const std::vector<Section>& sections, const std::vector<Limb>& limbs)
      : m_points(points), m_slices(slices), m_sections(sections), m_node_of_slice(slices.size(), no_index)
  {
    for (const Limb& limb : limbs) {
      add(limb);
    }
    find_strahler_orders();
  }

  /// Parents first, and each branch in one piece.
  const std::vector<Tree_node>& nodes() const { return m_nodes; }
  /// One for each limb; lengths are in the unit of the points, objects are not named.
  const std::vector<Tree_branch>& branches() const { return m_branches; }
  /// The node of a slice of a limb.
  Index node(Index slice) const { return m_node_of_slice[slice]; }
  /// How many sections had which outcome.
  const std::array<std::size_t, number_of_circle_outcomes>& number_of_outcomes() const { return m_number_of_outcomes; }

private:
  /// The least distance of an end from the next center, relative to the spacing of the points.
  static constexpr double min_end = 0.1;
  /// How far along its parent a joint is moved, relative to the radius of the parent.
  static constexpr double farthest_move = 3;
  /// The nodes from which the line of a branch is told.
  static constexpr std::size_t line_nodes = 4;

  void add(const Limb& limb)
  {
    Tree_branch branch;
    if (limb.joint != no_index) {
      branch.parent = limb.parent;
      branch.order = m_branches[limb.parent].order + 1;
      branch.nodes.push_back(m_node_of_slice[limb.joint]);
    } else {
      add_end(limb.slices.front(), -1, branch);
    }
    for (Index slice : limb.slices) {
      const Section& section = m_sections[slice];
      add_node(section.center, section.radius, branch);
      m_node_of_slice[slice] = Index(m_nodes.size() - 1);
      branch.number_of_circles += section.is_circle() ? 1 : 0;
      ++m_number_of_outcomes[std::size_t(section.outcome)];
    }
    branch.number_of_sections = limb.slices.size();
    add_end(limb.slices.back(), 1, branch);
    if (limb.joint != no_index) {
      move_joint(branch);
    }
    branch.radius_at_base = m_sections[limb.slices.front()].radius;
    branch.radius_at_tip = m_nodes[branch.nodes.back()].radius;
    for (std::size_t i = 1; i < branch.nodes.size(); ++i) {
      branch.length += (m_nodes[branch.nodes[i]].position - m_nodes[branch.nodes[i - 1]].position).norm();
    }
    m_branches.push_back(std::move(branch));
  }

  void add_node(const Vector_3& position, double radius, Tree_branch& branch)
  {
    m_nodes.push_back({position, radius, branch.nodes.empty() ? no_index : Index(branch.nodes.back())});
    branch.nodes.push_back(m_nodes.size() - 1);
  }

  /// Adds a node where the axis leaves the points of a slice, backward or forward.
  void add_end(Index slice, int sense, Tree_branch& branch)
  {
    const Section& section = m_sections[slice];
    double farthest = 0;
    for (Index point : m_slices[slice].points) {
      farthest = std::max(farthest, sense * (m_points[point] - section.center).dot(section.direction));
    }
    if (farthest > min_end * m_slices[slice].spacing) {
      add_node(section.center + sense * farthest * section.direction, section.radius, branch);
    }
  }

  /// Moves the joint of a branch along its parent to where the line of its first nodes points: slices of limbs fall
  /// apart in the crotch, beyond the place where their axes meet.
  void move_joint(Tree_branch& branch)
  {
    const Vector_3 base = m_nodes[branch.nodes[1]].position;
    const Vector_3 far = m_nodes[branch.nodes[std::min(branch.nodes.size() - 1, line_nodes)]].position;
    if (far == base) {
      return;
    }
    const Vector_3 direction = (far - base).normalized();
    const Tree_branch& parent = m_branches[branch.parent];
    const Tree_node& old_joint = m_nodes[branch.nodes.front()];
    double least = std::numeric_limits<double>::max();
    std::size_t joint = branch.nodes.front();
    // The first node of a branch belongs to another one.
    for (std::size_t i = parent.parent == no_branch ? 0 : 1; i < parent.nodes.size(); ++i) {
      const Vector_3& place = m_nodes[parent.nodes[i]].position;
      if ((place - old_joint.position).norm() > farthest_move * old_joint.radius) {
        continue;
      }
      const Vector_3 d = place - base;
      const double distance = d.cross(direction).norm() + std::max(0., d.dot(direction));
      if (distance < least) {
        least = distance;
        joint = parent.nodes[i];
      }
    }
    branch.nodes.front() = joint;
    m_nodes[branch.nodes[1]].parent = Index(joint);
  }

  /// Horton's orders as of Strahler, from tips to bases.
  void find_strahler_orders()
  {
    std::vector<std::size_t> order_at_node(m_nodes.size(), 0); // the highest of the branches that begin there
    for (std::size_t b = m_branches.size(); b-- > 0;) {
      Tree_branch& branch = m_branches[b];
      branch.strahler_order = 1;
      for (std::size_t i = branch.nodes.size(); i-- > (branch.parent == no_branch ? 0u : 1u);) {
        const std::size_t joining = order_at_node[branch.nodes[i]];
        branch.strahler_order =
            joining == branch.strahler_order ? joining + 1 : std::max(joining, branch.strahler_order);
      }
      if (branch.parent != no_branch) {
        // Two of an order that begin at one node are one of the next.
        std::size_t& order = order_at_node[branch.nodes.front()];
        order = order == branch.strahler_order ? order + 1 : std::max(order, branch.strahler_order);
      }
    }
  }

  const std::vector<Vector_3>& m_points;
  const std::vector<Slice>& m_slices;
  const std::vector<Section>& m_sections;
  std::vector<Index> m_node_of_slice;
  std::vector<Tree_node> m_nodes;
  std::vector<Tree_branch> m_branches;
  std::array<std::size_t, number_of_circle_outcomes> m_number_of_outcomes{};
};

} // namespace CSCD::internal

#endif // CSCD_TREE_TREE_NODES_H
