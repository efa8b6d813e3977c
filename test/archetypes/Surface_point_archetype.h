// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the queries of a SolidSkeletonizationTraits give, with no more than the concept asks for.

#ifndef CSCD_TEST_ARCHETYPES_SURFACE_POINT_ARCHETYPE_H
#define CSCD_TEST_ARCHETYPES_SURFACE_POINT_ARCHETYPE_H

#include <CSCD/Vector_3.h>

namespace CSCD::test {

/// A point of a surface and the face that it lies in; there is none by default.
struct Surface_point_archetype
{
  Surface_point_archetype(const CSCD::Vector_3& its_point, CSCD::Index its_face)
      : point(its_point), face(its_face)
  {
  }

  CSCD::Vector_3 point;
  CSCD::Index face;
};

/// The same of anything that has these members.
template <class SurfacePoint>
Surface_point_archetype surface_point_archetype(const SurfacePoint& p)
{
  return {p.point, p.face};
}

} // namespace CSCD::test

#endif // CSCD_TEST_ARCHETYPES_SURFACE_POINT_ARCHETYPE_H
