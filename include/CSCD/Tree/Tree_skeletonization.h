// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a scan of trees to nodes and branches.

#ifndef CSCD_TREE_TREE_SKELETONIZATION_H
#define CSCD_TREE_TREE_SKELETONIZATION_H

#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Tree/Tree_report.h>
#include <CSCD/Vector_3.h>

#include <optional>
#include <vector>

namespace CSCD::internal {

/// A node of the skeleton of a tree.
struct Tree_node
{
  Vector_3 position;
  double radius;
  Index parent; ///< stands before it; `no_index` for a root
};

/// The skeletons of the objects in a cloud, in the normalized coordinates of its points.
struct Tree_skeleton
{
  std::vector<Tree_node> nodes;
  std::vector<Index> node_of_point; ///< of every point of the cloud
  Tree_report report;               ///< in the unit of the input; without time
};

/// Thins a scan of trees that is denser than its noise allows: between points that are nearer to each other than they
/// are to the bark, there are branches everywhere. Points that are left out are those nearest to them. O(n log n).
Point_cloud thin_to_noise(Point_cloud&& cloud);

/// Skeletonizes a scan of trees; O(n log n).
/// \param root where one of the objects begins; all others begin at their lowest points
Tree_skeleton skeletonize_trees(const Point_cloud& cloud, const std::optional<Vector_3>& root);

} // namespace CSCD::internal

#endif // CSCD_TREE_TREE_SKELETONIZATION_H
