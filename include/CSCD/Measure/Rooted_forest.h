// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Roots of a skeleton, and the forest that grows from them.

#ifndef CSCD_MEASURE_ROOTED_FOREST_H
#define CSCD_MEASURE_ROOTED_FOREST_H

#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Vector3.h>

#include <array>
#include <vector>

namespace CSCD {

/// Which node of each component of a skeleton is its root.
enum class Root_rule
{
  thickest, ///< the node of the greatest radius
  lowest,   ///< the node of the least third coordinate
  longest   ///< of both ends of the longest path the thicker one; cycles count as if they were cut where they are
            ///< thinnest
};

namespace internal {

/// A spanning forest of a skeleton, each tree grown depth first from its root, and the edges that it leaves out: every
/// cycle is cut at its thinnest edge. O(n log n).
class Rooted_forest
{
public:
  /// \param roots come first; components without any begin at their first node. More than one of a component is one too
  ///        many: the first counts
  explicit Rooted_forest(const Skeleton& skeleton, const std::vector<Index>& roots = {});

  /// All nodes, each after its parent and each branch in one piece.
  const std::vector<Index>& order() const { return m_order; }
  /// The parent of `node`; a root is its own.
  Index parent(Index node) const { return m_parent[node]; }
  bool is_root(Index node) const { return m_parent[node] == node; }
  /// The root of the tree of `node`.
  Index root(Index node) const { return m_root[node]; }
  /// The edges that are not in the forest; each of them closes a cycle.
  const std::vector<std::array<Index, 2>>& loops() const { return m_loops; }

private:
  /// Takes edges, the thickest first, as long as they close no cycle. \return the neighbors of each node by these
  std::vector<std::vector<Index>> cut_cycles(const Skeleton& skeleton);
  void grow_from(Index root, const std::vector<std::vector<Index>>& neighbors);

  std::vector<Index> m_parent;
  std::vector<Index> m_root;
  std::vector<Index> m_order;
  std::vector<std::array<Index, 2>> m_loops;
};

std::vector<Index> find_roots(const Skeleton& skeleton, Root_rule rule);
std::vector<Index> find_roots(const Skeleton& skeleton, const Vector3& point);

} // namespace internal

/// chooses a root in each component of `skeleton`.
/// O(n log n) for n nodes.
/// \tparam Skeleton a model of `CurveSkeletonGraph`
/// \return the numbers of the roots, nodes counted from 0 in the order of the graph
/// \throw Input_error if the thickest nodes are asked for and the nodes have no radius
template <class Skeleton>
std::vector<Index> find_roots(const Skeleton& skeleton, Root_rule rule)
{
  return internal::find_roots(internal::index_skeleton(skeleton), rule);
}

/// chooses in each component of `skeleton` the node that is nearest to `point` as its root.
/// O(n log n) for n nodes.
/// \tparam Skeleton a model of `CurveSkeletonGraph`
/// \tparam Point a type with coordinates `x()`, `y()`, `z()`
/// \return the numbers of the roots, nodes counted from 0 in the order of the graph
template <class Skeleton, class Point>
std::vector<Index> find_roots(const Skeleton& skeleton, const Point& point)
{
  return internal::find_roots(internal::index_skeleton(skeleton), internal::to_vector_3(point));
}

} // namespace CSCD

#endif // CSCD_MEASURE_ROOTED_FOREST_H
