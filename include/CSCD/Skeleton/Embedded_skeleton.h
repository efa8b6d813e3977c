// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The skeleton of a surface before it is written to the user's graph.

#ifndef CSCD_SKELETON_EMBEDDED_SKELETON_H
#define CSCD_SKELETON_EMBEDDED_SKELETON_H

#include <CSCD/Skeleton/Skeleton_draft.h>
#include <CSCD/internal/Vector_3.h>

#include <vector>

namespace CSCD {

/// Nodes and edges in the normalized frame of the traits object, and what of the surface belongs to each node.
struct Embedded_skeleton
{
  /// Nodes and edges; none is removed.
  internal::Skeleton_draft draft;
  /// For each site, the node to which it belongs.
  std::vector<internal::Index> node_of_site;
  /// For each node, the radius of the body around it.
  std::vector<double> radius;
};

} // namespace CSCD

#endif // CSCD_SKELETON_EMBEDDED_SKELETON_H
