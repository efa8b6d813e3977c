// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A SkeletonizationTraits and TriangulatedSolidSkeletonizationTraits with no more than the concepts ask for, and
// without any type of a mesh.

#ifndef CSCD_TEST_ARCHETYPES_SKELETONIZATION_TRAITS_ARCHETYPE_H
#define CSCD_TEST_ARCHETYPES_SKELETONIZATION_TRAITS_ARCHETYPE_H

#include "Closest_point_archetype.h"
#include "Point_archetype.h"
#include "Surface_point_archetype.h"
#include "Triangle_mesh_archetype.h"
#include "support/Shape.h"
#include <CSCD/Traits/Triangle_mesh_traits.h>
#include <CSCD/Vector_3.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CSCD::test {

/// A shape, its sites named by what is neither a number nor comparable.
class Skeletonization_traits_archetype
{
public:
  using Point = Point_archetype;
  using Input_descriptor = Triangle_mesh_archetype::Vertex;

  explicit Skeletonization_traits_archetype(const Shape& shape)
      : m_mesh(shape), m_traits(m_mesh, Vertex_point_map_archetype(m_mesh))
  {
  }
  Skeletonization_traits_archetype(const Skeletonization_traits_archetype&) = delete;
  Skeletonization_traits_archetype& operator=(const Skeletonization_traits_archetype&) = delete;
  ~Skeletonization_traits_archetype() = default;

  /// \name SkeletonizationTraits
  /// @{
  Index number_of_sites() const { return m_traits.number_of_sites(); }
  Vector_3 point(Index site) const { return m_traits.point(site); }
  double weight(Index site) const { return m_traits.weight(site); }
  Vector_3 normal(Index site) const { return m_traits.normal(site); }
  auto neighbors(Index site) const { return m_traits.neighbors(site); }
  Index number_of_triangles() const { return m_traits.number_of_triangles(); }
  std::array<Index, 3> triangle(Index face) const { return m_traits.triangle(face); }
  auto descriptors(Index site) const { return m_traits.descriptors(site); }
  Point to_input_point(const Vector_3& p) const { return m_traits.to_input_point(p); }
  double to_input_length(double length) const { return m_traits.to_input_length(length); }
  std::size_t number_of_input_vertices() const { return m_traits.number_of_input_vertices(); }
  std::size_t number_of_isolated_vertices() const { return m_traits.number_of_isolated_vertices(); }
  std::size_t number_of_components() const { return m_traits.number_of_components(); }
  std::size_t number_of_bridged_borders() const { return m_traits.number_of_bridged_borders(); }
  std::size_t number_of_inserted_vertices() const { return m_traits.number_of_inserted_vertices(); }
  std::size_t number_of_degenerate_faces() const { return m_traits.number_of_degenerate_faces(); }
  std::vector<std::string> warnings() const { return m_traits.warnings(); }
  std::size_t genus() const { return m_traits.genus(); }
  double seconds_to_compile() const { return m_traits.seconds_to_compile(); }
  /// @}

  /// \name TriangulatedSolidSkeletonizationTraits
  /// @{
  const CSCD::Surface_levels& levels() const { return m_traits.levels(); }
  const CSCD::Triangulated_surface& surface() const { return m_traits.surface(); }
  std::optional<Vector_3> middle_behind(const Vector_3& p) const { return m_traits.middle_behind(p); }
  const CSCD::Triangulated_surface& solid_surface() const { return m_traits.solid_surface(); }
  bool is_inside(const Vector_3& p) const { return m_traits.is_inside(p); }
  Closest_point_archetype closest_point(const Vector_3& p) const
  {
    return Closest_point_archetype(m_traits.closest_point(p).point);
  }
  std::optional<Surface_point_archetype> first_hit(const Vector_3& origin, const Vector_3& direction) const
  {
    const auto hit = m_traits.first_hit(origin, direction);
    return hit ? std::optional(surface_point_archetype(*hit)) : std::nullopt;
  }
  void crossings(const Vector_3& from, const Vector_3& to, std::vector<double>& distances) const
  {
    m_traits.crossings(from, to, distances);
  }
  /// @}

private:
  Triangle_mesh_archetype m_mesh;
  Triangle_mesh_traits<Triangle_mesh_archetype, Vertex_point_map_archetype> m_traits;
};

} // namespace CSCD::test

#endif // CSCD_TEST_ARCHETYPES_SKELETONIZATION_TRAITS_ARCHETYPE_H
