// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the triangles of a body are prepared, and its queries.

#ifndef CSCD_SURFACE_TRIANGULATED_SOLID_IMPL_H
#define CSCD_SURFACE_TRIANGULATED_SOLID_IMPL_H

#include <CSCD/Options.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Surface/Surface_components.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Surface/close_surface.h>
#include <CSCD/Surface/double_sheets.h>
#include <CSCD/Surface/refine_large_faces.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/config.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CSCD::internal {

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

/// Doubles sheets and bridges borders; counts both in `report`.
inline Doubled_sheets close(Indexed_triangles& triangles, Halfedge_pairing& pairing, Border_treatment treatment,
                            Skeletonization_report& report)
{
  Doubled_sheets sheets;
  if (treatment != Border_treatment::bridge && pairing.has_border()) {
    sheets = double_sheets(triangles, pairing, treatment == Border_treatment::open);
  }
  if (sheets.number_of_sheets > 0) {
    pairing = Halfedge_pairing(triangles.faces, triangles.points.size());
  }
  report.number_of_sheets = sheets.number_of_sheets;
  report.number_of_wide_borders = sheets.number_of_wide_borders;
  const std::size_t number_of_points = triangles.points.size();
  report.number_of_bridged_borders = bridge_borders(triangles, pairing) - sheets.number_of_copied_borders;
  report.number_of_inserted_vertices = triangles.points.size() - number_of_points;
  if (sheets.number_of_sheets > 0) {
    extend_sides(triangles, sheets.side);
  }
  if (pairing.has_border()) {
    pairing = Halfedge_pairing(triangles.faces, triangles.points.size());
  }
  return sheets;
}

} // namespace CSCD::internal

namespace CSCD {

CSCD_INLINE Triangulated_solid::Triangulated_solid(Clock::time_point start, Checked_triangles&& checked,
                                                   Border_treatment treatment, unsigned number_of_threads)
{
  Indexed_triangles& triangles = checked.triangles;
  Halfedge_pairing& pairing = checked.pairing;
  std::vector<Index>& input_number = checked.input_number; // of every point; added points have none
  m_report.number_of_input_vertices = input_number.size();
  m_report.number_of_isolated_vertices = checked.number_of_isolated_vertices;
  const std::size_t number_of_input_faces = triangles.faces.size();
  const Normalization to_unit_box = normalize_extent(triangles.points);
  internal::Doubled_sheets sheets = internal::close(triangles, pairing, treatment, m_report);
  input_number.resize(triangles.points.size(), no_index);
  internal::Surface_components components(triangles, sheets.side);
  m_report.number_of_degenerate_faces =
      std::size_t(std::count_if(components.degenerate_faces.begin(), components.degenerate_faces.end(),
                                [number_of_input_faces](Index face) { return face < number_of_input_faces; }));
  const internal::Filled_cavities cavities =
      internal::fill_cavities(triangles, pairing, components, m_report.number_of_input_vertices, sheets.side);
  m_report.number_of_cavities = cavities.number;
  const std::vector<Index> cavity_vertices = internal::reordered(input_number, cavities.vertices);
  m_side_of_sheet = std::move(sheets.side);
  if (cavities.number > 0) {
    input_number = internal::reordered(input_number, cavities.old_number);
    m_side_of_sheet = internal::reordered(m_side_of_sheet, cavities.old_number);
  }
  const std::size_t number_of_reversed_components = internal::orient_outwards(triangles, components);
  if (number_of_reversed_components > 0) {
    pairing = Halfedge_pairing(triangles.faces, triangles.points.size());
  }
  internal::split_two_face_components(triangles, pairing, components);
  const bool has_many_limbs = internal::refine_large_faces(triangles, pairing, components);
  m_report.number_of_inserted_vertices += triangles.points.size() - input_number.size();
  input_number.resize(triangles.points.size(), no_index);
  if (m_report.number_of_sheets > 0) {
    internal::extend_sides(triangles, m_side_of_sheet);
  }
  const std::vector<Index> order = internal::canonical_order(triangles, pairing, components);
  for (Index i = 1; components.number() > 1 && i < order.size(); ++i) {
    if (components.component_of_vertex(pairing, order[i]) != components.component_of_vertex(pairing, order[i - 1])) {
      m_first_vertices.push_back(i);
    }
  }
  pairing = {}; // before memory is allocated for the pairing of the new numbers
  renumber(triangles, order);
  input_number = internal::reordered(input_number, order);
  m_side_of_sheet = internal::reordered(m_side_of_sheet, order);
  // Summed in canonical order, the area and the centroid are the same for any order of the input.
  const Normalization to_unit_area = normalize_area(triangles);
  m_normalization = to_unit_box.then(to_unit_area);
  Triangulated_surface surface(std::move(triangles), number_of_threads);
  CGAL_postcondition(!surface.has_defect());
  m_levels = std::make_unique<const Surface_levels>(std::move(surface), number_of_threads, has_many_limbs);
  m_report.number_of_levels = m_levels->size();
  m_report.number_of_surface_components = components.number();
  m_report.genus = genus_of_closed_surface(components.number(), triangulation().number_of_vertices(),
                                           triangulation().number_of_faces());

  std::vector<Index> nearest; // to each vertex of cavities
  for (const Vector3& place : cavities.places) {
    nearest.push_back(nearest_vertex(to_unit_area.from_input(place)));
  }
  m_input_vertices = internal::Compressed_rows<Index>(input_number.size(), [&](const auto& add) {
    for (Index vertex = 0; vertex < input_number.size(); ++vertex) {
      if (input_number[vertex] != no_index) {
        add(vertex, input_number[vertex]);
      }
    }
    for (std::size_t i = 0; i < nearest.size(); ++i) {
      add(nearest[i], cavity_vertices[i]);
    }
  });
  warn(number_of_reversed_components);
  m_report.seconds[std::size_t(Skeletonization_stage::compile_surface)] =
      std::chrono::duration<double>(Clock::now() - start).count();
}

CSCD_INLINE void Triangulated_solid::build_component_queries() const
{
  const Triangulated_surface& surface = query_surface();
  const internal::Compressed_rows<Index> faces(number_of_components(), [&](const auto& add) {
    for (Index face = 0; face < surface.number_of_faces(); ++face) {
      add(component(query_level().to_finest(surface.origin(3 * face))), face);
    }
  });
  const std::vector<internal::Bounding_box> boxes = internal::Solid_queries::face_boxes(surface);
  m_component_queries.reserve(number_of_components());
  for (Index c = 0; c < number_of_components(); ++c) {
    m_component_queries.emplace_back(surface, boxes, faces[c]);
  }
}

CSCD_INLINE void Triangulated_solid::warn(std::size_t number_of_reversed_components)
{
  m_report.add_warning(m_report.number_of_isolated_vertices, "vertex without a face: it belongs to no node",
                       "vertices without a face: they belong to no node");
  m_report.add_warning(m_report.number_of_bridged_borders, "border: bridged by faces without weight",
                       "borders: bridged by faces without weight");
  m_report.add_warning(m_report.number_of_sheets, "sheet: its separators lead from border to border",
                       "sheets: their separators lead from border to border");
  m_report.add_warning(m_report.number_of_degenerate_faces, "face with (nearly) no area",
                       "faces with (nearly) no area");
  m_report.add_warning(m_report.number_of_cavities,
                       "cavity: filled; its vertices belong to the nodes of the body around",
                       "cavities: filled; their vertices belong to the nodes of the bodies around");
  m_report.add_warning(number_of_reversed_components, "component that faced inwards: turned",
                       "components that faced inwards: turned");
}

CSCD_INLINE Index Triangulated_solid::nearest_vertex(const Vector3& place) const
{
  const Surface_level& level = query_level();
  const auto sides = Triangulated_surface::face_halfedges(queries().closest_point(place).face);
  const auto distance = [&](Index h) { return (level.surface.point(level.surface.origin(h)) - place).squaredNorm(); };
  return level.to_finest(level.surface.origin(*std::min_element(
      sides.begin(), sides.end(), [&distance](Index a, Index b) { return distance(a) < distance(b); })));
}

} // namespace CSCD

#endif // CSCD_SURFACE_TRIANGULATED_SOLID_IMPL_H
