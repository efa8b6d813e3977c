// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Discs that grow around the sources until they meet themselves and each other.

#ifndef CSCD_CUT_LOCUS_DISC_GROWTH_H
#define CSCD_CUT_LOCUS_DISC_GROWTH_H

#include <CSCD/Cut_locus/Cut_measures.h>
#include <CSCD/internal/Disjoint_sets.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CSCD::internal {

/// Unites the faces of a triangulation across its edges in order of distance, so that they make one disc around each
/// source: an edge that would close a ring of faces, or join the discs of two sources, is not crossed. So the cut locus
/// is not crossed, since there the discs meet. Borders count as closed by discs.
template <class Triangulation>
class Disc_growth
{
public:
  /// \param sources those that are neighbors share a disc
  Disc_growth(const Cut_measures<Triangulation>& measures, const std::vector<Index>& sources)
      : m_measures(measures), m_triangulation(measures.frames().triangulation()),
        m_discs(std::size_t(m_triangulation.number_of_faces()) + m_triangulation.number_of_vertices()),
        m_has_source(m_discs.size(), 0)
  {
    cap_borders();
    mark_sources(sources);
  }

  /// Crosses all edges between vertices that have a distance, but those for which `is_blocked(h)` holds, in order of
  /// distance, those for which `is_last(h)` holds after the others. O(m log m) for m faces.
  /// \return a halfedge of each edge that was neither blocked nor crossed
  template <class IsBlocked, class IsLast>
  std::vector<Index> operator()(const IsBlocked& is_blocked, const IsLast& is_last)
  {
    std::vector<Edge> edges;
    for (Index h = 0; h < m_triangulation.number_of_halfedges(); ++h) {
      // All vertices of a face have a distance, or none has.
      if (m_measures.is_reached(m_triangulation.origin(h)) && m_triangulation.twin(h) >= h && !is_blocked(h)) {
        const double distance =
            m_measures.distance(m_triangulation.origin(h)) + m_measures.distance(m_triangulation.target(h));
        edges.push_back({is_last(h), distance, h});
      }
    }
    std::sort(edges.begin(), edges.end());
    std::vector<Index> uncrossed;
    for (const Edge& edge : edges) {
      if (!cross(edge.halfedge)) {
        uncrossed.push_back(edge.halfedge);
      }
    }
    return uncrossed;
  }

private:
  struct Edge
  {
    bool is_last;
    double distance;
    Index halfedge;
    bool operator<(const Edge& other) const
    {
      return std::tie(is_last, distance, halfedge) < std::tie(other.is_last, other.distance, other.halfedge);
    }
  };

  /// What lies beyond a border at the vertex.
  Index outside(Index vertex) const { return m_triangulation.number_of_faces() + vertex; }
  /// What lies beyond `halfedge`.
  Index across(Index halfedge) const
  {
    const Index twin = m_triangulation.twin(halfedge);
    return twin != no_index ? Triangulation::face(twin) : outside(m_triangulation.origin(halfedge));
  }

  /// Makes one disc of what lies beyond each border.
  void cap_borders()
  {
    for (Index h = 0; h < m_triangulation.number_of_halfedges(); ++h) {
      if (m_triangulation.twin(h) == no_index) {
        m_discs.join(outside(m_triangulation.origin(h)), outside(m_triangulation.target(h)));
      }
    }
  }

  /// Marks one face of each group of neighboring sources.
  void mark_sources(const std::vector<Index>& sources)
  {
    std::vector<char> is_new(m_triangulation.number_of_vertices(), 0);
    for (Index source : sources) {
      is_new[source] = 1;
    }
    std::vector<Index> group;
    for (Index source : sources) {
      if (is_new[source]) {
        mark_face_of(source);
        group.assign(1, source);
        is_new[source] = 0;
      }
      while (!group.empty()) {
        const Index member = group.back();
        group.pop_back();
        m_measures.frames().for_each_neighbor(member, [&](Index neighbor, Index) {
          if (is_new[neighbor]) {
            is_new[neighbor] = 0;
            group.push_back(neighbor);
          }
        });
      }
    }
  }

  void mark_face_of(Index source)
  {
    Index face = no_index;
    m_measures.frames().for_each_outgoing(source, [&](Index h) { face = std::min(face, Triangulation::face(h)); });
    if (face != no_index) {
      m_has_source[m_discs.find(face)] = 1;
    }
  }

  /// Unites what lies on both sides of `halfedge`. \return false if it is one disc already, or holds two sources
  bool cross(Index halfedge)
  {
    const Index a = m_discs.find(Triangulation::face(halfedge));
    const Index b = m_discs.find(across(halfedge));
    if (a == b || (m_has_source[a] != 0 && m_has_source[b] != 0)) {
      return false;
    }
    const char has_source = std::max(m_has_source[a], m_has_source[b]);
    m_discs.join(a, b);
    m_has_source[m_discs.find(a)] = has_source;
    return true;
  }

  const Cut_measures<Triangulation>& m_measures;
  const Triangulation& m_triangulation;
  Disjoint_sets m_discs; ///< of faces and, for each vertex, of what lies outside there
  std::vector<char> m_has_source;
};

} // namespace CSCD::internal

#endif // CSCD_CUT_LOCUS_DISC_GROWTH_H
