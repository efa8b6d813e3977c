// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The algorithms of the pipeline for graphs.

#ifndef CSCD_GRAPH_POLICIES_H
#define CSCD_GRAPH_POLICIES_H

#include <CSCD/Graph/Spatial_graph.h>
#include <CSCD/Options.h>
#include <CSCD/Published/Region_packing.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeletonization_report.h>

#include <vector>

namespace CSCD {

/// The method for graphs: distances along edges, separators that are sets of vertices, overlap where these have a
/// vertex in common, the quotient graph of regions (appendix K.1, which replicates the local separators of Baerentzen
/// and Rotenberg). A model of `SkeletonizationPolicies` for `Spatial_graph`.
class Graph_policies
{
public:
  /// The packed separators, and the regions of the graph around them.
  using Packing = internal::Region_packing;

  /// Seeks separators from vertices in random order; a vertex is a source the more rarely, the more separators it is
  /// part of. Near O(n log n) where limbs are thin, O(n^2) for a body without limbs.
  std::vector<Separator> find_separators(const Spatial_graph& graph, const Options& settings,
                                         Skeletonization_report& report, const Progress& progress) const;

  /// Packs separators that have no vertex in common, and gives each vertex to the nearest of them.
  Packing pack_separators(const Spatial_graph& graph, const std::vector<Separator>& separators,
                          Skeletonization_report& report) const;

  /// Builds the skeleton of the quotient graph: a node for each region, an edge where two regions touch.
  Embedded_skeleton build_skeleton(const Spatial_graph& graph, const std::vector<Separator>& separators,
                                   const Packing& packing, Skeletonization_report& report) const;
};

} // namespace CSCD

#ifndef CSCD_COMPILED
#include <CSCD/Graph_policies_impl.h>
#endif

#endif // CSCD_GRAPH_POLICIES_H
