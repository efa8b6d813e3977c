// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The two directions from which fronts arrive at a point of the cut locus.

#ifndef CSCD_PUBLISHED_INCOMING_DIRECTIONS_H
#define CSCD_PUBLISHED_INCOMING_DIRECTIONS_H

#include <CSCD/Published/Cut_locus_indicators.h>
#include <CSCD/Published/Descent.h>
#include <CSCD/Vector_3.h>

#include <boost/container/small_vector.hpp>
#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <optional>

namespace CSCD::internal {

/// Splits the faces around a cut point into the two sides that fronts come from: the split of their cycle into two arcs
/// with the greatest angle between the sums of unit gradients that converge.
template <class Measures>
class Front_sides
{
public:
  using Complex = std::complex<double>;

  Front_sides(const Measures& measures, Index vertex)
  {
    Gradient_samples samples;
    measures.collect_samples(vertex, samples);
    // The cycle twice, so that arcs need not wrap around.
    boost::container::small_vector<Sum, 33> sums(1);
    for (std::size_t i = 0; i < 2 * samples.size(); ++i) {
      const auto& sample = samples[i % samples.size()];
      sums.push_back({sums.back().gradient + sample.gradient, sums.back().direction + sample.direction});
    }
    const std::size_t size = samples.size();
    const std::size_t stride = (size + max_samples - 1) / max_samples;
    for (std::size_t begin = 0; begin < size; begin += stride) {
      for (std::size_t end = begin + stride; end < begin + size && end < size; end += stride) {
        consider(difference(sums[end], sums[begin]), difference(sums[begin + size], sums[end]));
      }
    }
  }

  /// Whether there are two sides.
  explicit operator bool() const { return m_cosine <= 1; }
  /// The direction of the gradient on one side, of length 1.
  const Complex& gradient(std::size_t side) const { return m_gradient[side]; }

private:
  /// Faces around a vertex that are sorted into sides one by one; of more, several go together.
  static constexpr std::size_t max_samples = 32;

  struct Sum
  {
    Complex gradient = 0;
    Complex direction = 0;
  };

  static Sum difference(const Sum& a, const Sum& b) { return {a.gradient - b.gradient, a.direction - b.direction}; }

  void consider(const Sum& a, const Sum& b)
  {
    const double norms[] = {std::abs(a.gradient), std::abs(b.gradient)};
    if (!(norms[0] > 0 && norms[1] > 0)) {
      return;
    }
    const Complex gradients[] = {a.gradient / norms[0], b.gradient / norms[1]};
    const double cosine = dot(gradients[0], gradients[1]);
    if (cosine < m_cosine && dot(gradients[0] - gradients[1], a.direction - b.direction) < 0) {
      m_cosine = cosine;
      m_gradient = {gradients[0], gradients[1]};
    }
  }

  double m_cosine = std::numeric_limits<double>::max();
  std::array<Complex, 2> m_gradient{};
};

/// An edge of a vertex: where it leads, and in which direction.
struct Incident_edge
{
  Edge_step step;
  double distance; ///< that of its end, from the source
  double angle;    ///< in the frame of the vertex
};

using Incident_edges = boost::container::small_vector<Incident_edge, 16>;

/// Collects the edges of `vertex`, counterclockwise.
template <class Measures>
void collect_incident_edges(const Measures& measures, Index vertex, Incident_edges& incident_edges)
{
  const auto& frames = measures.frames();
  frames.for_each_neighbor(vertex, [&](Index neighbor, Index halfedge) {
    const bool is_reversed = frames.triangulation().origin(halfedge) != vertex;
    incident_edges.push_back(
        {{halfedge, is_reversed},
         measures.distance(neighbor),
         is_reversed ? frames.direction_at_target(halfedge) : frames.direction_at_origin(halfedge)});
  });
}

/// The two nearest ends of `incident_edges` that are nearer than their neighbors in the ring and at least a right angle
/// apart; null where there are none.
inline std::array<const Incident_edge*, 2> ring_minima(const Incident_edges& incident_edges)
{
  const std::size_t size = incident_edges.size();
  const bool is_border = incident_edges.back().step.is_reversed;
  // Of equal ones that follow each other the first counts.
  const auto is_nearer = [&](std::size_t a, std::size_t b) {
    return incident_edges[a].distance < incident_edges[b].distance ||
           (incident_edges[a].distance == incident_edges[b].distance && a < b);
  };
  const auto is_minimum = [&](std::size_t i) {
    const bool has_before = i > 0 || !is_border;
    const bool has_after = i + 1 < size || !is_border;
    return (!has_before || is_nearer(i, (i + size - 1) % size)) && (!has_after || is_nearer(i, (i + 1) % size));
  };
  std::array<const Incident_edge*, 2> result{};
  for (std::size_t i = 0; i < size; ++i) {
    if (is_minimum(i) && (result[0] == nullptr || incident_edges[i].distance < result[0]->distance)) {
      result[0] = &incident_edges[i];
    }
  }
  for (std::size_t i = 0; i < size; ++i) {
    const double turn = std::abs(incident_edges[i].angle - result[0]->angle);
    const bool is_apart =
        std::min(turn, boost::math::double_constants::two_pi - turn) >= boost::math::double_constants::half_pi;
    if (is_apart && is_minimum(i) && (result[1] == nullptr || incident_edges[i].distance < result[1]->distance)) {
      result[1] = &incident_edges[i];
    }
  }
  return result;
}

/// The edge of `incident_edges` that is closest in direction to the geodesic of the front whose distance has the
/// gradient `gradient`.
inline const Incident_edge* closest_to_descent(const Incident_edges& incident_edges,
                                               const std::complex<double>& gradient)
{
  const auto cosine = [&](const Incident_edge& incident_edge) {
    return -gradient.real() * std::cos(incident_edge.angle) - gradient.imag() * std::sin(incident_edge.angle);
  };
  const auto closest =
      std::max_element(incident_edges.begin(), incident_edges.end(),
                       [&](const Incident_edge& a, const Incident_edge& b) { return cosine(a) < cosine(b); });
  return &*closest;
}

/// The edges along which to leave the cut point `vertex` towards the source, on one side and on the other (section
/// 3.1.4, which is missing): the edges to the two minima of the distance in the ring around it. They need not be nearer
/// to the source than `vertex`, since the cut locus may run between. Where there is one minimum only, the edges that
/// are closest in direction to the geodesics. Nothing if the fronts have no two sides, or one edge serves
/// both. O(d^2) for degree d up to a constant.
template <class Measures>
std::optional<std::array<Edge_step, 2>> incoming_directions(const Measures& measures, Index vertex)
{
  Incident_edges incident_edges;
  collect_incident_edges(measures, vertex, incident_edges);
  if (incident_edges.empty()) {
    return std::nullopt;
  }
  std::array<const Incident_edge*, 2> chosen = ring_minima(incident_edges);
  if (chosen[1] == nullptr) {
    const Front_sides<Measures> sides(measures, vertex);
    if (!sides) {
      return std::nullopt;
    }
    chosen = {closest_to_descent(incident_edges, sides.gradient(0)),
              closest_to_descent(incident_edges, sides.gradient(1))};
    if (chosen[0] == chosen[1]) {
      return std::nullopt;
    }
  }
  return std::array<Edge_step, 2>{chosen[0]->step, chosen[1]->step};
}

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_INCOMING_DIRECTIONS_H
