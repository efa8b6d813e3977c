// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sources, fields and operators of the heat method.

#ifndef CSCD_GEODESIC_HEAT_OPERATORS_H
#define CSCD_GEODESIC_HEAT_OPERATORS_H

#include <CSCD/Geodesic/Cotangent_elements.h>
#include <CSCD/Geodesic/Interleaved_solver.h>
#include <CSCD/Vector_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// A point of a surface from which distance is measured, seen from the vertices around it: so it is a source on every
/// triangulation of the surface with the same vertices.
struct Geodesic_source
{
  static Geodesic_source at_vertex(Index vertex) { return {{vertex, vertex, vertex}, {1, 0, 0}, {0, 0, 0}}; }

  /// The point in a face of `triangulation` with these barycentric coordinates with respect to the origins of the
  /// halfedges 3 `face`, 3 `face` + 1 and 3 `face` + 2.
  /// \pre the coordinates are not negative, and their sum is 1; the face carries area
  template <class Triangulation>
  static Geodesic_source in_face(const Triangulation& triangulation, Index face,
                                 const std::array<double, 3>& coordinates)
  {
    const std::array<double, 3> lengths{triangulation.length(3 * face), triangulation.length(3 * face + 1),
                                        triangulation.length(3 * face + 2)};
    const double unit = (lengths[0] + lengths[1] + lengths[2]) / 3;
    const Face_layout layout = lay_out_face(lengths, unit > 0 ? unit : 1.);
    const std::array<double, 2> point = layout.point(coordinates);
    Geodesic_source result{};
    for (Index k = 0; k < 3; ++k) {
      const Index corner = triangulation.origin(3 * face + k);
      if (coordinates[k] == 1) {
        return at_vertex(corner);
      }
      const std::array<double, 2> position = layout.corner(k);
      result.vertices[k] = corner;
      result.weights[k] = coordinates[k];
      result.distances[k] = std::hypot(position[0] - point[0], position[1] - point[1]);
    }
    return result;
  }

  bool is_vertex() const { return weights[0] == 1; }

  std::array<Index, 3> vertices;   ///< around the point
  std::array<double, 3> weights;   ///< its barycentric coordinates
  std::array<double, 3> distances; ///< from it to the vertices, in the unit of the lengths
};

/// Distances from a set of sources, and on request what they were computed from.
struct Heat_field
{
  /// Of every vertex, in the unit of the lengths; 0 at vertices that are sources, infinite on components without a
  /// source. Close to several sources, or to one inside a face, values may be a little below 0.
  std::vector<double> distances;
  /// Of every face, in the frame of its layout: the unit vector away from the sources, which is the gradient of the
  /// exact distance; zero where there is none. Empty unless asked for.
  std::vector<Eigen::Vector2d> directions;
  /// The natural logarithm of the heat at every vertex, up to a constant for each component; -infinity on components
  /// without a source, and where the heat is not positive, as happens where faces are not Delaunay. On Delaunay
  /// triangulations every vertex but the sources has a neighbor with more heat. Empty unless asked for.
  std::vector<double> log_heat;
};

/// Which parts of a field are wanted besides the distances.
struct Heat_field_parts
{
  bool directions = false;
  bool log_heat = false;
};

/// The elements of a surface and the factors of the heat method's two equations.
struct Heat_operators
{
  /// The numbers of the matrices in `solver`.
  static constexpr std::size_t heat = 0;    ///< masses / time + stiffness: one implicit step of heat flow
  static constexpr std::size_t poisson = 1; ///< stiffness, pinned

  /// \param step_factor the duration of the heat flow, in squared mean edge lengths
  template <class Triangulation>
  Heat_operators(const Triangulation& triangulation, double step_factor)
      : elements(triangulation),
        solver({elements.matrix(1 / step_factor, false), elements.matrix(0, true)},
               "the Laplacian of the surface cannot be factored: its triangles are too uneven; remesh it, for instance "
               "by CGAL::Polygon_mesh_processing::isotropic_remeshing")
  {
    faces.reserve(elements.faces().size());
    for (const Cotangent_elements::Face& face : elements.faces()) {
      faces.push_back({{solver.place(face.vertices[0]), solver.place(face.vertices[1]), solver.place(face.vertices[2])},
                       face.face,
                       elements.component(face.vertices[0]),
                       face.layout});
    }
    const auto first_place = [](const Face& face) { return *std::min_element(face.places.begin(), face.places.end()); };
    std::sort(faces.begin(), faces.end(), [&](const Face& a, const Face& b) {
      return std::make_pair(first_place(a), a.face) < std::make_pair(first_place(b), b.face);
    });
  }

  /// A face of the elements, in the order of elimination.
  struct Face
  {
    std::array<Index, 3> places; ///< of its corners
    Index face;                  ///< its number in the triangulation
    Index component;
    Face_layout layout;
  };

  Cotangent_elements elements;
  Interleaved_solver solver;
  std::vector<Face> faces; ///< near numbers are near in the order of elimination
};

} // namespace CSCD::internal

#endif // CSCD_GEODESIC_HEAT_OPERATORS_H
