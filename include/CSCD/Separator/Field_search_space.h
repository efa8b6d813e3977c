// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the search for separators from distance fields needs to know of a surface.

#ifndef CSCD_SEPARATOR_FIELD_SEARCH_SPACE_H
#define CSCD_SEPARATOR_FIELD_SEARCH_SPACE_H

#include <CSCD/Cut_locus/Cut_measures.h>
#include <CSCD/Cut_locus/Tangent_frames.h>
#include <CSCD/Geodesic/Heat_method.h>
#include <CSCD/Intrinsic/make_intrinsic_delaunay.h>
#include <CSCD/Separator/Field_separator_finder.h>
#include <CSCD/Separator/Separator_shortening.h>
#include <CSCD/Separator/Shortening_rule.h>
#include <CSCD/Separator/Target_rule.h>
#include <CSCD/Traits/Solid_queries.h>
#include <CSCD/Traits/Triangulated_surface.h>

#include <optional>

namespace CSCD::internal {

/// How distances on a `Surface` are estimated, and separators found from them: prepared once, shared by all threads.
/// A specialization has the type `Finder`, whose objects are called as `Field_separator_finder` is, the constant
/// `default_shortening_rule`, and the members of that for meshes.
template <class Surface>
class Field_search_space;

/// Meshes: the heat method on the intrinsic Delaunay triangulation, and loops along the edges of the mesh.
template <>
class Field_search_space<Triangulated_surface>
{
public:
  using Finder = Field_separator_finder<Cut_measures<Triangulated_surface>, Separator_shortening>;

  static constexpr Shortening_rule default_shortening_rule = Shortening_rule::edge_flips;

  /// \param surface is referred to and must outlive this object
  Field_search_space(const Triangulated_surface& surface, Shortening_rule shortening_rule)
      : m_surface(surface), m_frames(surface), m_heat_method(make_intrinsic_delaunay(surface))
  {
    if (shortening_rule == Shortening_rule::variational) {
      m_queries.emplace(surface);
    }
  }
  Field_search_space(Triangulated_surface&&, Shortening_rule) = delete;

  const Heat_method& heat_method() const { return m_heat_method; }

  /// Makes a finder, which refers to this object.
  Finder make_finder(Target_rule target_rule) const
  {
    return Finder(m_frames, m_surface.points(), target_rule, m_surface, m_queries ? &*m_queries : nullptr);
  }

private:
  const Triangulated_surface& m_surface;
  Tangent_frames<Triangulated_surface> m_frames;
  Heat_method m_heat_method;
  std::optional<Solid_queries> m_queries; ///< for the variational shortening
};

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_FIELD_SEARCH_SPACE_H
