// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closes gaps of a few edges between triangles.

#ifndef CSCD_POINTS_CLOSE_SMALL_GAPS_H
#define CSCD_POINTS_CLOSE_SMALL_GAPS_H

#include <CSCD/Vector_3.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Fills border loops of few edges with triangles, the smallest ears first.
class Gap_closing
{
public:
  Gap_closing(const std::vector<Vector_3>& points, const std::vector<Vector_3>& normals,
              std::vector<std::array<Index, 3>>& triangles)
      : m_points(points), m_normals(normals), m_triangles(triangles)
  {
  }

  void operator()()
  {
    find_border();
    std::vector<Index> loop;
    std::vector<char> is_met(m_border.size(), 0);
    for (Index first = 0; first < m_border.size(); ++first) {
      if (is_met[first] == 0 && find_loop(first, loop)) {
        for (const Index edge : loop) {
          is_met[edge] = 1;
        }
        fill(loop);
      }
    }
  }

private:
  /// The most edges of a gap that is closed: at random, seven points lie no more evenly than that.
  static constexpr std::size_t longest_loop = 7;

  using Edge = std::pair<Index, Index>; // in the direction of the triangle to its left

  void find_border()
  {
    m_edges.reserve(3 * m_triangles.size());
    for (const auto& [a, b, c] : m_triangles) {
      m_edges.insert(m_edges.end(), {{a, b}, {b, c}, {c, a}});
    }
    std::sort(m_edges.begin(), m_edges.end());
    for (const auto& [a, b] : m_edges) {
      if (!has_edge(b, a)) {
        m_border.emplace_back(a, b);
      }
    }
  }

  bool has_edge(Index a, Index b) const
  {
    return std::binary_search(m_edges.begin(), m_edges.end(), Edge(a, b)) || m_new_edges.count({a, b}) > 0;
  }

  /// Follows the border from an edge. \return whether it comes back soon
  bool find_loop(Index first, std::vector<Index>& loop) const
  {
    loop.clear();
    Index edge = first;
    do {
      loop.push_back(edge);
      edge = next(edge);
    } while (edge != first && edge != no_index && loop.size() < longest_loop);
    return edge == first && loop.size() > 2;
  }

  /// The border edge on the other side of the gap at the end of a border edge.
  Index next(Index edge) const
  {
    const auto [a, b] = m_border[edge];
    Index result = no_index;
    double min_turn = std::numeric_limits<double>::infinity();
    for (auto other = std::lower_bound(m_border.begin(), m_border.end(), Edge(b, 0));
         other != m_border.end() && other->first == b; ++other) {
      const double turn = gap(a, b, other->second);
      if (turn < min_turn) {
        min_turn = turn;
        result = Index(other - m_border.begin());
      }
    }
    return result;
  }

  /// The angle at `b` from `a` to `c`, counterclockwise around its normal, in (0, 2 pi].
  double gap(Index a, Index b, Index c) const
  {
    const Vector_3& normal = m_normals[b];
    const Vector_3 x = m_points[a] - m_points[b];
    const Vector_3 y = m_points[c] - m_points[b];
    const double angle = std::atan2(normal.dot(x.cross(y)), x.dot(y) - normal.dot(x) * normal.dot(y));
    return angle > 0 ? angle : angle + boost::math::double_constants::two_pi;
  }

  /// Cuts off ears until a triangle is left, or no ear fits.
  void fill(const std::vector<Index>& loop)
  {
    std::vector<Index> polygon;
    polygon.reserve(loop.size());
    for (const Index edge : loop) {
      polygon.push_back(m_border[edge].first);
    }
    std::vector<std::array<Index, 3>> ears;
    while (polygon.size() > 3) {
      std::size_t best = polygon.size();
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const double size = ear_size(polygon, i);
        if (size < least) {
          least = size;
          best = i;
        }
      }
      if (best == polygon.size()) {
        return;
      }
      ears.push_back(ear(polygon, best));
      polygon.erase(polygon.begin() + std::ptrdiff_t(best));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (!is_convex(ear(polygon, i))) {
        return;
      }
    }
    ears.push_back(ear(polygon, 1));
    m_triangles.insert(m_triangles.end(), ears.begin(), ears.end());
    for (const auto& [a, b, c] : ears) {
      m_new_edges.insert({{a, b}, {b, c}, {c, a}});
    }
  }

  /// The corner `i` and its neighbors, counterclockwise: the polygon runs clockwise around the gap.
  static std::array<Index, 3> ear(const std::vector<Index>& polygon, std::size_t i)
  {
    const std::size_t size = polygon.size();
    return {polygon[(i + 1) % size], polygon[i], polygon[(i + size - 1) % size]};
  }

  bool is_convex(const std::array<Index, 3>& ear) const
  {
    return gap(ear[2], ear[1], ear[0]) < boost::math::double_constants::pi;
  }

  /// The squared radius of the circumcircle of the ear; infinite if it cannot be cut off.
  double ear_size(const std::vector<Index>& polygon, std::size_t i) const
  {
    const std::array<Index, 3> corners = ear(polygon, i);
    if (!is_convex(corners) || has_edge(corners[0], corners[2]) || has_edge(corners[2], corners[0])) {
      return std::numeric_limits<double>::infinity();
    }
    const Vector_3 x = m_points[corners[0]] - m_points[corners[1]];
    const Vector_3 y = m_points[corners[2]] - m_points[corners[1]];
    return x.squaredNorm() * y.squaredNorm() * (x - y).squaredNorm() / x.cross(y).squaredNorm();
  }

  const std::vector<Vector_3>& m_points;
  const std::vector<Vector_3>& m_normals;
  std::vector<std::array<Index, 3>>& m_triangles;
  std::vector<Edge> m_edges;  // of the triangles, sorted
  std::set<Edge> m_new_edges; // of triangles in gaps
  std::vector<Edge> m_border; // those without a triangle on the right, sorted
};

/// Closes the gaps between `triangles` that only a few edges surround: random samples have voids that are no holes.
/// O(n log n).
/// \pre the triangles are oriented as the normals say, and no edge has more than two
inline void close_small_gaps(const std::vector<Vector_3>& points, const std::vector<Vector_3>& normals,
                             std::vector<std::array<Index, 3>>& triangles)
{
  Gap_closing(points, normals, triangles)();
}

} // namespace CSCD::internal

#endif // CSCD_POINTS_CLOSE_SMALL_GAPS_H
