// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The triangles between the points of a cloud that its neighborhoods agree on, and neighborhoods in them.

#ifndef CSCD_POINTS_POINT_COMPLEX_H
#define CSCD_POINTS_POINT_COMPLEX_H

#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/Iterator_range.h>
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

/// The neighbors of every vertex in some triangles, each once, by ascending number.
class Vertex_neighbors : public Compressed_rows<Index>
{
public:
  /// O(n) for bounded degrees.
  /// \param triangles a range of what `vertices_of` maps to three vertices
  template <class Triangles, class VerticesOf>
  Vertex_neighbors(std::size_t number_of_vertices, const Triangles& triangles, const VerticesOf& vertices_of)
      : Compressed_rows(number_of_vertices, [&](const auto& add) {
          for (const auto& triangle : triangles) {
            const std::array<Index, 3>& vertices = vertices_of(triangle);
            for (std::size_t k = 0; k < 3; ++k) {
              add(vertices[k], vertices[(k + 1) % 3]);
              add(vertices[k], vertices[(k + 2) % 3]);
            }
          }
        })
  {
    reduce_rows([](Index* first, Index* last) {
      std::sort(first, last);
      return std::unique(first, last);
    });
  }
};

} // namespace internal

/// Points joined by edges and triangles, nearly a surface: an edge may have one triangle, two, or more, and the
/// triangles around a vertex need not form one fan. Immutable. Every edge belongs to a triangle; a vertex may have
/// none.
///
/// Halfedges are numbered vertex by vertex, and for each counterclockwise around its normal.
class Point_complex
{
public:
  /// Consecutive halfedges.
  using Halfedge_range = boost::iterator_range<boost::counting_iterator<Index>>;

  Point_complex() = default;

  /// Joins `points` by `triangles`; O(n) for bounded degrees.
  /// \param points, normals the normals are of unit length
  /// \param triangles the vertices of each, counterclockwise as the normals see it; no two have the same vertices
  Point_complex(std::vector<Vector3>&& points, std::vector<Vector3>&& normals,
                const std::vector<std::array<Index, 3>>& triangles)
      : m_points(std::move(points)), m_normals(std::move(normals))
  {
    CGAL_precondition(m_points.size() == m_normals.size());
    find_neighbors(triangles);
    find_twins();
    find_faces(triangles);
    number_components();
    measure_areas();
  }

  /// \name Vertices
  /// @{

  /// The number of vertices.
  Index number_of_vertices() const { return Index(m_points.size()); }
  /// All positions.
  const std::vector<Vector3>& points() const { return m_points; }
  /// The position of `vertex`.
  const Vector3& point(Index vertex) const { return m_points[vertex]; }
  /// The normal at `vertex`, of unit length: it agrees with those of the neighbors, and points outwards.
  const Vector3& normal(Index vertex) const { return m_normals[vertex]; }
  /// The share of the surface that belongs to `vertex`: a third of its triangles, less where they overlap.
  double vertex_area(Index vertex) const { return m_areas[vertex]; }
  /// Vertices joined by edges are in one component; a vertex without edges is one by itself.
  Index number_of_components() const { return m_number_of_components; }
  /// The connected component of `vertex`.
  Index component(Index vertex) const { return m_component[vertex]; }
  /// @}

  /// \name Halfedges
  /// @{

  /// The number of halfedges.
  Index number_of_halfedges() const { return Index(m_targets.number_of_values()); }
  /// The halfedges from `vertex`, counterclockwise.
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
  /// The halfedge that represents the edge: the smaller one of the two.
  Index edge(Index halfedge) const { return std::min(halfedge, m_twins[halfedge]); }
  /// The halfedge from `origin` to `target`, `no_index` if there is none.
  Index find_halfedge(Index origin, Index target) const
  {
    const auto targets = m_targets[origin];
    const auto found = std::find(targets.begin(), targets.end(), target);
    return found == targets.end() ? no_index : m_targets.begin(origin) + Index(found - targets.begin());
  }
  /// The length of `halfedge`.
  double length(Index halfedge) const { return m_lengths[halfedge]; }
  /// 0 without edges.
  double mean_edge_length() const
  {
    const double sum = std::accumulate(m_lengths.begin(), m_lengths.end(), 0.);
    return m_lengths.empty() ? 0 : sum / double(m_lengths.size());
  }
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
    m_targets = internal::Vertex_neighbors(
        m_points.size(), triangles, [](const auto& triangle) -> auto& { return triangle; });
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

  void number_components()
  {
    internal::Disjoint_sets sets(m_points.size());
    for (Index h = 0; h < number_of_halfedges(); ++h) {
      sets.join(origin(h), target(h));
    }
    m_component = sets.numbers(m_number_of_components);
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

  std::vector<Vector3> m_points;
  std::vector<Vector3> m_normals;
  std::vector<double> m_areas;                // of every vertex
  std::vector<Index> m_component;             // of every vertex
  internal::Compressed_rows<Index> m_targets; // of every halfedge, vertex by vertex
  std::vector<Index> m_twins;                 // of every halfedge
  std::vector<double> m_lengths;              // of every halfedge
  std::vector<std::array<Index, 3>> m_faces;  // their halfedges
  Index m_number_of_components = 0;
};

namespace internal {

/// Goes from `vertex` to the neighbor that is nearest to `point`, again and again until none is nearer.
/// \param is_allowed whether to go on from its first argument to its second one
template <class Predicate>
Index descend_to_nearest(const Point_complex& complex, const Vector3& point, Index vertex, const Predicate& is_allowed)
{
  double min_distance = (complex.point(vertex) - point).squaredNorm();
  for (Index center = no_index; center != vertex;) {
    center = vertex;
    for (const Index h : complex.outgoing(center)) {
      const Index neighbor = complex.target(h);
      const double distance = (complex.point(neighbor) - point).squaredNorm();
      if (distance < min_distance && is_allowed(center, neighbor)) {
        min_distance = distance;
        vertex = neighbor;
      }
    }
  }
  return vertex;
}

} // namespace internal

/// A part with fewer of the points than this, relative to the largest part, is a fragment: noise, or the tip of a limb
/// that lost its connection.
inline constexpr double min_part_of_points = 0.02;

/// Makes the complex of the components of `complex` that are not fragments; linear.
/// \param number gets for each vertex of `complex` its number in the result, `no_index` if it was dropped
/// \pre `complex` has a triangle
inline Point_complex drop_fragments(Point_complex&& complex, std::vector<Index>& number)
{
  std::vector<std::size_t> size(complex.number_of_components(), 0);
  for (Index v = 0; v < complex.number_of_vertices(); ++v) {
    ++size[complex.component(v)];
  }
  const double min_size = min_part_of_points * double(*std::max_element(size.begin(), size.end()));
  number.assign(complex.number_of_vertices(), no_index);
  std::vector<Vector3> points;
  std::vector<Vector3> normals;
  for (Index v = 0; v < complex.number_of_vertices(); ++v) {
    if (double(size[complex.component(v)]) >= min_size && !complex.outgoing(v).empty()) {
      number[v] = Index(points.size());
      points.push_back(complex.point(v));
      normals.push_back(complex.normal(v));
    }
  }
  if (points.size() == number.size()) {
    return std::move(complex);
  }
  std::vector<std::array<Index, 3>> triangles;
  for (Index face = 0; face < complex.number_of_faces(); ++face) {
    const auto [a, b, c] = complex.face_vertices(face);
    if (number[a] != no_index) {
      triangles.push_back({number[a], number[b], number[c]});
    }
  }
  return {std::move(points), std::move(normals), triangles};
}

} // namespace CSCD

namespace CSCD::internal {

/// For every vertex of a point complex, how far it matters to the surface around it, and the vertices that matter to
/// the surface near it. These are reached over edges, through vertices whose normals look to the same side: so points
/// of another sheet that passes nearby are not among them. Const and thread safe.
class Point_neighborhoods
{
public:
  /// Collects the neighborhoods; linear, with some forty vertices in each.
  explicit Point_neighborhoods(const Point_complex& complex)
  {
    const Index n = complex.number_of_vertices();
    m_radius.reserve(n);
    for (Index vertex = 0; vertex < n; ++vertex) {
      m_radius.push_back(support * mean_edge_length(complex, vertex));
    }
    Epoch_marks is_met(n);
    m_begin.reserve(std::size_t(n) + 1);
    for (Index vertex = 0; vertex < n; ++vertex) {
      m_begin.push_back(m_neighbors.size());
      collect(complex, vertex, is_met);
    }
    m_begin.push_back(m_neighbors.size());
  }

  /// The vertices around `vertex`, itself among them: all whose radius a point may come into that is nearest to it.
  CGAL::Iterator_range<const Index*> neighbors(Index vertex) const
  {
    return {m_neighbors.data() + m_begin[vertex], m_neighbors.data() + m_begin[vertex + 1]};
  }
  /// Within this distance `vertex` matters; zero for one without edges.
  double radius(Index vertex) const { return m_radius[vertex]; }
  /// The mean length of the edges at `vertex`.
  double spacing(Index vertex) const { return m_radius[vertex] / support; }

private:
  /// The radius relative to the mean length of the edges at a vertex: some twenty-five points lie within it, and ten
  /// have much weight; with fewer, noise is seen, with more, round parts are flattened.
  static constexpr double support = 2.5;
  /// Points that are nearest to a vertex are about so far from it at most, relative to the same length.
  static constexpr double reach = 0.6;

  static double mean_edge_length(const Point_complex& complex, Index vertex)
  {
    double sum = 0;
    std::size_t number = 0;
    for (const Index h : complex.outgoing(vertex)) {
      sum += complex.length(h);
      ++number;
    }
    return number == 0 ? 0. : sum / double(number);
  }

  void collect(const Point_complex& complex, Index vertex, Epoch_marks& is_met)
  {
    const double distance = m_radius[vertex] * (1 + reach / support);
    is_met.clear();
    is_met.mark(vertex);
    m_neighbors.push_back(vertex);
    for (std::size_t i = m_begin[vertex]; i < m_neighbors.size(); ++i) {
      for (const Index h : complex.outgoing(m_neighbors[i])) {
        const Index target = complex.target(h);
        if ((complex.point(target) - complex.point(vertex)).squaredNorm() <= distance * distance &&
            complex.normal(target).dot(complex.normal(vertex)) > 0 && is_met.mark(target)) {
          m_neighbors.push_back(target);
        }
      }
    }
  }

  std::vector<double> m_radius;
  std::vector<std::size_t> m_begin;
  std::vector<Index> m_neighbors;
};

} // namespace CSCD::internal

#endif // CSCD_POINTS_POINT_COMPLEX_H
