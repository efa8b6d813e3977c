// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Thin shells whose two sides are joined by wrong triangles, as those of point clouds may be.

#ifndef CSCD_TEST_SURFACE_JOINED_SHELL_H
#define CSCD_TEST_SURFACE_JOINED_SHELL_H

#include "support/Shape.h"
#include "support/shape_operations.h"

#include <cstddef>

namespace CSCD::test {

/// The shell between `outer` and `inner`, which have the same triangles: first the vertices of `outer`, then those of
/// `inner`, with its normals inwards. Of every `stride` triangles one has another on an edge of it that leads through
/// the shell.
inline Shape joined_shell(const Shape& outer, const Shape& inner, std::size_t stride)
{
  Shape shell = merged("shell", {outer, reversed(inner)});
  for (std::size_t i = 0; i < outer.triangles.size(); i += stride) {
    const Triangle& t = outer.triangles[i];
    shell.triangles.push_back({t[0], t[1], t[2] + outer.points.size()});
  }
  return shell;
}

} // namespace CSCD::test

#endif // CSCD_TEST_SURFACE_JOINED_SHELL_H
