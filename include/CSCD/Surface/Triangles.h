// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles as indices of points: their order, the pairing of their halfedges, and checks of a manifold.

#ifndef CSCD_SURFACE_TRIANGLES_H
#define CSCD_SURFACE_TRIANGLES_H

#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/flat_arrays.h>
#include <CSCD/internal/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD {

/// Halfedge `h` runs along side `h % 3` of face `h / 3`, counterclockwise: so going around a face needs no memory.
/// Triangulations are derived from this.
struct Triangle_halfedges
{
  /// The halfedge after `halfedge` in its face.
  static Index next(Index halfedge) { return halfedge % 3 == 2 ? halfedge - 2 : halfedge + 1; }
  /// The halfedge before `halfedge` in its face.
  static Index previous(Index halfedge) { return halfedge % 3 == 0 ? halfedge + 2 : halfedge - 1; }
  /// The face of `halfedge`.
  static Index face(Index halfedge) { return halfedge / 3; }
};

/// The genus of a closed surface, all components together: their Euler numbers V - E + F = V - F/2, each 2 - 2 g, add
/// up.
constexpr std::size_t genus_of_closed_surface(std::size_t number_of_components, std::size_t number_of_vertices,
                                              std::size_t number_of_faces)
{
  return (2 * number_of_components + number_of_faces / 2 - number_of_vertices) / 2;
}

/// Points and triangles, counterclockwise seen from outside.
struct Indexed_triangles
{
  /// The vertex where `halfedge` starts.
  Index origin(Index halfedge) const { return faces[halfedge / 3][halfedge % 3]; }
  /// The vertex where `halfedge` ends.
  Index target(Index halfedge) const { return faces[halfedge / 3][(halfedge + 1) % 3]; }

  /// The positions of the vertices.
  std::vector<Vector3> points;
  /// The vertices of each face, counterclockwise seen from outside.
  std::vector<std::array<Index, 3>> faces;
  /// The faces from this one on only bridge borders: they close the surface but carry no area.
  std::size_t first_hole_filling_face = 0;
};

/// Removes the numbers that no face uses from the numbering, and returns the old numbers of the rest, in order.
inline std::vector<Index> compact_numbers(std::vector<std::array<Index, 3>>& faces, std::size_t number_of_vertices)
{
  std::vector<Index> new_number(number_of_vertices, no_index);
  for (const std::array<Index, 3>& face : faces) {
    for (Index corner : face) {
      new_number[corner] = 0;
    }
  }
  std::vector<Index> old_number;
  old_number.reserve(number_of_vertices);
  for (Index vertex = 0; vertex < number_of_vertices; ++vertex) {
    if (new_number[vertex] != no_index) {
      new_number[vertex] = Index(old_number.size());
      old_number.push_back(vertex);
    }
  }
  if (old_number.size() < number_of_vertices) {
    for (std::array<Index, 3>& face : faces) {
      for (Index& corner : face) {
        corner = new_number[corner];
      }
    }
  }
  return old_number;
}

namespace internal {

/// The sets of vertices that faces join. Near linear.
inline Disjoint_sets sets_of_vertices(const std::vector<std::array<Index, 3>>& faces, std::size_t number_of_vertices)
{
  Disjoint_sets sets(number_of_vertices);
  for (const auto& [a, b, c] : faces) {
    sets.join(a, b);
    sets.join(a, c);
  }
  return sets;
}

/// The areas of the faces.
inline std::vector<double> face_areas(const Indexed_triangles& triangles)
{
  std::vector<double> areas;
  areas.reserve(triangles.faces.size());
  for (const auto& [a, b, c] : triangles.faces) {
    areas.push_back(triangle_area(triangles.points[a], triangles.points[b], triangles.points[c]));
  }
  return areas;
}

/// Removes the points of `triangles` that no face uses. Linear. \return the old numbers of the rest, in order
inline std::vector<Index> remove_unused_points(Indexed_triangles& triangles)
{
  std::vector<Index> old_number = compact_numbers(triangles.faces, triangles.points.size());
  for (std::size_t i = 0; i < old_number.size(); ++i) {
    triangles.points[i] = Vector3(triangles.points[old_number[i]]);
  }
  triangles.points.resize(old_number.size());
  return old_number;
}

/// A number of the edge between two vertices that decides between equal choices: scattered, since the first or the
/// least would lead all choices to one side. The multipliers are primes of xxHash.
constexpr std::uint32_t scattered(Index a, Index b)
{
  constexpr std::uint32_t first_prime = 0x9e3779b1U;
  constexpr std::uint32_t second_prime = 0x85ebca77U;
  std::uint32_t mixed = (a * first_prime) ^ (b * second_prime);
  mixed = (mixed ^ (mixed >> 15U)) * second_prime;
  return mixed ^ (mixed >> 13U);
}

/// The point of a fine grid that `point` is nearest to: coordinates that differ by rounding only become equal.
/// \pre the coordinates are about 1
inline Vector3 on_grid(const Vector3& point)
{
  constexpr double lines = 1 << 30; // for each unit of length
  return {std::round(lines * point.x()), std::round(lines * point.y()), std::round(lines * point.z())};
}

} // namespace internal

/// Sorts faces lexicographically, hole-filling faces after all others; linear where degrees are bounded.
/// \pre the smallest corner of every face comes first
inline void sort_faces(Indexed_triangles& triangles)
{
  // One bucket for each smallest corner; the buckets of the hole-filling faces come last.
  const std::size_t n = triangles.points.size();
  const auto bucket = [&triangles, n](std::size_t f) {
    return triangles.faces[f].front() + (f < triangles.first_hole_filling_face ? 0 : n);
  };
  internal::Compressed_rows<std::array<Index, 3>> buckets(2 * n, [&](const auto& add) {
    for (std::size_t f = 0; f < triangles.faces.size(); ++f) {
      add(bucket(f), triangles.faces[f]);
    }
  });
  for (Index b = 0; b < 2 * n; ++b) {
    std::sort(buckets[b].begin(), buckets[b].end());
  }
  triangles.faces = std::move(buckets).values();
}

/// Gives the vertex `order[i]` of `triangles` the number `i`, and sorts the faces accordingly, each from its smallest
/// corner on. Linear where degrees are bounded.
/// \pre `order` is a permutation
inline void renumber(Indexed_triangles& triangles, const std::vector<Index>& order)
{
  std::vector<Index> number(order.size());
  for (Index i = 0; i < order.size(); ++i) {
    number[order[i]] = i;
  }
  triangles.points = internal::reordered(triangles.points, order);
  for (std::array<Index, 3>& face : triangles.faces) {
    for (Index& corner : face) {
      corner = number[corner];
    }
    if (face[1] < face[0] && face[1] < face[2]) {
      face = {face[1], face[2], face[0]};
    } else if (face[2] < face[0]) {
      face = {face[2], face[0], face[1]};
    }
  }
  sort_faces(triangles);
}

/// The sides of a set of triangles as halfedges.
class Halfedge_pairing : public Triangle_halfedges
{
public:
  Halfedge_pairing() = default;

  /// Pairs the halfedges of `faces`, less than 2^29 faces, by the numbers of their ends; near linear for any degrees.
  /// \param number_of_threads 0 for as many as TBB allows; the result is the same for any number
  /// \pre the corners of `faces` are less than `number_of_points`, and each face has three different ones
  Halfedge_pairing(const std::vector<std::array<Index, 3>>& faces, std::size_t number_of_points,
                   unsigned number_of_threads = 1)
      : m_twin(3 * faces.size(), no_index), m_outgoing(number_of_points, [&faces](const auto& add) {
          Index halfedge = 0;
          for (const std::array<Index, 3>& face : faces) {
            for (const Index corner : face) {
              add(corner, halfedge++);
            }
          }
        })
  {
    const auto n = Index(number_of_points);
    std::vector<Findings> findings(n / range_size + 1);
    internal::For_each_index<char> for_each([] { return '\0'; }, findings.size() > 1 ? number_of_threads : 1);
    for_each(Index(findings.size()), [&](Index range, char&) {
      findings[range] = pair_range(faces, range * range_size, std::min((range + 1) * range_size, n));
    });
    for (const Findings& found : findings) {
      m_findings.conflict = m_findings.conflict == no_index ? found.conflict : m_findings.conflict;
      m_findings.pinched_vertex = std::min(m_findings.pinched_vertex, found.pinched_vertex);
      m_findings.has_border = m_findings.has_border || found.has_border;
    }
  }

  /// The number of halfedges, three a face.
  Index number_of_halfedges() const { return Index(m_twin.size()); }
  /// The oppositely directed halfedge of the same edge; `no_index` on a border.
  Index twin(Index halfedge) const { return m_twin[halfedge]; }
  /// The halfedges that leave each point, counterclockwise: at a border the first one of the fan comes first, elsewhere
  /// the smallest. Without order where there is a conflict or a pinched vertex.
  const internal::Compressed_rows<Index>& outgoing() const { return m_outgoing; }
  /// Hands over the twins of all halfedges and the rows of `outgoing()`.
  void move_to(std::vector<Index>& twins, internal::Compressed_rows<Index>& outgoing_rows) &&
  {
    twins = std::move(m_twin);
    outgoing_rows = std::move(m_outgoing);
  }
  /// A halfedge that has the ends and the direction of another one, or `no_index`: two faces are then oriented
  /// inconsistently, or more than two meet in one edge.
  Index conflict() const { return m_findings.conflict; }
  /// The first vertex whose faces form several fans, or `no_index`. \pre no halfedge is in conflict
  Index pinched_vertex() const { return m_findings.pinched_vertex; }
  /// Whether any halfedge has no twin.
  bool has_border() const { return m_findings.has_border; }

private:
  /// Prefetch distance, in vertices.
  static constexpr Index prefetch_distance = 8;
  /// Vertices that are paired at once: enough that the parallel loop itself does not count.
  static constexpr Index range_size = 1U << 13U;

  /// Violations of a manifold around some vertices, the first of each kind.
  struct Findings
  {
    Index conflict = no_index;
    Index pinched_vertex = no_index;
    bool has_border = false;
  };

  /// The corner of a face at a vertex.
  struct Fan_corner
  {
    Index target;     ///< of its halfedge
    Index apex;       ///< the third vertex of its face
    Index halfedge;   ///< that leaves the vertex
    std::size_t next; ///< the position of the corner that comes next counterclockwise; past the end at a border
  };

  /// Pairs and orders the halfedges that leave the vertices from `begin` to `end` - 1, and no others.
  Findings pair_range(const std::vector<std::array<Index, 3>>& faces, Index begin, Index end)
  {
    Findings findings;
    std::vector<Fan_corner> corners;
    for (Index vertex = begin; vertex < end; ++vertex) {
#ifdef __GNUC__
      // Half of the time went to waiting for faces: prefetch the faces of a vertex that comes soon.
      if (vertex + prefetch_distance < end) {
        for (const Index h : m_outgoing[vertex + prefetch_distance]) {
          __builtin_prefetch(&faces[face(h)]);
        }
      }
#endif
      corners.clear();
      for (const Index h : m_outgoing[vertex]) {
        corners.push_back({faces[face(h)][next(h) % 3], faces[face(h)][previous(h) % 3], h, m_outgoing.size(vertex)});
      }
      if (!corners.empty()) {
        pair_around(vertex, corners, findings);
      }
    }
    return findings;
  }

  /// Pairs and orders the halfedges that leave `vertex` in `corners`, in ascending order.
  void pair_around(Index vertex, std::vector<Fan_corner>& corners, Findings& findings)
  {
    const auto leads_to_less = [](const Fan_corner& a, const Fan_corner& b) {
      return std::tie(a.target, a.halfedge) < std::tie(b.target, b.halfedge);
    };
    std::sort(corners.begin(), corners.end(), leads_to_less);
    const auto same = std::adjacent_find(corners.begin(), corners.end(),
                                         [](const Fan_corner& a, const Fan_corner& b) { return a.target == b.target; });
    if (same != corners.end() && findings.conflict == no_index) {
      findings.conflict = (same + 1)->halfedge;
    }
    for (Fan_corner& corner : corners) {
      const auto found =
          std::lower_bound(corners.begin(), corners.end(), Fan_corner{corner.apex, 0, 0, 0}, leads_to_less);
      if (found != corners.end() && found->target == corner.apex) {
        corner.next = std::size_t(found - corners.begin());
        m_twin[found->halfedge] = previous(corner.halfedge);
      }
    }
    // The corner that begins the fan: the first one behind a border, else the first of all.
    const auto comes_first = [this](const Fan_corner& a, const Fan_corner& b) {
      return std::make_tuple(m_twin[a.halfedge] != no_index, a.halfedge) <
             std::make_tuple(m_twin[b.halfedge] != no_index, b.halfedge);
    };
    const auto first = std::min_element(corners.begin(), corners.end(), comes_first);
    findings.has_border = findings.has_border || m_twin[first->halfedge] == no_index;
    std::size_t size = 1; // of the fan
    for (std::size_t at = first->next;
         at < corners.size() && corners[at].halfedge != first->halfedge && size < corners.size();
         at = corners[at].next) {
      ++size;
    }
    if (size == corners.size()) {
      auto at = std::size_t(first - corners.begin());
      for (Index& h : m_outgoing[vertex]) {
        h = corners[at].halfedge;
        at = corners[at].next;
      }
    } else if (findings.pinched_vertex == no_index) {
      findings.pinched_vertex = vertex;
    }
  }

  std::vector<Index> m_twin;
  internal::Compressed_rows<Index> m_outgoing;
  Findings m_findings;
};

/// Triangles with paired halfedges, and the vertices of the input that they use.
struct Checked_triangles
{
  Indexed_triangles triangles;                 ///< the triangles of the input, with points that have a face
  Halfedge_pairing pairing;                    ///< of their halfedges
  std::vector<Index> input_number;             ///< for each point, its number in the input
  std::size_t number_of_isolated_vertices = 0; ///< points of the input without a face
};

namespace internal {

/// With more faces than this the halfedges of the refined surface could no longer be indexed.
inline constexpr std::size_t maximum_number_of_faces = std::size_t(1) << 26;

/// Throws for the edge of `halfedge`, whose faces contradict each other.
[[noreturn]] inline void refuse_edge(const Checked_triangles& checked, Index halfedge)
{
  const std::vector<std::array<Index, 3>>& faces = checked.triangles.faces;
  const Index source = checked.triangles.origin(halfedge);
  const Index target = checked.triangles.target(halfedge);
  const auto has_edge = [source, target](const std::array<Index, 3>& face) {
    return std::count(face.begin(), face.end(), source) + std::count(face.begin(), face.end(), target) == 2;
  };
  const auto number_of_faces = std::count_if(faces.begin(), faces.end(), has_edge);
  const std::string edge = "the edge between vertices " + std::to_string(checked.input_number[source]) + " and " +
                           std::to_string(checked.input_number[target]);
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
  const std::size_t number_of_points = checked.triangles.points.size();
  checked.input_number = remove_unused_points(checked.triangles);
  checked.number_of_isolated_vertices = number_of_points - checked.input_number.size();
  const std::vector<Vector3>& points = checked.triangles.points;
  const auto bad = std::find_if(points.begin(), points.end(), [](const Vector3& p) { return !p.allFinite(); });
  if (bad != points.end()) {
    throw Input_error("vertex " + std::to_string(checked.input_number[std::size_t(bad - points.begin())]) +
                      " has a coordinate that is not finite: correct it or remove the vertex");
  }
}

} // namespace internal

/// Leaves out the points without a face, and pairs the halfedges of the rest. Linear.
/// \param number_of_threads 0 for as many as TBB allows
/// \pre each face has three different corners, which are less than the number of points
/// \throw Input_error naming the element, by its number in the input, if `faces` is empty, there are more than 2^26
///        faces or points, an edge has more than two faces or faces of opposite orientation, a vertex is pinched, or a
///        coordinate is not finite
inline Checked_triangles check_triangles(std::vector<Vector3>&& points, std::vector<std::array<Index, 3>>&& faces,
                                         unsigned number_of_threads = 1)
{
  if (faces.empty()) {
    throw Input_error(
        "the mesh has no faces: a skeleton needs a surface; if these are points, use them as a point set");
  }
  if (std::max(faces.size(), points.size()) > internal::maximum_number_of_faces) {
    throw Input_error("the mesh has more than 2^26 faces or vertices: simplify it first");
  }
  Checked_triangles result;
  result.triangles.points = std::move(points);
  result.triangles.faces = std::move(faces);
  result.triangles.first_hole_filling_face = result.triangles.faces.size();
  internal::keep_used_points(result);
  result.pairing = Halfedge_pairing(result.triangles.faces, result.triangles.points.size(), number_of_threads);
  if (result.pairing.conflict() != no_index) {
    internal::refuse_edge(result, result.pairing.conflict());
  }
  if (result.pairing.pinched_vertex() != no_index) {
    throw Input_error("vertex " + std::to_string(result.input_number[result.pairing.pinched_vertex()]) +
                      " is pinched: its faces form several fans that touch in this point only; duplicate it, for "
                      "instance by CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices");
  }
  return result;
}

/// The same for triangles with paired halfedges.
/// \pre `pairing` is that of the faces, and has no conflict and no pinched vertex
/// \throw Input_error if a coordinate is not finite
inline Checked_triangles check_triangles(Indexed_triangles&& triangles, Halfedge_pairing&& pairing,
                                         unsigned number_of_threads = 1)
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

} // namespace CSCD

#endif // CSCD_SURFACE_TRIANGLES_H
