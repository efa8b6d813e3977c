// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Axis-parallel boxes, and a hierarchy of them for searches in space.

#ifndef CSCD_INTERNAL_BOX_TREE_H
#define CSCD_INTERNAL_BOX_TREE_H

#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The smallest box with sides parallel to the axes around some points; empty without any.
class Bounding_box
{
public:
  Bounding_box() = default;
  /// The box of `points`.
  explicit Bounding_box(const std::vector<Vector3>& points)
  {
    for (const Vector3& point : points) {
      extend(point);
    }
  }

  void extend(const Vector3& point)
  {
    m_min = m_min.cwiseMin(point);
    m_max = m_max.cwiseMax(point);
  }
  void extend(const Bounding_box& other)
  {
    m_min = m_min.cwiseMin(other.m_min);
    m_max = m_max.cwiseMax(other.m_max);
  }

  bool is_empty() const { return m_min.x() > m_max.x(); }
  const Vector3& min() const { return m_min; }
  const Vector3& max() const { return m_max; }
  double diagonal() const { return (m_max - m_min).norm(); }
  double squared_distance(const Vector3& point) const
  {
    return (m_min - point).cwiseMax(point - m_max).cwiseMax(Vector3::Zero()).squaredNorm();
  }

private:
  Vector3 m_min = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 m_max = Vector3::Constant(-std::numeric_limits<double>::infinity());
};

/// A balanced binary tree of boxes over objects, which are known by number. The hierarchies of CGAL and Eigen do the
/// same, but each would be a tenth of the compile time of a file that calls the library.
class Box_tree
{
public:
  Box_tree() = default;
  /// O(n log n).
  /// \param boxes the boxes of the objects
  /// \param max_leaf_size the objects that a leaf may hold: fewer leaves are built faster
  explicit Box_tree(const std::vector<Bounding_box>& boxes, Index max_leaf_size = 1)
      : Box_tree(boxes, all_indices(boxes.size()), max_leaf_size)
  {
  }
  /// The same over some of the objects.
  template <class Range>
  Box_tree(const std::vector<Bounding_box>& boxes, const Range& objects, Index max_leaf_size)
      : m_max_leaf_size(max_leaf_size)
  {
    std::vector<Entry> entries;
    entries.reserve(objects.size());
    for (const Index i : objects) {
      entries.push_back({(boxes[i].min() + boxes[i].max()) / 2, i});
    }
    m_objects.reserve(entries.size());
    m_root = entries.empty() ? no_index : build(boxes, entries, 0, Index(entries.size())).first;
    m_leaf_begin.push_back(Index(m_objects.size()));
  }

  /// Calls `visit(object)` for all objects except in boxes where `must_enter(box)` is false.
  template <class MustEnter, class Visit>
  void visit(const MustEnter& must_enter, const Visit& visit) const
  {
    std::vector<Index> to_do;
    const auto meet = [&](Index child) {
      if (is_leaf(child)) {
        visit_leaf(child, visit);
      } else if (is_node(child) && must_enter(m_boxes[child])) {
        to_do.push_back(child);
      }
    };
    meet(m_root);
    while (!to_do.empty()) {
      const auto [lower, upper] = m_children[to_do.back()];
      to_do.pop_back();
      meet(lower);
      meet(upper);
    }
  }

  /// Calls `visit(object)`, which returns the value of the object, for all objects that can have the least value,
  /// starting in the most promising box.
  /// \param bound `bound(box)` is at most the value of every object in the box
  /// \param least a value that is known already: boxes that cannot have a lesser one are not entered
  template <class Bound, class Visit>
  void minimize(const Bound& bound, const Visit& visit, double least = std::numeric_limits<double>::infinity()) const
  {
    using Bounded_node = std::pair<double, Index>;
    std::priority_queue<Bounded_node, std::vector<Bounded_node>, std::greater<>> to_do;
    const auto meet = [&](const std::array<Index, 2>& children) {
      for (const Index child : children) {
        if (is_leaf(child)) {
          visit_leaf(child, [&](Index object) { least = std::min(least, visit(object)); });
        }
      }
      for (const Index child : children) {
        if (is_node(child)) {
          if (const double value = bound(m_boxes[child]); value < least) {
            to_do.emplace(value, child);
          }
        }
      }
    };
    meet({m_root, no_index});
    while (!to_do.empty() && to_do.top().first < least) {
      const Index node = to_do.top().second;
      to_do.pop();
      meet(m_children[node]);
    }
  }

private:
  struct Entry
  {
    Vector3 center;
    Index object;
  };

  /// Nodes are less than this, leaves are offset by it.
  static constexpr Index first_leaf = Index(1) << 31;

  static bool is_node(Index child) { return child < first_leaf; }
  static bool is_leaf(Index child) { return !is_node(child) && child != no_index; }

  template <class Visit>
  void visit_leaf(Index leaf, const Visit& visit) const
  {
    const Index* const begin = &m_leaf_begin[leaf - first_leaf];
    std::for_each(&m_objects[begin[0]], &m_objects[0] + begin[1], visit);
  }

  static int longest_side(const std::vector<Entry>& entries, Index begin, Index end)
  {
    Bounding_box box;
    for (Index i = begin; i < end; ++i) {
      box.extend(entries[i].center);
    }
    const Vector3 sides = box.max() - box.min();
    return int(std::max_element(sides.begin(), sides.end()) - sides.begin());
  }

  /// Builds the tree over the entries from `begin` to `end` - 1, whose halves lie on both sides of the median center
  /// along the longest side of their box. \return its root, a node or a leaf, and its box
  std::pair<Index, Bounding_box> build(const std::vector<Bounding_box>& boxes, std::vector<Entry>& entries, Index begin,
                                       Index end)
  {
    const Index size = end - begin;
    if (size <= m_max_leaf_size) {
      m_leaf_begin.push_back(Index(m_objects.size()));
      Bounding_box box;
      for (Index i = begin; i < end; ++i) {
        m_objects.push_back(entries[i].object);
        box.extend(boxes[entries[i].object]);
      }
      return {first_leaf + Index(m_leaf_begin.size() - 1), box};
    }
    const Index middle = begin + (size + (size == 3 ? 1 : 0)) / 2;
    if (size > 2) {
      const int axis = longest_side(entries, begin, end);
      std::nth_element(entries.begin() + begin, entries.begin() + middle, entries.begin() + end,
                       [axis](const Entry& a, const Entry& b) { return a.center[axis] < b.center[axis]; });
    }
    const auto [lower, lower_box] = build(boxes, entries, begin, middle);
    auto [upper, box] = build(boxes, entries, middle, end);
    box.extend(lower_box);
    m_boxes.push_back(box);
    m_children.push_back({lower, upper});
    return {Index(m_boxes.size() - 1), box};
  }

  Index m_max_leaf_size = 1;
  std::vector<Bounding_box> m_boxes; // of the inner nodes
  std::vector<std::array<Index, 2>> m_children;
  std::vector<Index> m_objects;    // leaf by leaf
  std::vector<Index> m_leaf_begin; // the place of the first object of every leaf, and their number at the end
  Index m_root = no_index;
};

} // namespace CSCD::internal

#endif // CSCD_INTERNAL_BOX_TREE_H
