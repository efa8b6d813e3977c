// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Laplacian and gradient angle of a distance field: they show which vertices are cut points.

#ifndef CSCD_PUBLISHED_CUT_LOCUS_INDICATORS_H
#define CSCD_PUBLISHED_CUT_LOCUS_INDICATORS_H

#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Published/Tangent_frames.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector3.h>

#include <CGAL/assertions.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// A face around a vertex, or a neighbor: where it lies, and its gradient, both in the frame of the vertex.
struct Gradient_sample
{
  std::complex<double> direction; ///< from the vertex to there, of length 1
  std::complex<double> gradient;  ///< of length 1
};

/// The samples around one vertex, counterclockwise.
using Gradient_samples = boost::container::small_vector<Gradient_sample, 16>;

inline double dot(const std::complex<double>& a, const std::complex<double>& b)
{
  return a.real() * b.real() + a.imag() * b.imag();
}

inline bool are_converging(const Gradient_sample& a, const Gradient_sample& b)
{
  return dot(a.gradient - b.gradient, a.direction - b.direction) < 0;
}

/// The greatest angle in [0, pi] between the gradients of two samples that run towards each other. O(d^2) for d samples
/// up to a constant, beyond which an even sample of them is taken.
inline double max_convergence(const Gradient_samples& samples)
{
  // Sectors that are compared pair by pair.
  constexpr std::size_t max_samples = 32;
  const std::size_t stride = (samples.size() + max_samples - 1) / max_samples;
  double min_cosine = 1;
  for (std::size_t i = 0; i < samples.size(); i += stride) {
    for (std::size_t j = i + stride; j < samples.size(); j += stride) {
      const double cosine = dot(samples[i].gradient, samples[j].gradient);
      if (cosine < min_cosine && are_converging(samples[i], samples[j])) {
        min_cosine = cosine;
      }
    }
  }
  return std::acos(std::clamp(min_cosine, -1., 1.));
}

/// Decides which vertices are points of the cut locus, however derivatives are computed.
/// \tparam FramesType of the vertices, `Tangent_frames` or `Point_frames`
/// \tparam Derived has the members `laplacian(vertex)`, `gradient(vertex)` and
///         `collect_samples(vertex, samples)`, which collects the gradients around a vertex, counterclockwise
template <class Derived, class FramesType>
class Cut_point_test
{
public:
  using Frames = FramesType;
  using Complex = std::complex<double>;

  /// \param field the distance of every vertex, infinite or not a number where it is unknown; as `frames`, it is
  ///        referred to and must outlive this object
  Cut_point_test(const Frames& frames, const std::vector<double>& field) : m_frames(frames), m_distances(field)
  {
    CGAL_precondition(field.size() == frames.triangulation().number_of_vertices());
  }

  const Frames& frames() const { return m_frames; }
  const std::vector<double>& distances() const { return m_distances; }
  double distance(Index vertex) const { return m_distances[vertex]; }
  bool is_reached(Index vertex) const { return std::isfinite(m_distances[vertex]); }

  /// The gradients of all vertices; linear for bounded degrees.
  std::vector<Complex> gradients() const
  {
    std::vector<Complex> result;
    result.reserve(m_distances.size());
    for (Index vertex = 0; vertex < m_distances.size(); ++vertex) {
      result.push_back(derived().gradient(vertex));
    }
    return result;
  }

  /// Whether `vertex` is a point of the cut locus.
  /// \param gradients if given, those of all vertices: then the neighbors are compared, which lie farther away than the
  ///        faces around the vertex, where a heat method does not round off a ridge any more
  bool is_cut(Index vertex, const Cut_locus_settings& settings, const std::vector<Complex>* gradients = nullptr) const
  {
    if (!is_reached(vertex) || !(derived().laplacian(vertex) <= settings.laplacian_threshold)) {
      return false;
    }
    Gradient_samples samples;
    if (gradients != nullptr) {
      collect_neighbors(
          vertex, [gradients](Index neighbor) { return (*gradients)[neighbor]; }, samples);
    } else {
      derived().collect_samples(vertex, samples);
    }
    return max_convergence(samples) >= settings.angle_threshold;
  }

protected:
  /// Collects the neighbors of `vertex`, counterclockwise, unless their gradients are those of a ridge or a source,
  /// which are short and have no direction.
  template <class GradientOf>
  void collect_neighbors(Index vertex, const GradientOf& gradient_of, Gradient_samples& samples) const
  {
    constexpr double min_gradient = 0.1; // away from ridges and sources it is 1
    samples.clear();
    m_frames.for_each_neighbor(vertex, [&](Index neighbor, Index h) {
      const Complex gradient = gradient_of(neighbor);
      const double norm = std::abs(gradient);
      if (norm > min_gradient && std::isfinite(norm)) {
        const bool is_outgoing = m_frames.triangulation().origin(h) == vertex;
        const double direction = is_outgoing ? m_frames.direction_at_origin(h) : m_frames.direction_at_target(h);
        const Complex transport = m_frames.transport_to_origin(h);
        samples.push_back(
            {std::polar(1., direction), (is_outgoing ? transport : std::conj(transport)) * gradient / norm});
      }
    });
  }

private:
  const Derived& derived() const { return static_cast<const Derived&>(*this); }

  const Frames& m_frames;
  const std::vector<double>& m_distances;
};

/// The derivatives of a distance field at the vertices, each computed on request, from the faces around the
/// vertex (supplement G.1: in tangent frames, from lengths alone). O(degree) unless said otherwise; samples beyond a
/// constant number are thinned out evenly before they are compared pair by pair.
class Cut_locus_indicators : public Cut_point_test<Cut_locus_indicators, Tangent_frames>
{
public:
  using Cut_point_test::Cut_point_test;

  static constexpr bool knows_loops = true; ///< around handles
  static constexpr Cut_locus_settings default_settings() { return {}; }

  /// The unit gradient in the face of `halfedge`, in the frame of the origin of `halfedge`; 0 where there is none.
  Complex face_direction(Index halfedge) const
  {
    const Intrinsic_triangulation& triangulation = frames().triangulation();
    const auto& corner = frames().corner(halfedge);
    if (corner.sine == 0) {
      return 0;
    }
    const double here = distance(triangulation.origin(halfedge));
    const Index last = Triangle_halfedges::previous(halfedge);
    const double along = (distance(triangulation.target(halfedge)) - here) / corner.length;
    const double along_last = (distance(triangulation.origin(last)) - here) / frames().corner(last).length;
    const Complex gradient(along, (along_last - along * corner.cosine) / corner.sine);
    const double norm = std::abs(gradient);
    return norm > 0 && std::isfinite(norm) ? corner.turn * gradient / norm : Complex(0);
  }

  /// The mean of the unit gradients around `vertex`, weighted by angle, in its frame: it is shorter than 1 where they
  /// disagree.
  Complex gradient(Index vertex) const
  {
    Complex sum = 0;
    double weight = 0;
    frames().for_each_outgoing(vertex, [&](Index h) {
      const double angle = std::atan2(frames().corner(h).sine, frames().corner(h).cosine);
      sum += angle * face_direction(h);
      weight += angle;
    });
    return weight > 0 ? sum / weight : Complex(0);
  }

  /// The Laplacian times the spacing: that of the vertices around `vertex` or, if it is larger, the mean edge length,
  /// over which a heat method smooths its distances.
  double laplacian(Index vertex) const
  {
    const double area = frames().area(vertex);
    if (!(area > 0)) {
      return 0;
    }
    const Intrinsic_triangulation& triangulation = frames().triangulation();
    double sum = 0;
    frames().for_each_outgoing(vertex, [&](Index h) {
      const Index next = Triangle_halfedges::next(h);
      const Index last = Triangle_halfedges::previous(h);
      sum += cotangent(last) * (distance(triangulation.origin(next)) - distance(vertex)) / 2 +
             cotangent(next) * (distance(triangulation.origin(last)) - distance(vertex)) / 2;
    });
    const double spacing = std::max(frames().mean_edge_length(), std::sqrt(area / area_of_unit_spacing));
    return std::isfinite(sum) ? sum / area * spacing : 0;
  }

  /// Collects the faces around `vertex`.
  void collect_samples(Index vertex, Gradient_samples& samples) const
  {
    samples.clear();
    frames().for_each_outgoing(vertex, [&](Index h) {
      const Complex gradient = face_direction(h);
      if (gradient != Complex(0)) {
        const auto& corner = frames().corner(h);
        // The bisector of the corner, by the half-angle formulas.
        const Complex bisector(std::sqrt((1 + corner.cosine) / 2), std::sqrt((1 - corner.cosine) / 2));
        samples.push_back({corner.turn * bisector, gradient});
      }
    });
  }

private:
  /// Of the angle at the origin of `halfedge`; 0 where the face has no area.
  double cotangent(Index halfedge) const
  {
    const auto& corner = frames().corner(halfedge);
    return corner.sine > 0 ? corner.cosine / corner.sine : 0;
  }
};

/// What `Cut_locus_indicators` are on a triangulation, on a point complex (supplement, appendix G.2): the derivatives
/// of a distance field at the vertices, each computed on request. The gradient that a vertex has is the mean
/// of those of its immediate neighbors and its own: a single one follows the noise of a few points. Only the immediate
/// neighbors of a vertex are compared.
class Point_cut_locus_indicators : public Cut_point_test<Point_cut_locus_indicators, Point_frames>
{
public:
  using Cut_point_test::Cut_point_test;

  static constexpr bool knows_loops = false;
  static constexpr Cut_locus_settings default_settings() { return point_cut_locus_settings(); }

  /// The mean gradient of `vertex` and its neighbors, in its frame: it is shorter than 1 where they disagree. O(d^2)
  /// for degree d.
  Complex gradient(Index vertex) const
  {
    Complex sum = frames().gradient(vertex, distances());
    double number = 1;
    frames().for_each_neighbor(vertex, [&](Index neighbor, Index h) {
      sum += frames().transport_to_origin(h) * frames().gradient(neighbor, distances());
      number += 1;
    });
    return sum / number;
  }

  /// The Laplacian times the spacing, see `Point_frames`. O(d) for degree d.
  double laplacian(Index vertex) const
  {
    const double result = frames().laplacian(vertex, distances());
    return std::isfinite(result) ? result : 0;
  }

  /// Collects the neighbors of `vertex`.
  void collect_samples(Index vertex, Gradient_samples& samples) const
  {
    collect_neighbors(
        vertex, [this](Index neighbor) { return gradient(neighbor); }, samples);
  }
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_CUT_LOCUS_INDICATORS_H
