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
#include <utility>
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
class Graph_region_meetings
{
public:
  template <class Region>
  Graph_region_meetings(const Spatial_graph& graph, const Region& region)
      : m_graph(graph), m_networks(graph.number_of_halfedges()), m_cycles(graph.number_of_halfedges()),
        m_halfedge_to(graph.number_of_vertices(), no_index)
  {
    for (Index a = 0; a < graph.number_of_vertices(); ++a) {
      join_at_vertex(region, a);
    }
    m_meetings = collect_meetings(graph, region, m_networks, m_cycles);
  }

  std::vector<std::vector<Index>> meetings() && { return std::move(m_meetings); }

private:
  /// Joins along cycles of three or four edges that have two edges at `a`.
  template <class Region>
  void join_at_vertex(const Region& region, Index a)
  {
    for (const Index h : m_graph.outgoing(a)) {
      m_halfedge_to[m_graph.target(h)] = h;
    }
    for (const Index h : m_graph.outgoing(a)) {
      const Index b = m_graph.target(h);
      for (const Index side : m_graph.outgoing(b)) {
        const Index c = m_graph.target(side);
        if (m_halfedge_to[c] != no_index && b < c) {
          join(region, {h, side, m_graph.twin(m_halfedge_to[c])});
        }
        for (const Index opposite : m_graph.outgoing(c)) {
          const Index d = m_graph.target(opposite);
          if (a < c && b < d && m_halfedge_to[d] != no_index && m_halfedge_to[c] == no_index &&
              !m_graph.is_adjacent(b, d)) {
            join_square(region, {h, side, opposite, m_graph.twin(m_halfedge_to[d])});
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
  template <class Region>
  void join_square(const Region& region, const std::array<Index, 4>& sides)
  {
    std::array<Index, 4> corner{};
    std::transform(sides.begin(), sides.end(), corner.begin(), [&](Index h) { return region(m_graph.origin(h)); });
    if (corner[0] == corner[2] && corner[1] != corner[3]) {
      join(region, {sides[0], sides[1]});
      join(region, {sides[2], sides[3]});
    } else if (corner[1] == corner[3] && corner[0] != corner[2]) {
      join(region, {sides[1], sides[2]});
      join(region, {sides[3], sides[0]});
    } else {
      join(region, {sides[0], sides[1], sides[2], sides[3]});
    }
  }

  /// Joins the edges between regions among those of a cycle, and the halfedges among them that leave one region.
  template <class Region>
  void join(const Region& region, std::initializer_list<Index> cycle)
  {
    Index first = no_index;
    std::array<Index, 8> leaving{}; // two for each edge
    std::size_t size = 0;
    for (const Index h : cycle) {
      if (region(m_graph.origin(h)) == region(m_graph.target(h))) {
        continue;
      }
      if (first == no_index) {
        first = h;
      }
      m_networks.join(edge_of(m_graph, first), edge_of(m_graph, h));
      for (const Index leaves : {h, m_graph.twin(h)}) {
        for (std::size_t i = 0; i < size; ++i) {
          if (region(m_graph.origin(leaving[i])) == region(m_graph.origin(leaves))) {
            m_cycles.join(leaving[i], leaves);
          }
        }
        leaving[size++] = leaves;
      }
    }
  }

  const Spatial_graph& m_graph;
  Disjoint_sets m_networks;         ///< of edges between regions
  Disjoint_sets m_cycles;           ///< of halfedges that leave a region
  std::vector<Index> m_halfedge_to; ///< from the vertex that is looked at to its neighbors
  std::vector<std::vector<Index>> m_meetings;
};

template <class Region>
std::vector<std::vector<Index>> region_meetings(const Spatial_graph& graph, const Region& region)
{
  return Graph_region_meetings(graph, region).meetings();
}

/// Finishes skeletons of graphs, once regions are joined.
class Graph_skeleton_finishing
{
public:
  Graph_skeleton_finishing(const Spatial_graph& graph, const Separator_regions& regions, Skeleton_builder& builder)
      : m_graph(graph), m_regions(regions), m_builder(builder)
  {
  }

  void operator()()
  {
    prune_bumps();
    center();
    m_builder.compact();
  }

private:
  /// How far a tip reaches from the junction that it hangs on if it is only a bump, in radii of the junction. Chosen on
  /// dino, elephant and a torus of nine handles: with 1.3 tubes have tips aside, with 2 blunt limbs are lost.
  static constexpr double bump_reach = 1.6;
  /// The part that the separator has in the place of a node inside a branch; the region has the rest. The region of a
  /// separator between oblique ones is a wedge, whose centroid is off the axis; chosen on the same shapes.
  static constexpr double separator_part = 0.5;

  void prune_bumps()
  {
    std::vector<char> is_wire_end(m_regions.size(), 0);
    for (Index vertex = 0; vertex < m_graph.number_of_vertices(); ++vertex) {
      if (m_graph.outgoing(vertex).size() == 1) {
        is_wire_end[m_regions[vertex]] = 1;
      }
    }
    for (Index node = 0; node < m_regions.size(); ++node) {
      if (m_builder.degree(node) != 1 || is_wire_end[node] != 0) {
        continue;
      }
      const Index junction = m_builder[node].neighbors.front();
      if (m_builder.is_junction(junction) &&
          m_builder.edge_length(node, junction) + m_builder[node].radius < bump_reach * m_builder[junction].radius) {
        m_builder.contract(node, junction);
      }
    }
    // Nodes between regions that no longer join three.
    for (Index node = m_regions.size(); node < m_builder.size(); ++node) {
      const std::vector<Index>& neighbors = m_builder[node].neighbors;
      if (neighbors.size() == 2 && neighbors[0] != neighbors[1]) {
        m_builder.bypass(node);
      }
    }
  }

  void center()
  {
    std::vector<Vector3> sum(m_regions.size(), Vector3::Zero());
    std::vector<double> length(m_regions.size(), 0);
    for (Index vertex = 0; vertex < m_graph.number_of_vertices(); ++vertex) {
      if (m_regions.is_on_separator(vertex)) {
        const double extent = std::sqrt(m_graph.vertex_area(vertex));
        sum[m_regions[vertex]] += extent * m_graph.points()[vertex];
        length[m_regions[vertex]] += extent;
      }
    }
    for (Index node = 0; node < m_regions.size(); ++node) {
      if (m_builder.is_regular(node) && length[node] > 0) {
        Vector3& position = m_builder[node].position;
        position = (1 - separator_part) * position + separator_part * (sum[node] / length[node]);
      }
    }
  }

  const Spatial_graph& m_graph;
  const Separator_regions& m_regions;
  Skeleton_builder& m_builder;
};

/// A graph bounds no body.
inline void finish_skeleton(const Spatial_graph& graph, const Separator_regions& regions, Skeleton_builder& builder,
                            Skeletonization_report& /* report */)
{
  Graph_skeleton_finishing(graph, regions, builder)();
  make_simple(builder);
}

} // namespace internal
} // namespace CSCD

#endif // CSCD_GRAPH_GRAPH_REGIONS_H
