// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Laplacian and gradient angle of a distance field: they show which vertices are cut points.

#ifndef CSCD_PUBLISHED_CUT_LOCUS_INDICATORS_H
#define CSCD_PUBLISHED_CUT_LOCUS_INDICATORS_H

#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Published/Tangent_frames.h>
#include <CSCD/Vector3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

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

/// The derivatives of a distance field at the vertices, each computed on request in their tangent frames, and which
/// vertices are points of the cut locus. O(degree) unless said otherwise.
/// \tparam FramesType `Tangent_frames` of a triangulation, or `Point_frames` of a point complex
template <class FramesType>
class Cut_locus_indicators
{
public:
  using Frames = FramesType;

  /// \param field the distance of every vertex, infinite or not a number where it is unknown; as `frames`, it is
  ///        referred to and must outlive this object
  Cut_locus_indicators(const Frames& frames, const std::vector<double>& field) : m_frames(frames), m_distances(field)
  {
    CGAL_precondition(field.size() == frames.triangulation().number_of_vertices());
  }

  const Frames& frames() const { return m_frames; }
  const std::vector<double>& distances() const { return m_distances; }
  double distance(Index vertex) const { return m_distances[vertex]; }
  bool is_reached(Index vertex) const { return std::isfinite(m_distances[vertex]); }

  /// The Laplacian times the spacing: that of the vertices around `vertex` or, if it is larger, the mean edge length,
  /// over which a heat method smooths its distances.
  double laplacian(Index vertex) const
  {
    const double result = m_frames.laplacian(vertex, m_distances);
    return std::isfinite(result) ? result : 0;
  }

  /// Collects the gradients around `vertex`, counterclockwise.
  void collect_samples(Index vertex, Gradient_samples& samples) const
  {
    m_frames.collect_samples(vertex, m_distances, samples);
  }

  /// The mean gradients around all vertices; linear for bounded degrees.
  std::vector<std::complex<double>> gradients() const
  {
    std::vector<std::complex<double>> result;
    result.reserve(m_distances.size());
    for (Index vertex = 0; vertex < m_distances.size(); ++vertex) {
      result.push_back(m_frames.mean_gradient(vertex, m_distances));
    }
    return result;
  }

  /// Whether `vertex` is a point of the cut locus. Samples beyond a constant number are thinned out evenly before they
  /// are compared pair by pair.
  /// \param gradients if given, those of all vertices: then the neighbors are compared, which lie farther away than the
  ///        faces around the vertex, where a heat method does not round off a ridge any more
  bool is_cut(Index vertex, const Cut_locus_settings& settings,
              const std::vector<std::complex<double>>* gradients = nullptr) const
  {
    if (!is_reached(vertex) || !(laplacian(vertex) <= settings.laplacian_threshold)) {
      return false;
    }
    Gradient_samples samples;
    if (gradients != nullptr) {
      collect_neighbors(
          m_frames, vertex, [gradients](Index neighbor) { return (*gradients)[neighbor]; }, samples);
    } else {
      collect_samples(vertex, samples);
    }
    return max_convergence(samples) >= settings.angle_threshold;
  }

private:
  const Frames& m_frames;
  const std::vector<double>& m_distances;
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_CUT_LOCUS_INDICATORS_H
