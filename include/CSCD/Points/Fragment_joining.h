// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joins the fragments of one body.

#ifndef CSCD_POINTS_FRAGMENT_JOINING_H
#define CSCD_POINTS_FRAGMENT_JOINING_H

#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector_3.h>
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
  Vector_3 center;
  double width;
};

/// Joins fragments of a surface whose borders come near each other. Nothing is turned. A join
/// is a band of two triangles from border to border: the two borders become one, which can then be closed like any
/// other.
class Fragment_joining
{
public:
  Fragment_joining(Indexed_triangles& triangles, const Halfedge_pairing& pairing)
      : m_triangles(triangles), m_pairing(pairing), m_next(triangles.points.size(), no_index),
        m_previous(triangles.points.size(), no_index)
  {
    find_fragments();
    find_borders();
  }

  /// Joins the fragments. \return the gaps, in the order of bridging
  /// \post the pairing is invalid
  std::vector<Joined_gap> operator()()
  {
    std::vector<Joined_gap> result;
    if (m_number_of_fragments > 1) {
      for (const Candidate& candidate : find_candidates()) {
        if (join(candidate)) {
          result.push_back({(m_triangles.points[candidate.a] + m_triangles.points[candidate.b]) / 2, candidate.gap});
        }
      }
    }
    Index kept = 0;
    for (Index f = 0; f < m_triangles.faces.size(); ++f) {
      if (!m_is_removed[f]) {
        m_triangles.faces[kept++] = m_triangles.faces[f];
      }
    }
    m_triangles.faces.resize(kept);
    m_triangles.faces.insert(m_triangles.faces.end(), m_bands.begin(), m_bands.end());
    m_triangles.first_hole_filling_face = m_triangles.faces.size();
    return result;
  }

private:
  /// A vertex that is as near as so many neighbors of one in another fragment belongs to the same body ...
  static constexpr Index near_neighbors = 16;
  /// ... unless both fragments have more than this part of all faces: they may be bodies that touch.
  static constexpr double max_near_part = 0.15;
  /// The widest gap over which fragments are joined, relative to how far those neighbors reach: about nine spacings of
  /// points. Only missing data explain such gaps.
  static constexpr double widest_gap = 4;
  /// The neighbors among which the ends of such gaps are sought: as many as are within its width on a surface.
  static constexpr Index far_neighbors = 256;
  /// Fragments of at most so many faces are not bodies of their own: with a border ...
  static constexpr std::size_t max_open_debris = 800;
  /// ... and without, when they look whole.
  static constexpr std::size_t max_closed_debris = 100;
  /// The minimal length of the borders, relative to the gap, that makes larger fragments two stumps of a limb ...
  static constexpr double min_border = 3;
  /// ... and relative to the reach of the neighbors: a shorter border is only a hole in the sampling.
  static constexpr double min_border_in_reaches = 4;

  struct Candidate
  {
    double gap;
    Index a;
    Index b;
    bool operator<(const Candidate& other) const { return std::tie(gap, a, b) < std::tie(other.gap, other.a, other.b); }
  };

  Index origin(Index h) const { return m_triangles.faces[h / 3][h % 3]; }
  Index target(Index h) const { return m_triangles.faces[h / 3][(h + 1) % 3]; }
  double distance(Index a, Index b) const { return (m_triangles.points[a] - m_triangles.points[b]).norm(); }
  Index group(Index vertex) { return m_groups.find(m_fragment[vertex]); }

  void find_fragments()
  {
    Disjoint_sets sets(m_triangles.points.size());
    for (const std::array<Index, 3>& face : m_triangles.faces) {
      sets.join(face[0], face[1]);
      sets.join(face[0], face[2]);
    }
    m_fragment = sets.numbers(m_number_of_fragments);
    m_groups = Disjoint_sets(m_number_of_fragments);
    m_size.assign(m_number_of_fragments, 0);
    for (const std::array<Index, 3>& face : m_triangles.faces) {
      ++m_size[m_fragment[face[0]]];
    }
    m_is_removed.assign(m_triangles.faces.size(), 0);
    m_faces_of_vertex = Compressed_rows<Index>(m_triangles.points.size(), [this](const auto& add) {
      for (Index f = 0; f < m_triangles.faces.size(); ++f) {
        for (const Index corner : m_triangles.faces[f]) {
          add(corner, f);
        }
      }
    });
  }

  /// Borders run so that the faces that close them lie to their left.
  void find_borders()
  {
    m_has_border.assign(m_number_of_fragments, 0);
    for (Index h = 0; h < m_pairing.number_of_halfedges(); ++h) {
      if (m_pairing.twin(h) == no_index) {
        m_next[target(h)] = origin(h);
        m_previous[origin(h)] = target(h);
        m_has_border[m_fragment[origin(h)]] = 1;
      }
    }
  }

  /// Pairs of vertices of different fragments, the nearest first: neighbors, and across wider gaps the vertices of
  /// borders and of small fragments.
  std::vector<Candidate> find_candidates()
  {
    const Point_tree tree(m_triangles.points);
    std::vector<Candidate> result;
    m_reach.resize(m_triangles.points.size());
    for (Index a = 0; a < m_fragment.size(); ++a) {
      const bool is_far_end = m_next[a] != no_index || is_debris(m_fragment[a]);
      const Index number = is_far_end ? far_neighbors : near_neighbors + 1; // a itself among them
      Index i = 0;
      tree.for_each_nearest(m_triangles.points[a], number, [&](Index b, double squared_distance) {
        const double gap = std::sqrt(squared_distance);
        m_reach[a] = i++ <= near_neighbors ? gap : m_reach[a];
        if (m_fragment[a] != m_fragment[b] && gap <= widest_gap * m_reach[a]) {
          result.push_back({gap, std::min(a, b), std::max(a, b)});
        }
      });
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  /// Whether a group is too small to be a body of its own.
  bool is_debris(Index group) const
  {
    return m_size[group] <= (m_has_border[group] != 0 ? max_open_debris : max_closed_debris);
  }

  /// Whether a border of at least this length runs through `vertex`.
  bool has_border_of(Index vertex, double length) const
  {
    double sum = 0;
    Index v = vertex;
    do {
      if (m_next[v] == no_index) {
        return false;
      }
      sum += distance(v, m_next[v]);
      v = m_next[v];
    } while (v != vertex && sum < length);
    return sum >= length;
  }

  /// Joins the groups at the ends of a gap if they are of the same body: if they are near each other, or one is small,
  /// or both are stumps.
  bool join(const Candidate& gap)
  {
    const Index group_a = group(gap.a);
    const Index group_b = group(gap.b);
    if (group_a == group_b) {
      return false;
    }
    const double reach = std::max(m_reach[gap.a], m_reach[gap.b]);
    const double border = std::max(min_border * gap.gap, min_border_in_reaches * reach);
    const auto smaller = double(std::min(m_size[group_a], m_size[group_b]));
    const bool is_part = smaller <= max_near_part * double(m_triangles.faces.size());
    const bool is_small = is_part && (gap.gap <= reach || is_debris(group_a) || is_debris(group_b));
    if (!is_small && !(has_border_of(gap.a, border) && has_border_of(gap.b, border))) {
      return false;
    }
    unite(group_a, group_b);
    const Vector_3 way = m_triangles.points[gap.b] - m_triangles.points[gap.a];
    const Index end_a = open(gap.a, way);
    const Index end_b = open(gap.b, -way);
    add_band(end_a, end_b);
    return true;
  }

  /// Makes sure that there is a border at or next to `vertex`, by opening a face that looks along `direction`.
  /// \return a vertex on the border
  Index open(Index vertex, const Vector_3& direction)
  {
    if (m_next[vertex] != no_index) {
      return vertex;
    }
    Index best = no_index;
    double greatest = 0;
    Index on_border = no_index;
    for (const Index f : m_faces_of_vertex[vertex]) {
      const std::array<Index, 3>& face = m_triangles.faces[f];
      const auto border = std::find_if(face.begin(), face.end(), [this](Index v) { return m_next[v] != no_index; });
      if (border != face.end()) {
        on_border = *border;
        continue;
      }
      const Vector_3& p = m_triangles.points[face[0]];
      const double cosine =
          (m_triangles.points[face[1]] - p).cross(m_triangles.points[face[2]] - p).normalized().dot(direction);
      if (best == no_index || cosine > greatest) {
        best = f;
        greatest = cosine;
      }
    }
    if (best == no_index) {
      return on_border;
    }
    m_is_removed[best] = 1;
    const std::array<Index, 3>& face = m_triangles.faces[best];
    for (std::size_t i = 0; i < 3; ++i) {
      m_next[face[i]] = face[(i + 1) % 3];
      m_previous[face[(i + 1) % 3]] = face[i];
    }
    return vertex;
  }

  void unite(Index group_a, Index group_b)
  {
    m_groups.join(group_a, group_b);
    const Index joined = m_groups.find(group_a);
    const Index other = joined == group_a ? group_b : group_a;
    m_size[joined] += m_size[other];
    m_has_border[joined] = char(m_has_border[joined] | m_has_border[other]);
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
      m_bands.push_back({p, after_p, q});
      m_bands.push_back({p, q, after_q});
    } else {
      m_bands.push_back({p, after_p, after_q});
      m_bands.push_back({after_p, q, after_q});
    }
    m_next[p] = after_q;
    m_previous[after_q] = p;
    m_next[q] = after_p;
    m_previous[after_p] = q;
  }

  Indexed_triangles& m_triangles;
  const Halfedge_pairing& m_pairing;
  std::vector<Index> m_fragment; // of every vertex
  std::vector<Index> m_next;     // of the vertices on borders
  std::vector<Index> m_previous; // likewise
  std::vector<double> m_reach;   // how far the neighbors of every vertex reach
  Index m_number_of_fragments = 0;
  Disjoint_sets m_groups;          // of fragments that are joined
  std::vector<std::size_t> m_size; // faces of the groups
  std::vector<char> m_has_border;  // of the groups, before any face was opened
  std::vector<char> m_is_removed;  // of every face
  Compressed_rows<Index> m_faces_of_vertex;
  std::vector<std::array<Index, 3>> m_bands;
};

} // namespace CSCD::internal

#endif // CSCD_POINTS_FRAGMENT_JOINING_H
