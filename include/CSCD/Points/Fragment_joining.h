// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joins the fragments of one body.

#ifndef CSCD_POINTS_FRAGMENT_JOINING_H
#define CSCD_POINTS_FRAGMENT_JOINING_H

#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CSCD::internal {

/// A gap between two fragments that was bridged.
struct Joined_gap
{
  Vector3 center;
  double width;
};

/// Joins fragments of a surface whose borders come near each other, and drops small others. Nothing is turned. A join
/// is a band of two triangles from border to border: the two borders become one, which can then be closed like any
/// other.
class Fragment_joining
{
public:
  Fragment_joining(Indexed_triangles& triangles, const Halfedge_pairing& pairing)
      : m_triangles(triangles), m_next(triangles.points.size(), no_index), m_previous(m_next),
        m_groups(sets_of_vertices(triangles.faces, triangles.points.size())), m_size(triangles.points.size(), 0)
  {
    for (const std::array<Index, 3>& face : triangles.faces) {
      ++m_size[m_groups.find(face[0])];
    }
    // Borders run so that the faces that close them lie to their left.
    for (Index h = 0; h < pairing.number_of_halfedges(); ++h) {
      if (pairing.twin(h) == no_index) {
        m_next[triangles.target(h)] = triangles.origin(h);
        m_previous[triangles.origin(h)] = triangles.target(h);
      }
    }
  }

  /// Joins the fragments. \return the gaps, in the order of bridging
  /// \post the pairing is invalid, and vertices of small fragments that were not joined have no faces
  std::vector<Joined_gap> operator()()
  {
    std::vector<Joined_gap> result;
    for (const auto& [gap, a, b] : find_candidates()) {
      if (are_one_body(gap, a, b)) {
        const std::size_t size = m_size[m_groups.find(a)] + m_size[m_groups.find(b)];
        m_groups.join(a, b);
        m_size[m_groups.find(a)] = size;
        add_band(a, b);
        result.push_back({(m_triangles.points[a] + m_triangles.points[b]) / 2, gap});
      }
    }
    drop_debris();
    return result;
  }

private:
  /// Two fragments that both have more than this part of all faces may be bodies that touch.
  static constexpr double max_part = 0.15;
  /// The widest gap over which fragments are joined, relative to the edges of the borders: about nine spacings of
  /// points. Only missing data explain such gaps.
  static constexpr double widest_gap = 8;
  /// The vertices of borders among which the ends of such gaps are sought.
  static constexpr Index far_neighbors = 64;
  /// Fragments of at most so many faces are dropped if they are not joined ...
  static constexpr double max_dropped = 100;
  /// ... and have at most this part of all faces.
  static constexpr double max_dropped_part = 0.02;
  /// The minimal length of the borders, relative to the gap, that makes larger fragments two stumps of a limb ...
  static constexpr double min_border = 3;
  /// ... and relative to their edges: a shorter border is only a hole in the sampling.
  static constexpr double min_border_in_edges = 8;

  /// The width of a gap, and the vertices on borders at its ends.
  using Candidate = std::tuple<double, Index, Index>;

  double distance(Index a, Index b) const { return (m_triangles.points[a] - m_triangles.points[b]).norm(); }
  /// The mean length of the two edges of the border at `vertex`.
  double edge_length(Index vertex) const
  {
    return (distance(m_previous[vertex], vertex) + distance(vertex, m_next[vertex])) / 2;
  }

  /// Pairs of vertices on borders of different fragments, the nearest first.
  std::vector<Candidate> find_candidates()
  {
    std::vector<Index> ends;
    std::vector<Vector3> places;
    for (Index vertex = 0; vertex < m_next.size(); ++vertex) {
      if (m_next[vertex] != no_index) {
        ends.push_back(vertex);
        places.push_back(m_triangles.points[vertex]);
      }
    }
    const Point_tree tree(places);
    std::vector<Candidate> result;
    for (const Index a : ends) {
      tree.for_each_nearest(m_triangles.points[a], far_neighbors, [&](Index i, double squared_distance) {
        const Index b = ends[i];
        const double gap = std::sqrt(squared_distance);
        if (m_groups.find(a) != m_groups.find(b) && gap <= widest_gap * std::min(edge_length(a), edge_length(b))) {
          result.emplace_back(gap, std::min(a, b), std::max(a, b));
        }
      });
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  /// Whether the groups at the ends of a gap are to be joined: if one is small, or both are stumps.
  bool are_one_body(double gap, Index a, Index b)
  {
    const Index group_a = m_groups.find(a);
    const Index group_b = m_groups.find(b);
    if (group_a == group_b) {
      return false;
    }
    const bool is_part =
        double(std::min(m_size[group_a], m_size[group_b])) <= max_part * double(m_triangles.faces.size());
    const double border = std::max(min_border * gap, min_border_in_edges * std::max(edge_length(a), edge_length(b)));
    return is_part || (has_border_of(a, border) && has_border_of(b, border));
  }

  /// Whether the border through `vertex` has at least this length.
  bool has_border_of(Index vertex, double length) const
  {
    double sum = 0;
    Index v = vertex;
    do {
      sum += distance(v, m_next[v]);
      v = m_next[v];
    } while (v != vertex && sum < length);
    return sum >= length;
  }

  void drop_debris()
  {
    std::vector<std::array<Index, 3>>& faces = m_triangles.faces;
    const double max_size = std::min(max_dropped, max_dropped_part * double(faces.size()));
    const auto is_debris = [&](const std::array<Index, 3>& face) {
      return double(m_size[m_groups.find(face[0])]) <= max_size;
    };
    faces.erase(std::remove_if(faces.begin(), faces.end(), is_debris), faces.end());
  }

  /// Bridges the gap between `a` and `b` by a quadrangle with an edge of either border.
  void add_band(Index a, Index b)
  {
    const double behind = distance(m_next[a], m_previous[b]);
    const double before = distance(m_previous[a], m_next[b]);
    // The quadrangle p, after p, q, after q: either a is p and b after q, or a is after p and b is q.
    const Index p = behind <= before ? a : m_previous[a];
    const Index q = behind <= before ? m_previous[b] : b;
    const Index after_p = m_next[p];
    const Index after_q = m_next[q];
    if (distance(p, q) < distance(after_p, after_q)) {
      m_triangles.faces.push_back({p, after_p, q});
      m_triangles.faces.push_back({p, q, after_q});
    } else {
      m_triangles.faces.push_back({p, after_p, after_q});
      m_triangles.faces.push_back({after_p, q, after_q});
    }
    m_next[p] = after_q;
    m_previous[after_q] = p;
    m_next[q] = after_p;
    m_previous[after_p] = q;
  }

  Indexed_triangles& m_triangles;
  std::vector<Index> m_next;       // of the vertices on borders
  std::vector<Index> m_previous;   // likewise
  Disjoint_sets m_groups;          // of the vertices of fragments that are joined
  std::vector<std::size_t> m_size; // faces of the groups
};

} // namespace CSCD::internal

#endif // CSCD_POINTS_FRAGMENT_JOINING_H
