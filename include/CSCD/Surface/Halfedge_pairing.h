// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which halfedges of a list of triangles are twins, and where the triangles are no manifold.

#ifndef CSCD_SURFACE_HALFEDGE_PAIRING_H
#define CSCD_SURFACE_HALFEDGE_PAIRING_H

#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/Compressed_rows.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD {

/// The sides of a set of triangles as halfedges.
class Halfedge_pairing : public Triangle_halfedges
{
public:
  Halfedge_pairing() = default;

  /// Pairs the halfedges of `faces`, of which there are less than 2^29, by the numbers of their ends; near linear,
  /// whatever the degrees.
  /// \pre the corners of `faces` are less than `number_of_points`, and each face has three different ones
  Halfedge_pairing(const std::vector<std::array<Index, 3>>& faces, std::size_t number_of_points)
      : m_twin(3 * faces.size(), no_index)
  {
    pair(faces, number_of_points);
  }

  /// The number of halfedges, three a face.
  Index number_of_halfedges() const { return Index(m_twin.size()); }
  /// The oppositely directed halfedge of the same edge; `no_index` on a border.
  Index twin(Index halfedge) const { return m_twin[halfedge]; }
  /// The twins of all halfedges.
  std::vector<Index> twins() && { return std::move(m_twin); }
  /// A halfedge that has the ends and the direction of another one, or `no_index`: two faces are then oriented
  /// inconsistently, or more than two meet in one edge.
  Index conflict() const { return m_conflict; }
  /// Whether any halfedge has no twin.
  bool has_border() const { return m_has_border; }

private:
  /// An ascending halfedge, from its smaller to its larger end, in the bucket of the smaller one.
  struct Entry
  {
    Index larger_end;
    Index halfedge;

    bool operator<(const Entry& other) const
    {
      return std::tie(larger_end, halfedge) < std::tie(other.larger_end, other.halfedge);
    }
  };

  /// Buckets of more entries than this are sorted, so that vertices of high degree do not cost their degree squared.
  static constexpr Index small_bucket = 16;

  /// Calls `function(halfedge, origin, target)` for all halfedges.
  template <class Function>
  static void for_each_halfedge(const std::vector<std::array<Index, 3>>& faces, const Function& function)
  {
    Index halfedge = 0;
    for (const auto& [a, b, c] : faces) {
      function(halfedge++, a, b);
      function(halfedge++, b, c);
      function(halfedge++, c, a);
    }
  }

  void pair(const std::vector<std::array<Index, 3>>& faces, std::size_t number_of_points)
  {
    fill_buckets(faces, number_of_points);
    for (Index vertex = 0; vertex < number_of_points; ++vertex) {
      check_bucket(vertex);
    }
    for_each_halfedge(faces, [this](Index halfedge, Index origin, Index target) {
      if (origin > target) {
        pair_descending(halfedge, origin, target);
      }
    });
    m_entries = {};
    m_has_border = std::find(m_twin.begin(), m_twin.end(), no_index) != m_twin.end();
  }

  void fill_buckets(const std::vector<std::array<Index, 3>>& faces, std::size_t number_of_points)
  {
    m_entries = internal::Compressed_rows<Entry>(number_of_points, [&faces](const auto& add) {
      for_each_halfedge(faces, [&add](Index halfedge, Index origin, Index target) {
        if (origin < target) {
          add(origin, Entry{target, halfedge});
        }
      });
    });
  }

  bool is_sorted(Index vertex) const { return m_entries.size(vertex) > small_bucket; }

  /// Seeks two entries for the same edge; sorts the bucket if it is large.
  void check_bucket(Index vertex)
  {
    Entry* const first = m_entries[vertex].begin();
    Entry* const last = m_entries[vertex].end();
    if (is_sorted(vertex)) {
      std::sort(first, last);
    }
    const auto is_same_edge = [](const Entry& a, const Entry& b) { return a.larger_end == b.larger_end; };
    for (Entry* it = first; it != last && m_conflict == no_index; ++it) {
      Entry* const end = is_sorted(vertex) ? std::min(it + 2, last) : last;
      const auto other = std::find_if(it + 1, end, [&](const Entry& entry) { return is_same_edge(*it, entry); });
      m_conflict = other == end ? no_index : other->halfedge;
    }
  }

  /// Pairs the halfedge `h` from `larger_end` to `smaller_end` with the ascending one of its edge, if there is one.
  void pair_descending(Index h, Index larger_end, Index smaller_end)
  {
    const Entry* first = std::as_const(m_entries)[smaller_end].begin();
    const Entry* const last = std::as_const(m_entries)[smaller_end].end();
    if (is_sorted(smaller_end)) {
      first = std::lower_bound(first, last, Entry{larger_end, 0});
    }
    while (first != last && first->larger_end != larger_end) {
      ++first;
    }
    if (first == last) {
      return;
    }
    if (m_twin[first->halfedge] != no_index) {
      m_conflict = m_conflict == no_index ? h : m_conflict;
      return;
    }
    m_twin[h] = first->halfedge;
    m_twin[first->halfedge] = h;
  }

  std::vector<Index> m_twin;
  internal::Compressed_rows<Entry> m_entries; // by bucket, while halfedges are paired
  Index m_conflict = no_index;
  bool m_has_border = false;
};

/// Throws for the edge of `halfedge`, whose faces contradict each other.
template <class VertexName>
[[noreturn]] void refuse_edge(const Indexed_triangles& triangles, Index halfedge, const VertexName& name)
{
  const std::array<Index, 3>& owner = triangles.faces[halfedge / 3];
  const Index source = owner[halfedge % 3];
  const Index target = owner[(halfedge + 1) % 3];
  const auto has_edge = [source, target](const std::array<Index, 3>& face) {
    return std::count(face.begin(), face.end(), source) + std::count(face.begin(), face.end(), target) == 2;
  };
  const auto number_of_faces = std::count_if(triangles.faces.begin(), triangles.faces.end(), has_edge);
  const std::string edge =
      "the edge between vertices " + std::to_string(name(source)) + " and " + std::to_string(name(target));
  if (number_of_faces > 2) {
    throw Input_error(edge + " has " + std::to_string(number_of_faces) +
                      " faces, a surface has at most two: remove faces or split the edge, for instance by "
                      "CGAL::Polygon_mesh_processing::orient_polygon_soup");
  }
  throw Input_error(edge + " has two faces of opposite orientation: orient the faces consistently, for instance by "
                           "CGAL::Polygon_mesh_processing::orient_polygon_soup; a one-sided surface has no inside");
}

/// Calls `use(h)` for each halfedge `h` that leaves the origin of `halfedge` inside the same fan of faces.
template <class Use>
void for_each_in_fan(const Halfedge_pairing& pairing, Index halfedge, const Use& use)
{
  Index at = halfedge;
  do {
    use(at);
    at = pairing.twin(Halfedge_pairing::previous(at));
  } while (at != no_index && at != halfedge);
  if (at == no_index) {
    for (at = pairing.twin(halfedge); at != no_index; at = pairing.twin(at)) {
      at = Halfedge_pairing::next(at);
      use(at);
    }
  }
}

/// A vertex around which the faces form several fans, or `no_index`; linear.
/// \param pairing of the faces, without conflict
inline Index find_pinched_vertex(const Indexed_triangles& triangles, const Halfedge_pairing& pairing)
{
  std::vector<char> marked(pairing.number_of_halfedges(), 0);
  std::vector<char> has_fan(triangles.points.size(), 0);
  for (Index halfedge = 0; halfedge < pairing.number_of_halfedges(); ++halfedge) {
    if (marked[halfedge]) {
      continue;
    }
    const Index vertex = triangles.faces[halfedge / 3][halfedge % 3];
    if (has_fan[vertex]) {
      return vertex;
    }
    has_fan[vertex] = 1;
    for_each_in_fan(pairing, halfedge, [&marked](Index h) { marked[h] = 1; });
  }
  return no_index;
}

/// Pairs the halfedges of `triangles`, after making sure that every edge has at most two faces, oriented consistently,
/// and that the faces around every vertex form one fan. Linear.
/// \param name gives the number by which a message calls a vertex
/// \throw Input_error naming the first edge or vertex that violates this
template <class VertexName>
Halfedge_pairing check_manifold(const Indexed_triangles& triangles, const VertexName& name)
{
  Halfedge_pairing pairing(triangles.faces, triangles.points.size());
  if (pairing.conflict() != no_index) {
    refuse_edge(triangles, pairing.conflict(), name);
  }
  const Index pinched = find_pinched_vertex(triangles, pairing);
  if (pinched != no_index) {
    throw Input_error("vertex " + std::to_string(name(pinched)) +
                      " is pinched: its faces form several fans that touch in this point only; duplicate it, for "
                      "instance by CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices");
  }
  return pairing;
}

/// Gives every fan of faces around a vertex a vertex of its own: the first keeps it, the others get copies, which are
/// appended. The pairing remains valid. Linear. \return for every copy, in order, the vertex of which it is one
/// \pre `pairing`, that of the faces, has no conflict
inline std::vector<Index> split_pinched_vertices(Indexed_triangles& triangles, const Halfedge_pairing& pairing)
{
  std::vector<char> is_visited(pairing.number_of_halfedges(), 0);
  std::vector<char> has_fan(triangles.points.size(), 0);
  std::vector<Index> originals;
  for (Index halfedge = 0; halfedge < pairing.number_of_halfedges(); ++halfedge) {
    if (is_visited[halfedge]) {
      continue;
    }
    Index vertex = triangles.faces[halfedge / 3][halfedge % 3];
    if (has_fan[vertex]) {
      originals.push_back(vertex);
      triangles.points.push_back(Vector_3(triangles.points[vertex]));
      vertex = Index(triangles.points.size() - 1);
    } else {
      has_fan[vertex] = 1;
    }
    for_each_in_fan(pairing, halfedge, [&](Index h) {
      is_visited[h] = 1;
      triangles.faces[h / 3][h % 3] = vertex;
    });
  }
  return originals;
}

} // namespace CSCD

#endif // CSCD_SURFACE_HALFEDGE_PAIRING_H
