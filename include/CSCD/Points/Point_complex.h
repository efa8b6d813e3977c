// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The triangles between the points of a cloud that its neighborhoods agree on.

#ifndef CSCD_POINTS_POINT_COMPLEX_H
#define CSCD_POINTS_POINT_COMPLEX_H

#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/assertions.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/math/constants/constants.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CSCD {

namespace internal {

/// The angle in (-pi, pi] that turns `x` to `y` around `normal`, seen along it.
inline double angle_around(const Vector3& normal, const Vector3& x, const Vector3& y)
{
  return std::atan2(normal.dot(x.cross(y)), x.dot(y) - normal.dot(x) * normal.dot(y));
}

/// The neighbors of every vertex in some triangles, each once, by ascending number. O(n) for bounded degrees.
/// \tparam Triangle an array of three vertices
template <class Triangle>
Compressed_rows<Index> vertex_neighbors(std::size_t number_of_vertices, const std::vector<Triangle>& triangles)
{
  Compressed_rows<Index> result(number_of_vertices, [&](const auto& add) {
    for (const Triangle& triangle : triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        add(triangle[k], triangle[(k + 1) % 3]);
        add(triangle[k], triangle[(k + 2) % 3]);
      }
    }
  });
  result.reduce_rows([](Index* first, Index* last) {
    std::sort(first, last);
    return std::unique(first, last);
  });
  return result;
}

} // namespace internal

/// Points joined by edges. Halfedges are numbered vertex by vertex. Derived classes make the edges.
class Halfedge_graph
{
public:
  /// Consecutive halfedges.
  using Halfedge_range = boost::iterator_range<boost::counting_iterator<Index>>;

  /// \name Vertices
  /// @{

  /// The number of vertices.
  Index number_of_vertices() const { return Index(m_points.size()); }
  /// All positions.
  const std::vector<Vector3>& points() const { return m_points; }
  /// The position of `vertex`.
  const Vector3& point(Index vertex) const { return m_points[vertex]; }
  /// @}

  /// \name Halfedges
  /// @{

  /// The number of halfedges, two for each edge.
  Index number_of_halfedges() const { return Index(m_targets.number_of_values()); }
  /// The halfedges from `vertex`.
  Halfedge_range outgoing(Index vertex) const
  {
    return {boost::counting_iterator<Index>(m_targets.begin(vertex)),
            boost::counting_iterator<Index>(m_targets.begin(vertex + 1))};
  }
  /// The vertex where `halfedge` starts.
  Index origin(Index halfedge) const { return target(m_twins[halfedge]); }
  /// The vertex at which `halfedge` ends.
  Index target(Index halfedge) const { return m_targets.values()[halfedge]; }
  /// The halfedge from the target of `halfedge` to its origin.
  Index twin(Index halfedge) const { return m_twins[halfedge]; }
  /// The length of `halfedge`.
  double length(Index halfedge) const { return m_lengths[halfedge]; }
  /// @}

protected:
  std::vector<Vector3> m_points;              ///< of every vertex
  internal::Compressed_rows<Index> m_targets; ///< of every halfedge, vertex by vertex
  std::vector<Index> m_twins;                 ///< of every halfedge
  std::vector<double> m_lengths;              ///< of every halfedge
};

/// Points joined by edges and triangles, nearly a surface: an edge may have one triangle, two, or more, and the
/// triangles around a vertex need not form one fan. Immutable. Every edge belongs to a triangle; a vertex may have
/// none. The halfedges of each vertex run counterclockwise around its normal.
class Point_complex : public Halfedge_graph
{
public:
  Point_complex() = default;

  /// Joins `points` by `triangles`; O(n) for bounded degrees.
  /// \param points, normals the normals are of unit length
  /// \param triangles the vertices of each, counterclockwise as the normals see it; no two have the same vertices
  Point_complex(std::vector<Vector3>&& points, std::vector<Vector3>&& normals,
                const std::vector<std::array<Index, 3>>& triangles)
      : m_normals(std::move(normals))
  {
    m_points = std::move(points);
    CGAL_precondition(m_points.size() == m_normals.size());
    find_neighbors(triangles);
    find_twins();
    find_faces(triangles);
    m_component = internal::sets_of_vertices(triangles, m_points.size()).numbers(m_number_of_components);
    measure_areas();
  }

  /// \name Vertices and halfedges
  /// @{

  /// The normal at `vertex`, of unit length: it agrees with those of the neighbors, and points outwards.
  const Vector3& normal(Index vertex) const { return m_normals[vertex]; }
  /// The share of the surface that belongs to `vertex`: a third of its triangles, less where they overlap.
  double vertex_area(Index vertex) const { return m_areas[vertex]; }
  /// Vertices joined by edges are in one component; a vertex without edges is one by itself.
  Index number_of_components() const { return m_number_of_components; }
  /// The connected component of `vertex`.
  Index component(Index vertex) const { return m_component[vertex]; }
  /// The halfedge that represents the edge: the smaller one of the two.
  Index edge(Index halfedge) const { return std::min(halfedge, m_twins[halfedge]); }
  /// The halfedge from `origin` to `target`, `no_index` if there is none.
  Index find_halfedge(Index origin, Index target) const
  {
    const auto targets = m_targets[origin];
    const auto found = std::find(targets.begin(), targets.end(), target);
    return found == targets.end() ? no_index : m_targets.begin(origin) + Index(found - targets.begin());
  }
  /// 0 without edges.
  double mean_edge_length() const { return m_mean_edge_length; }
  /// @}

  /// \name Triangles
  /// @{

  /// The number of faces.
  Index number_of_faces() const { return Index(m_faces.size()); }
  /// The halfedges around face `face`, counterclockwise seen from outside: from its first vertex to the second, from
  /// there to the third, and back.
  const std::array<Index, 3>& face_halfedges(Index face) const { return m_faces[face]; }
  /// The vertices where the halfedges of the face start.
  std::array<Index, 3> face_vertices(Index face) const
  {
    const auto [a, b, c] = m_faces[face];
    return {origin(a), origin(b), origin(c)};
  }
  /// @}

private:
  void find_neighbors(const std::vector<std::array<Index, 3>>& triangles)
  {
    m_targets = internal::vertex_neighbors(m_points.size(), triangles);
    m_lengths.reserve(m_targets.number_of_values());
    std::vector<std::pair<double, Index>> around;
    for (Index v = 0; v < number_of_vertices(); ++v) {
      around.clear();
      const auto targets = m_targets[v];
      for (const Index& neighbor : targets) {
        around.emplace_back(&neighbor == targets.begin() ? 0. : angle(v, *targets.begin(), neighbor), neighbor);
      }
      std::sort(around.begin(), around.end());
      for (std::size_t i = 0; i < around.size(); ++i) {
        const Index neighbor = around[i].second;
        targets.begin()[i] = neighbor;
        m_lengths.push_back((m_points[neighbor] - m_points[v]).norm());
      }
    }
    const double sum = std::accumulate(m_lengths.begin(), m_lengths.end(), 0.);
    m_mean_edge_length = m_lengths.empty() ? 0 : sum / double(m_lengths.size());
  }

  /// The angle in [0, 2 pi) that turns the direction to `from` to that to `to`, around the normal of `center`.
  double angle(Index center, Index from, Index to) const
  {
    const Vector3& point = m_points[center];
    const double result = internal::angle_around(m_normals[center], m_points[from] - point, m_points[to] - point);
    return result < 0 ? result + boost::math::double_constants::two_pi : result;
  }

  void find_twins()
  {
    m_twins.resize(number_of_halfedges());
    for (Index v = 0; v < number_of_vertices(); ++v) {
      for (const Index h : outgoing(v)) {
        m_twins[h] = find_halfedge(target(h), v);
      }
    }
  }

  void find_faces(const std::vector<std::array<Index, 3>>& triangles)
  {
    m_faces.reserve(triangles.size());
    for (const auto& [a, b, c] : triangles) {
      m_faces.push_back({find_halfedge(a, b), find_halfedge(b, c), find_halfedge(c, a)});
    }
  }

  /// Where the corners of triangles at a vertex, seen along its normal, add up to more than a full turn, they overlap
  /// by as much.
  void measure_areas()
  {
    using boost::math::double_constants::two_pi;
    m_areas.assign(m_points.size(), 0);
    std::vector<double> turns(m_points.size(), 0);
    for (Index face = 0; face < number_of_faces(); ++face) {
      const std::array<Index, 3> vertices = face_vertices(face);
      const double area = internal::triangle_area(m_points[vertices[0]], m_points[vertices[1]], m_points[vertices[2]]);
      for (std::size_t k = 0; k < 3; ++k) {
        const double turn = angle(vertices[k], vertices[(k + 1) % 3], vertices[(k + 2) % 3]);
        m_areas[vertices[k]] += area / 3;
        turns[vertices[k]] += std::min(turn, two_pi - turn);
      }
    }
    for (Index v = 0; v < number_of_vertices(); ++v) {
      m_areas[v] *= turns[v] > two_pi ? two_pi / turns[v] : 1.;
    }
  }

  std::vector<Vector3> m_normals;            // of every vertex
  std::vector<double> m_areas;               // of every vertex
  std::vector<Index> m_component;            // of every vertex
  std::vector<std::array<Index, 3>> m_faces; // their halfedges
  double m_mean_edge_length = 0;
  Index m_number_of_components = 0;
};

/// A part with fewer of the points than this, relative to the largest part, is a fragment: noise, or the tip of a limb
/// that lost its connection.
inline constexpr double min_part_of_points = 0.02;

/// Makes the complex of the components of `complex` that are not fragments; linear.
/// \param number gets for each vertex of `complex` its number in the result, `no_index` if it was dropped
/// \pre `complex` has a triangle
inline Point_complex drop_fragments(const Point_complex& complex, std::vector<Index>& number)
{
  std::vector<std::size_t> size(complex.number_of_components(), 0);
  for (Index v = 0; v < complex.number_of_vertices(); ++v) {
    ++size[complex.component(v)];
  }
  const double min_size = min_part_of_points * double(*std::max_element(size.begin(), size.end()));
  std::vector<std::array<Index, 3>> triangles;
  for (Index face = 0; face < complex.number_of_faces(); ++face) {
    const std::array<Index, 3> vertices = complex.face_vertices(face);
    if (double(size[complex.component(vertices[0])]) >= min_size) {
      triangles.push_back(vertices);
    }
  }
  number.assign(complex.number_of_vertices(), no_index);
  std::vector<Vector3> points;
  std::vector<Vector3> normals;
  for (const Index v : compact_numbers(triangles, number.size())) {
    number[v] = Index(points.size());
    points.push_back(complex.point(v));
    normals.push_back(complex.normal(v));
  }
  return {std::move(points), std::move(normals), triangles};
}

} // namespace CSCD

#endif // CSCD_POINTS_POINT_COMPLEX_H
