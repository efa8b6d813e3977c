// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a shape to a mesh or a skeleton of any type, and from a mesh back.

#ifndef CSCD_TEST_SUPPORT_CONVERT_SHAPE_H
#define CSCD_TEST_SUPPORT_CONVERT_SHAPE_H

#include "Shape.h"
#include <CSCD/Skeleton_graph.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CSCD::test {

/// The mesh of `shape`, its vertices and faces in the same order.
/// \tparam Mesh a model of `MutableFaceGraph` with an internal vertex point map
template <class Mesh>
Mesh to_mesh(const Shape& shape)
{
  using Vertex_point_map = typename boost::property_map<Mesh, CGAL::vertex_point_t>::type;
  using Point = typename boost::property_traits<Vertex_point_map>::value_type;
  std::vector<Point> points;
  for (const Triple& p : shape.points) {
    points.emplace_back(p[0], p[1], p[2]);
  }
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, shape.triangles, mesh);
  return mesh;
}

/// The vertices of `mesh` in their order.
template <class Mesh>
std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> vertices_in_order(const Mesh& mesh)
{
  const auto range = vertices(mesh);
  return {range.begin(), range.end()};
}

template <class Point>
Triple to_triple(const Point& p)
{
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

/// Points and triangles of `mesh`, which must have triangles only; known properties of a shape are not filled in.
template <class Mesh>
Shape to_shape(const Mesh& mesh)
{
  Shape shape;
  const auto point_map = get(CGAL::vertex_point, mesh);
  const auto number = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  for (const auto v : vertices(mesh)) {
    put(number, v, shape.points.size());
    shape.points.push_back(to_triple(get(point_map, v)));
  }
  for (const auto f : faces(mesh)) {
    Triangle triangle{};
    std::size_t k = 0;
    for (const auto v : vertices_around_face(halfedge(f, mesh), mesh)) {
      triangle[k++ % 3] = get(number, v);
    }
    shape.triangles.push_back(triangle);
  }
  return shape;
}

/// The edges of the triangles of `shape`.
inline std::vector<std::pair<std::size_t, std::size_t>> edges_of(const Shape& shape)
{
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (const auto& [a, b, c] : shape.triangles) {
    edges.insert({std::minmax(a, b), std::minmax(b, c), std::minmax(c, a)});
  }
  return {edges.begin(), edges.end()};
}

/// The graph with nodes at `points` and with `edges` between them.
/// \tparam Graph an adjacency list whose nodes have a member `point` and, if there are `radii`, a member `radius`
template <class Graph>
Graph to_graph(const std::vector<Triple>& points, const std::vector<std::pair<std::size_t, std::size_t>>& edges,
               const std::vector<double>& radii = {})
{
  Graph graph(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    graph[v].point = {points[v][0], points[v][1], points[v][2]};
    if constexpr (has_radius_v<Graph>) {
      graph[v].radius = radii.empty() ? 0 : radii[v];
    }
  }
  for (const auto& [a, b] : edges) {
    add_edge(a, b, graph);
  }
  return graph;
}

/// The skeleton of straight segments, with their radii; equal ends are one node.
template <class Skeleton>
Skeleton to_skeleton(const std::vector<Centreline_segment>& segments)
{
  Skeleton skeleton;
  const auto node = [&](const Triple& p, double radius) {
    for (std::size_t v = 0; v < num_vertices(skeleton); ++v) {
      if (to_triple(skeleton[v].point) == p) {
        return v;
      }
    }
    const std::size_t v = add_vertex(skeleton);
    skeleton[v].point = {p[0], p[1], p[2]};
    skeleton[v].radius = radius;
    return v;
  };
  for (const Centreline_segment& segment : segments) {
    const std::size_t source = node(segment.source, segment.source_radius);
    add_edge(source, node(segment.target, segment.target_radius), skeleton);
  }
  return skeleton;
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_CONVERT_SHAPE_H
