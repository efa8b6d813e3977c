// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The neighbors of a point in the Delaunay triangulation of points in a plane.

#ifndef CSCD_POINT_CLOUD_DELAUNAY_STAR_H
#define CSCD_POINT_CLOUD_DELAUNAY_STAR_H

#include <CSCD/internal/Vector_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
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
  /// Forgets all points.
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

  /// Appends the chain but for its last point.
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

} // namespace CSCD::internal

#endif // CSCD_POINT_CLOUD_DELAUNAY_STAR_H
