// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletonizes a surface that is not a mesh: a torus, with points by a formula and a periodic grid. The skeleton should
// be the circle in its middle.

#include <CSCD/Curve_skeletonization.h>
#include <CSCD/Published_policies.h>
#include <CSCD/Skeleton_graph.h>

#include <CGAL/Iterator_range.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>
#include <optional>
#include <vector>

namespace {

using boost::math::double_constants::two_pi;
using CSCD::Index;
using CSCD::Vector3;

//! [A surface of one's own]
/// A torus around the z axis: a model of `SurfaceTriangulation` and of `SkeletonizationSurface`.
/// Vertex (i, j) is the j-th one on the i-th circle. The diagonals from (i, j) to (i + 1, j + 1) make two triangles of
/// each quad of the grid.
class Torus : public CSCD::Triangle_halfedges
{
public:
  static constexpr Index size = 120;  // number of circles
  static constexpr Index around = 20; // vertices of each
  static constexpr double radius = 2; // of the circle in the middle
  static constexpr double thickness = 0.4;

  Torus()
  {
    for (Index i = 0; i < size; ++i) {
      const double t = two_pi * i / size;
      for (Index j = 0; j < around; ++j) {
        const double s = two_pi * j / around;
        const double from_axis = radius + thickness * std::cos(s);
        m_points.emplace_back(from_axis * std::cos(t), from_axis * std::sin(t), thickness * std::sin(s));
      }
    }
  }

  static Index vertex(Index i, Index j) { return i % size * around + j % around; }
  static Index number_of_vertices() { return size * around; }
  static Index number_of_faces() { return 2 * size * around; }
  static Index number_of_halfedges() { return 3 * number_of_faces(); }

  static Index origin(Index h)
  {
    constexpr Index di[] = {0, 1, 1, 0, 1, 0}; // of the sides of the two triangles of a quad
    constexpr Index dj[] = {0, 0, 1, 0, 1, 1};
    return vertex(h / 6 / around + di[h % 6], h / 6 % around + dj[h % 6]);
  }
  static Index target(Index h) { return origin(next(h)); }
  static Index twin(Index h)
  {
    constexpr Index di[] = {0, 1, 0, 0, 0, size - 1}; // from the quad of h to that of its twin
    constexpr Index dj[] = {around - 1, 0, 0, 0, 1, 0};
    constexpr Index side[] = {4, 5, 3, 2, 0, 1};
    return 6 * vertex(h / 6 / around + di[h % 6], h / 6 % around + dj[h % 6]) + side[h % 6];
  }
  static std::array<Index, 6> outgoing(Index v)
  {
    std::array<Index, 6> result{6 * v}; // side 0 of the quad of v
    for (std::size_t k = 1; k < 6; ++k) {
      result[k] = twin(previous(result[k - 1]));
    }
    return result;
  }
  const std::vector<Vector3>& points() const { return m_points; }
  double length(Index h) const { return (m_points[target(h)] - m_points[origin(h)]).norm(); }
  double vertex_area(Index v) const
  {
    double sum = 0;
    for (const Index h : outgoing(v)) {
      const Vector3& p = m_points[v];
      sum += (m_points[target(h)] - p).cross(m_points[origin(previous(h))] - p).norm() / 6;
    }
    return sum;
  }

  const Torus& triangulation() const { return *this; }
  bool is_inside(const Vector3& p) const { return distance_above(p) < 0; }
  std::optional<Vector3> middle_behind(const Vector3& p) const { return nearest_in_middle(p); }
  void crossings(const Vector3& p, const Vector3& q, std::vector<double>& distances) const
  {
    distances.clear();
    const double length = (q - p).norm();
    double last = distance_above(p);
    for (double at = 0; at < length;) {
      at = std::min(length, at + std::max(std::fabs(last), 1e-6)); // no nearer point is on the surface
      const double here = distance_above(p + at / length * (q - p));
      if ((here < 0) != (last < 0)) {
        distances.push_back(at);
      }
      last = here;
    }
  }

private:
  static Vector3 nearest_in_middle(const Vector3& p)
  {
    const double from_axis = std::hypot(p.x(), p.y());
    return from_axis > 0 ? radius / from_axis * Vector3(p.x(), p.y(), 0) : Vector3(radius, 0, 0);
  }
  static double distance_above(const Vector3& p) { return (p - nearest_in_middle(p)).norm() - thickness; }

  std::vector<Vector3> m_points;
};

/// A model of `SkeletonizationTraits` with the coordinates of the surface; its vertices are named by row and column.
struct Torus_traits
{
  using Point = Vector3;
  using Input_descriptor = std::array<Index, 2>;
  using Surface = Torus;

  const Surface& surface() const { return torus; }
  std::array<Input_descriptor, 1> descriptors(Index v) const { return {{{v / Torus::around, v % Torus::around}}}; }
  CSCD::Normalization normalization() const { return {}; }
  void describe_input(CSCD::Skeletonization_report& report) const { report.genus = 1; }

  Torus torus;
};
//! [A surface of one's own]

} // namespace

int main()
try {
  const Torus_traits traits;
  CSCD::Curve_skeletonization skeletonization(traits, CSCD::Published_policies());
  skeletonization.set_maximum_number_of_sources(200);
  CSCD::Skeleton_graph<Vector3, Torus_traits::Input_descriptor> skeleton;
  const CSCD::Skeletonization_report& report = skeletonization.run(skeleton);
  double max_offset = 0;
  for (const auto node : CGAL::make_range(vertices(skeleton))) {
    const Vector3& point = skeleton[node].point;
    max_offset = std::max(max_offset, (point - *traits.torus.middle_behind(point)).norm());
  }
  std::cout << "nodes: " << report.number_of_nodes << ", cycles: " << report.betti_number
            << ", tips: " << report.number_of_tips << ", farthest from the circle: " << max_offset << '\n';
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
