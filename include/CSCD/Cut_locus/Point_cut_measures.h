// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What tells the cut locus from the rest of a distance field on a point cloud, vertex by vertex.

#ifndef CSCD_CUT_LOCUS_POINT_CUT_MEASURES_H
#define CSCD_CUT_LOCUS_POINT_CUT_MEASURES_H

#include <CSCD/Cut_locus/Cut_criterion.h>
#include <CSCD/Cut_locus/Front_sector.h>
#include <CSCD/Cut_locus/Point_derivatives.h>
#include <CSCD/Cut_locus/Point_frames.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/assertions.h>

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <complex>
#include <vector>

namespace CSCD::internal {

/// What `Cut_measures` are on a triangulation, on a point complex (supplement, appendix G.2): the derivatives of a
/// distance field at the vertices, each computed when it is asked for. The gradient that a vertex has is the mean of
/// those of its immediate neighbors and its own: a single one follows the noise of a few points. Only the immediate
/// neighbors of a vertex are compared.
class Point_cut_measures
{
public:
  using Frames = Point_frames;
  using Complex = Frames::Complex;
  using Basis = Point_derivatives; ///< what these are made of

  static const Frames& frames_of(const Basis& basis) { return basis.frames(); }

  /// When a vertex of a cloud counts as a point of the cut locus. Less is asked than on a mesh, since means over
  /// neighbors round a ridge off. Chosen on samples of a sphere, a capsule, a torus, an ellipsoid and a flat tube,
  /// random or even, with noise or without: of what passes, 99.8 % lies within two edges of the true cut locus (of
  /// single gradients 97.9 %, and 70 % on the worst cloud), and the cut locus where fronts meet at 60 degrees is near
  /// such a vertex everywhere. At a threshold of 60 degrees it is not (doc/cut_locus.md).
  static constexpr Cut_criterion default_criterion() { return {-0.35, boost::math::double_constants::pi / 4}; }

  /// \param distances the distance of every vertex, infinite or not a number where it is unknown; as `derivatives`, it
  ///        is referred to and must outlive this object
  Point_cut_measures(const Point_derivatives& derivatives, const std::vector<double>& distances)
      : m_derivatives(derivatives), m_distances(distances)
  {
    CGAL_precondition(distances.size() == frames().triangulation().number_of_vertices());
  }

  const Frames& frames() const { return m_derivatives.frames(); }
  const std::vector<double>& distances() const { return m_distances; }
  double distance(Index vertex) const { return m_distances[vertex]; }
  bool is_reached(Index vertex) const { return std::isfinite(m_distances[vertex]); }

  /// The mean gradient of `vertex` and its neighbors, in its frame: it is shorter than 1 where they disagree. O(d^2)
  /// for degree d.
  Complex gradient(Index vertex) const
  {
    return mean_gradient(vertex, [this](Index v) { return m_derivatives.gradient(v, m_distances); });
  }

  /// The gradients of all vertices; linear for bounded degrees.
  std::vector<Complex> gradients() const
  {
    std::vector<Complex> single;
    single.reserve(m_distances.size());
    for (Index vertex = 0; vertex < m_distances.size(); ++vertex) {
      single.push_back(m_derivatives.gradient(vertex, m_distances));
    }
    std::vector<Complex> result;
    result.reserve(m_distances.size());
    for (Index vertex = 0; vertex < m_distances.size(); ++vertex) {
      result.push_back(mean_gradient(vertex, [&single](Index v) { return single[v]; }));
    }
    return result;
  }

  /// The Laplacian times the spacing, see `Point_derivatives`. O(d) for degree d.
  double laplacian(Index vertex) const
  {
    const double result = m_derivatives.laplacian(vertex, m_distances);
    return std::isfinite(result) ? result : 0;
  }

  /// The greatest angle in [0, pi] between the gradients of two neighbors of `vertex` that run towards each other.
  double convergence(Index vertex) const
  {
    Front_sectors sectors;
    collect_sectors(vertex, sectors);
    return greatest_convergence(sectors);
  }

  /// The same with known gradients. \param gradients those of all vertices, as `gradients()` gives them
  double convergence_of_neighbors(Index vertex, const std::vector<Complex>& gradients) const
  {
    Front_sectors sectors;
    collect_sectors(
        vertex, [&gradients](Index neighbor) { return gradients[neighbor]; }, sectors);
    return greatest_convergence(sectors);
  }

  /// Whether `vertex` is a point of the cut locus.
  bool is_cut(Index vertex, const Cut_criterion& criterion) const
  {
    return is_reached(vertex) && laplacian(vertex) <= criterion.laplacian_threshold &&
           convergence(vertex) >= criterion.angle_threshold;
  }

  /// The same with known gradients.
  bool is_cut(Index vertex, const Cut_criterion& criterion, const std::vector<Complex>& gradients) const
  {
    return is_reached(vertex) && laplacian(vertex) <= criterion.laplacian_threshold &&
           convergence_of_neighbors(vertex, gradients) >= criterion.angle_threshold;
  }

  /// Collects the neighbors of `vertex` that have a gradient, counterclockwise.
  void collect_sectors(Index vertex, Front_sectors& sectors) const
  {
    collect_sectors(
        vertex, [this](Index neighbor) { return gradient(neighbor); }, sectors);
  }

private:
  template <class Gradient>
  Complex mean_gradient(Index vertex, const Gradient& gradient_of) const
  {
    Complex sum = gradient_of(vertex);
    double number = 1;
    frames().for_each_neighbor(vertex, [&](Index neighbor, Index h) {
      sum += frames().transport_to_origin(h) * gradient_of(neighbor);
      number += 1;
    });
    return sum / number;
  }

  template <class Gradient>
  void collect_sectors(Index vertex, const Gradient& gradient_of, Front_sectors& sectors) const
  {
    // Gradients that are shorter are those of ridges and sources, and have no direction.
    constexpr double least_gradient = 0.1;
    sectors.clear();
    frames().for_each_neighbor(vertex, [&](Index neighbor, Index h) {
      const Complex gradient = gradient_of(neighbor);
      const double norm = std::abs(gradient);
      if (norm > least_gradient && std::isfinite(norm)) {
        sectors.push_back(
            {std::polar(1., frames().direction_at_origin(h)), frames().transport_to_origin(h) * gradient / norm});
      }
    });
  }

  const Point_derivatives& m_derivatives;
  const std::vector<double>& m_distances;
};

} // namespace CSCD::internal

#endif // CSCD_CUT_LOCUS_POINT_CUT_MEASURES_H
