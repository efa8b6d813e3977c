// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nearest neighbors among points, points within a fixed distance, and the thinning of points.

#ifndef CSCD_POINTS_NEIGHBOR_TABLE_H
#define CSCD_POINTS_NEIGHBOR_TABLE_H

#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Vector3.h>

#include <CGAL/Dimension.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits.h>

#include <boost/unordered_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CSCD::internal {

/// A point and its number.
struct Numbered_point
{
  Vector3 place;
  Index number;
};

/// The coordinates of a point as CGAL's search trees ask for them.
struct Coordinates_of_point
{
  using result_type = const double*;
  result_type operator()(const Numbered_point& point) const { return point.place.data(); }
  result_type operator()(const Numbered_point& point, int /* past the last */) const { return point.place.data() + 3; }
};

/// A search tree over points. Among equally distant ones the order is unspecified, but always the same.
class Point_tree
{
public:
  /// Builds the tree; O(n log n). The points are copied.
  explicit Point_tree(const std::vector<Vector3>& points)
  {
    for (const Vector3& point : points) {
      m_tree.insert({point, Index(m_tree.size())});
    }
    if (!points.empty()) {
      m_tree.build();
    }
  }

  /// Calls `use(index, squared_distance)` for the `number` points that are nearest to `query`, the nearest first.
  /// O(number log n) in expectation.
  template <class Use>
  void for_each_nearest(const Vector3& query, Index number, const Use& use) const
  {
    const Search search(m_tree, {query, no_index}, number);
    for (const auto& [point, squared_distance] : search) {
      use(point.number, squared_distance);
    }
  }

  /// The point nearest to `query`.
  /// \pre there are points
  Index nearest(const Vector3& query) const { return Search(m_tree, {query, no_index}, 1).begin()->first.number; }

private:
  using Search = CGAL::Orthogonal_k_neighbor_search<
      CGAL::Search_traits<double, Numbered_point, const double*, Coordinates_of_point, CGAL::Dimension_tag<3>>>;

  Search::Tree m_tree;
};

/// Assigns the points without a vertex that of the nearest point with one; O(n log n).
/// \param vertices of every point, `no_index` where there is none
/// \pre some point has one
inline void assign_to_nearest(const std::vector<Vector3>& points, std::vector<Index>& vertices)
{
  std::vector<Index> used;
  std::vector<Vector3> used_points;
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
  Neighbor_table(const std::vector<Vector3>& points, Index number)
      : m_size(Index(points.size())), m_number(std::min<Index>(number, points.empty() ? 0 : m_size - 1))
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

  /// The number of points.
  Index size() const { return m_size; }
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
  Index m_size;
  Index m_number;
  std::vector<Index> m_neighbors;
  std::vector<double> m_distances;
};

/// For every point the mean distance to the nearest six: as many as an even sampling has around, about. Zero without
/// neighbors.
inline std::vector<double> spacings(const Neighbor_table& neighbors)
{
  constexpr Index number_of_nearest = 6;
  const Index number = std::min(number_of_nearest, neighbors.number());
  std::vector<double> result(neighbors.size(), 0.);
  for (Index point = 0; number > 0 && point < neighbors.size(); ++point) {
    const double* first = neighbors.distances(point).begin();
    result[point] = std::accumulate(first, first + number, 0.) / number;
  }
  return result;
}

/// Points in the cells of a grid, for queries of all within a radius that is the same for all queries. Unlike a search
/// tree it can grow, and takes a tenth of the time where few points are within the radius.
class Point_grid
{
public:
  /// \param radius positive, at least 2^-60 of the coordinates
  explicit Point_grid(double radius) : m_radius(radius) {}
  Point_grid(double radius, const std::vector<Vector3>& points) : Point_grid(radius)
  {
    for (const Vector3& point : points) {
      insert(point);
    }
  }

  /// Adds a point, and numbers it by the number of those before; constant amortized time.
  void insert(const Vector3& point)
  {
    m_cells[cell_of(point, 0)].push_back(size());
    m_points.push_back(point);
  }

  Index size() const { return Index(m_points.size()); }
  const Vector3& point(Index index) const { return m_points[index]; }

  /// Calls `use(index, squared_distance)` for all points within the radius; linear in the number of points in eight
  /// cells that are twice as wide as it.
  template <class Use>
  void for_each_near(const Vector3& query, const Use& use) const
  {
    const Cell least = cell_of(query, -m_radius); // the ball meets at most two cells in each direction
    for (unsigned corner = 0; corner < 8; ++corner) {
      const auto cell =
          m_cells.find({least[0] + (corner & 1U), least[1] + (corner >> 1U & 1U), least[2] + (corner >> 2U)});
      if (cell == m_cells.end()) {
        continue;
      }
      for (const Index index : cell->second) {
        const double squared_distance = (m_points[index] - query).squaredNorm();
        if (squared_distance <= m_radius * m_radius) {
          use(index, squared_distance);
        }
      }
    }
  }

private:
  using Cell = std::array<std::int64_t, 3>;

  Cell cell_of(const Vector3& point, double shift) const
  {
    Cell result{};
    for (std::size_t axis = 0; axis < result.size(); ++axis) {
      result[axis] = std::int64_t(std::floor((point[axis] + shift) / (2 * m_radius)));
    }
    return result;
  }

  double m_radius;
  std::vector<Vector3> m_points;
  boost::unordered_map<Cell, std::vector<Index>> m_cells; ///< the points in them
};

/// The members of `points`, in their order, that are farther than `radius` from all that were chosen before.
/// \param step only every so many of the points are looked at
inline std::vector<Index> thin(const std::vector<Vector3>& points, double radius, std::size_t step = 1)
{
  std::vector<Index> result;
  Point_grid grid(radius);
  for (std::size_t point = 0; point < points.size(); point += step) {
    bool is_free = true;
    grid.for_each_near(points[point], [&](Index, double) { is_free = false; });
    if (is_free) {
      grid.insert(points[point]);
      result.push_back(Index(point));
    }
  }
  return result;
}

/// The number of points with at least a radius between each two, times its square, relative to the area: the value of a
/// random sequential choice.
inline constexpr double packing_density = 0.69;

/// The area that points cover, estimated from some 2000 balls around them: noise that is less than their radius, and a
/// few points that are far away, hardly count. Does not depend on the pose. Linear.
inline double estimate_area(const std::vector<Vector3>& points)
{
  constexpr double number_of_balls = 2000;
  constexpr std::size_t sample = 50000;    // points that serve the estimate, about
  constexpr int max_number_of_trials = 40; // of radii; stops the search where no radius leaves as many balls
  constexpr double first_radius = 0.05;    // relative to the root mean squared distance from the centroid
  const double target = std::min(number_of_balls, double(points.size()) / 4);
  const std::size_t step = std::max<std::size_t>(1, points.size() / sample);
  double radius = first_radius / Canonical_pose(points).scale();
  double area = 0;
  for (int i = 0; i < max_number_of_trials; ++i) {
    const auto number = double(thin(points, radius, step).size());
    area = number * radius * radius / packing_density;
    if (number > target / 1.5 && number < target * 1.5) {
      break;
    }
    radius *= std::sqrt(number / target);
  }
  return area;
}

} // namespace CSCD::internal

#endif // CSCD_POINTS_NEIGHBOR_TABLE_H
