// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Straightens a cut locus that runs along edges, for display.

#ifndef CSCD_PUBLISHED_CUT_LOCUS_SMOOTHING_H
#define CSCD_PUBLISHED_CUT_LOCUS_SMOOTHING_H

#include <CSCD/Points/Point_complex.h>
#include <CSCD/Published/Cut_locus_indicators.h>
#include <CSCD/Published/Point_derivatives.h>
#include <CSCD/Published/Surface_walk.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <cmath>
#include <complex>
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
  /// The part of the vector to the middle of the neighbors that is added at once: with all of it, a zigzag would
  /// oscillate.
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

/// The domain of `Cut_locus_smoothing` on a triangulation: points move straight on over its faces.
class Surface_smoothing_domain
{
public:
  using Point = Face_point;
  using Measures = Cut_locus_indicators<Triangulated_surface>;

  /// \param measures is referred to and must outlive this object
  explicit Surface_smoothing_domain(const Measures& measures) : m_measures(measures), m_walk(measures.frames()) {}

  double mean_edge_length() const { return m_measures.frames().mean_edge_length(); }
  Vector_3 position(const Face_point& point) const { return m_walk.position(point); }
  Face_point moved(const Face_point& point, const Vector_3& displacement) const { return m_walk(point, displacement); }

  /// The mean unit gradient around `point`, in space; short where fronts meet.
  Vector_3 gradient(const Face_point& point) const
  {
    Vector_3 gradient = Vector_3::Zero();
    for (Index k = 0; k < 3; ++k) {
      if (point.weights[k] > 0) {
        const Index vertex = m_measures.frames().triangulation().origin(3 * point.face + k);
        gradient += point.weights[k] * vertex_gradient(vertex);
      }
    }
    return gradient;
  }

private:
  /// The mean unit gradient of the faces around `vertex`, in space; short where they disagree, as on the ridge.
  Vector_3 vertex_gradient(Index vertex) const
  {
    const Triangulated_surface& surface = m_measures.frames().triangulation();
    Vector_3 sum = Vector_3::Zero();
    double number = 0;
    m_measures.frames().for_each_outgoing(vertex, [&](Index h) {
      const auto& corner = m_measures.frames().corner(h);
      if (corner.sine == 0) {
        return;
      }
      const std::complex<double> local = m_measures.face_direction(h) / corner.turn;
      const Vector_3 x = (surface.point(surface.target(h)) - surface.point(vertex)) / corner.length;
      const Index last = Triangulated_surface::previous(h);
      const Vector_3 incident_edge = surface.point(surface.origin(last)) - surface.point(vertex);
      const Vector_3 y = (incident_edge - incident_edge.dot(x) * x).normalized();
      sum += local.real() * x + local.imag() * y;
      number += 1;
    });
    return number > 0 ? Vector_3(sum / number) : Vector_3::Zero();
  }

  const Measures& m_measures;
  Surface_walk m_walk;
};

/// A point near the vertices of a point complex.
struct Cloud_point
{
  Index nearest = no_index; ///< the nearest vertex, sought along edges
  Vector_3 position;
};

/// The domain of `Cut_locus_smoothing` on a point complex: points move freely, and then back to the surface that the
/// tangent planes of the nearest vertex and its neighbors make.
class Point_smoothing_domain
{
public:
  using Point = Cloud_point;

  /// \param measures is referred to and must outlive this object
  explicit Point_smoothing_domain(const Point_cut_locus_indicators& measures)
      : m_measures(measures), m_complex(measures.frames().triangulation())
  {
  }

  double mean_edge_length() const { return m_complex.mean_edge_length(); }
  static const Vector_3& position(const Cloud_point& point) { return point.position; }

  Cloud_point moved(const Cloud_point& point, const Vector_3& displacement) const
  {
    Cloud_point result{point.nearest, point.position + displacement};
    result.nearest = descend_to_nearest(m_complex, result.position, point.nearest, [](Index, Index) { return true; });
    Vector_3 normal = Vector_3::Zero();
    double height = 0;
    for_each_weight(result, [&](Index vertex, double weight) {
      normal += weight * m_complex.normal(vertex);
      height += weight * m_complex.normal(vertex).dot(result.position - m_complex.point(vertex));
    });
    // Where normals cancel out, as on a thin sheet, there is no plane to go back to.
    if (normal.squaredNorm() > 0) {
      result.position -= height / normal.squaredNorm() * normal;
    }
    return result;
  }

  /// The mean gradient around `point`, in space; short where fronts meet.
  Vector_3 gradient(const Cloud_point& point) const
  {
    Vector_3 sum = Vector_3::Zero();
    for_each_weight(point, [&](Index vertex, double weight) {
      sum += weight * m_measures.frames().in_space(vertex, m_measures.gradient(vertex));
    });
    return sum;
  }

private:
  /// Where the weight of a vertex has fallen to 1/e, in mean edge lengths: about the distance of the neighbors.
  static constexpr double reach = 1;

  /// Calls `function(vertex, weight)` for the nearest vertex and its neighbors; the weights add up to 1.
  template <class Function>
  void for_each_weight(const Cloud_point& point, const Function& function) const
  {
    const double scale = reach * mean_edge_length();
    const auto weight_of = [&](Index vertex) {
      const double distance = (m_complex.point(vertex) - point.position).norm() - nearest_distance(point);
      return std::exp(-distance * distance / (scale * scale));
    };
    double sum = 1;
    for (const Index h : m_complex.outgoing(point.nearest)) {
      sum += weight_of(m_complex.target(h));
    }
    function(point.nearest, 1 / sum);
    for (const Index h : m_complex.outgoing(point.nearest)) {
      function(m_complex.target(h), weight_of(m_complex.target(h)) / sum);
    }
  }

  double nearest_distance(const Cloud_point& point) const
  {
    return (m_complex.point(point.nearest) - point.position).norm();
  }

  const Point_cut_locus_indicators& m_measures;
  const Point_complex& m_complex;
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_CUT_LOCUS_SMOOTHING_H
