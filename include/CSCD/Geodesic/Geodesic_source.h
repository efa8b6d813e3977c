// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where geodesic distance is measured from.

#ifndef CSCD_GEODESIC_GEODESIC_SOURCE_H
#define CSCD_GEODESIC_GEODESIC_SOURCE_H

#include <CSCD/Geodesic/Face_layout.h>
#include <CSCD/internal/Vector_3.h>

#include <array>
#include <cmath>

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

} // namespace CSCD::internal

#endif // CSCD_GEODESIC_GEODESIC_SOURCE_H
