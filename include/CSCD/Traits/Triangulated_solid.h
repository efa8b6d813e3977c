// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the surface traits of meshes and of point sets have in common: everything but where their sites come from.

#ifndef CSCD_TRAITS_TRIANGULATED_SOLID_H
#define CSCD_TRAITS_TRIANGULATED_SOLID_H

#include <CSCD/Surface/Normalization.h>
#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Surface/compile_surface.h>
#include <CSCD/Vector_3.h>

#include <CGAL/Iterator_range.h>

#include <boost/iterator/transform_iterator.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The part of surface traits that a compiled surface determines. Points and lengths are normalized (unit area,
/// centroid at the origin) unless a function says otherwise. All members are const and may be called by several threads
/// at once. \tparam InputPoint the points of the input, with coordinates `x()`, `y()`, `z()`, constructible from three
///         coordinates
template <class InputPoint>
class Compiled_surface_traits
{
public:
  /// \name Types
  /// @{
  using Point = InputPoint;
  /// @}

  Compiled_surface_traits(const Compiled_surface_traits&) = delete;
  Compiled_surface_traits& operator=(const Compiled_surface_traits&) = delete;

  /// \name Sites
  /// @{
  Index number_of_sites() const { return surface().number_of_vertices(); }
  const Vector_3& point(Index site) const { return surface().point(site); }
  /// The part of the area that the site stands for; all together are 1.
  double weight(Index site) const { return surface().vertex_area(site); }
  /// The outward unit normal.
  Vector_3 normal(Index site) const { return surface().vertex_normal(site); }
  /// The sites that share an edge with `site`, counterclockwise.
  auto neighbors(Index site) const
  {
    const auto target = [this](Index halfedge) { return surface().target(halfedge); };
    const auto outgoing = surface().outgoing(site);
    return CGAL::make_range(boost::make_transform_iterator(outgoing.begin(), target),
                            boost::make_transform_iterator(outgoing.end(), target));
  }
  /// The connected component of the surface to which the site belongs; O(log c) for c components.
  Index component(Index site) const
  {
    return Index(std::upper_bound(m_component_begin.begin(), m_component_begin.end(), site) -
                 m_component_begin.begin()) -
           1;
  }
  /// @}

  /// \name Triangles
  /// @{
  Index number_of_triangles() const { return surface().number_of_faces(); }
  /// The three sites of a triangle, counterclockwise seen from outside.
  std::array<Index, 3> triangle(Index face) const
  {
    return {surface().origin(3 * face), surface().origin(3 * face + 1), surface().origin(3 * face + 2)};
  }
  /// The triangles with their halfedges: the finest level.
  const Triangulated_surface& surface() const { return m_levels->finest().surface; }
  const Surface_levels& levels() const { return *m_levels; }
  /// @}

  /// \name Coordinates of the input
  /// @{
  Point to_input_point(const Vector_3& point) const { return CSCD::to_input_point<Point>(m_normalization, point); }
  double to_input_length(double length) const { return length * m_normalization.unit; }
  /// @}

  /// \name The body
  /// The body is bounded by the surface, bridged borders included. The first query builds a search structure.
  /// @{

  /// The surface that answers the queries and that their faces belong to: the finest level of at most 60000 vertices.
  /// From there on, coarser faces differ from the finest ones by less than the skeleton is exact.
  const Triangulated_surface& solid_surface() const
  {
    constexpr Index max_vertices = 60000;
    return (*m_levels)[m_levels->finest_with_at_most(max_vertices)].surface;
  }
  /// Whether the body holds `point`. Where the surface cuts itself, a part that two sheets enclose counts as outside.
  bool is_inside(const Vector_3& point) const { return queries().is_inside(point); }
  /// The point of the surface that is nearest to `point`.
  Surface_point closest_point(const Vector_3& point) const { return queries().closest_point(point); }
  /// The middle of the body behind the point of the surface that is nearest to `point`, if it can be told.
  std::optional<Vector_3> middle_behind(const Vector_3& point) const { return queries().middle_behind(point); }
  /// The first point in which the ray from `origin` along `direction` meets the surface, if any.
  std::optional<Surface_hit> first_hit(const Vector_3& origin, const Vector_3& direction) const
  {
    return queries().first_hit(origin, direction);
  }
  /// Writes the distances from `from` at which the segment from there to `to` meets the surface, in ascending order.
  void crossings(const Vector_3& from, const Vector_3& to, std::vector<double>& distances) const
  {
    queries().crossings(from, to, distances);
  }
  /// @}

  /// \name Counts
  /// @{
  std::size_t number_of_bridged_borders() const { return m_number_of_bridged_borders; }
  bool is_closed_input() const { return m_number_of_bridged_borders == 0; }
  std::size_t number_of_inserted_vertices() const { return m_number_of_inserted_vertices; }
  /// The number of input faces with (nearly) no area; they are kept.
  std::size_t number_of_degenerate_faces() const { return m_number_of_degenerate_faces; }
  /// The number of components whose faces looked inwards in the input.
  std::size_t number_of_reversed_components() const { return m_number_of_reversed_components; }
  std::size_t number_of_components() const { return m_component_begin.size() - 1; }
  /// The number of handles of the bridged surface, over all components.
  std::size_t genus() const
  {
    // The Euler numbers V - E + F = V - F/2 of the components, each 2 - 2g, add up.
    return (2 * number_of_components() + number_of_triangles() / 2 - number_of_sites()) / 2;
  }
  /// @}

protected:
  Compiled_surface_traits() = default;
  ~Compiled_surface_traits() = default;

  /// Takes over `compiled` and builds the levels of detail; linear.
  void set_surface(Compiled_surface&& compiled)
  {
    m_input_point = std::move(compiled.input_point);
    m_component_begin = std::move(compiled.component_begin);
    m_normalization = compiled.normalization;
    m_number_of_bridged_borders = compiled.number_of_bridged_borders;
    m_number_of_inserted_vertices = compiled.number_of_inserted_vertices;
    m_number_of_degenerate_faces = compiled.number_of_degenerate_faces;
    m_number_of_reversed_components = compiled.number_of_reversed_components;
    m_levels.emplace(std::move(compiled.surface));
  }

  /// The vertex of the triangles, before they were compiled, that the site is; `no_index` for an inserted one.
  Index input_point(Index site) const { return m_input_point[site]; }

private:
  const Solid_queries& queries() const
  {
    std::call_once(m_queries_built, [this] { m_queries.emplace(solid_surface()); });
    return *m_queries;
  }

  std::optional<Surface_levels> m_levels;
  std::vector<Index> m_input_point; // of every site
  std::vector<Index> m_component_begin;
  Normalization m_normalization;
  std::size_t m_number_of_bridged_borders = 0;
  std::size_t m_number_of_inserted_vertices = 0;
  std::size_t m_number_of_degenerate_faces = 0;
  std::size_t m_number_of_reversed_components = 0;
  mutable std::once_flag m_queries_built;
  mutable std::optional<Solid_queries> m_queries;
};

} // namespace CSCD::internal

#endif // CSCD_TRAITS_TRIANGULATED_SOLID_H
