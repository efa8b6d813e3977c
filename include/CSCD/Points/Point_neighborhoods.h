// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The points of a cloud around each of its points, on the same sheet of the surface.

#ifndef CSCD_POINTS_POINT_NEIGHBORHOODS_H
#define CSCD_POINTS_POINT_NEIGHBORHOODS_H

#include <CSCD/Points/Point_complex.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Epoch_marks.h>

#include <CGAL/Iterator_range.h>

#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// For every vertex of a point complex, how far it matters to the surface around it, and the vertices that matter to
/// the surface near it. These are reached over edges, through vertices whose normals look to the same side: so points
/// of another sheet that passes nearby are not among them. Const and thread safe.
class Point_neighborhoods
{
public:
  /// Collects the neighborhoods; linear, with some forty vertices in each.
  explicit Point_neighborhoods(const Point_complex& complex)
  {
    const Index n = complex.number_of_vertices();
    m_radius.reserve(n);
    for (Index vertex = 0; vertex < n; ++vertex) {
      m_radius.push_back(support * mean_edge_length(complex, vertex));
    }
    Epoch_marks is_met(n);
    m_begin.reserve(std::size_t(n) + 1);
    for (Index vertex = 0; vertex < n; ++vertex) {
      m_begin.push_back(m_neighbors.size());
      collect(complex, vertex, is_met);
    }
    m_begin.push_back(m_neighbors.size());
  }

  /// The vertices around `vertex`, itself among them: all whose radius a point may come into that is nearest to it.
  CGAL::Iterator_range<const Index*> neighbors(Index vertex) const
  {
    return {m_neighbors.data() + m_begin[vertex], m_neighbors.data() + m_begin[vertex + 1]};
  }
  /// Within this distance `vertex` matters; zero for one without edges.
  double radius(Index vertex) const { return m_radius[vertex]; }
  /// The mean length of the edges at `vertex`.
  double spacing(Index vertex) const { return m_radius[vertex] / support; }

private:
  /// The radius relative to the mean length of the edges at a vertex: some twenty-five points lie within it, of which
  /// ten have much weight; with fewer noise is seen, with more what is round is flattened.
  static constexpr double support = 2.5;
  /// Points that are nearest to a vertex are about so far from it at most, relative to the same length.
  static constexpr double reach = 0.6;

  static double mean_edge_length(const Point_complex& complex, Index vertex)
  {
    double sum = 0;
    std::size_t number = 0;
    for (const Index h : complex.outgoing(vertex)) {
      sum += complex.length(h);
      ++number;
    }
    return number == 0 ? 0. : sum / double(number);
  }

  void collect(const Point_complex& complex, Index vertex, Epoch_marks& is_met)
  {
    const double distance = m_radius[vertex] * (1 + reach / support);
    is_met.clear();
    is_met.mark(vertex);
    m_neighbors.push_back(vertex);
    for (std::size_t i = m_begin[vertex]; i < m_neighbors.size(); ++i) {
      for (const Index h : complex.outgoing(m_neighbors[i])) {
        const Index target = complex.target(h);
        if ((complex.point(target) - complex.point(vertex)).squaredNorm() <= distance * distance &&
            complex.normal(target).dot(complex.normal(vertex)) > 0 && is_met.mark(target)) {
          m_neighbors.push_back(target);
        }
      }
    }
  }

  std::vector<double> m_radius;
  std::vector<std::size_t> m_begin;
  std::vector<Index> m_neighbors;
};

} // namespace CSCD::internal

#endif // CSCD_POINTS_POINT_NEIGHBORHOODS_H
