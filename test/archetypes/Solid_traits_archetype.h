// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A TriangulatedSolidSkeletonizationTraits with no more than the concept asks for: no sites, no way back to an input.

#ifndef CSCD_TEST_ARCHETYPES_SOLID_TRAITS_ARCHETYPE_H
#define CSCD_TEST_ARCHETYPES_SOLID_TRAITS_ARCHETYPE_H

#include "Closest_point_archetype.h"
#include "Surface_point_archetype.h"
#include "Traits/to_surface.h"
#include "support/Shape.h"
#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <optional>
#include <vector>

namespace CSCD::test {

/// A shape and its body, in the numbers and coordinates of the shape. All queries go to the finest level.
class Solid_traits_archetype
{
public:

  explicit Solid_traits_archetype(const Shape& shape) : m_levels(to_levels(shape)), m_queries(solid_surface()) {}
  Solid_traits_archetype(const Solid_traits_archetype&) = delete;
  Solid_traits_archetype& operator=(const Solid_traits_archetype&) = delete;
  ~Solid_traits_archetype() = default;

  const CSCD::Surface_levels& levels() const { return m_levels; }
  const CSCD::Triangulated_surface& surface() const { return m_levels.finest().surface; }
  std::optional<Vector_3> middle_behind(const Vector_3& p) const { return m_queries.middle_behind(p); }
  const CSCD::Triangulated_surface& solid_surface() const { return m_levels.finest().surface; }
  bool is_inside(const Vector_3& p) const { return m_queries.is_inside(p); }
  Closest_point_archetype closest_point(const Vector_3& p) const
  {
    return Closest_point_archetype(m_queries.closest_point(p).point);
  }
  std::optional<Surface_point_archetype> first_hit(const Vector_3& origin, const Vector_3& direction) const
  {
    const auto hit = m_queries.first_hit(origin, direction);
    return hit ? std::optional(surface_point_archetype(*hit)) : std::nullopt;
  }
  void crossings(const Vector_3& from, const Vector_3& to, std::vector<double>& distances) const
  {
    m_queries.crossings(from, to, distances);
  }

private:
  CSCD::Surface_levels m_levels;
  CSCD::internal::Solid_queries m_queries;
};

} // namespace CSCD::test

#endif // CSCD_TEST_ARCHETYPES_SOLID_TRAITS_ARCHETYPE_H
