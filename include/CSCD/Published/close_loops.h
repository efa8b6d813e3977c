// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closes the loops of a cut locus around the handles of the surface.

#ifndef CSCD_PUBLISHED_CLOSE_LOOPS_H
#define CSCD_PUBLISHED_CLOSE_LOOPS_H

#include <CSCD/Points/Point_complex.h>
#include <CSCD/Published/Cut_locus_indicators.h>
#include <CSCD/Published/Cut_locus_settings.h>
#include <CSCD/Published/Cut_tree.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Disjoint_sets.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <variant>
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
  Disc_growth(const Cut_locus_indicators<Triangulation>& measures, const std::vector<Index>& sources)
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

  const Cut_locus_indicators<Triangulation>& m_measures;
  const Triangulation& m_triangulation;
  Disjoint_sets m_discs; ///< of faces and, for each vertex, of what lies outside there
  std::vector<char> m_has_source;
};

/// Marks the vertices of the loops of the cut locus and of what joins these: discs grow around the sources by distance,
/// and of the edges where they meet those are taken away, one after the other, that end freely. None are left on a
/// sphere with one source. Fronts may meet there at any angle, even at one that no threshold would notice.
/// O(m log m) for m faces.
template <class Triangulation>
std::vector<char> find_loop_vertices(const Cut_locus_indicators<Triangulation>& measures,
                                     const std::vector<Index>& sources)
{
  const Triangulation& triangulation = measures.frames().triangulation();
  const auto never = [](Index) { return false; };
  const std::vector<Index> uncrossed = Disc_growth<Triangulation>(measures, sources)(never, never);

  std::vector<char> is_left(triangulation.number_of_halfedges(), 0);
  std::vector<Index> degree(triangulation.number_of_vertices(), 0);
  for (Index h : uncrossed) {
    is_left[h] = 1;
    ++degree[triangulation.origin(h)];
    ++degree[triangulation.target(h)];
  }
  const auto mark_of = [&](Index halfedge) -> char& {
    const Index twin = triangulation.twin(halfedge);
    return is_left[is_left[halfedge] || twin == no_index ? halfedge : twin];
  };
  for (Index start = 0; start < triangulation.number_of_vertices(); ++start) {
    for (Index vertex = start; vertex != no_index && degree[vertex] == 1;) {
      Index next = no_index;
      measures.frames().for_each_neighbor(vertex, [&](Index neighbor, Index halfedge) {
        if (next == no_index && mark_of(halfedge)) {
          mark_of(halfedge) = 0;
          next = neighbor;
        }
      });
      --degree[vertex];
      --degree[next];
      vertex = next;
    }
  }
  std::vector<char> result(degree.size(), 0);
  for (Index vertex = 0; vertex < degree.size(); ++vertex) {
    result[vertex] = degree[vertex] > 0 ? 1 : 0;
  }
  return result;
}

/// Adds chords to `cut` until what it leaves of the surface is one disc around each source: the edges that the tree
/// does not take are crossed in order of distance, those along the cut locus last; those that cannot be crossed become
/// chords. On a closed connected surface of genus g, k sources make 2 g + k - 1 of them, and as many loops. Borders
/// count as closed by discs. O(m log m) for m faces.
/// \param sources the vertices at distance 0; those that are neighbors count as one source
template <class Triangulation>
void close_loops(const Cut_locus_indicators<Triangulation>& measures, const std::vector<Index>& sources, Cut_tree& cut)
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

/// Whether a closed surface has handles, around which cut loci have loops. Linear.
template <class Triangulation>
bool has_handles(const Triangulation& surface)
{
  Disjoint_sets components(surface.number_of_vertices());
  std::size_t number_of_components = surface.number_of_vertices();
  for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
    number_of_components -= components.join(surface.origin(h), surface.target(h)) ? 1 : 0;
  }
  return genus_of_closed_surface(number_of_components, surface.number_of_vertices(), surface.number_of_faces()) > 0;
}

/// \name Among points
/// No loops are known.
/// @{

inline bool has_handles(const Point_complex& /* surface */)
{
  return false;
}
inline std::vector<char> find_loop_vertices(const Point_cut_locus_indicators& measures,
                                            const std::vector<Index>& /* sources */)
{
  return std::vector<char>(measures.distances().size(), 0);
}
inline void close_loops(const Point_cut_locus_indicators& /* measures */, const std::vector<Index>& /* sources */,
                        Cut_tree& /* cut */)
{
}

/// @}

/// Finds the cut locus of `sources` as part of `tree`, the ORG tree of `measures`: filtered by the policy of
/// `settings`, its loops closed, made one vertex wide, without short branches. O(n log n) for n vertices.
/// \tparam Measures `Cut_locus_indicators` of a triangulation, or `Point_cut_locus_indicators`
/// \param closes_loops whether there are loops to be closed, as far as is known
template <class Measures>
Cut_tree find_cut_tree(const Measures& measures, const Org_tree& tree, const std::vector<Index>& sources,
                       const Cut_locus_settings& settings, bool closes_loops = true)
{
  return std::visit(
      [&](const auto& policy) {
        return filter_org_tree(measures, tree, settings.criterion, policy, settings.minimum_branch_length,
                               [&](Cut_tree& cut) {
                                 if (closes_loops) {
                                   close_loops(measures, sources, cut);
                                 }
                               });
      },
      settings.policy);
}

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_CLOSE_LOOPS_H
