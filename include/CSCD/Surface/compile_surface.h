// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From checked triangles to the surface on which everything is computed.

#ifndef CSCD_SURFACE_COMPILE_SURFACE_H
#define CSCD_SURFACE_COMPILE_SURFACE_H

#include <CSCD/Surface/Halfedge_pairing.h>
#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Surface/Surface_components.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Surface/bridge_borders.h>
#include <CSCD/Surface/canonical_order.h>
#include <CSCD/Surface/refine_large_faces.h>
#include <CSCD/Vector_3.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// A surface in normalized coordinates and canonical order, and what was done to the input for it.
struct Compiled_surface
{
  Triangulated_surface surface;
  Normalization normalization;
  std::vector<Index> input_point;     ///< the point of the input that a vertex is, `no_index` for an inserted vertex
  std::vector<Index> component_begin; ///< the first vertex of every component, and the number of vertices at the end
  std::size_t number_of_bridged_borders = 0;
  std::size_t number_of_inserted_vertices = 0;
  std::size_t number_of_degenerate_faces = 0;
  std::size_t number_of_reversed_components = 0;
};

/// Closes, orients, refines, renumbers and normalizes `triangles`, and compiles them; near linear.
/// \pre the points are finite, each has a face, and `pairing`, that of the faces, has no conflict and no pinched vertex
/// \throw Input_error if the surface has no extent or no area
inline Compiled_surface compile_surface(Indexed_triangles&& triangles, Halfedge_pairing&& pairing)
{
  Compiled_surface result;
  const std::size_t number_of_input_points = triangles.points.size();
  const Normalization to_unit_box = normalize_extent(triangles.points);
  result.number_of_bridged_borders = bridge_borders(triangles, pairing);
  if (pairing.has_border()) {
    pairing = Halfedge_pairing(triangles.faces, triangles.points.size());
  }
  Surface_components components(triangles, pairing);
  result.number_of_degenerate_faces = components.number_of_degenerate_faces;
  result.number_of_reversed_components = orient_outwards(triangles, pairing, components);
  split_two_face_components(triangles, pairing, components);
  refine_large_faces(triangles, pairing, components);
  result.number_of_inserted_vertices = triangles.points.size() - number_of_input_points;

  Canonical_order order = canonical_order(triangles, pairing, components);
  pairing = {}; // before memory is taken for those of the new numbers
  renumber(triangles, order.vertices);
  result.input_point = std::move(order.vertices);
  for (Index& point : result.input_point) {
    point = point < number_of_input_points ? point : no_index;
  }
  result.component_begin = std::move(order.component_begin);
  // Summed in canonical order, the area and the centroid are the same whatever the order of the input was.
  result.normalization = to_unit_box.then(normalize_area(triangles));
  result.surface = Triangulated_surface(std::move(triangles));
  CGAL_postcondition(!result.surface.defect());
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_SURFACE_COMPILE_SURFACE_H
