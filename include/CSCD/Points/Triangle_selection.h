// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which triangles between points their neighborhoods agree on.

#ifndef CSCD_POINTS_TRIANGLE_SELECTION_H
#define CSCD_POINTS_TRIANGLE_SELECTION_H

#include <CSCD/Points/Point_complex.h>
#include <CSCD/Vector3.h>

#include <Eigen/Core>
#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Finds the neighbors of the origin in the Delaunay triangulation of points in the plane, one set of points after
/// another.
///
/// The inversion x / |x|^2 takes circles through the origin to lines, and empty ones to lines with all points on one
/// side: so the neighbors are the corners of the convex hull of the inverted points. If the origin is a corner too, it
/// is on the border of the triangulation.
class Delaunay_star
{
public:
  /// Removes all points.
  void clear() { m_points.clear(); }

  /// Adds a point under the number `label`, unless it is at the origin.
  void add(const Eigen::Vector2d& point, Index label)
  {
    const double squared_distance = point.squaredNorm();
    if (squared_distance > 0) {
      m_points.push_back({point / squared_distance, label});
    }
  }

  /// Finds the neighbors; O(k log k) for k points. Those of four points on a circle are found or not.
  void operator()()
  {
    m_points.push_back({Eigen::Vector2d::Zero(), no_index});
    std::sort(m_points.begin(), m_points.end(), [](const Point& a, const Point& b) {
      return std::make_pair(a.inverted.x(), a.inverted.y()) < std::make_pair(b.inverted.x(), b.inverted.y());
    });
    // Andrew's chains: the lower part of the hull from left to right, then the upper one back.
    m_hull.clear();
    add_chain(m_points.begin(), m_points.end());
    add_chain(m_points.rbegin(), m_points.rend());
    const auto origin = std::find(m_hull.begin(), m_hull.end(), no_index);
    m_is_closed = origin == m_hull.end();
    if (!m_is_closed) {
      std::rotate(m_hull.begin(), origin, m_hull.end());
      m_hull.erase(m_hull.begin());
    }
  }

  /// The labels of the neighbors, counterclockwise.
  const std::vector<Index>& neighbors() const { return m_hull; }
  /// Whether there is a triangle between the last neighbor and the first; there is one between any two that follow.
  bool is_closed() const { return m_is_closed; }

private:
  struct Point
  {
    Eigen::Vector2d inverted;
    Index label;
  };

  /// Appends the chain except its last point.
  template <class Iterator>
  void add_chain(Iterator begin, Iterator end)
  {
    m_chain.clear();
    for (Iterator point = begin; point != end; ++point) {
      while (m_chain.size() > 1 && !turns_left(*m_chain[m_chain.size() - 2], *m_chain.back(), *point)) {
        m_chain.pop_back();
      }
      m_chain.push_back(&*point);
    }
    for (std::size_t i = 0; i + 1 < m_chain.size(); ++i) {
      m_hull.push_back(m_chain[i]->label);
    }
  }

  static bool turns_left(const Point& a, const Point& b, const Point& c)
  {
    const Eigen::Vector2d x = b.inverted - a.inverted;
    const Eigen::Vector2d y = c.inverted - a.inverted;
    return x.x() * y.y() - x.y() * y.x() > 0;
  }

  std::vector<Point> m_points;
  std::vector<const Point*> m_chain;
  std::vector<Index> m_hull;
  bool m_is_closed = false;
};

/// The squared radius of the circumcircle of a triangle.
inline double squared_circumradius(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const Vector3 x = b - a;
  const Vector3 y = c - a;
  return x.squaredNorm() * y.squaredNorm() * (x - y).squaredNorm() / (4 * x.cross(y).squaredNorm());
}

/// A triangle that is Delaunay in the tangent planes of some of its vertices, which are in ascending order.
struct Local_triangle : std::array<Index, 3>
{
  Index votes = 1; ///< in how many tangent planes
  double size = 0; ///< the squared radius of its circumcircle
};

/// Takes the triangles of most votes first, among those the smallest, and each only if it overlaps none of those taken
/// before in the tangent planes of its vertices. So the result covers the directions around a vertex at most once, and
/// no edge has more than two triangles.
class Triangle_selection
{
public:
  /// \param points, normals the normals of either orientation
  /// \param triangles no two have the same vertices
  Triangle_selection(const std::vector<Vector3>& points, const std::vector<Vector3>& normals,
                     std::vector<Local_triangle>&& triangles)
      : m_points(points), m_normals(normals), m_triangles(std::move(triangles)),
        m_neighbors(vertex_neighbors(points.size(), m_triangles))
  {
    std::sort(m_triangles.begin(), m_triangles.end(), [](const Local_triangle& a, const Local_triangle& b) {
      return std::tie(b.votes, a.size, a) < std::tie(a.votes, b.size, b);
    });
    lay_out_sectors();
  }

  /// The triangles taken. O(n log n) in all for bounded degrees.
  std::vector<std::array<Index, 3>> operator()()
  {
    std::vector<std::array<Index, 3>> result;
    const auto is_free = [](const Sector& sector) { return !sector.is_covered; };
    const auto cover = [](Sector& sector) { return sector.is_covered = true; };
    for (const Local_triangle& triangle : m_triangles) {
      if (for_each_sector(triangle, is_free)) {
        result.push_back(triangle);
        for_each_sector(triangle, cover);
      }
    }
    return result;
  }

private:
  /// The directions around a vertex from that of an edge to that of the next one counterclockwise.
  struct Sector
  {
    Index neighbor;
    double begin;
    bool is_covered;
  };

  void lay_out_sectors()
  {
    for (Index v = 0; v < m_points.size(); ++v) {
      const Vector3 x = m_normals[v].unitOrthogonal();
      const Vector3 y = m_normals[v].cross(x);
      for (const Index neighbor : m_neighbors[v]) {
        const Vector3 edge = m_points[neighbor] - m_points[v];
        m_sectors.push_back({neighbor, std::atan2(y.dot(edge), x.dot(edge)), false});
      }
      std::sort(m_sectors.begin() + m_neighbors.begin(v), m_sectors.end(), [](const Sector& a, const Sector& b) {
        return std::make_pair(a.begin, a.neighbor) < std::make_pair(b.begin, b.neighbor);
      });
    }
  }

  /// Calls `function(sector)` for those between the sides of the triangle at `vertex` until it returns false.
  /// \return whether it never did, and there is an angle between the sides
  template <class Function>
  bool for_each_sector(Index vertex, Index neighbor_1, Index neighbor_2, const Function& function)
  {
    const Index begin = m_neighbors.begin(vertex);
    const Index end = m_neighbors.begin(vertex + 1);
    const auto find = [&](Index neighbor) {
      return Index(std::find_if(m_sectors.begin() + begin, m_sectors.begin() + end,
                                [&](const Sector& sector) { return sector.neighbor == neighbor; }) -
                   m_sectors.begin());
    };
    Index from = find(neighbor_1);
    Index to = find(neighbor_2);
    using boost::math::double_constants::pi;
    double turn = m_sectors[to].begin - m_sectors[from].begin;
    turn += turn < 0 ? 2 * pi : 0;
    if (turn > pi) {
      std::swap(from, to);
    }
    if (turn == 0) {
      return false;
    }
    for (Index sector = from; sector != to; sector = sector + 1 == end ? begin : sector + 1) {
      if (!function(m_sectors[sector])) {
        return false;
      }
    }
    return true;
  }

  /// The same at all vertices of the triangle, until it returns false at one of them.
  template <class Function>
  bool for_each_sector(const Local_triangle& triangle, const Function& function)
  {
    const auto& [a, b, c] = static_cast<const std::array<Index, 3>&>(triangle);
    return for_each_sector(a, b, c, function) && for_each_sector(b, c, a, function) &&
           for_each_sector(c, a, b, function);
  }

  const std::vector<Vector3>& m_points;
  const std::vector<Vector3>& m_normals;
  std::vector<Local_triangle> m_triangles;
  Compressed_rows<Index> m_neighbors;
  std::vector<Sector> m_sectors; // towards them, vertex by vertex, counterclockwise
};

} // namespace CSCD::internal

#endif // CSCD_POINTS_TRIANGLE_SELECTION_H
