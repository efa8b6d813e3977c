// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What tells the cut locus from the rest of a distance field, vertex by vertex.

#ifndef CSCD_CUT_LOCUS_CUT_MEASURES_H
#define CSCD_CUT_LOCUS_CUT_MEASURES_H

#include <CSCD/Cut_locus/Cut_criterion.h>
#include <CSCD/Cut_locus/Front_sector.h>
#include <CSCD/Cut_locus/Tangent_frames.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace CSCD::internal {

/// The derivatives of a distance field at the vertices, each computed when it is asked for, from the faces around the
/// vertex (supplement G.1: in tangent frames, from lengths alone). O(degree) unless said otherwise.
template <class Triangulation>
class Cut_measures
{
public:
  using Frames = Tangent_frames<Triangulation>;
  using Complex = typename Frames::Complex;
  using Basis = Frames; ///< what these are made of

  static constexpr Cut_criterion default_criterion() { return {}; }
  static const Frames& frames_of(const Basis& basis) { return basis; }

  /// \param distances the distance of every vertex, infinite or not a number where it is unknown; as `frames`, it is
  ///        referred to and must outlive this object
  Cut_measures(const Frames& frames, const std::vector<double>& distances) : m_frames(frames), m_distances(distances)
  {
    CGAL_precondition(distances.size() == frames.triangulation().number_of_vertices());
  }

  const Frames& frames() const { return m_frames; }
  const std::vector<double>& distances() const { return m_distances; }
  double distance(Index vertex) const { return m_distances[vertex]; }
  bool is_reached(Index vertex) const { return std::isfinite(m_distances[vertex]); }

  /// The unit gradient in the face of `halfedge`, in the frame of the origin of `halfedge`; 0 where there is none.
  Complex face_direction(Index halfedge) const
  {
    const Triangulation& triangulation = m_frames.triangulation();
    const auto& corner = m_frames.corner(halfedge);
    if (corner.sine == 0) {
      return 0;
    }
    const double here = m_distances[triangulation.origin(halfedge)];
    const Index last = triangulation.previous(halfedge);
    const double along = (m_distances[triangulation.target(halfedge)] - here) / corner.length;
    const double along_last = (m_distances[triangulation.origin(last)] - here) / m_frames.corner(last).length;
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
    m_frames.for_each_outgoing(vertex, [&](Index h) {
      const double angle = std::atan2(m_frames.corner(h).sine, m_frames.corner(h).cosine);
      sum += angle * face_direction(h);
      weight += angle;
    });
    return weight > 0 ? sum / weight : Complex(0);
  }

  /// The gradients of all vertices; linear.
  std::vector<Complex> gradients() const
  {
    std::vector<Complex> result;
    result.reserve(m_distances.size());
    for (Index vertex = 0; vertex < m_distances.size(); ++vertex) {
      result.push_back(gradient(vertex));
    }
    return result;
  }

  /// The Laplacian times the spacing: that of the vertices around `vertex` or, if it is larger, the mean edge length,
  /// over which a heat method smooths its distances.
  double laplacian(Index vertex) const
  {
    const double area = m_frames.area(vertex);
    if (!(area > 0)) {
      return 0;
    }
    const Triangulation& triangulation = m_frames.triangulation();
    double sum = 0;
    m_frames.for_each_outgoing(vertex, [&](Index h) {
      const Index next = triangulation.next(h);
      const Index last = triangulation.previous(h);
      sum += cotangent(last) * (m_distances[triangulation.origin(next)] - m_distances[vertex]) / 2 +
             cotangent(next) * (m_distances[triangulation.origin(last)] - m_distances[vertex]) / 2;
    });
    const double spacing = std::max(m_frames.mean_edge_length(), std::sqrt(area / area_of_unit_spacing));
    return std::isfinite(sum) ? sum / area * spacing : 0;
  }

  /// The greatest angle in [0, pi] between the gradients of two faces around `vertex` that run towards each other.
  /// O(d^2) for degree d up to a constant, beyond which an even sample of the faces is taken.
  double convergence(Index vertex) const
  {
    Front_sectors sectors;
    collect_sectors(vertex, sectors);
    return greatest_convergence(sectors);
  }

  /// The same of the mean gradients of two neighbors of `vertex`, carried to its frame: they see farther, to where a
  /// heat method does not round off a ridge any more.
  /// \param gradients those of all vertices, as `gradient()` gives them
  double convergence_of_neighbors(Index vertex, const std::vector<Complex>& gradients) const
  {
    // Gradients that are shorter are those of ridges and sources, and have no direction.
    constexpr double least_gradient = 0.1;
    Front_sectors sectors;
    m_frames.for_each_neighbor(vertex, [&](Index neighbor, Index h) {
      const double norm = std::abs(gradients[neighbor]);
      if (norm > least_gradient) {
        const bool is_outgoing = m_frames.triangulation().origin(h) == vertex;
        const double angle = is_outgoing ? m_frames.direction_at_origin(h) : m_frames.direction_at_target(h);
        const Complex transport = m_frames.transport_to_origin(h);
        sectors.push_back(
            {std::polar(1., angle), (is_outgoing ? transport : std::conj(transport)) * gradients[neighbor] / norm});
      }
    });
    return greatest_convergence(sectors);
  }

  /// Whether `vertex` is a point of the cut locus, by the faces around it.
  bool is_cut(Index vertex, const Cut_criterion& criterion) const
  {
    return is_reached(vertex) && laplacian(vertex) <= criterion.laplacian_threshold &&
           convergence(vertex) >= criterion.angle_threshold;
  }

  /// Whether `vertex` is a point of the cut locus, by its neighbors.
  bool is_cut(Index vertex, const Cut_criterion& criterion, const std::vector<Complex>& gradients) const
  {
    return is_reached(vertex) && laplacian(vertex) <= criterion.laplacian_threshold &&
           convergence_of_neighbors(vertex, gradients) >= criterion.angle_threshold;
  }

  /// Collects the faces around `vertex` that have a gradient, counterclockwise.
  void collect_sectors(Index vertex, Front_sectors& sectors) const
  {
    sectors.clear();
    m_frames.for_each_outgoing(vertex, [&](Index h) {
      const Complex gradient = face_direction(h);
      if (gradient != Complex(0)) {
        const auto& corner = m_frames.corner(h);
        // The bisector of the corner, by the half-angle formulas.
        const Complex bisector(std::sqrt((1 + corner.cosine) / 2), std::sqrt((1 - corner.cosine) / 2));
        sectors.push_back({corner.turn * bisector, gradient});
      }
    });
  }

private:
  /// The dual area of a vertex of a regular triangulation with edges of length 1.
  static constexpr double area_of_unit_spacing = 0.8660254037844386;

  /// Of the angle at the origin of `halfedge`; 0 where the face has no area.
  double cotangent(Index halfedge) const
  {
    const auto& corner = m_frames.corner(halfedge);
    return corner.sine > 0 ? corner.cosine / corner.sine : 0;
  }

  const Frames& m_frames;
  const std::vector<double>& m_distances;
};

} // namespace CSCD::internal

#endif // CSCD_CUT_LOCUS_CUT_MEASURES_H
