// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a body answers when it is asked for its nearest point: no more than its place.

#ifndef CSCD_TEST_ARCHETYPES_CLOSEST_POINT_ARCHETYPE_H
#define CSCD_TEST_ARCHETYPES_CLOSEST_POINT_ARCHETYPE_H

#include <CSCD/Vector_3.h>

namespace CSCD::test {

/// A point of a surface; there is none by default.
struct Closest_point_archetype
{
  explicit Closest_point_archetype(const CSCD::Vector_3& its_point) : point(its_point) {}

  CSCD::Vector_3 point;
};

} // namespace CSCD::test

#endif // CSCD_TEST_ARCHETYPES_CLOSEST_POINT_ARCHETYPE_H
