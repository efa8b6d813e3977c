// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the search for separators from distance fields needs to know of a point cloud.

#ifndef CSCD_SEPARATOR_POINT_FIELD_SEARCH_SPACE_H
#define CSCD_SEPARATOR_POINT_FIELD_SEARCH_SPACE_H

#include <CSCD/Cut_locus/Point_cut_measures.h>
#include <CSCD/Cut_locus/Point_derivatives.h>
#include <CSCD/Cut_locus/Point_frames.h>
#include <CSCD/Geodesic/Heat_method.h>
#include <CSCD/Geodesic/Tufted_cover.h>
#include <CSCD/Intrinsic/make_intrinsic_delaunay.h>
#include <CSCD/Point_cloud/Point_complex.h>
#include <CSCD/Point_cloud/Point_neighborhoods.h>
#include <CSCD/Separator/Field_search_space.h>
#include <CSCD/Separator/Field_separator_finder.h>
#include <CSCD/Separator/Point_separator_shortening.h>
#include <CSCD/Separator/Shortening_rule.h>
#include <CSCD/Separator/Target_rule.h>

#include <CGAL/assertions.h>

namespace CSCD::internal {

/// Point clouds: the heat method on the intrinsic Delaunay triangulation of the tufted cover, loops along the edges of
/// the complex, and the variational flow.
template <>
class Field_search_space<Point_complex>
{
public:
  using Finder = Field_separator_finder<Point_cut_measures, Point_separator_shortening>;

  static constexpr Shortening_rule default_shortening_rule = Shortening_rule::variational;

  /// \param complex is referred to and must outlive this object
  /// \pre `shortening_rule` is `variational`: points have no edges to be flipped
  Field_search_space(const Point_complex& complex, [[maybe_unused]] Shortening_rule shortening_rule)
      : m_complex(complex), m_frames(complex), m_heat_method(make_intrinsic_delaunay(Tufted_cover(complex))),
        m_derivatives(m_frames, m_heat_method.operators().elements), m_neighborhoods(complex)
  {
    CGAL_precondition(shortening_rule == Shortening_rule::variational);
  }
  Field_search_space(Point_complex&&, Shortening_rule) = delete;

  const Heat_method& heat_method() const { return m_heat_method; }

  /// Makes a finder, which refers to this object.
  Finder make_finder(Target_rule target_rule) const
  {
    return Finder(m_derivatives, m_complex.points(), target_rule, m_complex, m_neighborhoods);
  }

private:
  const Point_complex& m_complex;
  Point_frames m_frames;
  Heat_method m_heat_method;
  Point_derivatives m_derivatives;
  Point_neighborhoods m_neighborhoods;
};

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_POINT_FIELD_SEARCH_SPACE_H
