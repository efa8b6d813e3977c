// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of a skeleton that lies inside a closed mesh.

#ifndef CSCD_TEST_SUPPORT_INSIDE_COUNT_H
#define CSCD_TEST_SUPPORT_INSIDE_COUNT_H

#include "convert_shape.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <cstddef>

namespace CSCD::test {

/// The numbers of nodes and edges of a skeleton, and the numbers that are outside the body or only partly inside.
struct Inside_count
{
  std::size_t number_of_nodes = 0;
  std::size_t number_of_nodes_outside = 0;
  double length = 0;
  double length_outside = 0; ///< by samples

  double fraction_of_nodes_inside() const
  {
    return number_of_nodes == 0
               ? 1
               : 1 - static_cast<double>(number_of_nodes_outside) / static_cast<double>(number_of_nodes);
  }
  double fraction_of_length_inside() const { return length == 0 ? 1 : 1 - length_outside / length; }
};

/// The winding number of a closed surface around `p`: the sum of the solid angles of its triangles (Van Oosterom and
/// Strackee, "The solid angle of a plane triangle", 1983). Linear.
inline double winding_number(const Shape& shape, const Triple& p)
{
  double sum = 0;
  for (const Triangle& triangle : shape.triangles) {
    const Triple a = shape.points[triangle[0]] - p;
    const Triple b = shape.points[triangle[1]] - p;
    const Triple c = shape.points[triangle[2]] - p;
    const double denominator =
        norm(a) * norm(b) * norm(c) + dot(a, b) * norm(c) + dot(b, c) * norm(a) + dot(c, a) * norm(b);
    sum += 2 * std::atan2(dot(a, cross(b, c)), denominator);
  }
  return sum / (4 * boost::math::double_constants::pi);
}

/// \pre `mesh` is a closed triangle mesh
template <class Mesh, class Skeleton>
Inside_count count_inside(const Mesh& mesh, const Skeleton& skeleton)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Exact_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  const Shape shape = to_shape(mesh);
  const Exact_mesh body = to_mesh<Exact_mesh>(shape);
  const CGAL::Side_of_triangle_mesh<Exact_mesh, Kernel> side(body);
  // CGAL uses the parity of crossings: a point that an even number of sheets contain may still be inside.
  const auto is_outside = [&](const Triple& p) {
    return side(Kernel::Point_3(p[0], p[1], p[2])) == CGAL::ON_UNBOUNDED_SIDE &&
           std::fabs(winding_number(shape, p)) < 0.5;
  };
  Inside_count result;
  result.number_of_nodes = num_vertices(skeleton);
  for (std::size_t v = 0; v < result.number_of_nodes; ++v) {
    result.number_of_nodes_outside += is_outside(to_triple(skeleton[v].point)) ? 1 : 0;
  }
  const std::size_t samples_of_an_edge = 10;
  const auto range = edges(skeleton);
  for (auto e = range.first; e != range.second; ++e) {
    const Triple a = to_triple(skeleton[source(*e, skeleton)].point);
    const Triple b = to_triple(skeleton[target(*e, skeleton)].point);
    const double length_of_a_sample = norm(b - a) / static_cast<double>(samples_of_an_edge);
    result.length += norm(b - a);
    for (std::size_t i = 0; i < samples_of_an_edge; ++i) {
      const double t = (static_cast<double>(i) + 0.5) / static_cast<double>(samples_of_an_edge);
      result.length_outside += is_outside((1 - t) * a + t * b) ? length_of_a_sample : 0;
    }
  }
  return result;
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_INSIDE_COUNT_H
