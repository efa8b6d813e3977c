// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the heat method prepares once for a surface.

#ifndef CSCD_GEODESIC_HEAT_OPERATORS_H
#define CSCD_GEODESIC_HEAT_OPERATORS_H

#include <CSCD/Geodesic/Cotangent_elements.h>
#include <CSCD/Geodesic/Face_layout.h>
#include <CSCD/Geodesic/Interleaved_solver.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

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
