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
#include <CSCD/Surface/double_sheets.h>
#include <CSCD/Surface/fill_cavities.h>
#include <CSCD/Surface/refine_large_faces.h>
#include <CSCD/Surface/sample_limbs.h>
#include <CSCD/Vector_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// A surface in normalized coordinates and canonical order, and what was done to the input for it.
struct Compiled_surface
{
  Triangulated_surface surface; ///< not measured yet
  Normalization normalization;
  std::vector<Index> input_point;     ///< the point of the input that a vertex is, `no_index` for an inserted vertex
  std::vector<Index> component_begin; ///< the first vertex of every component, and the number of vertices at the end
  std::vector<signed char> side_of_sheet; ///< of every vertex, 1 or 2, or 0; empty without sheets
  Filled_cavities cavities;               ///< places in normalized coordinates
  bool has_sampled_limbs = false;         ///< so many that coarser levels would lose them
  std::size_t number_of_sheets = 0;
  std::size_t number_of_wide_borders = 0;
  std::size_t number_of_bridged_borders = 0;
  std::size_t number_of_inserted_vertices = 0;
  std::size_t number_of_degenerate_faces = 0;
  std::size_t number_of_reversed_components = 0;
};

/// Gives the vertices of `triangles` that have been inserted since `side` was filled the side of some neighbor; linear
/// for each level of insertion.
inline void extend_sides(const Indexed_triangles& triangles, std::vector<signed char>& side)
{
  constexpr signed char unknown = -1;
  side.resize(triangles.points.size(), unknown);
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    for (const std::array<Index, 3>& face : triangles.faces) {
      const signed char known = std::max({side[face[0]], side[face[1]], side[face[2]]});
      for (const Index corner : face) {
        if (side[corner] == unknown && known != unknown) {
          side[corner] = known;
          is_changed = true;
        }
      }
    }
  }
}

/// Closes, orients, refines, renumbers and normalizes `triangles`, and compiles them; near linear.
/// \param treatment which components are doubled as sheets instead of being closed
/// \param number_of_threads 0 for as many as TBB allows; the result is the same for any number
/// \pre the points are finite, each has a face, and `pairing`, that of the faces, has no conflict and no pinched vertex
/// \throw Input_error if the surface has no extent or no area
inline Compiled_surface compile_surface(Indexed_triangles&& triangles, Halfedge_pairing&& pairing,
                                        Border_treatment treatment, unsigned number_of_threads)
{
  Compiled_surface result;
  std::size_t number_of_input_points = triangles.points.size();
  const std::size_t number_of_input_faces = triangles.faces.size();
  const Normalization to_unit_box = normalize_extent(triangles.points);
  Doubled_sheets sheets;
  if (treatment != Border_treatment::bridge && pairing.has_border()) {
    sheets = double_sheets(triangles, pairing, treatment == Border_treatment::open);
  }
  if (sheets.number_of_sheets > 0) {
    pairing = Halfedge_pairing(triangles.faces, triangles.points.size());
  }
  const std::size_t number_of_copied_points = triangles.points.size() - number_of_input_points;
  result.number_of_sheets = sheets.number_of_sheets;
  result.number_of_wide_borders = sheets.number_of_wide_borders;
  result.number_of_bridged_borders = bridge_borders(triangles, pairing) - sheets.number_of_copied_borders;
  if (pairing.has_border()) {
    pairing = Halfedge_pairing(triangles.faces, triangles.points.size());
  }
  Surface_components components(triangles);
  result.number_of_degenerate_faces =
      std::size_t(std::count_if(components.degenerate_faces.begin(), components.degenerate_faces.end(),
                                [number_of_input_faces](Index face) { return face < number_of_input_faces; }));
  result.cavities = fill_cavities(triangles, pairing, components, number_of_input_points, sheets.side);
  number_of_input_points -= result.cavities.vertices.size();
  if (result.cavities.number > 0 && !sheets.side.empty()) {
    for (std::size_t i = 0; i < result.cavities.old_number.size(); ++i) {
      sheets.side[i] = sheets.side[result.cavities.old_number[i]]; // which is not less than i
    }
    sheets.side.resize(result.cavities.old_number.size());
  }
  result.number_of_reversed_components = orient_outwards(triangles, pairing, components);
  split_two_face_components(triangles, pairing, components);
  result.has_sampled_limbs = sample_limbs(triangles, pairing, components, sheets.side) > 0;
  refine_large_faces(triangles, pairing, components);
  result.number_of_inserted_vertices = triangles.points.size() - number_of_input_points - number_of_copied_points;
  if (sheets.number_of_sheets > 0) {
    extend_sides(triangles, sheets.side);
  }

  Canonical_order order = canonical_order(triangles, pairing, components);
  pairing = {}; // before memory is taken for those of the new numbers
  renumber(triangles, order.vertices);
  result.side_of_sheet.resize(sheets.side.size());
  for (std::size_t i = 0; i < sheets.side.size(); ++i) {
    result.side_of_sheet[i] = sheets.side[order.vertices[i]];
  }
  result.input_point = std::move(order.vertices);
  for (Index& point : result.input_point) {
    const bool is_renumbered = point < number_of_input_points && result.cavities.number > 0;
    point = is_renumbered ? result.cavities.old_number[point] : point < number_of_input_points ? point : no_index;
  }
  result.component_begin = std::move(order.component_begin);
  // Summed in canonical order, the area and the centroid are the same whatever the order of the input was.
  const Normalization to_unit_area = normalize_area(triangles);
  result.normalization = to_unit_box.then(to_unit_area);
  for (Vector_3& place : result.cavities.places) {
    place = to_unit_area.from_input(place);
  }
  result.surface = Triangulated_surface(std::move(triangles), number_of_threads);
  CGAL_postcondition(!result.surface.defect());
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_SURFACE_COMPILE_SURFACE_H
