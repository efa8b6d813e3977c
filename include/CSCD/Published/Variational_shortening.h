// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shortens a closed curve among points by minimizing an energy; its points are projected to the surface (appendix F).

#ifndef CSCD_PUBLISHED_VARIATIONAL_SHORTENING_H
#define CSCD_PUBLISHED_VARIATIONAL_SHORTENING_H

#include <CSCD/Points/Point_complex.h>
#include <CSCD/Published/Surface_path.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/assertions.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <vector>

namespace CSCD::internal {

/// A point of the surface of a point complex.
struct Projected_point
{
  Vector3 point = Vector3::Zero();
  Vector3 normal = Vector3::Zero(); ///< of unit length
  Index site = no_index;            ///< the nearest vertex, where the search for a nearby point begins
};

/// Projects points to the moving least squares surface of a point complex, for `Variational_shortening`.
///
/// The surface is where the weighted mean of (n + n_i) . (x - p_i) vanishes, over the points p_i near x with their
/// normals n_i; n is the weighted mean of the n_i. This is a plane fit with oriented normals, except that n is added to
/// n_i: a chord of a circle is perpendicular to the sum of the normals at its ends, so a sphere is met exactly, while a
/// plane fit alone is too small (the same sum serves S. Rusinkiewicz, "A symmetric objective function for ICP", 2019).
/// Only points of the sheet of the site count: those that pass nearby on another sheet are not among its neighbors. The
/// site is sought over edges from the last one: so no point jumps to another sheet. Const and thread safe.
class Moving_least_squares_projection
{
public:
  /// Collects the neighbors of every vertex; linear, with some forty of each.
  /// \param complex is referred to and must outlive this object
  explicit Moving_least_squares_projection(const Point_complex& complex) : m_complex(complex)
  {
    const Index n = complex.number_of_vertices();
    m_radius.reserve(n);
    for (Index vertex = 0; vertex < n; ++vertex) {
      m_radius.push_back(support * mean_edge_length(vertex));
    }
    Epoch_marks is_met(n);
    m_begin.reserve(std::size_t(n) + 1);
    for (Index vertex = 0; vertex < n; ++vertex) {
      m_begin.push_back(m_neighbors.size());
      collect(vertex, is_met);
    }
    m_begin.push_back(m_neighbors.size());
  }

  /// O(k) for k points around the site, and the steps to it. Where no point is near enough, as over a hole of the
  /// cloud, the nearest one is the projection.
  /// \param near a vertex where the descent of the distance to `point` begins \pre it is one
  Projected_point operator()(const Vector3& point, Index near) const
  {
    CGAL_precondition(near != no_index);
    Projected_point result{point, Vector3::Zero(), nearest(point, near)};
    const double small_height = min_height * (m_radius[result.site] / support);
    for (int i = 0; i < max_iterations; ++i) {
      const double height = fit(result);
      result.point -= height * result.normal;
      if (std::abs(height) <= small_height) {
        break;
      }
    }
    return result;
  }

private:
  static constexpr int max_iterations = 4; // of a projection
  /// Less is not worth an iteration, relative to the mean length of the edges at the site.
  static constexpr double min_height = 1e-2;

  /// The radius relative to the mean length of the edges at a vertex: some twenty-five points lie within it, and ten
  /// have much weight; with fewer, noise is seen, with more, round parts are flattened.
  static constexpr double support = 2.5;
  /// Points that are nearest to a vertex are about so far from it at most, relative to the same length.
  static constexpr double reach = 0.6;

  double mean_edge_length(Index vertex) const
  {
    double sum = 0;
    std::size_t number = 0;
    for (const Index h : m_complex.outgoing(vertex)) {
      sum += m_complex.length(h);
      ++number;
    }
    return number == 0 ? 0. : sum / double(number);
  }

  /// Appends the vertices around `vertex`, itself among them: all whose radius a point may come into that is nearest to
  /// it. They are reached over edges, through vertices whose normals look to the same side.
  void collect(Index vertex, Epoch_marks& is_met)
  {
    const double distance = m_radius[vertex] * (1 + reach / support);
    is_met.clear();
    is_met.mark(vertex);
    m_neighbors.push_back(vertex);
    for (std::size_t i = m_begin[vertex]; i < m_neighbors.size(); ++i) {
      for (const Index h : m_complex.outgoing(m_neighbors[i])) {
        const Index target = m_complex.target(h);
        if ((m_complex.point(target) - m_complex.point(vertex)).squaredNorm() <= distance * distance &&
            m_complex.normal(target).dot(m_complex.normal(vertex)) > 0 && is_met.mark(target)) {
          m_neighbors.push_back(target);
        }
      }
    }
  }

  /// Goes on to the nearest neighbor that looks to the same side until none is nearer.
  Index nearest(const Vector3& point, Index vertex) const
  {
    double min_distance = (m_complex.point(vertex) - point).squaredNorm();
    for (Index center = no_index; center != vertex;) {
      center = vertex;
      for (const Index h : m_complex.outgoing(center)) {
        const Index neighbor = m_complex.target(h);
        const double distance = (m_complex.point(neighbor) - point).squaredNorm();
        if (distance < min_distance && m_complex.normal(neighbor).dot(m_complex.normal(center)) > 0) {
          min_distance = distance;
          vertex = neighbor;
        }
      }
    }
    return vertex;
  }

  /// Sets the normal of the surface at the point of `projected`. The weight at distance d from a point of radius r is
  /// (1 - d^2/r^2)^4, nearly exp(-d^2/h^2) for h = r/2, but smooth where it ends; r follows the local spacing.
  /// \return how high above the surface it is
  double fit(Projected_point& projected) const
  {
    double sum = 0;
    double height = 0; // of the point above the tangent planes
    Vector3 offset = Vector3::Zero();
    Vector3 normal = Vector3::Zero();
    for (std::size_t i = m_begin[projected.site]; i < m_begin[projected.site + 1]; ++i) {
      const Index vertex = m_neighbors[i];
      const Vector3 difference = projected.point - m_complex.point(vertex);
      const double radius = m_radius[vertex];
      const double rest = 1 - difference.squaredNorm() / (radius * radius);
      if (rest > 0) {
        const double weight = rest * rest * rest * rest;
        const Vector3& n = m_complex.normal(vertex);
        sum += weight;
        height += weight * n.dot(difference);
        offset += weight * difference;
        normal += weight * n;
      }
    }
    const double norm = normal.norm();
    if (!(norm > 0)) {
      projected.point = m_complex.point(projected.site);
      projected.normal = m_complex.normal(projected.site);
      return 0;
    }
    projected.normal = normal / norm;
    return (height + projected.normal.dot(offset)) / (norm + sum);
  }

  const Point_complex& m_complex;
  std::vector<double> m_radius;     // of every vertex: within this distance it matters to the surface
  std::vector<std::size_t> m_begin; // of the neighbors of every vertex, and the end of the last ones
  std::vector<Index> m_neighbors;
};

/// Replaces `right_side` by the solution of a closed chain: row i has `diagonal[i]`, and -`coupling[i]` for its
/// successor, -`coupling[i - 1]` for its predecessor. Linear.
/// Eliminates from the first row to the last, with the last column carried along as a further right-hand side.
/// \param diagonal is overwritten
/// \pre there are at least three rows, and each diagonal entry is greater than the sum of the couplings of its row,
///      which are not negative
inline void solve_cyclic_tridiagonal(std::vector<double>& diagonal, const std::vector<double>& coupling,
                                     std::vector<Vector3>& right_side, std::vector<double>& last_column)
{
  const std::size_t n = diagonal.size();
  CGAL_precondition(n >= 3 && coupling.size() == n && right_side.size() == n);
  // Rows 0 to n - 2 say: x_i = right_side_i + coupling_i / diagonal_i x_{i+1} + last_column_i x_{n-1}.
  last_column.assign(n, 0.);
  last_column[0] = coupling[n - 1];
  for (std::size_t i = 0; i + 1 < n; ++i) {
    if (i > 0) {
      diagonal[i] -= coupling[i - 1] * coupling[i - 1] / diagonal[i - 1];
      right_side[i] += coupling[i - 1] * right_side[i - 1];
      last_column[i] = coupling[i - 1] * last_column[i - 1];
    }
    right_side[i] /= diagonal[i];
    last_column[i] /= diagonal[i];
  }
  // Backwards, with x_{n-1} still unknown.
  for (std::size_t i = n - 1; i-- > 0;) {
    const double part = coupling[i] / diagonal[i];
    if (i + 2 == n) {
      last_column[i] += part;
    } else {
      right_side[i] += part * right_side[i + 1];
      last_column[i] += part * last_column[i + 1];
    }
  }
  right_side[n - 1] += coupling[n - 2] * right_side[n - 2] + coupling[n - 1] * right_side[0];
  right_side[n - 1] /= diagonal[n - 1] - coupling[n - 2] * last_column[n - 2] - coupling[n - 1] * last_column[0];
  for (std::size_t i = 0; i + 1 < n; ++i) {
    right_side[i] += last_column[i] * right_side[n - 1];
  }
}

/// Writes to `samples` so many points at equal distances along the closed polygon `points`, beginning at its first
/// point. Linear.
/// \pre `points` is not empty and `number` is positive
inline void resample_polygon(const std::vector<Vector3>& points, std::size_t number, std::vector<Vector3>& samples)
{
  CGAL_precondition(!points.empty() && number > 0);
  samples.clear();
  const double step = measure_polygon(points).length / double(number);
  double begin = 0; // of the side that follows `side`
  std::size_t side = 0;
  double side_length = (points[1 % points.size()] - points[0]).norm();
  for (std::size_t k = 0; k < number; ++k) {
    const double position = double(k) * step;
    while (begin + side_length < position && side + 1 < points.size()) {
      begin += side_length;
      ++side;
      side_length = (points[(side + 1) % points.size()] - points[side]).norm();
    }
    const double part = side_length > 0 ? std::clamp((position - begin) / side_length, 0., 1.) : 0.;
    samples.push_back((1 - part) * points[side] + part * points[(side + 1) % points.size()]);
  }
}

/// Shortens closed curves by the variational method of appendix F.
///
/// The energy of points x_i is the sum of H(|x_i - x_{i+1}|) + lambda max(0, |x_i - c| - r)^2, where H(s) = exp(s^2) -
/// 1 makes the curve short and its sides equal, and the second term keeps the points in a ball around c. The supplement
/// gives no unit of length; here it is the mean side of the polygon to begin with, for both terms: so nothing depends
/// on the scale or on the number of points.
///
/// The ball does not prevent a curve that nothing holds from shrinking to a point, as the supplement has it: that is
/// noticed by the lost length. An object is working memory, and is reused.
class Variational_shortening
{
public:
  /// \param projection is referred to and must outlive this object
  explicit Variational_shortening(const Moving_least_squares_projection& projection) : m_projection(projection) {}

  /// Weight of leaving the ball, lambda, that of the supplement: a curve under full tension leaves the ball by about a
  /// hundredth of its sides times its number of turns.
  static constexpr double ball_weight = 10;
  /// Most iterations; a curve on a smooth surface takes some twenty.
  static constexpr int max_iterations = 200;
  /// A curve that has less than this part of its length is given up: what separates loses less.
  static constexpr double min_length_ratio = 0.5;

  /// Shortens the closed polygon `points`, which lies on the surface or near it, within the ball around `center`.
  /// O(iterations times `number_of_samples` projections).
  /// \param points gets the samples, on the surface and about equally far from each other
  /// \param radius of the ball
  /// \param near a vertex near the first point
  /// \return `held` where points are outside of the ball, `unfinished` after `max_iterations`
  /// \pre `number_of_samples` >= 3, `points` is not empty
  Shortening_outcome operator()(std::vector<Vector3>& points, std::size_t number_of_samples, const Vector3& center,
                                double radius, Index near)
  {
    CGAL_precondition(number_of_samples >= 3);
    resample_polygon(points, number_of_samples, m_samples);
    m_curve.clear();
    for (const Vector3& sample : m_samples) {
      m_curve.push_back(m_projection(sample, near));
      near = m_curve.back().site;
    }
    m_center = center;
    m_radius = radius;
    const double first_length = length();
    m_unit = first_length / double(size());
    const Shortening_outcome outcome = first_length > 0 ? minimize(first_length) : Shortening_outcome::collapsed;
    points.resize(number_of_samples);
    for (std::size_t i = 0; i < number_of_samples; ++i) {
      points[i] = m_curve[i].point;
    }
    return outcome;
  }

  /// The points of the last curve, with their sites.
  const std::vector<Projected_point>& curve() const { return m_curve; }

private:
  using Curve = std::vector<Projected_point>;

  /// Points move at most so far in an iteration, in units.
  static constexpr double longest_step = 0.5;
  /// The curve has converged where no gradient is longer than this; a side pulls by 2 e.
  static constexpr double min_gradient = 1e-4 * 5.4;
  /// Or where so many iterations together lower the energy by less than this, relative to it.
  static constexpr double min_decrease = 1e-4;
  static constexpr int patience = 10;
  /// Armijo's condition: the part of the decrease promised by the gradient that a step has to bring.
  static constexpr double sufficient_decrease = 1e-4;
  /// A step is not tried that promises to lower the energy by less than this, relative to it: such steps one by one
  /// could not bring what `min_decrease` asks for.
  static constexpr double min_promise = 0.1 * min_decrease / patience;
  /// A point that is projected to a side that looks the other way has gone through the body: the cosine of 120 degrees.
  static constexpr double min_normal_cosine = -0.5;

  std::size_t size() const { return m_curve.size(); }
  std::size_t after(std::size_t i) const { return i + 1 < size() ? i + 1 : 0; }

  double length() const
  {
    double sum = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      sum += (m_curve[after(i)].point - m_curve[i].point).norm();
    }
    return sum;
  }

  double energy(const Curve& curve) const
  {
    double sum = 0;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      sum += std::expm1((curve[after(i)].point - curve[i].point).squaredNorm() / (m_unit * m_unit));
      const double excess = std::max(0., (curve[i].point - m_center).norm() - m_radius) / m_unit;
      sum += ball_weight * excess * excess;
    }
    return sum;
  }

  /// Sets the tangential gradient of the energy, and the direction against which the curve moves; lengths in units.
  void set_gradient()
  {
    m_gradient.assign(size(), Vector3::Zero());
    m_stiffness.resize(size());
    m_diagonal.assign(size(), 0.);
    double sum = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      const Vector3 side = (m_curve[after(i)].point - m_curve[i].point) / m_unit;
      m_stiffness[i] = 2 * std::exp(side.squaredNorm());
      sum += m_stiffness[i];
      m_diagonal[i] += m_stiffness[i];
      m_diagonal[after(i)] += m_stiffness[i];
      m_gradient[i] -= m_stiffness[i] * side;
      m_gradient[after(i)] += m_stiffness[i] * side;
      const Vector3 offset = m_curve[i].point - m_center;
      const double distance = offset.norm();
      if (distance > m_radius) {
        m_gradient[i] += 2 * ball_weight * (distance - m_radius) / (m_unit * distance) * offset;
        m_diagonal[i] += 2 * ball_weight;
      }
    }
    make_tangential(m_gradient);
    set_direction(sum / double(size()));
  }

  /// The chain alone would let the curve as a whole go anywhere: it is held as firmly as its longest wave.
  void set_direction(double mean_stiffness)
  {
    const double wave = 2 * boost::math::double_constants::pi / double(size());
    for (double& entry : m_diagonal) {
      entry += wave * wave * mean_stiffness;
    }
    m_direction = m_gradient;
    solve_cyclic_tridiagonal(m_diagonal, m_stiffness, m_direction, m_column);
    make_tangential(m_direction);
  }

  void make_tangential(std::vector<Vector3>& vectors) const
  {
    for (std::size_t i = 0; i < size(); ++i) {
      vectors[i] -= vectors[i].dot(m_curve[i].normal) * m_curve[i].normal;
    }
  }

  static double longest(const std::vector<Vector3>& vectors)
  {
    double largest = 0;
    for (const Vector3& vector : vectors) {
      largest = std::max(largest, vector.squaredNorm());
    }
    return std::sqrt(largest);
  }

  static double product(const std::vector<Vector3>& a, const std::vector<Vector3>& b)
  {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0., std::plus<>(),
                              [](const Vector3& u, const Vector3& v) { return u.dot(v); });
  }

  /// Iterates to the least energy. The gradient is made tangential and spread along the curve by the inverse of the
  /// chain's stiffness: without that, the number of iterations grows with that of the points. The step is that of
  /// Barzilai and Borwein, "Two-point step size gradient methods" (1988), halved until the energy sinks enough
  /// (Armijo), and every point is projected back to the surface.
  Shortening_outcome minimize(double first_length)
  {
    double last_energy = energy(m_curve);
    double energy_before = last_energy; // some iterations ago
    double step = 1;
    set_gradient();
    for (int i = 1; longest(m_gradient) > min_gradient; ++i) {
      if (i > max_iterations) {
        return Shortening_outcome::unfinished;
      }
      const double slope = product(m_gradient, m_direction);
      step = descend(std::min(step, longest_step / longest(m_direction)), slope, last_energy);
      if (step == 0) {
        return outcome_at_minimum();
      }
      if (length() < min_length_ratio * first_length) {
        return Shortening_outcome::collapsed;
      }
      if (i % patience == 0) {
        if (energy_before - last_energy <= min_decrease * energy_before) {
          return outcome_at_minimum();
        }
        energy_before = last_energy;
      }
      step = next_step(step, slope);
    }
    return outcome_at_minimum();
  }

  Shortening_outcome outcome_at_minimum() const
  {
    const bool is_held = std::any_of(m_curve.begin(), m_curve.end(), [this](const Projected_point& p) {
      return (p.point - m_center).norm() > m_radius;
    });
    return is_held ? Shortening_outcome::held : Shortening_outcome::straight;
  }

  /// Moves the curve against the direction by the longest of `step`, its half, and so on, that lowers the energy
  /// enough.
  /// \param slope by how much the energy sinks along the direction
  /// \return that step, 0 if there is none
  double descend(double step, double slope, double& last_energy)
  {
    for (; step * slope > min_promise * last_energy; step /= 2) {
      if (!try_step(step)) {
        continue;
      }
      const double next_energy = energy(m_next);
      if (next_energy <= last_energy - sufficient_decrease * step * slope) {
        last_energy = next_energy;
        m_curve.swap(m_next); // which now is the curve before
        return step;
      }
    }
    return 0;
  }

  /// \return false if a point has gone through the body
  bool try_step(double step)
  {
    m_next.resize(size());
    for (std::size_t i = 0; i < size(); ++i) {
      m_next[i] = m_projection(m_curve[i].point - step * m_unit * m_direction[i], m_curve[i].site);
      if (m_next[i].normal.dot(m_curve[i].normal) < min_normal_cosine) {
        return false;
      }
    }
    return true;
  }

  /// Updates the gradient. \return the longer step of Barzilai and Borwein, measured by the stiffness
  double next_step(double step, double slope)
  {
    m_last_gradient.swap(m_gradient);
    set_gradient();
    double change = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      change += (m_curve[i].point - m_next[i].point).dot(m_gradient[i] - m_last_gradient[i]) / m_unit;
    }
    // Where the energy is not convex, as long as it is allowed to be.
    return change > 0 ? step * step * slope / change : std::numeric_limits<double>::max();
  }

  const Moving_least_squares_projection& m_projection;
  Vector3 m_center = Vector3::Zero();
  double m_radius = 0;
  double m_unit = 1; // the mean side of the polygon to begin with
  std::vector<Vector3> m_samples;
  Curve m_curve;
  Curve m_next;
  std::vector<Vector3> m_gradient;
  std::vector<Vector3> m_last_gradient;
  std::vector<Vector3> m_direction;
  std::vector<double> m_stiffness; // of every side
  std::vector<double> m_diagonal;
  std::vector<double> m_column;
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_VARIATIONAL_SHORTENING_H
