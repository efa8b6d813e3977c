// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Linear finite elements on triangles that are given by the lengths of their sides.

#ifndef CSCD_PUBLISHED_COTANGENT_ELEMENTS_H
#define CSCD_PUBLISHED_COTANGENT_ELEMENTS_H

#include <CSCD/Published/Intrinsic_triangulation.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// A triangle in the plane, counterclockwise: corner 0 at the origin, corner 1 at (`base`, 0), corner 2 at (`apex_x`,
/// `apex_y`). Vectors in a face are given in this frame, so that a face needs no points in space.
struct Face_layout
{
  double base = 0;   ///< positive
  double apex_x = 0; ///< of any sign
  double apex_y = 0; ///< positive

  double area() const { return base * apex_y / 2; }

  /// For each corner, the entry of the face's stiffness matrix for the two other corners: minus half the cotangent of
  /// the angle at the corner.
  std::array<double, 3> couplings() const
  {
    const double scale = -1 / (2 * base * apex_y);
    return {scale * base * apex_x, scale * base * (base - apex_x),
            scale * (apex_y * apex_y - apex_x * (base - apex_x))};
  }
};

/// In every laid out triangle, two sides together are longer than the third by at least this, relative to the longest:
/// as in geometry-central's mollification. Heights are then at least a thousandth of the longest side, and cotangents
/// at most some hundreds.
inline constexpr double min_excess_length = 1e-5;

/// Lays out the triangle whose sides from corner 0 to 1, 1 to 2 and 2 to 0 have these lengths.
/// A triangle that is degenerate, or that does not exist, is laid out with all sides lengthened by as little as makes
/// it one. This changes no other face: the matrices of the method are sums over faces, each positive semidefinite.
/// \param unit a typical length of the surface, positive: a triangle that is a single point becomes a tiny one
inline Face_layout lay_out_face(std::array<double, 3> lengths, double unit)
{
  // Extent, relative to the unit, below which a triangle counts as a point.
  constexpr double min_extent = 1e-6;
  const double longest = *std::max_element(lengths.begin(), lengths.end());
  const double excess = lengths[0] + lengths[1] + lengths[2] - 2 * longest;
  const double missing = min_excess_length * std::max(longest, min_extent * unit) - excess;
  for (double& length : lengths) {
    length += std::max(missing, 0.);
  }
  const Flat_triangle triangle{lengths[0], lengths[1], lengths[2]};
  return {triangle.base, triangle.foot(), triangle.height()};
}

/// Linear finite elements on a triangulation, from the lengths of its edges alone.
///
/// Every component is measured in its own unit, the mean length of its edges: results on a component do not depend on
/// others, and numbers are moderate whatever the scale is. Borders keep the natural condition, that no heat flows
/// through them. Vertices may be joined by several edges or to themselves.
struct Cotangent_elements
{
  struct Face
  {
    std::array<Index, 3> vertices; ///< the corners 0, 1 and 2 of the layout: origins of the halfedges 3f, 3f+1, 3f+2
    Face_layout layout;            ///< in the unit of its component
  };

  /// Lays out all faces of `triangulation`, which is not referred to later; linear.
  explicit Cotangent_elements(const Intrinsic_triangulation& triangulation)
      : masses(triangulation.number_of_vertices(), 0.)
  {
    number_components(triangulation);
    measure_units(triangulation);
    faces.reserve(triangulation.number_of_faces());
    for (Index f = 0; f < triangulation.number_of_faces(); ++f) {
      add_face(triangulation, f);
    }
  }

  Index number_of_vertices() const { return Index(masses.size()); }
  Index number_of_components() const { return Index(units.size()); }

  /// The lower triangle of (the mass matrix times `mass_factor`) + (the stiffness matrix, the negative Laplacian).
  /// A vertex without mass and stiffness gets a 1 on the diagonal.
  /// \param is_pinned doubles the stiffness's diagonal at one vertex of each component: if the right-hand side adds up
  ///        to 0 on a component, then the equation keeps its solution, but the one with 0 there
  Eigen::SparseMatrix<double> matrix(double mass_factor, bool is_pinned) const
  {
    std::vector<double> diagonal(number_of_vertices(), 0.);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(3 * faces.size() + number_of_vertices());
    for (const Face& face : faces) {
      const std::array<double, 3> couplings = face.layout.couplings();
      for (std::size_t k = 0; k < 3; ++k) {
        const Index i = face.vertices[(k + 1) % 3];
        const Index j = face.vertices[(k + 2) % 3];
        if (i != j) {
          entries.emplace_back(int(std::max(i, j)), int(std::min(i, j)), couplings[k]);
          diagonal[i] -= couplings[k];
          diagonal[j] -= couplings[k];
        }
      }
    }
    std::vector<char> has_pin(is_pinned ? number_of_components() : 0, 0);
    for (Index v = 0; v < number_of_vertices(); ++v) {
      const bool is_pin = is_pinned && std::exchange(has_pin[component[v]], char(1)) == 0;
      const double value = mass_factor * masses[v] + (is_pin ? 2 : 1) * diagonal[v];
      entries.emplace_back(int(v), int(v), value > 0 ? value : 1.);
    }
    Eigen::SparseMatrix<double> result(number_of_vertices(), number_of_vertices());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  std::vector<Face> faces;      ///< by their numbers
  std::vector<double> masses;   ///< of every vertex, a third of the areas of its faces, in the unit of its component
  std::vector<Index> component; ///< of every vertex; vertices of a face are in one
  std::vector<double> units;    ///< of every component, the mean length of its edges, those on no border counted twice

private:
  void number_components(const Intrinsic_triangulation& triangulation)
  {
    Disjoint_sets sets(number_of_vertices());
    for (Index f = 0; f < triangulation.number_of_faces(); ++f) {
      sets.join(triangulation.origin(3 * f), triangulation.origin(3 * f + 1));
      sets.join(triangulation.origin(3 * f), triangulation.origin(3 * f + 2));
    }
    Index number_of_components = 0;
    component = sets.numbers(number_of_components);
    units.assign(number_of_components, 0.);
  }

  void measure_units(const Intrinsic_triangulation& triangulation)
  {
    std::vector<double> count(units.size(), 0.);
    for (Index h = 0; h < triangulation.number_of_halfedges(); ++h) {
      units[component[triangulation.origin(h)]] += triangulation.length(h);
      count[component[triangulation.origin(h)]] += 1;
    }
    for (std::size_t i = 0; i < units.size(); ++i) {
      units[i] = units[i] > 0 ? units[i] / count[i] : 0.;
    }
  }

  void add_face(const Intrinsic_triangulation& triangulation, Index f)
  {
    const double unit = units[component[triangulation.origin(3 * f)]];
    // Where everything is in one point, any finite elements will do: distances get the unit 0.
    std::array<double, 3> lengths{1, 1, 1};
    for (Index k = 0; unit > 0 && k < 3; ++k) {
      lengths[k] = triangulation.length(3 * f + k) / unit;
    }
    faces.push_back({{triangulation.origin(3 * f), triangulation.origin(3 * f + 1), triangulation.origin(3 * f + 2)},
                     lay_out_face(lengths, 1)});
    for (const Index vertex : faces.back().vertices) {
      masses[vertex] += faces.back().layout.area() / 3;
    }
  }
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_COTANGENT_ELEMENTS_H
