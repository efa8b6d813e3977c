// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much the branches of a skeleton matter, from its nodes and radii alone.

#ifndef CSCD_SKELETON_BRANCH_HIERARCHY_H
#define CSCD_SKELETON_BRANCH_HIERARCHY_H

#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Skeleton_graph.h>

#include <boost/range/iterator_range_core.hpp>

#include <vector>

namespace CSCD {
namespace internal {

/// By what branches are pruned.
enum class Branch_measure
{
  significance,      ///< how far the limb reaches beyond the body it stands on, in its mean radii
  length,            ///< along the branch
  length_over_radius ///< the length in mean radii of the branch
};

/// When each edge falls as limbs are cut, the least first.
struct Branch_levels
{
  std::vector<double> levels; ///< for each edge the greatest threshold with which it stays, when what is below is cut
  std::vector<char> is_last;  ///< whether an edge belongs to the path that is left last of a component without cycles
};

/// Cuts the limbs of `skeleton` in thought, the least first.
Branch_levels branch_levels(const Indexed_skeleton& skeleton, Branch_measure measure);

/// The significance of every edge of `skeleton`; infinite for all where nodes have no radii. See
/// `compute_significance()`.
std::vector<double> significance_levels(const Indexed_skeleton& skeleton);

} // namespace internal

/// computes the significance of every branch of a finished skeleton and writes it to its edges: how far the limb
/// reaches beyond the body it stands on, in radii of the limb.
///
/// For a branch of length *l* from a tip of radius *t* to a junction of radius *j*, with the mean radius *m* over what
/// is farther than *j* from the junction along the branch (*t* if nothing is), it is max(0, *l* + *t* - *j*) / *m*: a
/// cylinder that stands out by *h* has about *h* over its radius, a bump 0. Branches are cut in thought, the least
/// first; two that are then alone at a junction are one from then on, at least as significant as what was cut. All
/// edges get what their branch has when it falls. The last branch of a tree, from tip to tip, has (*l* + the radii of
/// both tips) / (2 *m*) - 1, at least 0. Edges on cycles and between cycles are infinitely significant, and so is all
/// that has no radius. So the edges of at least a given significance are those that pruning leaves, besides the last
/// branch of each tree, which always stays; and the figures do not change when the skeleton is moved, turned, scaled or
/// renumbered, or pruned. O(n log n) for n nodes.
/// \tparam Skeleton a `CurveSkeletonGraph` of which the edges have a `significance`, as those of `Skeleton_graph`; of
///         others nothing is changed
/// \pre coordinates and radii are finite
template <class Skeleton>
void compute_significance([[maybe_unused]] Skeleton& skeleton)
{
  if constexpr (has_significance_v<Skeleton>) {
    const internal::Indexed_skeleton indexed = internal::index_skeleton(skeleton);
    const std::vector<double> levels = internal::significance_levels(indexed);
    auto level = levels.begin();
    for (const auto edge : boost::make_iterator_range(edges(skeleton))) {
      skeleton[edge].significance = *level++;
    }
  }
}

} // namespace CSCD

#ifndef CSCD_COMPILED
#include <CSCD/Skeleton/Branch_hierarchy_impl.h>
#endif

#endif // CSCD_SKELETON_BRANCH_HIERARCHY_H
