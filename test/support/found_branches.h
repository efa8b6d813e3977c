// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The branches of the skeleton of a tree, for the comparison with the known tree.

#ifndef CSCD_TEST_SUPPORT_FOUND_BRANCHES_H
#define CSCD_TEST_SUPPORT_FOUND_BRANCHES_H

#include "Tree_match.h"
#include <CSCD/Tree/Tree_report.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::test {

/// \tparam Skeleton a `Skeleton_graph`
template <class Skeleton>
std::vector<Found_branch> found_branches(const Skeleton& skeleton, const Tree_report& report)
{
  std::vector<Found_branch> result;
  for (const Tree_branch& branch : report.branches) {
    Found_branch found;
    for (const std::size_t node : branch.nodes) {
      const auto& p = skeleton[node].point;
      found.axis.push_back({p.x(), p.y(), p.z()});
      found.radii.push_back(skeleton[node].radius);
    }
    if (branch.parent != no_branch) {
      found.parent = branch.parent;
    }
    found.order = branch.order;
    result.push_back(std::move(found));
  }
  return result;
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_FOUND_BRANCHES_H
