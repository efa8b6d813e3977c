// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Straightens a cut locus that runs along edges, for display.

#ifndef CSCD_CUT_LOCUS_CUT_LOCUS_SMOOTHING_H
#define CSCD_CUT_LOCUS_CUT_LOCUS_SMOOTHING_H

#include <CSCD/Cut_locus/Cut_measures.h>
#include <CSCD/Cut_locus/Surface_walk.h>
#include <CSCD/Cut_locus/Tangent_frames.h>
#include <CSCD/Traits/Open_triangulation.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/assertions.h>

#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Moves the points of a cut locus over the surface: first across the curve, up the gradient of the distance, to the
/// ridge between the vertices; then to the middle of their neighbors, which takes the zigzag away. Forks only do the
/// latter; tips and lone points follow their neighbor or stay.
class Cut_locus_smoothing
{
public:
  using Measures = Cut_measures<Open_triangulation>;

  /// \param measures is referred to and must outlive this object
  explicit Cut_locus_smoothing(const Measures& measures) : m_measures(measures), m_walk(measures.frames()) {}

  /// Moves `points`, which `edges` join, `iterations` times either way. O(n) a time for n points.
  void operator()(std::vector<Face_point>& points, const std::vector<std::pair<Index, Index>>& edges, int iterations)
  {
    collect_neighbors(points.size(), edges);
    double factor = 1;
    for (int iteration = 0; iteration < iterations; ++iteration) {
      move_all(points, [&](Index i) { return uphill(i, points[i], factor); });
      factor *= damping;
    }
    for (int iteration = 0; iteration < iterations; ++iteration) {
      move_all(points, [&](Index i) { return to_middle(i); });
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
  void move_all(std::vector<Face_point>& points, const Displacement& displacement)
  {
    m_positions.clear();
    for (const Face_point& point : points) {
      m_positions.push_back(m_walk.position(point));
    }
    m_displacements.clear();
    for (Index i = 0; i < points.size(); ++i) {
      m_displacements.push_back(m_neighbors[i].size() >= 2 ? displacement(i) : Vector_3::Zero());
    }
    for (Index i = 0; i < points.size(); ++i) {
      const bool is_tip = m_neighbors[i].size() == 1;
      const Vector_3& step = m_displacements[is_tip ? m_neighbors[i].front() : i];
      if (step.squaredNorm() > 0) {
        points[i] = m_walk(points[i], step);
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
  Vector_3 uphill(Index i, const Face_point& point, double factor) const
  {
    if (m_neighbors[i].size() != 2) {
      return factor * to_middle(i);
    }
    const Vector_3 along = m_positions[m_neighbors[i][1]] - m_positions[m_neighbors[i][0]];
    Vector_3 gradient = Vector_3::Zero();
    for (Index k = 0; k < 3; ++k) {
      if (point.weights[k] > 0) {
        const Index vertex = m_measures.frames().triangulation().origin(3 * point.face + k);
        gradient += point.weights[k] * vertex_gradient(vertex);
      }
    }
    if (along.squaredNorm() > 0) {
      gradient -= gradient.dot(along) / along.squaredNorm() * along;
    }
    return factor * m_measures.frames().mean_edge_length() * gradient;
  }

  /// The mean unit gradient of the faces around `vertex`, in space; short where they disagree, as on the ridge.
  Vector_3 vertex_gradient(Index vertex) const
  {
    const Open_triangulation& surface = m_measures.frames().triangulation();
    Vector_3 sum = Vector_3::Zero();
    double number = 0;
    m_measures.frames().for_each_outgoing(vertex, [&](Index h) {
      const auto& corner = m_measures.frames().corner(h);
      if (corner.sine == 0) {
        return;
      }
      const std::complex<double> local = m_measures.face_direction(h) / corner.turn;
      const Vector_3 x = (surface.point(surface.target(h)) - surface.point(vertex)) / corner.length;
      const Index last = Open_triangulation::previous(h);
      const Vector_3 spoke = surface.point(surface.origin(last)) - surface.point(vertex);
      const Vector_3 y = (spoke - spoke.dot(x) * x).normalized();
      sum += local.real() * x + local.imag() * y;
      number += 1;
    });
    return number > 0 ? Vector_3(sum / number) : Vector_3::Zero();
  }

  const Measures& m_measures;
  Surface_walk m_walk;
  std::vector<std::vector<Index>> m_neighbors;
  std::vector<Vector_3> m_positions;
  std::vector<Vector_3> m_displacements;
};

} // namespace CSCD::internal

#endif // CSCD_CUT_LOCUS_CUT_LOCUS_SMOOTHING_H
