// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A MultiresolutionSkeletonizationTraits with no more than the concept asks for.

#ifndef CSCD_TEST_ARCHETYPES_MULTIRESOLUTION_TRAITS_ARCHETYPE_H
#define CSCD_TEST_ARCHETYPES_MULTIRESOLUTION_TRAITS_ARCHETYPE_H

#include "Traits/to_surface.h"
#include "support/Shape.h"
#include <CSCD/Surface/Surface_levels.h>

namespace CSCD::test {

/// The levels of detail of a shape, and nothing else.
class Multiresolution_traits_archetype
{
public:
  explicit Multiresolution_traits_archetype(const Shape& shape) : m_levels(to_levels(shape)) {}
  const CSCD::Surface_levels& levels() const { return m_levels; }

private:
  CSCD::Surface_levels m_levels;
};

} // namespace CSCD::test

#endif // CSCD_TEST_ARCHETYPES_MULTIRESOLUTION_TRAITS_ARCHETYPE_H
