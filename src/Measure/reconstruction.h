// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The reconstruction of a body from its skeleton: fields, and the triangulation of the surface where they are zero.

#ifndef CSCD_SRC_MEASURE_RECONSTRUCTION_H
#define CSCD_SRC_MEASURE_RECONSTRUCTION_H

#include "Measure/skeleton_tools.h"
#include <CSCD/Measure/Skeleton_measures.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/Box_tree.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/assertions.h>

#include <boost/math/constants/constants.hpp>
#include <boost/unordered_map.hpp>
#include <boost/unordered_set.hpp>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// A round cone, the convex hull of the balls around two points; a ball if it has no length.
struct Round_cone
{
  Vector3 source, direction;
  double length, source_radius, target_radius;
  double sine, cosine; ///< of the angle between the axis and the straight lines of the surface

  Round_cone(const Vector3& from, const Vector3& to, double from_radius, double to_radius)
      : source(from), direction(Vector3::Zero()), length((to - from).norm()), source_radius(from_radius),
        target_radius(to_radius), sine(length > 0 ? (from_radius - to_radius) / length : 1), cosine(0)
  {
    if (std::abs(sine) < 1) {
      direction = (to - from) / length;
      cosine = std::sqrt(1 - sine * sine);
    } else { // one ball holds the other
      source = from_radius >= to_radius ? from : to;
      source_radius = target_radius = std::max(from_radius, to_radius);
      length = sine = 0;
      cosine = 1;
    }
  }

  /// Negative inside, exact outside, and inside no greater in magnitude than the distance from the surface.
  double signed_distance(const Vector3& point) const
  {
    const Vector3 to_point = point - source;
    const double x = to_point.dot(direction);
    const double y2 = std::max(to_point.squaredNorm() - x * x, 0.);
    const double y = std::sqrt(y2);
    // Coordinate along the straight line of the surface below the point, 0 where it leaves the first ball.
    const double along = x * cosine - y * sine;
    if (along <= 0) {
      return std::sqrt(x * x + y2) - source_radius;
    }
    if (along >= length * cosine) {
      return std::sqrt((x - length) * (x - length) + y2) - target_radius;
    }
    return x * sine + y * cosine - source_radius;
  }
};

/// The signed distance from the union of round cones, the convex hulls of the balls around the two ends of each edge:
/// negative inside, exact outside, and inside no greater in magnitude than the distance from the surface.
/// Unlike a convolution it neither shortens tips nor swells junctions. A node without edges is a ball.
class Round_cone_field
{
public:
  /// \pre `skeleton` has nodes, and radii, which are positive or zero
  explicit Round_cone_field(const Skeleton& skeleton) : m_tree(skeleton, skeleton.radii)
  {
    CGAL_precondition(skeleton.has_radii());
    for (const auto& [u, v] : m_tree.segments()) {
      m_cones.emplace_back(skeleton.points[u], skeleton.points[v], skeleton.radii[u], skeleton.radii[v]);
    }
  }

  /// The signed distance of `point`; O(log n) where the cones are well spread.
  double operator()(const Vector3& point) const
  {
    double least = std::numeric_limits<double>::infinity();
    m_tree.minimize([&](const Bounding_box& box) { return bound(box, point); },
                    [&](Index i) {
                      least = std::min(least, m_cones[i].signed_distance(point));
                      return least;
                    });
    return least;
  }

private:
  /// At most the signed distance of `point` from the content of `box`: inside it, the distance from its nearest side.
  static double bound(const Bounding_box& box, const Vector3& point)
  {
    constexpr double slack = 1e-12; // far above rounding
    const double square = box.squared_distance(point);
    const double distance =
        square > 0 ? std::sqrt(square) : -std::min((point - box.min()).minCoeff(), (box.max() - point).minCoeff());
    return distance - slack * std::abs(distance);
  }

  Segment_tree m_tree;
  std::vector<Round_cone> m_cones;
};

/// The convolution of a skeleton with the inverse quartic kernel.
///
/// The surface is where F = 1 for F(p) = 2/pi times the integral of r(x)^3 / |p - x|^4 over all edges, with the radius
/// r varying linearly along each edge. An endless straight line of constant radius r thereby gives the cylinder of
/// radius r exactly, whatever r is, and the surface depends on the union of the edges only, not on how many nodes
/// divide them. The kernel is the limit of the Cauchy kernel for great widths; those that decay more slowly let distant
/// limbs swell each other. A node without edges is a ball of its radius. See A. Sherstyuk, Kernel functions in
/// convolution surfaces (The Visual Computer, 1999).
class Convolution_field
{
public:
  /// \pre `skeleton` has radii, which are positive or zero
  explicit Convolution_field(const Skeleton& skeleton)
  {
    CGAL_precondition(skeleton.has_radii());
    Disjoint_sets places(skeleton.number_of_nodes()); // of nodes that edges of length zero join
    std::vector<double> radius = skeleton.radii;      // of the ball at each node, infinite at an edge of any length
    for (const std::array<Index, 2>& edge : skeleton.edges) {
      const double length = skeleton.length(edge);
      if (length > 0) {
        const Vector3& source = skeleton.points[edge[0]];
        m_edges.push_back({source, (skeleton.points[edge[1]] - source) / length, length, skeleton.radii[edge[0]],
                           skeleton.radii[edge[1]]});
        radius[edge[0]] = radius[edge[1]] = std::numeric_limits<double>::infinity();
      } else {
        places.join(edge[0], edge[1]);
      }
    }
    for (Index v = 0; v < radius.size(); ++v) {
      radius[places.find(v)] = std::max(radius[places.find(v)], radius[v]);
    }
    for (Index v = 0; v < radius.size(); ++v) {
      if (places.find(v) == v && std::isfinite(radius[v])) {
        m_balls.push_back({skeleton.points[v], radius[v]});
      }
    }
  }

  /// F at `point`. Linear in the number of edges.
  double convolution(const Vector3& point) const
  {
    double sum = 0;
    for (const Edge& edge : m_edges) {
      sum += integral(edge, point);
    }
    sum *= boost::math::double_constants::two_div_pi;
    for (const Ball& ball : m_balls) {
      sum += value(ball, point);
    }
    return sum;
  }

  /// A function that is negative inside the surface and grows evenly across it: F^(-1/3) - 1, which for an endless line
  /// is the distance from it over its radius, less 1.
  double operator()(const Vector3& point) const
  {
    constexpr double min_convolution = 1e-30; // far from everything; keeps the result finite
    return 1 / std::cbrt(std::max(convolution(point), min_convolution)) - 1;
  }

private:
  struct Edge
  {
    Vector3 source, direction;
    double length, source_radius, target_radius;
  };
  struct Ball
  {
    Vector3 center;
    double radius;
  };

  static double value(const Ball& ball, const Vector3& point)
  {
    const double ratio = ball.radius * ball.radius / std::max((point - ball.center).squaredNorm(), min_square);
    return ratio * ratio;
  }

  /// Squared distances below this, in squared units of the skeleton's coordinates, count as this: the kernel has a
  /// pole.
  static constexpr double min_square = 1e-14;

  /// The integral of r(x)^3 / |point - x|^4 along `edge`.
  static double integral(const Edge& edge, const Vector3& point)
  {
    const Vector3 to_point = point - edge.source;
    const double foot = to_point.dot(edge.direction);
    const double x0 = -foot;
    const double x1 = edge.length - foot;
    const double square = std::max(to_point.squaredNorm() - foot * foot, 0.); // of the distance from the line
    const double gap = std::max({0., x0, -x1});                               // from the foot to the edge
    constexpr double far = 3;                                                 // in lengths of the edge
    return square + gap * gap > far * far * edge.length * edge.length ? integral_from_afar(edge, x0, square)
                                                                      : exact_integral(edge, x0, x1, square);
  }

  /// By Gauss's formula of three points, whose relative error is below 1e-4 where it is used.
  static double integral_from_afar(const Edge& edge, double x0, double square)
  {
    constexpr double offset = 0.38729833462074169; // of the outer points from the middle, in lengths: sqrt(3/20)
    const double slope = (edge.target_radius - edge.source_radius) / edge.length;
    const auto integrand = [&](double t) {
      const double x = x0 + t * edge.length;
      const double radius = edge.source_radius + slope * t * edge.length;
      const double q = x * x + square;
      return radius * radius * radius / (q * q);
    };
    return edge.length / 18 * (5 * integrand(0.5 - offset) + 8 * integrand(0.5) + 5 * integrand(0.5 + offset));
  }

  /// In closed form. Let x run along the line, 0 at the foot of the point, let h be its distance from the line,
  /// q = x^2 + h^2 and r = a + b x. Then the primitive functions of x^k / q^2 are, for k = 0 to 3, (x/q + atan(x/h)/h)
  /// / (2 h^2), -1 / (2 q), (atan(x/h)/h - x/q) / 2 and (ln q + h^2/q) / 2.
  static double exact_integral(const Edge& edge, double x0, double x1, double square)
  {
    // Closer to the line than this, in the greater distance to an end, F is great and needs no digits.
    constexpr double relative_min_square = 1e-6;
    const double h2 = std::max({square, relative_min_square * std::max(x0 * x0, x1 * x1), min_square});
    const double h = std::sqrt(h2);
    const double q0 = x0 * x0 + h2;
    const double q1 = x1 * x1 + h2;
    const double b = (edge.target_radius - edge.source_radius) / edge.length;
    const double a = edge.source_radius - b * x0;
    const double angle = std::atan2(h * edge.length, h2 + x0 * x1) / h; // atan(x1/h) - atan(x0/h), divided by h
    const double ratio = x1 / q1 - x0 / q0;
    const double reciprocal = 1 / q1 - 1 / q0;
    double sum = a * a * a * (ratio + angle) / h2 - 3 * a * a * b * reciprocal + 3 * a * b * b * (angle - ratio);
    if (b != 0) {
      sum += b * b * b * (std::log(q1 / q0) + h2 * reciprocal);
    }
    return std::max(sum / 2, 0.);
  }

  std::vector<Edge> m_edges;
  std::vector<Ball> m_balls;
};

/// Marching tetrahedra on those cubes of a lattice that the surface passes through, each cut into the six tetrahedra
/// around its main diagonal. Since neighboring cubes agree on their common faces and no lattice point counts as lying
/// on the surface, the result is a closed oriented manifold. Only cells reached from the seeds are visited, so the cost
/// is proportional to the surface, not to the space around it.
/// CGAL 5.5 offers `make_surface_mesh()` for implicit functions. Its refinement evaluates the function tens of times
/// for each face and inserts one point at a time; it takes minutes where this class takes a second.
/// \tparam Field callable with a point; negative inside, roughly linear across the surface
template <class Field>
class Isosurface_tracker
{
public:
  /// \param field is referred to
  /// \param cell_size the edge of the cubes, positive
  /// \param max_number_of_cells where tracking gives up
  Isosurface_tracker(const Field& field, double cell_size, std::size_t max_number_of_cells)
      : m_field(field), m_cell_size(cell_size), m_max_number_of_cells(max_number_of_cells)
  {
  }

  /// Follows the surfaces that the lattice line along `axis` meets first on either side of `point`.
  /// \return whether a lattice point near `point` is inside; if not, the field is too thin there for the lattice
  bool track_around(const Vector3& point, int axis)
  {
    const Cell cell = cell_of(point);
    int k = 0;
    while (k < 8 && !is_inside(corner(cell, k))) {
      ++k;
    }
    if (k == 8) {
      return false;
    }
    track_along(corner(cell, k), axis, 1);
    track_along(corner(cell, k), axis, -1);
    return true;
  }

  /// Whether there were more cells than allowed, so that the surface is not complete.
  bool is_too_large() const
  {
    constexpr std::size_t max_values_per_cell = 4; // a surface has about two; more are of lines that go on inside
    return m_visited.size() > m_max_number_of_cells || m_values.size() > max_values_per_cell * m_max_number_of_cells;
  }

  /// The surface, facing outwards.
  Indexed_triangles release()
  {
    m_triangles.first_hole_filling_face = m_triangles.faces.size();
    return std::move(m_triangles);
  }

private:
  using Cell = std::array<std::int32_t, 3>; ///< a lattice point, or the cube whose least corner it is
  using Key = std::uint64_t;

  static constexpr std::int32_t bias = 1 << 19; ///< makes coordinates positive; keys have 20 bits for each
  static Key key(const Cell& cell)
  {
    return (Key(cell[0] + bias) << 40) | (Key(cell[1] + bias) << 20) | Key(cell[2] + bias);
  }

  Cell cell_of(const Vector3& point) const
  {
    Cell cell{};
    for (int i = 0; i < 3; ++i) {
      cell[std::size_t(i)] = std::int32_t(std::floor(point[i] / m_cell_size));
    }
    return cell;
  }
  static Cell corner(const Cell& cell, int k)
  {
    return {cell[0] + (k & 1), cell[1] + (k >> 1 & 1), cell[2] + (k >> 2 & 1)};
  }
  Vector3 position(const Cell& cell) const { return m_cell_size * Vector3(cell[0], cell[1], cell[2]); }

  double value(const Cell& cell)
  {
    const auto [place, is_new] = m_values.try_emplace(key(cell), 0.);
    if (is_new) {
      place->second = m_field(position(cell));
    }
    return place->second;
  }
  bool is_inside(const Cell& cell) { return value(cell) < 0; }

  /// Goes from the lattice point `inside` along `axis` to the first cube with a point outside, and tracks from there.
  void track_along(Cell inside, int axis, int step)
  {
    // A field that is negative everywhere along the line would never end.
    for (std::size_t i = 0; i <= m_max_number_of_cells && std::abs(inside[std::size_t(axis)]) < bias - 2; ++i) {
      Cell next = inside;
      next[std::size_t(axis)] += step;
      if (!is_inside(next)) {
        track(step > 0 ? inside : next);
        return;
      }
      inside = next;
    }
  }

  /// Triangulates the cells of the part of the surface that passes through `start`.
  void track(const Cell& start)
  {
    m_stack.assign(1, start);
    while (!m_stack.empty() && !is_too_large()) {
      const Cell cell = m_stack.back();
      m_stack.pop_back();
      if (!m_visited.insert(key(cell)).second) {
        continue;
      }
      std::array<double, 8> values{};
      for (int k = 0; k < 8; ++k) {
        values[std::size_t(k)] = value(corner(cell, k));
      }
      for (const Tetrahedron& tetrahedron : tetrahedra) {
        cut(cell, values, tetrahedron);
      }
      for (int side = 0; side < 6; ++side) {
        push_neighbor(cell, side / 2, side % 2, values);
      }
    }
  }

  /// Puts the neighbor of `cell` across one of its sides on the stack if the surface passes through that side.
  void push_neighbor(const Cell& cell, int axis, int side, const std::array<double, 8>& values)
  {
    int number_inside = 0;
    for (int k = 0; k < 8; ++k) {
      number_inside += (k >> axis & 1) == side && values[std::size_t(k)] < 0 ? 1 : 0;
    }
    Cell neighbor = cell;
    neighbor[std::size_t(axis)] += side == 1 ? 1 : -1;
    if (number_inside != 0 && number_inside != 4 && std::abs(neighbor[std::size_t(axis)]) < bias - 2 &&
        m_visited.count(key(neighbor)) == 0) {
      m_stack.push_back(neighbor);
    }
  }

  /// A tetrahedron: corners of a cube, 0 to 7.
  using Tetrahedron = std::array<int, 4>;

  /// From corner 0 to corner 7 along the axes, in all orders; those in odd order are turned to have positive volume.
  static constexpr std::array<Tetrahedron, 6> tetrahedra{
      {{0, 1, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 7, 5, 1}, {0, 7, 3, 2}, {0, 7, 6, 4}}};

  /// Adds the triangle that cuts off the one corner which is inside, or the one which is outside, or the two triangles
  /// between two corners inside and two outside.
  void cut(const Cell& cell, const std::array<double, 8>& values, const Tetrahedron& corners)
  {
    // By the corners inside, as bits: the one or two that are cut off first, in an even permutation, so that the volume
    // stays positive. The triangles then face away from them.
    static constexpr std::array<const char*, 16> orders{"",     "0123", "1032", "0123", "2301", "0231", "1203", "3210",
                                                        "3210", "0312", "1320", "2301", "2301", "1032", "0123", ""};
    std::bitset<4> inside;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      inside[i] = values[std::size_t(corners[i])] < 0;
    }
    if (inside.none() || inside.all()) {
      return;
    }
    const auto vertex = [&, order = orders[inside.to_ulong()]](std::size_t from, std::size_t to) {
      const auto corner = [&](std::size_t i) { return corners[std::size_t(order[i] - '0')]; };
      return vertex_on(cell, values, corner(from), corner(to));
    };
    if (inside.count() == 2) {
      const Index p = vertex(0, 2);
      const Index q = vertex(0, 3);
      const Index r = vertex(1, 3);
      const Index s = vertex(1, 2);
      m_triangles.faces.insert(m_triangles.faces.end(), {{p, q, r}, {p, r, s}});
    } else {
      const Index p = vertex(0, 1);
      const Index q = vertex(0, 2);
      const Index r = vertex(0, 3);
      m_triangles.faces.push_back(inside.count() == 1 ? std::array<Index, 3>{p, q, r} : std::array<Index, 3>{p, r, q});
    }
  }

  /// The vertex on the lattice edge between the corners `a` and `b` of `cell`; one of them is inside.
  Index vertex_on(const Cell& cell, const std::array<double, 8>& values, int a, int b)
  {
    if (a > b) {
      std::swap(a, b); // all edges lead from a corner to one that has all its coordinates and more
    }
    const Cell source = corner(cell, a);
    const auto [place, is_new] =
        m_vertices.try_emplace(key(source) << 3 | Key(b - a), Index(m_triangles.points.size()));
    if (is_new) {
      // Kept off the lattice points by this, in lengths of the edge, so that no triangle degenerates.
      constexpr double margin = 1e-3;
      const double va = values[std::size_t(a)];
      const double vb = values[std::size_t(b)];
      const double t = std::clamp(va / (va - vb), margin, 1 - margin);
      m_triangles.points.push_back((1 - t) * position(source) + t * position(corner(cell, b)));
    }
    return place->second;
  }

  const Field& m_field;
  double m_cell_size;
  std::size_t m_max_number_of_cells;
  boost::unordered_map<Key, double> m_values;
  boost::unordered_set<Key> m_visited;
  boost::unordered_map<Key, Index> m_vertices; ///< by the lattice point where the edge begins, and its direction
  std::vector<Cell> m_stack;
  Indexed_triangles m_triangles;
};

/// A triangulated field.
struct Field_surface
{
  Indexed_triangles triangles;                    ///< closed and oriented, or empty
  double cell_size = 0;                           ///< of the lattice
  double unresolved_fraction = undefined_measure; ///< of the skeleton's length: no lattice point near it is inside
};

/// The greatest number of cells for a skeleton. A million of them and their surface take a gigabyte. The field is
/// evaluated about twice for each cell, over all edges and isolated nodes each time, which should not take minutes.
inline std::size_t max_number_of_cells(const Skeleton& skeleton)
{
  constexpr std::size_t max_cells = std::size_t(1) << 20;
  constexpr std::size_t min_cells = std::size_t(1) << 12;
  constexpr std::size_t max_cells_times_edges = std::size_t(1) << 27;
  const std::size_t number = std::max(skeleton.edges.size() + 1, skeleton.number_of_nodes());
  return std::clamp(max_cells_times_edges / number, min_cells, max_cells);
}

/// Triangulates the zero set of `field` on a lattice, seeded along `skeleton`.
/// Where that takes more cells than allowed, since radii or the skeleton are huge, the lattice is made coarser.
/// \param cell_size of the lattice, positive
template <class Field>
Field_surface triangulate_field(const Field& field, const Skeleton& skeleton, double cell_size)
{
  for (;; cell_size *= 2) {
    Isosurface_tracker<Field> tracker(field, cell_size, max_number_of_cells(skeleton));
    constexpr std::size_t max_number_of_samples = 1 << 20; // as many as cells at most
    const std::vector<Edge_sample> samples = sample_edges(skeleton, cell_size, max_number_of_samples);
    std::size_t number_unresolved = 0;
    for (const Edge_sample& sample : samples) {
      if (tracker.is_too_large()) {
        break;
      }
      const Vector3 lengths = sample.tangent.cwiseAbs();
      const auto axis = int(std::min_element(lengths.begin(), lengths.end()) - lengths.begin());
      number_unresolved += tracker.track_around(sample.point, axis) ? 0 : 1;
    }
    for (const Vector3& point : skeleton.points) { // nodes without edges, and edges shorter than a cell
      if (!tracker.is_too_large()) {
        tracker.track_around(point, 0);
      }
    }
    if (!tracker.is_too_large()) {
      const double fraction = samples.empty() ? undefined_measure : double(number_unresolved) / double(samples.size());
      return {tracker.release(), cell_size, fraction};
    }
  }
}

} // namespace CSCD::internal

#endif // CSCD_SRC_MEASURE_RECONSTRUCTION_H
