// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The computation for points; a file of its own, as the code for it takes long to compile.

#include "compute_point_skeleton.h"

#include "run_skeletonization.h"
#include "types.h"
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Traits/Point_set_traits.h>

#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range_core.hpp>

#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace cscd {

namespace {

using Numbers = std::vector<std::size_t>;
using Point_map = CGAL::Pointer_property_map<Point>::const_type;
using Traits = CSCD::Point_set_traits<Numbers, Point_map>;

/// The surface of `traits`; its first vertices are `points`, the others were inserted.
Mesh make_mesh(const std::vector<Point>& points, const Traits& traits)
{
  Mesh mesh;
  for (const Point& point : points) {
    mesh.add_vertex(point);
  }
  std::vector<Mesh::Vertex_index> vertex_of_site;
  for (Traits::Index site = 0; site < traits.number_of_sites(); ++site) {
    const auto numbers = traits.descriptors(site);
    vertex_of_site.push_back(numbers.begin() == numbers.end()
                                 ? mesh.add_vertex(traits.to_input_point(traits.point(site)))
                                 : Mesh::Vertex_index(static_cast<Mesh::size_type>(*numbers.begin())));
  }
  for (Traits::Index triangle = 0; triangle < traits.number_of_triangles(); ++triangle) {
    const std::array<Traits::Index, 3> sites = traits.triangle(triangle);
    mesh.add_face(vertex_of_site[sites[0]], vertex_of_site[sites[1]], vertex_of_site[sites[2]]);
  }
  return mesh;
}

/// The same skeleton with numbers of points as vertices of a mesh.
Skeleton convert(const CSCD::Skeleton_graph<Point, std::size_t>& skeleton)
{
  Skeleton result;
  for (const auto node : boost::make_iterator_range(vertices(skeleton))) {
    auto& converted = result[add_vertex(result)];
    converted.point = skeleton[node].point;
    converted.radius = skeleton[node].radius;
    for (std::size_t number : skeleton[node].vertices) {
      converted.vertices.emplace_back(static_cast<Mesh::size_type>(number));
    }
  }
  for (const auto edge : boost::make_iterator_range(edges(skeleton))) {
    add_edge(source(edge, skeleton), target(edge, skeleton), result);
  }
  return result;
}

} // namespace

Skeletonization_result compute_point_skeleton(Input& input, const Skeletonize_options& options,
                                              Progress_visitor& visitor)
{
  Numbers numbers(input.points.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t(0));
  const Point_map point_map = CGAL::make_property_map(std::as_const(input.points));
  const auto make_traits = [&] {
    return input.normals.empty() ? Traits(numbers, point_map)
                                 : Traits(numbers, point_map, CGAL::make_property_map(std::as_const(input.normals)));
  };
  const Traits traits = make_traits();
  CSCD::Skeleton_graph<Point, std::size_t> skeleton;
  Skeletonization_result result = run_skeletonization(traits, options, visitor, skeleton);
  result.skeleton = convert(skeleton);
  input.mesh = make_mesh(input.points, traits);
  return result;
}

} // namespace cscd
