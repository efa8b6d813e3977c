// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Regions of graphs: where they meet, and the skeleton that is made of them (appendix K.1).

#ifndef CSCD_GRAPH_GRAPH_REGIONS_H
#define CSCD_GRAPH_GRAPH_REGIONS_H

#include <CSCD/Graph/Spatial_graph.h>
#include <CSCD/Published/Quotient_skeleton.h>
#include <CSCD/Published/Region_packing.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <vector>

namespace CSCD {

/// \cond INTERNAL
/// The radius of the part that a vertex of `graph` stands for; found by the type of the graph.
inline double vertex_radius(const Spatial_graph& graph, Index vertex)
{
  return graph.radius(vertex);
}
/// \endcond

namespace internal {

/// Where regions meet in a graph, which has no faces: its cycles of three or four edges take their place.
/// \tparam Region a function that returns the region of a vertex
template <class Region>
class Graph_region_meetings
{
public:
  Graph_region_meetings(const Spatial_graph& graph, const Region& region)
      : m_graph(graph), m_region(region), m_networks(graph.number_of_halfedges()),
        m_cycles(graph.number_of_halfedges()), m_halfedge_to(graph.number_of_vertices(), no_index)
  {
  }

  std::vector<std::vector<Index>> operator()()
  {
    for (Index a = 0; a < m_graph.number_of_vertices(); ++a) {
      join_at_vertex(a);
    }
    return collect_meetings(m_graph, m_region, m_networks, m_cycles);
  }

private:
  /// Joins along cycles of three or four edges that have two edges at `a`.
  void join_at_vertex(Index a)
  {
    for (const Index h : m_graph.outgoing(a)) {
      m_halfedge_to[m_graph.target(h)] = h;
    }
    for (const Index h : m_graph.outgoing(a)) {
      const Index b = m_graph.target(h);
      for (const Index side : m_graph.outgoing(b)) {
        const Index c = m_graph.target(side);
        if (m_halfedge_to[c] != no_index && b < c) {
          join({h, side, m_graph.twin(m_halfedge_to[c])});
        }
        for (const Index opposite : m_graph.outgoing(c)) {
          const Index d = m_graph.target(opposite);
          if (a < c && b < d && m_halfedge_to[d] != no_index && m_halfedge_to[c] == no_index &&
              !m_graph.is_adjacent(b, d)) {
            join_square({h, side, opposite, m_graph.twin(m_halfedge_to[d])});
          }
        }
      }
    }
    for (const Index h : m_graph.outgoing(a)) {
      m_halfedge_to[m_graph.target(h)] = no_index;
    }
  }

  /// As `join()`; where two opposite corners are in one region, and the others in two, these do not meet: it is
  /// between.
  void join_square(const std::array<Index, 4>& sides)
  {
    std::array<Index, 4> corner{};
    std::transform(sides.begin(), sides.end(), corner.begin(), [&](Index h) { return m_region(m_graph.origin(h)); });
    if (corner[0] == corner[2] && corner[1] != corner[3]) {
      join({sides[0], sides[1]});
      join({sides[2], sides[3]});
    } else if (corner[1] == corner[3] && corner[0] != corner[2]) {
      join({sides[1], sides[2]});
      join({sides[3], sides[0]});
    } else {
      join({sides[0], sides[1], sides[2], sides[3]});
    }
  }

  /// Joins the edges between regions among those of a cycle, and the halfedges among them that leave one region.
  void join(std::initializer_list<Index> cycle)
  {
    Index first = no_index;
    std::array<Index, 8> leaving{}; // two for each edge
    std::size_t size = 0;
    for (const Index h : cycle) {
      if (m_region(m_graph.origin(h)) == m_region(m_graph.target(h))) {
        continue;
      }
      if (first == no_index) {
        first = h;
      }
      m_networks.join(edge_of(m_graph, first), edge_of(m_graph, h));
      for (const Index leaves : {h, m_graph.twin(h)}) {
        for (std::size_t i = 0; i < size; ++i) {
          if (m_region(m_graph.origin(leaving[i])) == m_region(m_graph.origin(leaves))) {
            m_cycles.join(leaving[i], leaves);
          }
        }
        leaving[size++] = leaves;
      }
    }
  }

  const Spatial_graph& m_graph;
  const Region& m_region;
  Disjoint_sets m_networks;         ///< of edges between regions
  Disjoint_sets m_cycles;           ///< of halfedges that leave a region
  std::vector<Index> m_halfedge_to; ///< from the vertex that is looked at to its neighbors
};

template <class Region>
std::vector<std::vector<Index>> region_meetings(const Spatial_graph& graph, const Region& region)
{
  return Graph_region_meetings(graph, region)();
}

/// Contracts tips that are only bumps of the junctions that they hang on.
inline void prune_bumps(const Spatial_graph& graph, const Separator_regions& regions, Skeleton_builder& builder)
{
  // How far a tip reaches from the junction that it hangs on if it is only a bump, in radii of the junction. Chosen on
  // dino, elephant and a torus of nine handles: with 1.3 tubes have tips aside, with 2 blunt limbs are lost.
  constexpr double bump_reach = 1.6;
  std::vector<char> is_wire_end(regions.size(), 0);
  for (Index vertex = 0; vertex < graph.number_of_vertices(); ++vertex) {
    if (graph.outgoing(vertex).size() == 1) {
      is_wire_end[regions[vertex]] = 1;
    }
  }
  for (Index node = 0; node < regions.size(); ++node) {
    if (builder.degree(node) != 1 || is_wire_end[node] != 0) {
      continue;
    }
    const Index junction = builder[node].neighbors.front();
    if (builder.is_junction(junction) &&
        builder.edge_length(node, junction) + builder[node].radius < bump_reach * builder[junction].radius) {
      builder.contract(node, junction);
    }
  }
  // Nodes between regions that no longer join three.
  for (Index node = regions.size(); node < builder.size(); ++node) {
    const std::vector<Index>& neighbors = builder[node].neighbors;
    if (neighbors.size() == 2 && neighbors[0] != neighbors[1]) {
      builder.bypass(node);
    }
  }
}

/// Moves the nodes inside branches towards the centroids of their separators.
inline void center(const Spatial_graph& graph, const Separator_regions& regions, Skeleton_builder& builder)
{
  // The part that the separator has in the place of a node; the region has the rest. The region of a separator between
  // oblique ones is a wedge, whose centroid is off the axis; chosen on the same shapes.
  constexpr double separator_part = 0.5;
  std::vector<Vector3> sum(regions.size(), Vector3::Zero());
  std::vector<double> length(regions.size(), 0);
  for (Index vertex = 0; vertex < graph.number_of_vertices(); ++vertex) {
    if (regions.is_on_separator(vertex)) {
      const double extent = std::sqrt(graph.vertex_area(vertex));
      sum[regions[vertex]] += extent * graph.points()[vertex];
      length[regions[vertex]] += extent;
    }
  }
  for (Index node = 0; node < regions.size(); ++node) {
    if (builder.is_regular(node) && length[node] > 0) {
      Vector3& position = builder[node].position;
      position = (1 - separator_part) * position + separator_part * (sum[node] / length[node]);
    }
  }
}

/// A graph bounds no body.
inline void finish_skeleton(const Spatial_graph& graph, const Separator_regions& regions, Skeleton_builder& builder,
                            Skeletonization_report& /* report */)
{
  prune_bumps(graph, regions, builder);
  center(graph, regions, builder);
  builder.compact();
  make_simple(builder);
}

} // namespace internal
} // namespace CSCD

#endif // CSCD_GRAPH_GRAPH_REGIONS_H
