// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Properties of every list of crossings of a closed curve.

#ifndef CSCD_TEST_SEPARATOR_IS_CLOSED_CURVE_H
#define CSCD_TEST_SEPARATOR_IS_CLOSED_CURVE_H

#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace CSCD::test {

/// Whether every crossing lies strictly within its edge, and the curve continues in the face that it has entered.
inline testing::AssertionResult is_closed_curve(const CSCD::Triangulated_surface& surface,
                                                const std::vector<CSCD::Edge_crossing>& crossings)
{
  using CSCD::Triangulated_surface;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const CSCD::Edge_crossing& crossing = crossings[i];
    const CSCD::Edge_crossing& next = crossings[(i + 1) % crossings.size()];
    if (!(crossing.position > 0 && crossing.position < 1)) {
      return testing::AssertionFailure() << "crossing " << i << " at position " << crossing.position;
    }
    if (Triangulated_surface::face(surface.twin(crossing.halfedge)) != Triangulated_surface::face(next.halfedge)) {
      return testing::AssertionFailure() << "crossing " << i << " and the next one share no face";
    }
    if (surface.edge(crossing.halfedge) == surface.edge(next.halfedge)) {
      return testing::AssertionFailure() << "crossing " << i << " is followed by one of the same edge";
    }
  }
  return testing::AssertionSuccess();
}

} // namespace CSCD::test

#endif // CSCD_TEST_SEPARATOR_IS_CLOSED_CURVE_H
