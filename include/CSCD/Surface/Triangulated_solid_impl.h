// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of Triangulated_solid.h.

#ifndef CSCD_SURFACE_TRIANGULATED_SOLID_IMPL_H
#define CSCD_SURFACE_TRIANGULATED_SOLID_IMPL_H

#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Surface/compile_surface.h>

#include <algorithm>
#include <utility>

namespace CSCD {

CSCD_INLINE Triangulated_solid::Triangulated_solid(Indexed_triangles&& triangles, Halfedge_pairing&& pairing,
                                                   Border_treatment treatment, unsigned number_of_threads)
{
  internal::Compiled_surface compiled =
      internal::compile_surface(std::move(triangles), std::move(pairing), treatment, number_of_threads);
  m_input_vertex = std::move(compiled.input_point);
  m_component_begin = std::move(compiled.component_begin);
  m_normalization = compiled.normalization;
  m_side_of_sheet = std::move(compiled.side_of_sheet);
  m_number_of_sheets = compiled.number_of_sheets;
  m_number_of_wide_borders = compiled.number_of_wide_borders;
  m_number_of_bridged_borders = compiled.number_of_bridged_borders;
  m_number_of_inserted_vertices = compiled.number_of_inserted_vertices;
  m_number_of_degenerate_faces = compiled.number_of_degenerate_faces;
  m_number_of_reversed_components = compiled.number_of_reversed_components;
  m_levels = std::make_unique<const Surface_levels>(std::move(compiled.surface), number_of_threads,
                                                    compiled.has_sampled_limbs);
  m_number_of_cavities = compiled.cavities.number;
  m_cavity_vertices.reserve(compiled.cavities.vertices.size());
  for (std::size_t i = 0; i < compiled.cavities.vertices.size(); ++i) {
    m_cavity_vertices.emplace_back(nearest_vertex(compiled.cavities.places[i]), compiled.cavities.vertices[i]);
  }
}

CSCD_INLINE Triangulated_solid::~Triangulated_solid() = default;

CSCD_INLINE const Triangulated_surface& Triangulated_solid::triangulation() const
{
  return m_levels->finest().surface;
}

CSCD_INLINE Index Triangulated_solid::component(Index vertex) const
{
  return Index(std::upper_bound(m_component_begin.begin(), m_component_begin.end(), vertex) -
               m_component_begin.begin()) -
         1;
}

CSCD_INLINE std::size_t Triangulated_solid::genus() const
{
  return genus_of_closed_surface(number_of_components(), triangulation().number_of_vertices(),
                                 triangulation().number_of_faces());
}

CSCD_INLINE const Surface_level& Triangulated_solid::query_level() const
{
  constexpr Index max_vertices = 60000;
  return (*m_levels)[m_levels->finest_with_at_most(max_vertices)];
}

CSCD_INLINE const Triangulated_surface& Triangulated_solid::query_surface() const
{
  return query_level().surface;
}

CSCD_INLINE bool Triangulated_solid::is_inside(const Vector_3& point) const
{
  return queries().is_inside(point);
}

CSCD_INLINE Surface_point Triangulated_solid::closest_point(const Vector_3& point) const
{
  return queries().closest_point(point);
}

CSCD_INLINE std::optional<Surface_hit> Triangulated_solid::first_hit(const Vector_3& origin,
                                                                     const Vector_3& direction) const
{
  return queries().first_hit(origin, direction);
}

CSCD_INLINE std::optional<Vector_3> Triangulated_solid::middle_behind(const Vector_3& point) const
{
  return queries().middle_behind(point);
}

CSCD_INLINE void Triangulated_solid::crossings(const Vector_3& from, const Vector_3& to,
                                               std::vector<double>& distances) const
{
  queries().crossings(from, to, distances);
}

CSCD_INLINE void Triangulated_solid::describe(Skeletonization_report& report) const
{
  report.number_of_surface_components = number_of_components();
  report.number_of_bridged_borders = number_of_bridged_borders();
  report.number_of_sheets = number_of_sheets();
  report.number_of_wide_borders = number_of_wide_borders();
  report.number_of_cavities = number_of_cavities();
  report.number_of_inserted_vertices = number_of_inserted_vertices();
  report.number_of_degenerate_faces = number_of_degenerate_faces();
  report.number_of_levels = levels().size();
  report.genus = genus();
}

CSCD_INLINE void Triangulated_solid::warn(Skeletonization_report& report) const
{
  report.add_warning(report.number_of_isolated_vertices, "vertex without a face: it belongs to no node",
                     "vertices without a face: they belong to no node");
  report.add_warning(number_of_bridged_borders(), "border: bridged by faces without weight",
                     "borders: bridged by faces without weight");
  report.add_warning(number_of_sheets(), "sheet: its separators lead from border to border",
                     "sheets: their separators lead from border to border");
  report.add_warning(number_of_degenerate_faces(), "face with (nearly) no area", "faces with (nearly) no area");
  report.add_warning(number_of_cavities(), "cavity: filled; its vertices belong to the nodes of the body around",
                     "cavities: filled; their vertices belong to the nodes of the bodies around");
  report.add_warning(number_of_reversed_components(), "component that faced inwards: turned",
                     "components that faced inwards: turned");
}

CSCD_INLINE Index Triangulated_solid::nearest_vertex(const Vector_3& place) const
{
  const Surface_level& level = query_level();
  const Index first = 3 * closest_point(place).face;
  Index nearest = level.surface.origin(first);
  for (const Index halfedge : {first + 1, first + 2}) {
    const Index vertex = level.surface.origin(halfedge);
    if ((level.surface.point(vertex) - place).squaredNorm() < (level.surface.point(nearest) - place).squaredNorm()) {
      nearest = vertex;
    }
  }
  return level.to_finest(nearest);
}

CSCD_INLINE const internal::Solid_queries& Triangulated_solid::queries() const
{
  std::call_once(m_queries_built,
                 [this] { m_queries = std::make_unique<const internal::Solid_queries>(query_surface()); });
  return *m_queries;
}

} // namespace CSCD

#endif // CSCD_SURFACE_TRIANGULATED_SOLID_IMPL_H
