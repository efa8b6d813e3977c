// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of Cut_locus_extraction.h.

#ifndef CSCD_PUBLISHED_CUT_LOCUS_EXTRACTION_IMPL_H
#define CSCD_PUBLISHED_CUT_LOCUS_EXTRACTION_IMPL_H

#include <CSCD/Points/Point_complex.h>
#include <CSCD/Points/build_point_complex.h>
#include <CSCD/Published/Cotangent_elements.h>
#include <CSCD/Published/Cut_locus_extraction.h>
#include <CSCD/Published/Cut_locus_indicators.h>
#include <CSCD/Published/Cut_locus_smoothing.h>
#include <CSCD/Published/Cut_tree.h>
#include <CSCD/Published/Edge_trace.h>
#include <CSCD/Published/Heat_method.h>
#include <CSCD/Published/Intrinsic_triangulation.h>
#include <CSCD/Published/Point_derivatives.h>
#include <CSCD/Published/Surface_walk.h>
#include <CSCD/Published/Tangent_frames.h>
#include <CSCD/Published/Tufted_cover.h>
#include <CSCD/Published/close_loops.h>

namespace CSCD::internal {

/// A triangulated surface, for `Cut_locus_extraction`: the cut locus is found on its intrinsic Delaunay triangulation.
class Surface_cut_locus_backend
{
public:
  using Triangulation = Intrinsic_triangulation<Triangulated_surface>;
  using Indicators = Cut_locus_indicators<Triangulation>;
  using Point = Face_point;
  using Location = Face_point;

  Surface_cut_locus_backend(Indexed_triangles&& triangles, Halfedge_pairing&& pairing)
      : m_surface(std::move(triangles), std::move(pairing)), m_surface_frames(m_surface), m_walk(m_surface_frames),
        m_triangulation(make_intrinsic_delaunay(m_surface))
  {
  }
  Surface_cut_locus_backend(const Surface_cut_locus_backend&) = delete;
  Surface_cut_locus_backend& operator=(const Surface_cut_locus_backend&) = delete;

  const Triangulation& triangulation() const { return m_triangulation; }
  Indicators::Basis make_basis() const { return Indicators::Basis(m_triangulation); }
  Face_point at_vertex(Index vertex) const { return m_walk.at_vertex(vertex); }
  Vector_3 position(const Face_point& at) const { return m_walk.position(at); }
  static const Face_point& location(const Face_point& at) { return at; }

  double distance(const Face_point& at, const std::vector<double>& distances) const
  {
    double sum = 0;
    for (Index k = 0; k < 3; ++k) {
      // A face between reached vertices has none at infinity.
      sum += at.weights[k] * distances[m_surface.origin(3 * at.face + k)];
    }
    return sum;
  }

  /// Calls `function(point)` for the points in which an edge of the triangulation crosses those of the surface.
  template <class Function>
  void for_each_crossing(Index halfedge, const Function& function) const
  {
    if (m_triangulation.is_input_edge(halfedge)) {
      return;
    }
    Edge_trace trace;
    m_triangulation.trace(halfedge, trace);
    for (const Edge_crossing& crossing : trace.crossings()) {
      Face_point point{Triangulated_surface::face(crossing.halfedge), {}};
      point.weights[crossing.halfedge % 3] = 1 - crossing.position;
      point.weights[Triangulated_surface::next(crossing.halfedge) % 3] = crossing.position;
      function(point);
    }
  }

  /// Calls `function(domain)` with what the points move on while they are smoothed.
  template <class Function>
  void with_smoothing_domain(const Indicators& indicators, const Function& function) const
  {
    const Cut_locus_indicators<Triangulated_surface> surface_indicators(m_surface_frames, indicators.distances());
    function(Surface_smoothing_domain(surface_indicators));
  }

private:
  Triangulated_surface m_surface;
  Tangent_frames<Triangulated_surface> m_surface_frames;
  Surface_walk m_walk;
  Triangulation m_triangulation;
};

/// The points of a cloud, for `Cut_locus_extraction`: the cut locus is found on their complex, with distances on the
/// intrinsic Delaunay triangulation of its tufted cover.
class Point_cut_locus_backend
{
public:
  using Triangulation = Intrinsic_triangulation<Tufted_cover>;
  using Indicators = Point_cut_locus_indicators;
  using Point = Cloud_point;
  using Location = Index;

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
  Cloud_point at_vertex(Index vertex) const { return {vertex, m_complex.point(vertex)}; }
  static const Vector_3& position(const Cloud_point& at) { return at.position; }
  static Index location(const Cloud_point& at) { return at.nearest; }
  static double distance(const Cloud_point& at, const std::vector<double>& distances) { return distances[at.nearest]; }

  template <class Function>
  void for_each_crossing(Index, const Function&) const
  {
  }

  template <class Function>
  void with_smoothing_domain(const Indicators& indicators, const Function& function) const
  {
    function(Point_smoothing_domain(indicators));
  }

private:
  Point_complex m_complex;
  Point_frames m_frames;
  Tufted_cover m_cover;
  Triangulation m_triangulation;
};

/// Finds the cut locus of vertices on what a backend holds: the steps that surfaces and point clouds have in common.
template <class Backend>
class Cut_locus_extraction
{
public:
  using Result = Extracted_cut_locus<typename Backend::Location>;

  /// \param backend is referred to and must outlive this object
  explicit Cut_locus_extraction(const Backend& backend) : m_backend(backend) {}

  Result operator()(const std::vector<Index>& sources, std::vector<double>&& distances,
                    const Cut_locus_settings& settings)
  {
    if (distances.empty()) {
      distances = distances_from_vertices(m_backend.triangulation(), sources);
    }
    const auto basis = m_backend.make_basis();
    const Indicators indicators(basis, distances);
    const Org_tree tree(indicators, find_loop_vertices(indicators, sources));
    collect_curves(indicators, find_cut_tree(indicators, tree, sources, settings));
    m_backend.with_smoothing_domain(indicators, [&](const auto& domain) {
      Cut_locus_smoothing<std::decay_t<decltype(domain)>> smoothing(domain);
      smoothing(m_points, m_result.edges, settings.number_of_iterations);
    });
    for (const auto& at : m_points) {
      m_result.vertices.push_back({m_backend.position(at), m_backend.location(at), m_backend.distance(at, distances)});
    }
    return std::move(m_result);
  }

private:
  using Indicators = typename Backend::Indicators;

  /// Turns vertices of the tree into points, and what joins them into curves.
  void collect_curves(const Indicators& indicators, const Cut_tree& cut)
  {
    std::vector<Index> point_of(indicators.distances().size(), no_index);
    for (const Index vertex : cut.tree().order()) {
      if (cut.is_kept(vertex)) {
        point_of[vertex] = Index(m_points.size());
        m_points.push_back(m_backend.at_vertex(vertex));
      }
    }
    const auto add_curve = [&](Index halfedge) {
      const auto& triangulation = indicators.frames().triangulation();
      Index last = point_of[triangulation.origin(halfedge)];
      m_backend.for_each_crossing(halfedge, [&](const auto& point) {
        m_result.edges.emplace_back(last, Index(m_points.size()));
        last = Index(m_points.size());
        m_points.push_back(point);
      });
      m_result.edges.emplace_back(last, point_of[triangulation.target(halfedge)]);
    };
    for (const Index vertex : cut.tree().order()) {
      if (cut.is_kept(vertex) && !cut.is_root(vertex)) {
        add_curve(cut.tree().halfedge_to_parent(vertex));
      }
    }
    for (const Index halfedge : cut.chords()) {
      add_curve(halfedge);
    }
  }

  const Backend& m_backend;
  std::vector<typename Backend::Point> m_points;
  Result m_result;
};

CSCD_INLINE Extracted_cut_locus<Face_point> extract_cut_locus_of_surface(Indexed_triangles&& triangles,
                                                                         Halfedge_pairing&& pairing,
                                                                         const std::vector<Index>& sources,
                                                                         std::vector<double>&& distances,
                                                                         const Cut_locus_settings& settings)
{
  const Surface_cut_locus_backend backend(std::move(triangles), std::move(pairing));
  return Cut_locus_extraction<Surface_cut_locus_backend>(backend)(sources, std::move(distances), settings);
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
  return Cut_locus_extraction<Point_cut_locus_backend>(backend)(vertices, std::move(distances), settings);
}

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_CUT_LOCUS_EXTRACTION_IMPL_H
