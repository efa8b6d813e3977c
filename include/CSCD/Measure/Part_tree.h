// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A search structure for objects that meet in one place, such as the edges around a hub.

#ifndef CSCD_MEASURE_PART_TREE_H
#define CSCD_MEASURE_PART_TREE_H

#include <CSCD/Vector_3.h>
#include <CSCD/internal/Box_tree.h>

#include <CGAL/assertions.h>

#include <boost/random/mersenne_twister.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Objects 0 to `number` - 1 in an order that has nothing to do with their numbers, always the same: those before a
/// place stand for all, where all would be too much work.
inline std::vector<Index> in_random_order(std::size_t number)
{
  std::vector<Index> order(number);
  std::iota(order.begin(), order.end(), Index(0));
  boost::random::mt19937 generator;
  for (std::size_t i = number; i > 1; --i) {
    std::swap(order[i - 1], order[generator() % i]);
  }
  return order;
}

/// A balanced binary tree over objects of several parts, such as the two ends of a segment. A node has a box for each
/// part, and objects are divided where the places of one part differ most. So objects that share one part are told
/// apart by the others, where one box around everything, as in `Box_tree`, would tell nothing. Objects can be removed.
template <std::size_t NumberOfParts>
class Part_tree
{
public:
  using Parts = std::array<Bounding_box, NumberOfParts>;

  /// A node: the root is node 0, and children have greater numbers than their parent.
  struct Node
  {
    Parts boxes{};
    Index parent = no_index;
    Index second_child = no_index; ///< the first follows its parent; `no_index` for a leaf
    Index begin = 0, end = 0;      ///< of the objects of a leaf that are left, as positions in `objects()`
    Index first_object = no_index; ///< the least number of an object that is left
  };

  /// An object, and its value.
  struct Candidate
  {
    double value = std::numeric_limits<double>::infinity();
    Index object = no_index;
  };

  /// Where a search ends before it has seen all that could be less.
  struct Limits
  {
    std::size_t max_number_of_nodes = std::numeric_limits<std::size_t>::max(); ///< that are looked into, at least 64
    double enough = -std::numeric_limits<double>::infinity(); ///< a value up to this need not be the least
    std::size_t* work = nullptr; ///< to which the number of nodes that were looked into is added
  };

  /// O(n log n).
  explicit Part_tree(const std::vector<Parts>& objects) : m_objects(objects.size()), m_leaf(objects.size(), no_index)
  {
    std::iota(m_objects.begin(), m_objects.end(), Index(0));
    if (!objects.empty()) {
      build(objects, 0, Index(objects.size()), no_index);
    }
  }

  const std::vector<Node>& nodes() const { return m_nodes; }
  const std::vector<Index>& objects() const { return m_objects; }

  /// The object of least value among those that are left, on ties the one with the least number.
  /// \param bound `bound(n)` is at most the value of every object of node number n
  /// \param value `value(object, least)` is the value of an object if it is at most `least`, and else greater than that
  /// \param best what has to be surpassed: without an object, an equal value surpasses it
  /// \param limits of the search, which goes to the nearest first: what it has found then is near, if not the least
  template <class Bound, class Value>
  Candidate minimize(const Bound& bound, const Value& value, Candidate best = {}, const Limits& limits = {}) const
  {
    constexpr std::size_t max_depth = 64; // of a balanced tree over 32-bit numbers, with room
    std::array<std::pair<double, Index>, max_depth> to_do;
    std::size_t number_to_do = 0;
    if (!m_nodes.empty()) {
      to_do[number_to_do++] = {-std::numeric_limits<double>::infinity(), 0};
    }
    std::size_t number_of_nodes = 0; // that were looked into
    while (number_to_do > 0 && number_of_nodes < limits.max_number_of_nodes && best.value > limits.enough) {
      const auto [least, n] = to_do[--number_to_do];
      const Node& node = m_nodes[n];
      if (!surpasses(least, node.first_object, best)) {
        continue;
      }
      ++number_of_nodes;
      if (node.second_child == no_index) {
        for (Index i = node.begin; i < node.end; ++i) {
          if (const Candidate candidate{value(m_objects[i], best.value), m_objects[i]};
              surpasses(candidate.value, candidate.object, best)) {
            best = candidate;
          }
        }
      } else {
        std::pair<double, Index> nearer{bound(n + 1), n + 1};
        std::pair<double, Index> farther{bound(node.second_child), node.second_child};
        if (farther.first < nearer.first) {
          std::swap(nearer, farther);
        }
        to_do[number_to_do++] = farther;
        to_do[number_to_do++] = nearer;
      }
    }
    if (limits.work != nullptr) {
      *limits.work += number_of_nodes;
    }
    return best;
  }

  /// Removes an object. O(log n).
  /// \pre it has not been removed
  void remove(Index object)
  {
    Node& leaf = m_nodes[m_leaf[object]];
    const auto place = std::find(m_objects.begin() + leaf.begin, m_objects.begin() + leaf.end, object);
    CGAL_precondition(place != m_objects.begin() + leaf.end);
    std::swap(*place, m_objects[--leaf.end]);
    for (Index n = m_leaf[object]; n != no_index; n = m_nodes[n].parent) {
      update_first_object(n);
    }
  }

private:
  static bool surpasses(double value, Index object, const Candidate& best)
  {
    return object != no_index && (value < best.value || (value == best.value && object < best.object));
  }

  void update_first_object(Index n)
  {
    Node& node = m_nodes[n];
    if (node.second_child != no_index) {
      node.first_object = std::min(m_nodes[n + 1].first_object, m_nodes[node.second_child].first_object);
      return;
    }
    node.first_object = no_index;
    for (Index i = node.begin; i < node.end; ++i) {
      node.first_object = std::min(node.first_object, m_objects[i]);
    }
  }

  static double center(const Bounding_box& box, int axis) { return (box.min()[axis] + box.max()[axis]) / 2; }

  /// The part and the axis along which the centers of a range of objects differ most.
  std::pair<std::size_t, int> widest_direction(const std::vector<Parts>& objects, Index begin, Index end) const
  {
    std::array<Bounding_box, NumberOfParts> centers;
    for (Index i = begin; i < end; ++i) {
      for (std::size_t part = 0; part < NumberOfParts; ++part) {
        const Bounding_box& box = objects[m_objects[i]][part];
        centers[part].extend(Vector_3(center(box, 0), center(box, 1), center(box, 2)));
      }
    }
    std::pair<std::size_t, int> widest{0, 0};
    double greatest = -1;
    for (std::size_t part = 0; part < NumberOfParts; ++part) {
      const Vector_3 sides = centers[part].max() - centers[part].min();
      for (int axis = 0; axis < 3; ++axis) {
        if (sides[axis] > greatest) {
          greatest = sides[axis];
          widest = {part, axis};
        }
      }
    }
    return widest;
  }

  void build(const std::vector<Parts>& objects, Index begin, Index end, Index parent)
  {
    constexpr Index max_leaf_size = 4; // as fast as less, with a fourth of the nodes
    const auto number = Index(m_nodes.size());
    Node node;
    node.parent = parent;
    node.begin = begin;
    node.end = end;
    for (Index i = begin; i < end; ++i) {
      for (std::size_t part = 0; part < NumberOfParts; ++part) {
        node.boxes[part].extend(objects[m_objects[i]][part]);
      }
      node.first_object = std::min(node.first_object, m_objects[i]);
    }
    m_nodes.push_back(node);
    if (end - begin <= max_leaf_size) {
      std::for_each(m_objects.begin() + begin, m_objects.begin() + end, [&](Index i) { m_leaf[i] = number; });
      return;
    }
    const Index middle = begin + (end - begin) / 2;
    const auto [part, axis] = widest_direction(objects, begin, end);
    std::nth_element(m_objects.begin() + begin, m_objects.begin() + middle, m_objects.begin() + end,
                     [&objects, part = part, axis = axis](Index a, Index b) {
                       return center(objects[a][part], axis) < center(objects[b][part], axis);
                     });
    build(objects, begin, middle, number);
    m_nodes[number].second_child = Index(m_nodes.size());
    build(objects, middle, end, number);
  }

  std::vector<Node> m_nodes;
  std::vector<Index> m_objects; ///< those of a leaf side by side
  std::vector<Index> m_leaf;    ///< of each object
};

} // namespace CSCD::internal

#endif // CSCD_MEASURE_PART_TREE_H
