// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A body bounded by triangles: how it is prepared, its surface in levels, queries, and the input vertices it stands
// for.

#ifndef CSCD_SURFACE_TRIANGULATED_SOLID_H
#define CSCD_SURFACE_TRIANGULATED_SOLID_H

#include <CSCD/Options.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/Iterator_range.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace CSCD {

/// A closed triangulated surface in levels of detail and the queries for the body that it bounds. The model of
/// `SkeletonizationSurface` for everything that is made of triangles, and the only one for `Local_policies`.
///
/// Coordinates are normalized (unit area, centroid at the origin) and vertices are in a canonical order, so that
/// results depend on the shape alone. All members are const and may be called by several threads at once.
class Triangulated_solid
{
public:
  /// Checks, closes, fills, orients, refines, renumbers and normalizes triangles, and builds levels of detail; near
  /// linear.
  /// \param points the points, some perhaps without a face
  /// \param faces the corners of each face, three different ones, less than the number of points
  /// \param treatment which components are doubled first: a sheet becomes a thin body, of two sides and a rim along its
  ///        wide borders, and its separators from border to border become closed curves around that
  /// \param number_of_threads 0 for as many as TBB allows; the surface is the same for any number
  /// \throw Input_error as `check_triangles()` does, or if the surface has no extent or no area
  Triangulated_solid(std::vector<Vector3>&& points, std::vector<std::array<Index, 3>>&& faces,
                     Border_treatment treatment = Border_treatment::automatic, unsigned number_of_threads = 1)
      : Triangulated_solid{Clock::now(), check_triangles(std::move(points), std::move(faces), number_of_threads),
                           treatment, number_of_threads}
  {
  }
  /// The same for triangles whose halfedges are paired; the faces before `first_hole_filling_face` have an area.
  /// \pre `pairing` is that of the faces, and has no conflict and no pinched vertex
  Triangulated_solid(Indexed_triangles&& triangles, Halfedge_pairing&& pairing,
                     Border_treatment treatment = Border_treatment::automatic, unsigned number_of_threads = 1)
      : Triangulated_solid{Clock::now(), check_triangles(std::move(triangles), std::move(pairing), number_of_threads),
                           treatment, number_of_threads}
  {
  }
  Triangulated_solid(Triangulated_solid&&) = delete;

  /// \name Surface
  /// @{

  /// The finest level.
  const Triangulated_surface& triangulation() const { return m_levels->finest().surface; }
  /// All levels of detail.
  const Surface_levels& levels() const { return *m_levels; }
  /// The numbers of the points as they were given that belong to `vertex`: its own, unless it was inserted, and the
  /// numbers of the vertices of cavities that it is nearest to.
  CGAL::Iterator_range<const Index*> input_vertices(Index vertex) const { return m_input_vertices[vertex]; }
  /// The number of connected components.
  std::size_t number_of_components() const { return m_report.number_of_surface_components; }
  /// The component of `vertex`.
  Index component(Index vertex) const
  {
    return Index(std::upper_bound(m_first_vertices.begin(), m_first_vertices.end(), vertex) - m_first_vertices.begin());
  }
  /// The number of handles, over all components.
  std::size_t genus() const { return *m_report.genus; }
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
  bool is_inside(const Vector3& point) const { return queries().is_inside(point); }
  /// These and further queries of the body.
  const internal::Solid_queries& queries() const
  {
    std::call_once(m_queries_built, [this] { m_queries.emplace(query_surface()); });
    return *m_queries;
  }
  /// The same for the body that `component` alone bounds; if it is `no_index`, for all.
  const internal::Solid_queries& queries(Index component) const
  {
    if (m_first_vertices.empty() || component == no_index) {
      return queries();
    }
    std::call_once(m_component_queries_built, [this] { build_component_queries(); });
    return m_component_queries[component];
  }
  /// The middle of the body behind the point of the surface nearest to `point`, if there is one.
  std::optional<Vector3> middle_behind(const Vector3& point) const { return queries().middle_behind(point); }
  /// Writes to `distances`, ascending, the distances from `from` where the segment from there to `to` enters or leaves
  /// the body.
  void crossings(const Vector3& from, const Vector3& to, std::vector<double>& distances) const
  {
    queries().crossings(from, to, distances);
  }
  /// @}

  /// The numbers of the input and of the surface, all changes, and warnings about them.
  const Skeletonization_report& report() const { return m_report; }

private:
  using Clock = std::chrono::steady_clock;

  Triangulated_solid(Clock::time_point start, Checked_triangles&& checked, Border_treatment treatment,
                     unsigned number_of_threads);

  /// Adds warnings about the input to the report.
  void warn(std::size_t number_of_reversed_components);

  void build_component_queries() const;

  /// Of the face nearest to `place`, the vertex that is nearest.
  Index nearest_vertex(const Vector3& place) const;

  std::unique_ptr<const Surface_levels> m_levels;
  internal::Compressed_rows<Index> m_input_vertices; ///< of every vertex
  std::vector<Index> m_first_vertices;               ///< of all components except the first, ascending
  std::vector<signed char> m_side_of_sheet;          ///< of every vertex; empty without sheets
  Normalization m_normalization;
  Skeletonization_report m_report;
  mutable std::once_flag m_queries_built;
  mutable std::optional<const internal::Solid_queries> m_queries;
  mutable std::once_flag m_component_queries_built;
  mutable std::vector<internal::Solid_queries> m_component_queries; ///< of each component, if there are several
};

} // namespace CSCD

#ifndef CSCD_COMPILED
#include <CSCD/Surface/Triangulated_solid_impl.h>
#endif

#endif // CSCD_SURFACE_TRIANGULATED_SOLID_H
