// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which of several sets of vertices is nearest to every vertex.

#ifndef CSCD_INTERNAL_LABELED_FRONT_H
#define CSCD_INTERNAL_LABELED_FRONT_H

#include <CSCD/internal/Distance_front.h>
#include <CSCD/internal/Vector_3.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CSCD::internal {

/// A front that starts from labeled vertices; each vertex gets the label of the one from which it is reached first, so
/// that what has a label is connected with a start of that label.
class Labeled_front
{
public:
  explicit Labeled_front(std::size_t number_of_vertices)
      : m_front(number_of_vertices), m_label(number_of_vertices, no_index)
  {
  }

  /// Lets the front start, or go on, from `vertex` with `label` at `distance`, not less than where it is by now.
  void reach(Index vertex, float distance, Index label)
  {
    if (m_front.reach(vertex, distance)) {
      m_label[vertex] = label;
    }
  }

  /// Goes on until no vertex is left that can be reached; `for_each_neighbor(vertex, visit)` calls
  /// `visit(neighbor, length)` for the edges of a vertex. O(n log n).
  template <class ForEachNeighbor>
  void spread(const ForEachNeighbor& for_each_neighbor)
  {
    m_front.spread([&](Index vertex, float distance) {
      for_each_neighbor(vertex,
                        [&](Index neighbor, float length) { reach(neighbor, distance + length, m_label[vertex]); });
    });
  }

  /// The label of `vertex`; `no_index` if it has not been reached.
  Index label(Index vertex) const { return m_label[vertex]; }
  /// The distance from the nearest start; infinite if there is none.
  float distance(Index vertex) const
  {
    return m_front.is_reached(vertex) ? m_front.distance(vertex) : std::numeric_limits<float>::infinity();
  }

private:
  Distance_front m_front;
  std::vector<Index> m_label;
};

} // namespace CSCD::internal

#endif // CSCD_INTERNAL_LABELED_FRONT_H
