// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Straightens a cut locus that runs along edges, for display.

#ifndef CSCD_CUT_LOCUS_CUT_LOCUS_SMOOTHING_H
#define CSCD_CUT_LOCUS_CUT_LOCUS_SMOOTHING_H

#include <CSCD/Vector_3.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Moves the points of a cut locus over the surface: first across the curve, up the gradient of the distance, to the
/// ridge between the vertices; then to the middle of their neighbors, which takes the zigzag away. Forks only do the
/// latter; tips follow their neighbor uphill and then stay, lone points stay.
/// \tparam Domain what the points move on: it has a type `Point`, and the members `position(point)`, `gradient(point)`,
///         the mean unit gradient of the distance there, `moved(point, displacement)` and `mean_edge_length()`
template <class Domain>
class Cut_locus_smoothing
{
public:
  using Point = typename Domain::Point;

  /// \param domain is referred to and must outlive this object
  explicit Cut_locus_smoothing(const Domain& domain) : m_domain(domain) {}

  /// Moves `points`, which `edges` join, `iterations` times either way. O(n) a time for n points.
  void operator()(std::vector<Point>& points, const std::vector<std::pair<Index, Index>>& edges, int iterations)
  {
    collect_neighbors(points.size(), edges);
    double factor = 1;
    for (int iteration = 0; iteration < iterations; ++iteration) {
      move_all(points, true, [&](Index i) { return uphill(i, points[i], factor); });
      factor *= damping;
    }
    for (int iteration = 0; iteration < iterations; ++iteration) {
      // If tips followed here too, short curves would drift away: their points would never come to the middle.
      move_all(points, false, [&](Index i) { return to_middle(i); });
    }
  }

private:
  /// Steps up the gradient become shorter by this, so that the points come to rest on the ridge and not beside it.
  static constexpr double damping = 0.66;
  /// The part of the way to the middle of the neighbors that is gone at once: all of it would let a zigzag swing.
  static constexpr double relaxation = 0.5;

  void collect_neighbors(std::size_t number_of_points, const std::vector<std::pair<Index, Index>>& edges)
  {
    m_neighbors.assign(number_of_points, {});
    for (const auto& [a, b] : edges) {
      if (a != b) {
        m_neighbors[a].push_back(b);
        m_neighbors[b].push_back(a);
      }
    }
  }

  /// Moves all points by what `displacement(i)` says, given the positions before.
  template <class Displacement>
  void move_all(std::vector<Point>& points, bool do_tips_follow, const Displacement& displacement)
  {
    m_positions.clear();
    for (const Point& point : points) {
      m_positions.push_back(m_domain.position(point));
    }
    m_displacements.clear();
    for (Index i = 0; i < points.size(); ++i) {
      m_displacements.push_back(m_neighbors[i].size() >= 2 ? displacement(i) : Vector_3::Zero());
    }
    for (Index i = 0; i < points.size(); ++i) {
      const bool is_following = do_tips_follow && m_neighbors[i].size() == 1;
      const Vector_3& step = m_displacements[is_following ? m_neighbors[i].front() : i];
      if (step.squaredNorm() > 0) {
        points[i] = m_domain.moved(points[i], step);
      }
    }
  }

  Vector_3 to_middle(Index i) const
  {
    Vector_3 sum = Vector_3::Zero();
    for (Index neighbor : m_neighbors[i]) {
      sum += m_positions[neighbor] - m_positions[i];
    }
    return relaxation * sum / double(m_neighbors[i].size());
  }

  /// The part of the gradient at `point` across the curve, times the mean edge length and `factor`.
  Vector_3 uphill(Index i, const Point& point, double factor) const
  {
    if (m_neighbors[i].size() != 2) {
      return factor * to_middle(i);
    }
    const Vector_3 along = m_positions[m_neighbors[i][1]] - m_positions[m_neighbors[i][0]];
    Vector_3 gradient = m_domain.gradient(point);
    if (along.squaredNorm() > 0) {
      gradient -= gradient.dot(along) / along.squaredNorm() * along;
    }
    return factor * m_domain.mean_edge_length() * gradient;
  }

  const Domain& m_domain;
  std::vector<std::vector<Index>> m_neighbors;
  std::vector<Vector_3> m_positions;
  std::vector<Vector_3> m_displacements;
};

} // namespace CSCD::internal

#endif // CSCD_CUT_LOCUS_CUT_LOCUS_SMOOTHING_H
