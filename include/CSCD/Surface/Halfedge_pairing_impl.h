// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of Halfedge_pairing.h.

#ifndef CSCD_SURFACE_HALFEDGE_PAIRING_IMPL_H
#define CSCD_SURFACE_HALFEDGE_PAIRING_IMPL_H

#include <CSCD/Surface/Halfedge_pairing.h>
#include <CSCD/exceptions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Calls `function(halfedge, origin, target)` for all halfedges.
template <class Function>
void for_each_halfedge(const std::vector<std::array<Index, 3>>& faces, const Function& function)
{
  Index halfedge = 0;
  for (const auto& [a, b, c] : faces) {
    function(halfedge++, a, b);
    function(halfedge++, b, c);
    function(halfedge++, c, a);
  }
}

/// Throws for the edge of `halfedge`, whose faces contradict each other.
[[noreturn]] inline void refuse_edge(const Indexed_triangles& triangles, Index halfedge,
                                     const std::function<Index(Index)>& name)
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

} // namespace CSCD::internal

namespace CSCD {

CSCD_INLINE Halfedge_pairing::Halfedge_pairing(const std::vector<std::array<Index, 3>>& faces,
                                               std::size_t number_of_points)
    : m_twin(3 * faces.size(), no_index)
{
  fill_buckets(faces, number_of_points);
  for (Index vertex = 0; vertex < number_of_points; ++vertex) {
    check_bucket(vertex);
  }
  internal::for_each_halfedge(faces, [this](Index halfedge, Index origin, Index target) {
    if (origin > target) {
      pair_descending(halfedge, origin, target);
    }
  });
  m_entries = {};
  m_has_border = std::find(m_twin.begin(), m_twin.end(), no_index) != m_twin.end();
}

CSCD_INLINE void Halfedge_pairing::fill_buckets(const std::vector<std::array<Index, 3>>& faces,
                                                std::size_t number_of_points)
{
  m_entries = internal::Compressed_rows<Entry>(number_of_points, [&faces](const auto& add) {
    internal::for_each_halfedge(faces, [&add](Index halfedge, Index origin, Index target) {
      if (origin < target) {
        add(origin, Entry{target, halfedge});
      }
    });
  });
}

CSCD_INLINE void Halfedge_pairing::check_bucket(Index vertex)
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

CSCD_INLINE void Halfedge_pairing::pair_descending(Index h, Index larger_end, Index smaller_end)
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

CSCD_INLINE Index find_pinched_vertex(const Indexed_triangles& triangles, const Halfedge_pairing& pairing)
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

CSCD_INLINE Halfedge_pairing check_manifold(const Indexed_triangles& triangles, const std::function<Index(Index)>& name)
{
  Halfedge_pairing pairing(triangles.faces, triangles.points.size());
  if (pairing.conflict() != no_index) {
    internal::refuse_edge(triangles, pairing.conflict(), name);
  }
  const Index pinched = find_pinched_vertex(triangles, pairing);
  if (pinched != no_index) {
    throw Input_error("vertex " + std::to_string(name(pinched)) +
                      " is pinched: its faces form several fans that touch in this point only; duplicate it, for "
                      "instance by CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices");
  }
  return pairing;
}

CSCD_INLINE std::vector<Index> split_pinched_vertices(Indexed_triangles& triangles, const Halfedge_pairing& pairing)
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

#endif // CSCD_SURFACE_HALFEDGE_PAIRING_IMPL_H
