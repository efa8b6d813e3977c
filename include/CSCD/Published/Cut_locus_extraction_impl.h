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
#include <CSCD/Published/Cut_locus_indicators.h>
#include <CSCD/Published/Cut_tree.h>
#include <CSCD/Published/Heat_method.h>
#include <CSCD/Published/Intrinsic_triangulation.h>
#include <CSCD/Published/Tangent_frames.h>
#include <CSCD/Surface/Triangulated_surface.h>

#include <algorithm>

namespace CSCD::internal {

/// A triangulated surface, for `extract_cut_locus_on()`: the cut locus is found on its intrinsic Delaunay
/// triangulation.
class Surface_cut_locus_backend
{
public:
  using Triangulation = Intrinsic_triangulation<Triangulated_surface>;
  using Indicators = Cut_locus_indicators<Triangulation>;
  using Result = Extracted_cut_locus<Face_point>;

  Surface_cut_locus_backend(Indexed_triangles&& triangles, Halfedge_pairing&& pairing)
      : m_surface(std::move(triangles), std::move(pairing)), m_triangulation(make_intrinsic_delaunay(m_surface)),
        m_corner(m_surface.number_of_vertices(), no_index)
  {
    for (Index h = 0; h < m_surface.number_of_halfedges(); ++h) {
      m_corner[m_surface.origin(h)] = std::min(m_corner[m_surface.origin(h)], h);
    }
  }
  Surface_cut_locus_backend(const Surface_cut_locus_backend&) = delete;
  Surface_cut_locus_backend& operator=(const Surface_cut_locus_backend&) = delete;

  const Triangulation& triangulation() const { return m_triangulation; }
  Indicators::Basis make_basis() const { return Indicators::Basis(m_triangulation); }

  Result::Vertex at_vertex(Index vertex, const std::vector<double>& distances) const
  {
    Face_point location{Triangulated_surface::face(m_corner[vertex]), {}};
    location.weights[m_corner[vertex] % 3] = 1;
    return {m_surface.point(vertex), location, distances[vertex]};
  }

  /// Calls `function(vertex)` for the points where an edge of the triangulation crosses edges of the surface.
  template <class Function>
  void for_each_crossing(Index halfedge, const std::vector<double>& distances, const Function& function) const
  {
    Edge_trace trace;
    m_triangulation.trace(halfedge, trace);
    for (const auto& [h, position] : trace.crossings()) {
      Face_point location{Triangulated_surface::face(h), {}};
      location.weights[h % 3] = 1 - position;
      location.weights[Triangulated_surface::next(h) % 3] = position;
      const Index from = m_surface.origin(h);
      const Index to = m_surface.target(h);
      function(typename Result::Vertex{(1 - position) * m_surface.point(from) + position * m_surface.point(to),
                                       location, (1 - position) * distances[from] + position * distances[to]});
    }
  }

private:
  Triangulated_surface m_surface;
  Triangulation m_triangulation;
  std::vector<Index> m_corner; // of every vertex, its first halfedge
};

/// The points of a cloud, for `extract_cut_locus_on()`: the cut locus is found on their complex, with distances on the
/// intrinsic Delaunay triangulation of its tufted cover.
class Point_cut_locus_backend
{
public:
  using Triangulation = Intrinsic_triangulation<Tufted_cover>;
  using Indicators = Point_cut_locus_indicators;
  using Result = Extracted_cut_locus<Index>;

  explicit Point_cut_locus_backend(const Point_cloud& cloud)
      : m_complex(build_point_complex(cloud)), m_frames(m_complex), m_cover(m_complex),
        m_triangulation(make_intrinsic_delaunay(m_cover))
  {
  }
  Point_cut_locus_backend(const Point_cut_locus_backend&) = delete;
  Point_cut_locus_backend& operator=(const Point_cut_locus_backend&) = delete;

  const Point_complex& complex() const { return m_complex; }
  const Triangulation& triangulation() const { return m_triangulation; }
  Indicators::Basis make_basis() const { return Indicators::Basis(m_frames, Cotangent_elements(m_triangulation)); }
  Result::Vertex at_vertex(Index vertex, const std::vector<double>& distances) const
  {
    return {m_complex.point(vertex), vertex, distances[vertex]};
  }
  template <class Function>
  void for_each_crossing(Index, const std::vector<double>&, const Function&) const
  {
  }

private:
  Point_complex m_complex;
  Point_frames m_frames;
  Tufted_cover m_cover;
  Triangulation m_triangulation;
};

/// Finds the cut locus of `sources` on what `backend` holds: the steps that surfaces and point clouds have in common.
template <class Backend>
typename Backend::Result extract_cut_locus_on(const Backend& backend, const std::vector<Index>& sources,
                                              std::vector<double>&& distances, const Cut_locus_settings& settings)
{
  if (distances.empty()) {
    distances = distances_from_vertices(backend.triangulation(), sources);
  }
  const auto basis = backend.make_basis();
  const typename Backend::Indicators indicators(basis, distances);
  const Org_tree tree(indicators, find_loop_vertices(indicators, sources));
  const Cut_tree cut = find_cut_tree(indicators, tree, sources, settings);
  typename Backend::Result result;
  std::vector<Index> number(distances.size(), no_index);
  for (const Index vertex : tree.order()) {
    if (cut.is_kept(vertex)) {
      number[vertex] = Index(result.vertices.size());
      result.vertices.push_back(backend.at_vertex(vertex, distances));
    }
  }
  const auto add_curve = [&](Index halfedge) {
    const auto& triangulation = indicators.frames().triangulation();
    Index last = number[triangulation.origin(halfedge)];
    backend.for_each_crossing(halfedge, distances, [&](const auto& vertex) {
      result.edges.emplace_back(last, Index(result.vertices.size()));
      last = Index(result.vertices.size());
      result.vertices.push_back(vertex);
    });
    result.edges.emplace_back(last, number[triangulation.target(halfedge)]);
  };
  for (const Index vertex : tree.order()) {
    if (cut.is_kept(vertex) && !cut.is_root(vertex)) {
      add_curve(tree.halfedge_to_parent(vertex));
    }
  }
  for (const Index halfedge : cut.chords()) {
    add_curve(halfedge);
  }
  return result;
}

CSCD_INLINE Extracted_cut_locus<Face_point> extract_cut_locus_of_surface(Indexed_triangles&& triangles,
                                                                         Halfedge_pairing&& pairing,
                                                                         const std::vector<Index>& sources,
                                                                         std::vector<double>&& distances,
                                                                         const Cut_locus_settings& settings)
{
  const Surface_cut_locus_backend backend(std::move(triangles), std::move(pairing));
  return extract_cut_locus_on(backend, sources, std::move(distances), settings);
}

CSCD_INLINE Extracted_cut_locus<Index> extract_cut_locus_of_points(const Point_cloud& cloud,
                                                                   const std::vector<std::size_t>& sources,
                                                                   std::vector<double>&& distances,
                                                                   const Cut_locus_settings& settings)
{
  const Point_cut_locus_backend backend(cloud);
  std::vector<Index> vertices;
  for (const std::size_t number : sources) {
    vertices.push_back(cloud.input_point[number]);
    if (backend.complex().outgoing(vertices.back()).empty()) {
      throw Input_error("the source, point " + std::to_string(number) +
                        ", lies off the surface of the others: choose another one");
    }
  }
  return extract_cut_locus_on(backend, vertices, std::move(distances), settings);
}

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_CUT_LOCUS_EXTRACTION_IMPL_H
