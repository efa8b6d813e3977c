// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the regions of a surface touch each other.

#ifndef CSCD_SKELETON_QUOTIENT_GRAPH_H
#define CSCD_SKELETON_QUOTIENT_GRAPH_H

#include <CSCD/internal/Disjoint_sets.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The graph of regions that touch (Alg. 2, line 14), with cliques removed and true small cycles kept.
///
/// Regions meet in a network of curves between them. Where a connected part of the network is one closed curve, it has
/// a region on either side, which an edge joins. Where curves meet, at faces that have corners in three regions, all
/// regions around that part of the network meet, and a junction joins them in place of a clique of edges. A region
/// counts for every one of its border cycles: three regions around a thin handle, which meet in three separate curves,
/// stay a cycle. Where the surface has a hole, all that ends there goes on as if it was a point. If all regions, and
/// the neighborhoods of all parts of the network, are planar, the first Betti number of the graph is the genus of the
/// surface.
class Quotient_graph
{
public:
  /// Computes the graph; near linear.
  /// \param region a function that returns the region of a vertex
  template <class Surface, class Region>
  Quotient_graph(const Surface& surface, const Region& region)
      : m_networks(surface.number_of_halfedges()), m_cycles(surface.number_of_halfedges())
  {
    const auto is_between = [&](Index h) { return region(surface.origin(h)) != region(surface.target(h)); };
    for (Index face = 0; face < surface.number_of_faces(); ++face) {
      const std::array<Index, 3> sides = surface.face_halfedges(face);
      for (std::size_t k = 0; k < 3; ++k) {
        join_at_corner(surface, is_between, sides[(k + 2) % 3], sides[k], sides[(k + 1) % 3]);
      }
    }
    join_at_holes(surface, region, is_between);
    collect(surface, region, is_between);
  }

  /// For each connected part of the network, the regions of the border cycles around it, two at least; a region with
  /// several cycles there stands several times.
  const std::vector<std::vector<Index>>& meetings() const { return m_meetings; }

private:
  /// Joins what is connected within a face, at the corner that its side `h` leaves. The border cycle of a region has a
  /// point on every halfedge that leaves the region, named after it.
  template <class Surface, class Predicate>
  void join_at_corner(const Surface& surface, const Predicate& is_between, Index before, Index h, Index after)
  {
    if (is_between(h) && is_between(before)) {
      m_networks.join(surface.edge(h), surface.edge(before));
      m_cycles.join(h, surface.twin(before));
      if (!is_between(after)) {
        // The corner lies alone in its region; the other two are on the other side.
        m_cycles.join(surface.twin(h), before);
      }
    }
  }

  /// Joins what ends at the same hole, or at holes that touch.
  template <class Surface, class Region, class Predicate>
  void join_at_holes(const Surface& surface, const Region& region, const Predicate& is_between)
  {
    std::vector<Index> number_of_faces(surface.number_of_halfedges(), 0);
    for (Index face = 0; face < surface.number_of_faces(); ++face) {
      for (const Index h : surface.face_halfedges(face)) {
        ++number_of_faces[surface.edge(h)];
      }
    }
    Disjoint_sets holes(surface.number_of_vertices());
    std::vector<Index> ends; // of curves of the network: the halfedges where they are
    for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
      if (number_of_faces[surface.edge(h)] == 1) {
        holes.join(surface.origin(h), surface.target(h));
        if (is_between(h)) {
          ends.push_back(h);
        }
      }
    }
    const auto place = [&](Index h) {
      return std::make_pair(holes.find(surface.origin(h)), region(surface.origin(h)));
    };
    std::stable_sort(ends.begin(), ends.end(), [&](Index a, Index b) { return place(a) < place(b); });
    for (std::size_t i = 1; i < ends.size(); ++i) {
      if (place(ends[i - 1]).first == place(ends[i]).first) {
        m_networks.join(surface.edge(ends[i - 1]), surface.edge(ends[i]));
      }
      if (place(ends[i - 1]) == place(ends[i])) {
        m_cycles.join(ends[i - 1], ends[i]);
      }
    }
  }

  template <class Surface, class Region, class Predicate>
  void collect(const Surface& surface, const Region& region, const Predicate& is_between)
  {
    std::vector<Index> meeting_of_network(surface.number_of_halfedges(), no_index);
    for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
      if (!is_between(h) || m_cycles.find(h) != h) {
        continue;
      }
      Index& meeting = meeting_of_network[m_networks.find(surface.edge(h))];
      if (meeting == no_index) {
        meeting = Index(m_meetings.size());
        m_meetings.emplace_back();
      }
      m_meetings[meeting].push_back(region(surface.origin(h)));
    }
  }

  Disjoint_sets m_networks; ///< of edges between regions
  Disjoint_sets m_cycles;   ///< of halfedges that leave a region
  std::vector<std::vector<Index>> m_meetings;
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_QUOTIENT_GRAPH_H
