// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nearest neighbors among points.

#ifndef CSCD_POINTS_NEIGHBOR_TABLE_H
#define CSCD_POINTS_NEIGHBOR_TABLE_H

#include <CSCD/Vector_3.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// A search tree over points. Among equally distant ones the order is unspecified, but always the same.
class Point_tree
{
public:
  /// Builds the tree; O(n log n). The points are copied.
  explicit Point_tree(const std::vector<Vector_3>& points)
      : m_points(to_cgal(points)), m_point_map(m_points.data()),
        m_tree(boost::make_counting_iterator(Index(0)), boost::make_counting_iterator(Index(m_points.size())),
               Search::Splitter(), Search_traits(m_point_map))
  {
    if (!m_points.empty()) {
      m_tree.build();
    }
  }
  Point_tree(const Point_tree&) = delete;
  Point_tree& operator=(const Point_tree&) = delete;
  ~Point_tree() = default;

  /// Calls `use(index, squared_distance)` for the `number` points that are nearest to `query`, the nearest first.
  /// O(number log n) in expectation.
  template <class Use>
  void for_each_nearest(const Vector_3& query, Index number, const Use& use) const
  {
    const Search search(m_tree, {query.x(), query.y(), query.z()}, number, 0, true, Distance(m_point_map));
    for (const auto& [index, squared_distance] : search) {
      use(index, squared_distance);
    }
  }

  /// The point nearest to `query`.
  /// \pre there are points
  Index nearest(const Vector_3& query) const
  {
    Index result = no_index;
    for_each_nearest(query, 1, [&result](Index index, double) { result = index; });
    return result;
  }

private:
  using Kernel = CGAL::Simple_cartesian<double>;
  using Point = Kernel::Point_3;
  using Point_map =
      boost::iterator_property_map<const Point*, boost::typed_identity_property_map<Index>, Point, const Point&>;
  using Search_traits = CGAL::Search_traits_adapter<Index, Point_map, CGAL::Search_traits_3<Kernel>>;
  using Search = CGAL::Orthogonal_k_neighbor_search<Search_traits>;
  using Distance = Search::Distance;

  static std::vector<Point> to_cgal(const std::vector<Vector_3>& points)
  {
    std::vector<Point> result;
    result.reserve(points.size());
    for (const Vector_3& point : points) {
      result.emplace_back(point.x(), point.y(), point.z());
    }
    return result;
  }

  std::vector<Point> m_points;
  Point_map m_point_map;
  Search::Tree m_tree;
};

/// Assigns the points without a vertex that of the nearest point with one; O(n log n).
/// \param vertices of every point, `no_index` where there is none
/// \pre some point has one
inline void assign_to_nearest(const std::vector<Vector_3>& points, std::vector<Index>& vertices)
{
  std::vector<Index> used;
  std::vector<Vector_3> used_points;
  for (Index point = 0; point < vertices.size(); ++point) {
    if (vertices[point] != no_index) {
      used.push_back(point);
      used_points.push_back(points[point]);
    }
  }
  if (used.size() == vertices.size()) {
    return;
  }
  const Point_tree tree(used_points);
  for (Index point = 0; point < vertices.size(); ++point) {
    if (vertices[point] == no_index) {
      vertices[point] = vertices[used[tree.nearest(points[point])]];
    }
  }
}

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

#endif // CSCD_POINTS_NEIGHBOR_TABLE_H
