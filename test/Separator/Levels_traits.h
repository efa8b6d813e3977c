// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Levels of detail, as the finders of separators ask for them.

#ifndef CSCD_TEST_SEPARATOR_LEVELS_TRAITS_H
#define CSCD_TEST_SEPARATOR_LEVELS_TRAITS_H

#include "Traits/to_surface.h"
#include "support/Shape.h"
#include <CSCD/Traits/Surface_levels.h>

namespace CSCD::test {

/// As much of the surface traits as the finder of local separators asks for.
class Levels_traits
{
public:
  explicit Levels_traits(const Shape& shape) : m_levels(to_levels(shape)) {}
  const CSCD::internal::Surface_levels& levels() const { return m_levels; }

private:
  CSCD::internal::Surface_levels m_levels;
};

} // namespace CSCD::test

#endif // CSCD_TEST_SEPARATOR_LEVELS_TRAITS_H
