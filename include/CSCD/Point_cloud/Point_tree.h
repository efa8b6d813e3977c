// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds nearest points: CGAL's search tree over the points of a cloud.

#ifndef CSCD_POINT_CLOUD_POINT_TREE_H
#define CSCD_POINT_CLOUD_POINT_TREE_H

#include <CSCD/internal/Vector_3.h>

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/property_map/property_map.hpp>

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

} // namespace CSCD::internal

#endif // CSCD_POINT_CLOUD_POINT_TREE_H
