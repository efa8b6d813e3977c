// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The nearest neighbors of every point of a cloud.

#ifndef CSCD_POINT_CLOUD_NEIGHBOR_TABLE_H
#define CSCD_POINT_CLOUD_NEIGHBOR_TABLE_H

#include <CSCD/Point_cloud/Point_tree.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// The same number of neighbors for every point, by increasing distance, the point itself not among them.
class Neighbor_table
{
public:
  /// Finds the `number` nearest neighbors of each of `points`, or as many as there are; O(number n log n) in
  /// expectation.
  Neighbor_table(const std::vector<Vector_3>& points, Index number)
      : m_number(std::min<Index>(number, points.empty() ? 0 : Index(points.size()) - 1))
  {
    m_neighbors.reserve(points.size() * m_number);
    m_distances.reserve(points.size() * m_number);
    if (m_number == 0) {
      return;
    }
    const Point_tree tree(points);
    for (Index point = 0; point < points.size(); ++point) {
      const std::size_t end = m_neighbors.size() + m_number;
      // Where others are at the same place, the point itself may not be among the first.
      tree.for_each_nearest(points[point], m_number + 1, [&](Index neighbor, double squared_distance) {
        if (neighbor != point && m_neighbors.size() < end) {
          m_neighbors.push_back(neighbor);
          m_distances.push_back(std::sqrt(squared_distance));
        }
      });
    }
  }

  /// The table of the `number` nearest neighbors of each point, or as many as there are; linear.
  Neighbor_table nearest(Index number) const
  {
    Neighbor_table result;
    result.m_number = std::min(number, m_number);
    for (std::size_t begin = 0; begin < m_neighbors.size(); begin += m_number) {
      const auto append = [&](auto& to, const auto& from) {
        to.insert(to.end(), from.begin() + std::ptrdiff_t(begin),
                  from.begin() + std::ptrdiff_t(begin + result.m_number));
      };
      append(result.m_neighbors, m_neighbors);
      append(result.m_distances, m_distances);
    }
    return result;
  }

  /// The number of neighbors of each point.
  Index number() const { return m_number; }
  /// The neighbors of `point`, the nearest first.
  CGAL::Iterator_range<const Index*> neighbors(Index point) const
  {
    const Index* first = m_neighbors.data() + std::size_t(point) * m_number;
    return {first, first + m_number};
  }
  /// The distances of `point` from its neighbors.
  CGAL::Iterator_range<const double*> distances(Index point) const
  {
    const double* first = m_distances.data() + std::size_t(point) * m_number;
    return {first, first + m_number};
  }
  /// The distance of `point` from the farthest of its neighbors.
  /// \pre there is one
  double reach(Index point) const { return m_distances[(std::size_t(point) + 1) * m_number - 1]; }

private:
  Neighbor_table() = default;

  Index m_number = 0;
  std::vector<Index> m_neighbors;
  std::vector<double> m_distances;
};

} // namespace CSCD::internal

#endif // CSCD_POINT_CLOUD_NEIGHBOR_TABLE_H
