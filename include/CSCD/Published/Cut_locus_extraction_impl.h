// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of Cut_locus_extraction.h.

#ifndef CSCD_PUBLISHED_CUT_LOCUS_EXTRACTION_IMPL_H
#define CSCD_PUBLISHED_CUT_LOCUS_EXTRACTION_IMPL_H

#include <CSCD/Points/Point_complex.h>
#include <CSCD/Points/Point_solid.h>
#include <CSCD/Published/Cotangent_elements.h>
#include <CSCD/Published/Cut_locus_extraction.h>
#include <CSCD/Published/Cut_tree.h>
#include <CSCD/Published/Heat_method.h>
#include <CSCD/Published/Intrinsic_triangulation.h>
#include <CSCD/Published/Tangent_frames.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Finds the cut locus of `sources`: the steps that surfaces and point clouds have in common.
/// \tparam Graph in the coordinates of the surface
/// \param at_vertex `at_vertex(vertex)` is a vertex of the result
/// \param for_each_crossing `for_each_crossing(halfedge, use)` calls `use(vertex)` for the vertices of the result along
///        an edge
template <class Graph, class Indicators, class AtVertex, class ForEachCrossing>
Graph extract_cut_locus_on(const Indicators& indicators, const std::vector<Index>& sources,
                           const Cut_locus_settings& settings, const AtVertex& at_vertex,
                           const ForEachCrossing& for_each_crossing)
{
  const Cut_tree cut = find_cut_tree(indicators, sources, settings);
  Graph result;
  std::vector<std::size_t> number(cut.parent.size(), 0);
  for (const Index vertex : cut.order) {
    if (cut.is_kept(vertex)) {
      number[vertex] = add_vertex(at_vertex(vertex), result);
    }
  }
  const auto add_curve = [&](Index halfedge) {
    const auto& triangulation = indicators.frames().triangulation();
    std::size_t last = number[triangulation.origin(halfedge)];
    for_each_crossing(halfedge, [&](const auto& vertex) {
      const std::size_t next = add_vertex(vertex, result);
      add_edge(last, next, result);
      last = next;
    });
    add_edge(last, number[triangulation.target(halfedge)], result);
  };
  for (const Index vertex : cut.order) {
    if (cut.is_kept(vertex) && !cut.is_root(vertex)) {
      add_curve(cut.halfedge[vertex]);
    }
  }
  for (const Index halfedge : cut.chords()) {
    add_curve(halfedge);
  }
  return result;
}

/// On the intrinsic Delaunay triangulation.
CSCD_INLINE Cut_locus_graph<Vector3, Index> extract_cut_locus_of_surface(Indexed_triangles&& triangles,
                                                                         Halfedge_pairing&& pairing,
                                                                         const std::vector<Index>& sources,
                                                                         std::vector<double>&& distances,
                                                                         const Cut_locus_settings& settings)
{
  using Graph = Cut_locus_graph<Vector3, Index>;
  using Vertex = Graph::vertex_bundled;
  const Triangulated_surface surface(std::move(triangles), std::move(pairing));
  const Intrinsic_triangulation triangulation = make_intrinsic_delaunay(surface);
  if (distances.empty()) {
    distances = distances_from_vertices(triangulation, sources);
  }
  const Tangent_frames frames(triangulation);
  const auto at_vertex = [&](Index vertex) {
    const Index corner = *std::min_element(surface.outgoing(vertex).begin(), surface.outgoing(vertex).end());
    std::array<double, 3> weights{};
    weights[corner % 3] = 1;
    return Vertex{surface.point(vertex), {Triangulated_surface::face(corner), weights}, distances[vertex]};
  };
  // Where an edge of the triangulation crosses edges of the surface.
  const auto for_each_crossing = [&](Index halfedge, const auto& use) {
    for (const auto& [h, position] : triangulation.trace(halfedge)) {
      std::array<double, 3> weights{};
      weights[h % 3] = 1 - position;
      weights[Triangulated_surface::next(h) % 3] = position;
      const Index from = surface.origin(h);
      const Index to = surface.target(h);
      use(Vertex{(1 - position) * surface.point(from) + position * surface.point(to),
                 {Triangulated_surface::face(h), weights},
                 (1 - position) * distances[from] + position * distances[to]});
    }
  };
  return extract_cut_locus_on<Graph>(Cut_locus_indicators(frames, distances), sources, settings, at_vertex,
                                     for_each_crossing);
}

/// On the complex of the points, with distances on the intrinsic Delaunay triangulation of its tufted cover.
CSCD_INLINE Point_cut_locus_graph<Vector3, Index> extract_cut_locus_of_points(const Point_cloud& cloud,
                                                                              const std::vector<std::size_t>& sources,
                                                                              std::vector<double>&& distances,
                                                                              const Cut_locus_settings& settings)
{
  using Graph = Point_cut_locus_graph<Vector3, Index>;
  const Point_complex complex = build_point_complex(cloud);
  std::vector<Index> vertices;
  for (const std::size_t number : sources) {
    vertices.push_back(cloud.input_point[number]);
    if (complex.outgoing(vertices.back()).empty()) {
      throw Input_error("the source, point " + std::to_string(number) +
                        ", lies off the surface of the others: choose another one");
    }
  }
  const Intrinsic_triangulation triangulation = make_intrinsic_delaunay(Tufted_cover(complex));
  if (distances.empty()) {
    distances = distances_from_vertices(triangulation, vertices);
  }
  const Point_frames frames(complex, Cotangent_elements(triangulation));
  const auto at_vertex = [&](Index vertex) {
    return Graph::vertex_bundled{complex.point(vertex), vertex, distances[vertex]};
  };
  return extract_cut_locus_on<Graph>(Cut_locus_indicators(frames, distances), vertices, settings, at_vertex,
                                     [](Index, const auto&) {});
}

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_CUT_LOCUS_EXTRACTION_IMPL_H
