// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The loops of a cut locus that go around handles.

#ifndef CSCD_CUT_LOCUS_CLOSE_LOOPS_H
#define CSCD_CUT_LOCUS_CLOSE_LOOPS_H

#include <CSCD/Cut_locus/Cut_measures.h>
#include <CSCD/Cut_locus/Cut_tree.h>
#include <CSCD/internal/Disjoint_sets.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Adds chords to a cut tree until what it leaves of the surface is one disc around each source, as the complement of a
/// cut locus is; see `close_loops()`.
template <class Triangulation>
class Loop_closing
{
public:
  Loop_closing(const Cut_measures<Triangulation>& measures, Cut_tree& cut)
      : m_measures(measures), m_triangulation(measures.frames().triangulation()), m_cut(cut),
        m_regions(std::size_t(m_triangulation.number_of_faces()) + m_triangulation.number_of_vertices()),
        m_has_source(m_regions.size(), 0)
  {
    cap_borders();
  }

  void operator()(const std::vector<Index>& sources)
  {
    mark_sources(sources);
    collect_edges();
    for (const Edge& edge : m_edges) {
      if (!join(edge.halfedge)) {
        m_cut.add_chord(edge.halfedge, m_triangulation.origin(edge.halfedge), m_triangulation.target(edge.halfedge));
      }
    }
  }

private:
  struct Edge
  {
    bool is_kept; ///< whether both ends are: such edges are crossed last, so that chords lie on the cut locus
    double distance;
    Index halfedge;
    bool operator<(const Edge& other) const
    {
      return std::tie(is_kept, distance, halfedge) < std::tie(other.is_kept, other.distance, other.halfedge);
    }
  };

  bool is_reached(Index halfedge) const { return m_measures.is_reached(m_triangulation.origin(halfedge)); }

  /// What lies beyond a border at the vertex.
  Index outside(Index vertex) const { return m_triangulation.number_of_faces() + vertex; }
  /// What lies beyond `halfedge`.
  Index across(Index halfedge) const
  {
    const Index twin = m_triangulation.twin(halfedge);
    return twin != no_index ? Triangulation::face(twin) : outside(m_triangulation.origin(halfedge));
  }

  /// Makes one region of what lies beyond each border, as if a disc closed it.
  void cap_borders()
  {
    for (Index h = 0; h < m_triangulation.number_of_halfedges(); ++h) {
      if (m_triangulation.twin(h) == no_index) {
        m_regions.join(outside(m_triangulation.origin(h)), outside(m_triangulation.target(h)));
      }
    }
  }

  /// Marks one face of each group of neighboring sources: they share a region.
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
      m_has_source[m_regions.find(face)] = 1;
    }
  }

  /// Collects the edges that the tree does not take, in the order in which discs that grow around the sources cross
  /// them. All vertices of a face have a distance, or none has.
  void collect_edges()
  {
    for (Index h = 0; h < m_triangulation.number_of_halfedges(); ++h) {
      const Index twin = m_triangulation.twin(h);
      if (!is_reached(h) || twin < h || is_in_tree(h, twin)) {
        continue;
      }
      const Index a = m_triangulation.origin(h);
      const Index b = m_triangulation.target(h);
      m_edges.push_back(
          {m_cut.is_kept(a) && m_cut.is_kept(b), (m_measures.distance(a) + m_measures.distance(b)) / 2, h});
    }
    std::sort(m_edges.begin(), m_edges.end());
  }

  bool is_in_tree(Index halfedge, Index twin) const
  {
    const auto is_tree_edge_of = [&](Index vertex) {
      const Index own = m_cut.tree().halfedge_to_parent(vertex);
      return own != no_index && (own == halfedge || own == twin);
    };
    return is_tree_edge_of(m_triangulation.origin(halfedge)) || is_tree_edge_of(m_triangulation.target(halfedge));
  }

  /// Unites what lies on both sides of `halfedge`. \return false if it is one region already, or has two sources
  bool join(Index halfedge)
  {
    const Index a = m_regions.find(Triangulation::face(halfedge));
    const Index b = m_regions.find(across(halfedge));
    if (a == b || (m_has_source[a] != 0 && m_has_source[b] != 0)) {
      return false;
    }
    const char has_source = std::max(m_has_source[a], m_has_source[b]);
    m_regions.join(a, b);
    m_has_source[m_regions.find(a)] = has_source;
    return true;
  }

  const Cut_measures<Triangulation>& m_measures;
  const Triangulation& m_triangulation;
  Cut_tree& m_cut;
  Disjoint_sets m_regions; ///< of faces and, for each vertex, of what lies outside there
  std::vector<char> m_has_source;
  std::vector<Edge> m_edges;
};

/// Adds chords to `cut` until what it leaves of the surface is one disc around each source. The edges that the tree
/// does not take are crossed in order of distance, those along the cut locus last, unless that would close a ring of
/// faces or join the regions of two sources: then the edge becomes a chord. On a closed connected surface of genus g, k
/// sources make 2 g + k - 1 chords, and as many loops. Borders count as closed by discs. O(m log m) for m faces.
/// \param sources the vertices at distance 0; those that are neighbors count as one source
template <class Triangulation>
void close_loops(const Cut_measures<Triangulation>& measures, const std::vector<Index>& sources, Cut_tree& cut)
{
  Loop_closing<Triangulation>(measures, cut)(sources);
}

} // namespace CSCD::internal

#endif // CSCD_CUT_LOCUS_CLOSE_LOOPS_H
