// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closes the loops of a cut locus that go around handles and between sources.

#ifndef CSCD_CUT_LOCUS_CLOSE_LOOPS_H
#define CSCD_CUT_LOCUS_CLOSE_LOOPS_H

#include <CSCD/Cut_locus/Cut_measures.h>
#include <CSCD/Cut_locus/Cut_tree.h>
#include <CSCD/Cut_locus/Disc_growth.h>
#include <CSCD/internal/Vector_3.h>

#include <vector>

namespace CSCD::internal {

/// Adds chords to `cut` until what it leaves of the surface is one disc around each source: the edges that the tree
/// does not take are crossed in order of distance, those along the cut locus last; those that cannot be crossed become
/// chords. On a closed connected surface of genus g, k sources make 2 g + k - 1 of them, and as many loops. Borders
/// count as closed by discs. O(m log m) for m faces.
/// \param sources the vertices at distance 0; those that are neighbors count as one source
template <class Triangulation>
void close_loops(const Cut_measures<Triangulation>& measures, const std::vector<Index>& sources, Cut_tree& cut)
{
  const Triangulation& triangulation = measures.frames().triangulation();
  const auto is_tree_edge = [&](Index halfedge, Index vertex) {
    const Index own = cut.tree().halfedge_to_parent(vertex);
    return own != no_index && (own == halfedge || own == triangulation.twin(halfedge));
  };
  const auto is_in_tree = [&](Index halfedge) {
    return is_tree_edge(halfedge, triangulation.origin(halfedge)) ||
           is_tree_edge(halfedge, triangulation.target(halfedge));
  };
  const auto is_kept = [&](Index halfedge) {
    return cut.is_kept(triangulation.origin(halfedge)) && cut.is_kept(triangulation.target(halfedge));
  };
  for (Index halfedge : Disc_growth<Triangulation>(measures, sources)(is_in_tree, is_kept)) {
    cut.add_chord(halfedge, triangulation.origin(halfedge), triangulation.target(halfedge));
  }
}

} // namespace CSCD::internal

#endif // CSCD_CUT_LOCUS_CLOSE_LOOPS_H
