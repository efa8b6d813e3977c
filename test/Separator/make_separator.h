// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Separators made by hand: plane sections.

#ifndef CSCD_TEST_SEPARATOR_MAKE_SEPARATOR_H
#define CSCD_TEST_SEPARATOR_MAKE_SEPARATOR_H

#include "Surface/to_surface.h"
#include <CSCD/Separator/Plane_section.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace CSCD::test {

/// The separator of `crossings`, with its measures.
inline Separator make_separator(const CSCD::Triangulated_surface& surface, std::vector<CSCD::Edge_crossing> crossings)
{
  Separator separator;
  separator.crossings = std::move(crossings);
  std::vector<CSCD::Vector3> points;
  CSCD::internal::crossing_points(surface, separator.crossings, points);
  CSCD::internal::set_measures(separator, points);
  separator.source = surface.origin(separator.crossings.front().halfedge);
  return separator;
}

/// The cycle that the plane through `point` normal to `axis` cuts off `surface` and that comes nearest to `near`.
inline Separator section_separator(const CSCD::Triangulated_surface& surface, const CSCD::Vector3& point,
                                   const CSCD::Vector3& axis, const CSCD::Vector3& near)
{
  CSCD::internal::Plane_section section(surface);
  Separator best;
  double least = std::numeric_limits<double>::max();
  for (CSCD::Index face = 0; face < surface.number_of_faces(); ++face) {
    double distance = std::numeric_limits<double>::max();
    for (CSCD::Index h = 3 * face; h < 3 * face + 3; ++h) {
      distance = std::min(distance, (surface.point(surface.origin(h)) - near).norm());
    }
    if (distance < least && section.cut_at_face(face, axis, point, std::numeric_limits<double>::max())) {
      least = distance;
      best = make_separator(surface, section.crossings());
    }
  }
  EXPECT_FALSE(best.crossings.empty()) << "the plane misses the surface";
  return best;
}

} // namespace CSCD::test

#endif // CSCD_TEST_SEPARATOR_MAKE_SEPARATOR_H
