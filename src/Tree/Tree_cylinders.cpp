// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cylinders of limbs, and the foresters' measures of them.

#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Tree/Tree_cylinders.h>
#include <CSCD/Tree/Tree_report.h>
#include <CSCD/Vector3.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CSCD {
namespace internal {
namespace {

/// The volume of a cylinder.
double volume(const Tree_cylinder& cylinder)
{
  return boost::math::double_constants::pi * cylinder.radius * cylinder.radius * cylinder.length;
}

/// The radius of a trunk where it first reaches a height, linear between nodes; not a number if it does not.
double radius_at_height(const Skeleton& skeleton, const std::vector<std::size_t>& trunk, double height)
{
  for (std::size_t i = 1; i < trunk.size(); ++i) {
    const double from = skeleton.points[trunk[i - 1]].z();
    const double to = skeleton.points[trunk[i]].z();
    if (from <= height && height < to) {
      const double part = (height - from) / (to - from);
      return (1 - part) * skeleton.radii[trunk[i - 1]] + part * skeleton.radii[trunk[i]];
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

} // namespace

std::vector<Tree_cylinder> make_tree_cylinders(const Skeleton& skeleton, const Tree_report& report)
{
  std::vector<Tree_cylinder> result;
  std::vector<std::optional<std::size_t>> cylinder_to(skeleton.number_of_nodes()); // that ends in a node
  for (std::size_t limb = 0; limb < report.branches.size(); ++limb) {
    const std::vector<std::size_t>& nodes = report.branches[limb].nodes;
    const bool is_trunk = report.branches[limb].parent == no_branch;
    std::size_t position = 0;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      const bool is_base = i == 1 && !is_trunk;
      const double radius = skeleton.radii[nodes[i]];
      const double radius_before = skeleton.radii[nodes[i - 1]];
      const Vector3 edge = skeleton.points[nodes[i]] - skeleton.points[nodes[i - 1]];
      const double inside = is_base ? radius_before : 0; // a limb begins at the bark of its parent
      cylinder_to[nodes[i]] = cylinder_to[nodes[i - 1]];
      if (!(edge.norm() > inside)) {
        continue;
      }
      Tree_cylinder cylinder;
      cylinder.axis = edge.normalized();
      cylinder.start = skeleton.points[nodes[i - 1]] + inside * cylinder.axis;
      cylinder.length = edge.norm() - inside;
      cylinder.radius = is_base ? radius : (radius_before + radius) / 2;
      cylinder.parent = cylinder_to[nodes[i - 1]];
      cylinder.limb = limb;
      cylinder.position = position++;
      if (cylinder.position > 0) {
        result.back().extension = result.size();
      }
      cylinder_to[nodes[i]] = result.size();
      result.push_back(cylinder);
    }
  }
  return result;
}

std::vector<Tree_measures> measure_trees(const Skeleton& skeleton, const Tree_report& report, double breast_height)
{
  std::vector<Tree_measures> result(report.number_of_objects);
  std::vector<double> foot(report.number_of_objects, 0);
  for (const Tree_branch& limb : report.branches) { // parents before children
    Tree_measures& tree = result[limb.object];
    if (limb.parent == no_branch) {
      foot[limb.object] = skeleton.points[limb.nodes.front()].z();
      tree.diameter_at_breast_height = 2 * radius_at_height(skeleton, limb.nodes, foot[limb.object] + breast_height);
    }
    tree.length += limb.length;
    for (const std::size_t node : limb.nodes) {
      tree.height = std::max(tree.height, skeleton.points[node].z() - foot[limb.object]);
    }
  }
  for (const Tree_cylinder& cylinder : make_tree_cylinders(skeleton, report)) {
    const Tree_branch& limb = report.branches[cylinder.limb];
    result[limb.object].volume += volume(cylinder);
    result[limb.object].trunk_volume += limb.parent == no_branch ? volume(cylinder) : 0;
  }
  return result;
}

} // namespace internal

void assign_limbs(const Tree_report& report, Skeleton_branches& branches)
{
  std::vector<std::size_t> limb_of_node(branches.branch_of_node.size(), 0);
  for (std::size_t limb = report.branches.size(); limb-- > 0;) {
    const Tree_branch& branch = report.branches[limb];
    for (std::size_t i = branch.parent == no_branch ? 0 : 1; i < branch.nodes.size(); ++i) {
      limb_of_node[branch.nodes[i]] = limb;
    }
  }
  for (Skeleton_branch& branch : branches.branches) {
    branch.limb = limb_of_node[branch.nodes.back()];
  }
}

} // namespace CSCD
