// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A body bounded by triangles: how it is prepared, its surface in levels, queries, and the input vertices it stands
// for.

#ifndef CSCD_SURFACE_TRIANGULATED_SOLID_H
#define CSCD_SURFACE_TRIANGULATED_SOLID_H

#include <CSCD/Options.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Surface/Surface_components.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace CSCD {

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
  const Triangulated_surface& triangulation() const { return m_levels->finest().surface; }
  /// All levels of detail.
  const Surface_levels& levels() const { return *m_levels; }
  /// The vertex of the triangles as they were given that `vertex` is; `no_index` for an inserted one.
  Index input_vertex(Index vertex) const { return m_input_vertex[vertex]; }
  /// For each vertex of the triangles as they were given that is on the surface of a cavity: the vertex of the body
  /// that is nearest to it, and its number.
  const std::vector<std::pair<Index, Index>>& cavity_vertices() const { return m_cavity_vertices; }
  /// The connected component of `vertex`; O(log c) for c components.
  Index component(Index vertex) const
  {
    const auto next = std::upper_bound(m_component_begin.begin(), m_component_begin.end(), vertex);
    return Index(next - m_component_begin.begin()) - 1;
  }
  /// The number of connected components.
  std::size_t number_of_components() const { return m_component_begin.size() - 1; }
  /// The number of handles, over all components.
  std::size_t genus() const
  {
    return genus_of_closed_surface(number_of_components(), triangulation().number_of_vertices(),
                                   triangulation().number_of_faces());
  }
  /// From the coordinates of the triangles as they were given.
  const Normalization& normalization() const { return m_normalization; }
  /// @}

  /// \name Sheets
  /// @{

  /// The number of components that are doubled sheets.
  std::size_t number_of_sheets() const { return m_report.number_of_sheets; }
  /// The side of its sheet that `vertex` is on, 1 or 2; 0 on a component that is not a sheet.
  int side_of_sheet(Index vertex) const { return m_side_of_sheet.empty() ? 0 : m_side_of_sheet[vertex]; }
  /// @}

  /// \name Body
  /// The first query builds a search structure.
  /// @{

  /// The level whose surface queries refer to.
  const Surface_level& query_level() const { return m_levels->precise(); }
  /// The surface of that level.
  const Triangulated_surface& query_surface() const { return query_level().surface; }
  /// Whether the body contains `point`. Where the surface intersects itself, the inside of several sheets is inside.
  bool is_inside(const Vector3& point) const;
  /// The point of the surface nearest to `point`.
  Surface_point closest_point(const Vector3& point) const;
  /// The first point where the ray from `origin` along `direction` meets the surface, if any.
  std::optional<Surface_hit> first_hit(const Vector3& origin, const Vector3& direction) const;
  /// The middle of the body behind the point of the surface nearest to `point`, if there is one.
  std::optional<Vector3> middle_behind(const Vector3& point) const;
  /// Writes to `distances`, ascending, the distances from `from` where the segment from there to `to` enters or leaves
  /// the body.
  void crossings(const Vector3& from, const Vector3& to, std::vector<double>& distances) const;
  /// @}

  /// \name Changes to the input
  /// @{

  /// The number of vertices that are not of the input.
  std::size_t number_of_inserted_vertices() const { return m_report.number_of_inserted_vertices; }
  /// The numbers of all changes and the numbers of the surface.
  const Skeletonization_report& report() const { return m_report; }
  /// Adds warnings about the mesh to `report`, including its isolated vertices.
  void warn(Skeletonization_report& report) const;
  /// @}

private:
  /// Gives the vertices of `triangles` their final order.
  void order_vertices(Indexed_triangles& triangles, Halfedge_pairing&& pairing,
                      const internal::Surface_components& components);

  const internal::Solid_queries& queries() const;
  /// Of the face nearest to `place`, the vertex that is nearest.
  Index nearest_vertex(const Vector3& place) const;

  std::unique_ptr<const Surface_levels> m_levels;
  std::vector<Index> m_input_vertex;
  std::vector<std::pair<Index, Index>> m_cavity_vertices;
  std::vector<Index> m_component_begin;     ///< the first vertex of every component, and the number of vertices
  std::vector<signed char> m_side_of_sheet; ///< of every vertex; empty without sheets
  Normalization m_normalization;
  Skeletonization_report m_report;                 ///< of all changes, and the numbers of the surface
  std::size_t m_number_of_reversed_components = 0; ///< that were oriented inwards in the input, except cavities
  mutable std::once_flag m_queries_built;
  mutable std::unique_ptr<const internal::Solid_queries> m_queries;
};

} // namespace CSCD

namespace CSCD::internal {

/// The body that a mesh bounds, and the numbers of its vertices in the input.
class Prepared_mesh
{
public:
  /// Prepares the triangles that `check()`, a function without arguments, returns as `Checked_triangles`; near linear.
  /// \param treatment which borders are bridged, and which are rims of sheets
  /// \param number_of_threads 0 for as many as TBB allows; the surface is the same for any number
  template <class Check>
  Prepared_mesh(const Check& check, Border_treatment treatment, unsigned number_of_threads)
      : m_start(Clock::now()), m_checked(check()),
        m_solid(std::move(m_checked.triangles), std::move(m_checked.pairing), treatment, number_of_threads)
  {
    if (!m_solid.cavity_vertices().empty()) {
      sort_input_vertices();
    }
    m_seconds = std::chrono::duration<double>(Clock::now() - m_start).count();
  }

  /// The body.
  const Triangulated_solid& solid() const { return m_solid; }
  /// The numbers of the input vertices that belong to `vertex`: its own, unless it was inserted, and the numbers of the
  /// vertices of cavities that it is nearest to.
  CGAL::Iterator_range<const Index*> input_vertices(Index vertex) const
  {
    if (!m_solid.cavity_vertices().empty()) {
      return m_rows[vertex];
    }
    const Index point = m_solid.input_vertex(vertex);
    const Index* first = m_checked.input_number.data() + (point == no_index ? 0 : point);
    return {first, point == no_index ? first : first + 1};
  }
  /// Describes the input in `report`.
  void describe(Skeletonization_report& report) const
  {
    report = m_solid.report();
    report.number_of_input_vertices = m_checked.input_number.size();
    report.number_of_isolated_vertices = m_checked.number_of_isolated_vertices;
    report.seconds[std::size_t(Skeletonization_stage::compile_surface)] = m_seconds;
    m_solid.warn(report);
  }

private:
  using Clock = std::chrono::steady_clock;

  /// Sorts the input vertices by their vertices of the surface.
  void sort_input_vertices()
  {
    const Index n = m_solid.triangulation().number_of_vertices();
    m_rows = Compressed_rows<Index>(n, [&](const auto& add) {
      for (Index vertex = 0; vertex < n; ++vertex) {
        if (m_solid.input_vertex(vertex) != no_index) {
          add(vertex, m_checked.input_number[m_solid.input_vertex(vertex)]);
        }
      }
      for (const auto& [vertex, point] : m_solid.cavity_vertices()) {
        add(vertex, m_checked.input_number[point]);
      }
    });
  }

  Clock::time_point m_start;
  Checked_triangles m_checked; ///< without triangles and pairing, once the body has them
  Triangulated_solid m_solid;
  Compressed_rows<Index> m_rows; ///< input vertices by vertices of the surface, where there are cavities
  double m_seconds = 0;
};

} // namespace CSCD::internal

#ifndef CSCD_COMPILED
#include <CSCD/Surface/Triangulated_solid_impl.h>
#endif

#endif // CSCD_SURFACE_TRIANGULATED_SOLID_H
