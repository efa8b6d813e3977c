// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A surface cut along separators made by hand.

#ifndef CSCD_TEST_PACKING_CUT_SURFACE_H
#define CSCD_TEST_PACKING_CUT_SURFACE_H

#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::test {

/// A surface cut along separators, all of which must be disjoint.
struct Cut_surface
{
  Cut_surface(const CSCD::Triangulated_surface& cut_surface, std::vector<Separator> all)
      : surface(cut_surface), separators(std::move(all)), arrangement(surface), cut_graph(surface, separators)
  {
    for (CSCD::Index i = 0; i < separators.size(); ++i) {
      EXPECT_TRUE(arrangement.insert(i, separators[i].crossings)) << "separator " << i << " crosses another one";
    }
    cut_graph.cut(arrangement);
  }

  int euler_number() const { return int(surface.number_of_vertices()) - int(surface.number_of_faces() / 2); }

  /// First Betti number of the graph of pieces and separators.
  std::size_t betti_number(std::size_t number_of_components) const
  {
    return separators.size() + number_of_components - cut_graph.pieces().size();
  }

  const CSCD::Triangulated_surface& surface;
  std::vector<Separator> separators;
  CSCD::internal::Separator_arrangement arrangement;
  CSCD::internal::Cut_graph cut_graph;
};

} // namespace CSCD::test

#endif // CSCD_TEST_PACKING_CUT_SURFACE_H
