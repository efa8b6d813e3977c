// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletonizes a surface that is not a mesh: a tube around a torus knot, with points by a formula and a periodic grid.
// The skeleton should be a single cycle along the knot.

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
/// A tube of radius 0.4 around a trefoil knot: a model of `SurfaceTriangulation` and of `SkeletonizationSurface`.
/// Vertex (i, j) is the j-th one on the i-th circle. The diagonals from (i, j) to (i + 1, j + 1) make two triangles of
/// each quad of the grid.
class Knot_tube : public CSCD::Triangle_halfedges
{
public:
  static constexpr Index size = 200;  // number of circles
  static constexpr Index around = 20; // vertices of each
  static constexpr double radius = 0.4;

  Knot_tube()
  {
    for (Index i = 0; i < size; ++i) {
      const double t = two_pi * i / size;
      const Vector3 normal(std::cos(3 * t) * std::cos(2 * t), std::cos(3 * t) * std::sin(2 * t), std::sin(3 * t));
      const Vector3 center = Vector3(2 * std::cos(2 * t), 2 * std::sin(2 * t), 0) + normal;
      const Vector3 tangent(-3 * std::sin(3 * t) * std::cos(2 * t) - 2 * center.y(),
                            -3 * std::sin(3 * t) * std::sin(2 * t) + 2 * center.x(), 3 * std::cos(3 * t));
      const Vector3 binormal = normal.cross(tangent).normalized();
      m_knot.push_back(center);
      for (Index j = 0; j < around; ++j) {
        const double s = two_pi * j / around;
        m_points.push_back(center + radius * (std::cos(s) * normal + std::sin(s) * binormal));
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

  const Knot_tube& triangulation() const { return *this; }
  bool is_inside(const Vector3& p) const { return distance_above(p) < 0; }
  std::optional<Vector3> middle_behind(const Vector3& p) const { return nearest_on_knot(p); }
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
  Vector3 nearest_on_knot(const Vector3& p) const
  {
    Vector3 nearest = m_knot.front();
    for (Index i = 0; i < size; ++i) {
      const Vector3 side = m_knot[(i + 1) % size] - m_knot[i];
      const double part = std::clamp((p - m_knot[i]).dot(side) / side.squaredNorm(), 0., 1.);
      const Vector3 foot = m_knot[i] + part * side;
      nearest = (p - foot).squaredNorm() < (p - nearest).squaredNorm() ? foot : nearest;
    }
    return nearest;
  }
  double distance_above(const Vector3& p) const { return (p - nearest_on_knot(p)).norm() - radius; }

  std::vector<Vector3> m_knot;
  std::vector<Vector3> m_points;
};

/// A model of `SkeletonizationTraits` with the coordinates of the surface; its vertices are named by row and column.
struct Knot_traits
{
  using Point = Vector3;
  using Input_descriptor = std::array<Index, 2>;
  using Surface = Knot_tube;

  const Surface& surface() const { return tube; }
  std::array<Input_descriptor, 1> descriptors(Index v) const { return {{{v / tube.around, v % tube.around}}}; }
  Point to_input_point(const Vector3& p) const { return p; }
  double to_input_length(double length) const { return length; }
  void describe_input(CSCD::Skeletonization_report& report) const { report.genus = 1; }

  Knot_tube tube;
};
//! [A surface of one's own]

} // namespace

int main()
try {
  const Knot_traits traits;
  CSCD::Curve_skeletonization skeletonization(traits, CSCD::Published_policies());
  skeletonization.set_maximum_number_of_sources(200);
  CSCD::Skeleton_graph<Vector3, Knot_traits::Input_descriptor> skeleton;
  const CSCD::Skeletonization_report& report = skeletonization.run(skeleton);
  double max_offset = 0;
  for (const auto node : CGAL::make_range(vertices(skeleton))) {
    const Vector3& point = skeleton[node].point;
    max_offset = std::max(max_offset, (point - *traits.tube.middle_behind(point)).norm());
  }
  std::cout << "nodes: " << report.number_of_nodes << ", cycles: " << report.betti_number
            << ", tips: " << report.number_of_tips << ", farthest from the knot: " << max_offset << '\n';
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
