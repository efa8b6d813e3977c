// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed curves along edges, given by their vertices.

#ifndef CSCD_TEST_SEPARATOR_HALFEDGES_ALONG_H
#define CSCD_TEST_SEPARATOR_HALFEDGES_ALONG_H

#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace CSCD::test {

/// The halfedges between consecutive vertices of `loop`, all of which must be neighbors.
template <class Surface>
std::vector<Index> halfedges_along(const Surface& surface, const Vertex_loop& loop)
{
  std::vector<Index> halfedges;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    halfedges.push_back(surface.find_halfedge(loop[i], loop[(i + 1) % loop.size()]));
    EXPECT_NE(halfedges.back(), no_index);
  }
  return halfedges;
}

} // namespace CSCD::test

#endif // CSCD_TEST_SEPARATOR_HALFEDGES_ALONG_H
