// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The skeleton of a scan of trees as cylinders, and what foresters measure.

#ifndef CSCD_TREE_TREE_CYLINDERS_H
#define CSCD_TREE_TREE_CYLINDERS_H

#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Tree/Tree_report.h>
#include <CSCD/Vector_3.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CSCD {

/// A cylinder of a quantitative structure model: a piece of a limb between two nodes. Lengths are in the unit of the
/// skeleton, indices are counted from 0.
struct Tree_cylinder
{
  Vector_3 start;                         ///< the end nearer to the root, on the axis
  Vector_3 axis;                          ///< away from the root, unit length
  double length = 0;                      ///< along the axis
  double radius = 0;                      ///< mean of both nodes
  std::optional<std::size_t> parent{};    ///< the cylinder before it; none for the first of a trunk
  std::optional<std::size_t> extension{}; ///< the cylinder after it in its limb; none for the last
  std::size_t limb = 0;                   ///< the `Tree_branch`
  std::size_t position = 0;               ///< in its limb
};

/// What foresters measure of one object of a scan, in the unit of the skeleton. The third coordinate is the height.
struct Tree_measures
{
  double height = 0;       ///< of the highest node above the root
  double length = 0;       ///< of all limbs
  double volume = 0;       ///< of all cylinders
  double trunk_volume = 0; ///< of those of the trunk
  /// Twice the radius of the trunk at breast height above the root; not a number if the trunk does not reach it.
  double diameter_at_breast_height = std::numeric_limits<double>::quiet_NaN();
};

/// The height above the root at which the diameter of a trunk is measured in most countries, in meters.
inline constexpr double default_breast_height = 1.3;

namespace internal {

/// The volume of a cylinder.
inline double volume(const Tree_cylinder& cylinder)
{
  return boost::math::double_constants::pi * cylinder.radius * cylinder.radius * cylinder.length;
}

inline std::vector<Tree_cylinder> make_tree_cylinders(const Indexed_skeleton& skeleton, const Tree_report& report)
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
      const Vector_3 edge = skeleton.points[nodes[i]] - skeleton.points[nodes[i - 1]];
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

/// The radius of a trunk where it first reaches a height, linear between nodes; not a number if it does not.
inline double radius_at_height(const Indexed_skeleton& skeleton, const std::vector<std::size_t>& trunk, double height)
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

inline std::vector<Tree_measures> measure_trees(const Indexed_skeleton& skeleton, const Tree_report& report,
                                                double breast_height)
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

/// writes to each branch of the skeleton of a scan of trees of which limb it is a part: that along its last edge.
/// Linear.
/// \param report what `extract_tree_skeleton()` returned
/// \param branches of the same skeleton, as `measure_branches()` gives them
inline void assign_limbs(const Tree_report& report, Skeleton_branches& branches)
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

/// makes cylinders of the limbs of a scan of trees, those of a limb one after the other, parents before children. A
/// limb begins at the bark of its parent. Linear.
/// \tparam Skeleton a model of `CurveSkeletonGraph` whose nodes have a radius, as `extract_tree_skeleton()` wrote it
/// \param report what `extract_tree_skeleton()` returned
template <class Skeleton>
std::vector<Tree_cylinder> make_tree_cylinders(const Skeleton& skeleton, const Tree_report& report)
{
  return internal::make_tree_cylinders(internal::index_skeleton(skeleton), report);
}

/// measures each object of a scan of trees, in the order of their numbers. Linear.
/// \tparam Skeleton a model of `CurveSkeletonGraph` whose nodes have a radius, as `extract_tree_skeleton()` wrote it
/// \param report what `extract_tree_skeleton()` returned
/// \param breast_height in the unit of the skeleton
template <class Skeleton>
std::vector<Tree_measures> measure_trees(const Skeleton& skeleton, const Tree_report& report,
                                         double breast_height = default_breast_height)
{
  return internal::measure_trees(internal::index_skeleton(skeleton), report, breast_height);
}

} // namespace CSCD

#endif // CSCD_TREE_TREE_CYLINDERS_H
