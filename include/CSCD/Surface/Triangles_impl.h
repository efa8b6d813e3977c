// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the sides of triangles are paired and checked.

#ifndef CSCD_SURFACE_TRIANGLES_IMPL_H
#define CSCD_SURFACE_TRIANGLES_IMPL_H

#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/config.h>
#include <CSCD/internal/flat_arrays.h>
#include <CSCD/internal/parallel.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

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

/// Removes the points of `checked` that no face uses.
/// \throw Input_error if one of the others has a coordinate that is not finite
inline void keep_used_points(Checked_triangles& checked)
{
  std::vector<Vector3>& points = checked.triangles.points;
  checked.input_number = compact_numbers(checked.triangles.faces, points.size());
  checked.number_of_isolated_vertices = points.size() - checked.input_number.size();
  for (std::size_t i = 0; i < checked.input_number.size(); ++i) {
    points[i] = Vector3(points[checked.input_number[i]]);
    if (!points[i].allFinite()) {
      throw Input_error("vertex " + std::to_string(checked.input_number[i]) +
                        " has a coordinate that is not finite: correct it or remove the vertex");
    }
  }
  points.resize(checked.input_number.size());
}

} // namespace CSCD::internal

namespace CSCD {

CSCD_INLINE Halfedge_pairing::Halfedge_pairing(const std::vector<std::array<Index, 3>>& faces,
                                               std::size_t number_of_points, unsigned number_of_threads)
    : m_twin(3 * faces.size(), no_index), m_outgoing(number_of_points, [&faces](const auto& add) {
        Index halfedge = 0;
        for (const std::array<Index, 3>& face : faces) {
          for (const Index corner : face) {
            add(corner, halfedge++);
          }
        }
      })
{
  std::vector<Findings> findings(number_of_points / internal::range_size + 1);
  internal::for_each_range(Index(number_of_points), number_of_threads, [&](Index begin, Index end) {
    findings[begin / internal::range_size] = pair_range(faces, begin, end);
  });
  for (const Findings& found : findings) {
    m_findings.conflict = m_findings.conflict == no_index ? found.conflict : m_findings.conflict;
    m_findings.pinched_vertex = std::min(m_findings.pinched_vertex, found.pinched_vertex);
    m_findings.has_border = m_findings.has_border || found.has_border;
  }
}

CSCD_INLINE Halfedge_pairing::Findings Halfedge_pairing::pair_range(const std::vector<std::array<Index, 3>>& faces,
                                                                    Index begin, Index end)
{
  Findings findings;
  for (Index vertex = begin; vertex < end; ++vertex) {
#ifdef __GNUC__
    // Half of the time went to waiting for faces: prefetch the faces of a vertex that comes soon.
    if (vertex + prefetch_distance < end) {
      for (const Index h : m_outgoing[vertex + prefetch_distance]) {
        __builtin_prefetch(&faces[face(h)]);
      }
    }
#endif
    pair_around(faces, vertex, findings);
  }
  return findings;
}

CSCD_INLINE void Halfedge_pairing::pair_around(const std::vector<std::array<Index, 3>>& faces, Index vertex,
                                               Findings& findings)
{
  const auto row = m_outgoing[vertex];
  const auto degree = row.size();
  if (degree <= small_degree ? !order_by_search<small_degree>(faces, row)
                             : degree > medium_degree || !order_by_search<medium_degree>(faces, row)) {
    order_by_sorting(faces, vertex, findings);
    return;
  }
  for (const Index* h = row.begin(); h != row.end(); ++h) {
    m_twin[*h] = previous(h == row.begin() ? *(row.end() - 1) : *(h - 1));
  }
}

template <std::size_t max_degree>
bool Halfedge_pairing::order_by_search(const std::vector<std::array<Index, 3>>& faces, CGAL::Iterator_range<Index*> row)
{
  std::array<Index, max_degree> target{};
  std::array<Index, max_degree> apex{};
  std::array<Index, max_degree> ordered{};
  target.fill(no_index);
  const auto degree = std::size_t(row.size());
  for (std::size_t i = 0; i < degree; ++i) {
    const Index h = row.begin()[i];
    const std::array<Index, 3>& corners = faces[face(h)];
    target[i] = corners[next(h) % 3];
    apex[i] = corners[previous(h) % 3];
  }
  std::size_t at = 0;
  for (std::size_t i = 0; i < degree; ++i) {
    ordered[i] = row.begin()[at];
    // All are compared, without a branch; the sum gives the place of one, and shows if none or several match.
    std::size_t sum = 0;
    for (std::size_t j = 0; j < max_degree; ++j) {
      sum += target[j] == apex[at] ? max_degree + j : 0;
    }
    at = sum - max_degree;
    if (at >= degree || (at == 0) != (i + 1 == degree)) {
      return false;
    }
  }
  std::copy(ordered.begin(), ordered.begin() + std::ptrdiff_t(degree), row.begin());
  return true;
}

CSCD_INLINE void Halfedge_pairing::order_by_sorting(const std::vector<std::array<Index, 3>>& faces, Index vertex,
                                                    Findings& findings)
{
  struct Sorted_corner
  {
    Index target;
    Index apex;
    Index halfedge;
    bool operator<(const Sorted_corner& other) const
    {
      return std::tie(target, halfedge) < std::tie(other.target, other.halfedge);
    }
  };
  const auto row = m_outgoing[vertex];
  if (row.empty()) {
    return;
  }
  std::vector<Sorted_corner> corners;
  corners.reserve(row.size());
  for (const Index h : row) {
    corners.push_back({faces[face(h)][next(h) % 3], faces[face(h)][previous(h) % 3], h});
  }
  std::sort(corners.begin(), corners.end());
  const auto is_same_edge = [](const Sorted_corner& a, const Sorted_corner& b) { return a.target == b.target; };
  const auto same = std::adjacent_find(corners.begin(), corners.end(), is_same_edge);
  if (same != corners.end() && findings.conflict == no_index) {
    findings.conflict = (same + 1)->halfedge;
  }
  const auto is_less = [](const Sorted_corner& a, const Sorted_corner& b) { return a.halfedge < b.halfedge; };
  auto first = std::min_element(corners.begin(), corners.end(), is_less);
  std::vector<std::size_t> next_corner(corners.size(), corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto found = std::lower_bound(corners.begin(), corners.end(), Sorted_corner{corners[i].apex, 0, 0});
    if (found != corners.end() && found->target == corners[i].apex) {
      next_corner[i] = std::size_t(found - corners.begin());
      m_twin[found->halfedge] = previous(corners[i].halfedge);
    }
  }
  bool is_on_border = false;
  for (auto it = corners.begin(); it != corners.end(); ++it) {
    if (m_twin[it->halfedge] == no_index) {
      first = is_on_border && is_less(*first, *it) ? first : it;
      findings.has_border = is_on_border = true;
    }
  }
  std::vector<Index> ordered;
  ordered.reserve(corners.size());
  std::size_t at = std::size_t(first - corners.begin());
  do {
    ordered.push_back(corners[at].halfedge);
    at = next_corner[at];
  } while (at < corners.size() && ordered.size() < corners.size() && corners[at].halfedge != first->halfedge);
  if (ordered.size() == corners.size()) {
    std::copy(ordered.begin(), ordered.end(), row.begin());
  } else if (findings.pinched_vertex == no_index) {
    findings.pinched_vertex = vertex;
  }
}

CSCD_INLINE Halfedge_pairing check_manifold(const Indexed_triangles& triangles, const std::function<Index(Index)>& name,
                                            unsigned number_of_threads)
{
  Halfedge_pairing pairing(triangles.faces, triangles.points.size(), number_of_threads);
  if (pairing.conflict() != no_index) {
    internal::refuse_edge(triangles, pairing.conflict(), name);
  }
  if (pairing.pinched_vertex() != no_index) {
    throw Input_error("vertex " + std::to_string(name(pairing.pinched_vertex())) +
                      " is pinched: its faces form several fans that touch in this point only; duplicate it, for "
                      "instance by CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices");
  }
  return pairing;
}

CSCD_INLINE Checked_triangles check_triangles(std::vector<Vector3>&& points, std::vector<std::array<Index, 3>>&& faces,
                                              unsigned number_of_threads)
{
  if (faces.empty()) {
    throw Input_error(
        "the mesh has no faces: a skeleton needs a surface; if these are points, use them as a point set");
  }
  Checked_triangles result;
  result.triangles.points = std::move(points);
  result.triangles.faces = std::move(faces);
  result.triangles.first_hole_filling_face = result.triangles.faces.size();
  internal::keep_used_points(result);
  result.pairing = check_manifold(
      result.triangles, [&result](Index vertex) { return result.input_number[vertex]; }, number_of_threads);
  return result;
}

CSCD_INLINE Checked_triangles check_triangles(Indexed_triangles&& triangles, Halfedge_pairing&& pairing,
                                              unsigned number_of_threads)
{
  Checked_triangles result;
  result.triangles = std::move(triangles);
  result.pairing = std::move(pairing);
  internal::keep_used_points(result);
  if (result.number_of_isolated_vertices > 0) {
    result.pairing = Halfedge_pairing(result.triangles.faces, result.triangles.points.size(), number_of_threads);
  }
  return result;
}

CSCD_INLINE std::vector<Index> split_pinched_vertices(Indexed_triangles& triangles, Halfedge_pairing& pairing)
{
  if (pairing.pinched_vertex() == no_index) {
    return {};
  }
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
      triangles.points.push_back(Vector3(triangles.points[vertex]));
      vertex = Index(triangles.points.size() - 1);
    } else {
      has_fan[vertex] = 1;
    }
    for_each_in_fan(pairing, halfedge, [&](Index h) {
      is_visited[h] = 1;
      triangles.faces[h / 3][h % 3] = vertex;
    });
  }
  pairing = Halfedge_pairing(triangles.faces, triangles.points.size());
  return originals;
}

} // namespace CSCD

#endif // CSCD_SURFACE_TRIANGLES_IMPL_H
