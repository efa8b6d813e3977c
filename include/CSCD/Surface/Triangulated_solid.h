// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A body bounded by triangles: the surface of the pipeline for meshes.

#ifndef CSCD_SURFACE_TRIANGULATED_SOLID_H
#define CSCD_SURFACE_TRIANGULATED_SOLID_H

#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Halfedge_pairing.h>
#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/config.h>

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace CSCD {

struct Surface_level;
class Surface_levels;

namespace internal {
class Solid_queries;
}

/// A closed triangulated surface in levels of detail and the queries for the body that it bounds. The model of
/// `SkeletonizationSurface` for everything that is made of triangles, and the only one for `Local_policies`.
///
/// Coordinates are normalized (unit area, centroid at the origin) and vertices are in a canonical order, so that
/// results depend on the shape alone. All members are const and may be called by several threads at once.
class Triangulated_solid
{
public:
  /// Closes, fills, orients, refines, renumbers and normalizes `triangles`, and builds levels of detail; near linear.
  /// \param triangles finite points, each with a face; the faces before `first_hole_filling_face` have an area
  /// \param pairing that of the faces, without conflicts and pinched vertices
  /// \param treatment which components are doubled first: a sheet becomes a thin body, of two sides and a rim along its
  ///        wide borders, and its separators from border to border become closed curves around that
  /// \param number_of_threads 0 for as many as TBB allows; the surface is the same for any number
  /// \throw Input_error if the surface has no extent or no area
  Triangulated_solid(Indexed_triangles&& triangles, Halfedge_pairing&& pairing,
                     Border_treatment treatment = Border_treatment::bridge, unsigned number_of_threads = 1);
  Triangulated_solid(Triangulated_solid&&) = delete;
  ~Triangulated_solid();

  /// \name Surface
  /// @{

  /// The finest level.
  const Triangulated_surface& triangulation() const;
  /// All levels of detail.
  const Surface_levels& levels() const { return *m_levels; }
  /// The vertex of the triangles as they were given that `vertex` is; `no_index` for an inserted one.
  Index input_vertex(Index vertex) const { return m_input_vertex[vertex]; }
  /// For each vertex of the triangles as they were given that is on the surface of a cavity: the vertex of the body
  /// that is nearest to it, and its number.
  const std::vector<std::pair<Index, Index>>& cavity_vertices() const { return m_cavity_vertices; }
  /// The connected component of `vertex`; O(log c) for c components.
  Index component(Index vertex) const;
  /// The number of connected components.
  std::size_t number_of_components() const { return m_component_begin.size() - 1; }
  /// The number of handles, over all components.
  std::size_t genus() const;
  /// From the coordinates of the triangles as they were given.
  const Normalization& normalization() const { return m_normalization; }
  /// @}

  /// \name Sheets
  /// @{

  /// The number of components that are doubled sheets.
  std::size_t number_of_sheets() const { return m_number_of_sheets; }
  /// The number of borders of the input that are rims of sheets now.
  std::size_t number_of_wide_borders() const { return m_number_of_wide_borders; }
  /// The side of its sheet on which `vertex` is, 1 or 2; 0 on a component that is no sheet.
  int side_of_sheet(Index vertex) const { return m_side_of_sheet.empty() ? 0 : m_side_of_sheet[vertex]; }
  /// @}

  /// \name Body
  /// The first query builds a search structure.
  /// @{

  /// The level whose surface queries refer to: the finest one of at most 60000 vertices. Finer faces differ from it by
  /// less than the precision of the skeleton.
  const Surface_level& query_level() const;
  /// The surface of that level.
  const Triangulated_surface& query_surface() const;
  /// Whether the body contains `point`. Where the surface intersects itself, what is inside of several sheets is
  /// inside.
  bool is_inside(const Vector_3& point) const;
  /// The point of the surface nearest to `point`.
  Surface_point closest_point(const Vector_3& point) const;
  /// The first point in which the ray from `origin` along `direction` meets the surface, if any.
  std::optional<Surface_hit> first_hit(const Vector_3& origin, const Vector_3& direction) const;
  /// The middle of the body behind the point of the surface nearest to `point`, if there is one.
  std::optional<Vector_3> middle_behind(const Vector_3& point) const;
  /// Writes the distances from `from` at which the segment from there to `to` enters or leaves the body, in ascending
  /// order.
  void crossings(const Vector_3& from, const Vector_3& to, std::vector<double>& distances) const;
  /// @}

  /// \name Changes to the input
  /// @{

  /// The number of borders of the input, which faces without area now close.
  std::size_t number_of_bridged_borders() const { return m_number_of_bridged_borders; }
  /// The number of vertices that are not of the input.
  std::size_t number_of_inserted_vertices() const { return m_number_of_inserted_vertices; }
  /// The number of input faces with (nearly) no area; they are kept.
  std::size_t number_of_degenerate_faces() const { return m_number_of_degenerate_faces; }
  /// The number of components that bound cavities: they were taken out, so that bodies are solid.
  std::size_t number_of_cavities() const { return m_number_of_cavities; }
  /// The number of other components that were oriented inwards in the input.
  std::size_t number_of_reversed_components() const { return m_number_of_reversed_components; }
  /// Writes these numbers and those of the surface to `report`.
  void describe(Skeletonization_report& report) const;
  /// Adds to `report` what the user should know of a mesh, its isolated vertices included.
  void warn(Skeletonization_report& report) const;
  /// @}

private:
  const internal::Solid_queries& queries() const;
  /// Of the face nearest to `place`, the vertex that is nearest.
  Index nearest_vertex(const Vector_3& place) const;

  std::unique_ptr<const Surface_levels> m_levels;
  std::vector<Index> m_input_vertex;
  std::vector<std::pair<Index, Index>> m_cavity_vertices;
  std::vector<Index> m_component_begin;     ///< the first vertex of every component, and the number of vertices
  std::vector<signed char> m_side_of_sheet; ///< of every vertex; empty without sheets
  Normalization m_normalization;
  std::size_t m_number_of_sheets = 0;
  std::size_t m_number_of_wide_borders = 0;
  std::size_t m_number_of_bridged_borders = 0;
  std::size_t m_number_of_inserted_vertices = 0;
  std::size_t m_number_of_degenerate_faces = 0;
  std::size_t m_number_of_cavities = 0;
  std::size_t m_number_of_reversed_components = 0;
  mutable std::once_flag m_queries_built;
  mutable std::unique_ptr<const internal::Solid_queries> m_queries;
};

} // namespace CSCD

#ifndef CSCD_COMPILED
#include <CSCD/Surface/Triangulated_solid_impl.h>
#endif

#endif // CSCD_SURFACE_TRIANGULATED_SOLID_H
