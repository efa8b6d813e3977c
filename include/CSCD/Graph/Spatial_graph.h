// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A graph with positions, as the skeletonization sees it.

#ifndef CSCD_GRAPH_SPATIAL_GRAPH_H
#define CSCD_GRAPH_SPATIAL_GRAPH_H

#include <CSCD/Points/Point_complex.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/config.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CSCD {

/// An undirected graph whose vertices have positions: neither a surface nor anything else is made of it.
///
/// Vertices at one place are one vertex; edges from a vertex to itself are left out, and all but the shortest of
/// parallel edges. Vertices are numbered in an order that depends, except for symmetries, on the positions alone. All
/// functions are const and may be called by several threads at once.
class Spatial_graph : public Halfedge_graph
{
public:
  /// An edge of the input.
  struct Edge
  {
    Index source = 0;  ///< the number of a point
    Index target = 0;  ///< the number of another one
    double length = 0; ///< how far it is along the edge, in the unit of the points
  };
  /// Makes a graph of points and edges of an input; O(n log n).
  /// \param points of the vertices, finite
  /// \param edges between them, of lengths that are finite and not negative
  /// \param radii of the parts that the vertices stand for, one for each point, or none
  /// \throw Input_error if `points` is empty or too large
  Spatial_graph(std::vector<Vector3> points, const std::vector<Edge>& edges, const std::vector<double>& radii = {});

  /// The weight of a vertex in means: on an evenly sampled surface, about twice the area that belongs to it.
  double vertex_area(Index vertex) const { return m_area[vertex]; }
  /// The graph itself, the input of the stages of the pipeline.
  const Spatial_graph& triangulation() const { return *this; }
  /// The radius of the part that the vertex stands for; 0 where none was given.
  double radius(Index vertex) const { return m_radius.empty() ? 0 : m_radius[vertex]; }
  /// Whether most edges are part of a cycle of three: if not, cycles of four edges take the place of faces, too.
  bool is_triangulated() const { return m_is_triangulated; }
  /// Whether an edge leads from `vertex` to `other`.
  bool is_adjacent(Index vertex, Index other) const
  {
    const auto targets = m_targets[vertex];
    return std::binary_search(targets.begin(), targets.end(), other);
  }
  /// For every point of the input, its vertex.
  const std::vector<Index>& vertex_of_point() const { return m_vertex_of_point; }
  /// From the coordinates of the input to those of the graph.
  const Normalization& normalization() const { return m_normalization; }
  /// The number of connected components.
  std::size_t number_of_components() const { return m_number_of_components; }
  /// The number of points at the place of another one.
  std::size_t number_of_duplicates() const { return m_vertex_of_point.size() - m_points.size(); }
  /// The number of edges that were left out.
  std::size_t number_of_unused_edges() const { return m_number_of_unused_edges; }

private:
  void join(const std::vector<Edge>& edges);
  void measure();

  std::vector<double> m_radius;
  std::vector<double> m_area;
  std::vector<Index> m_vertex_of_point;
  Normalization m_normalization;
  bool m_is_triangulated = false;
  std::size_t m_number_of_components = 0;
  std::size_t m_number_of_unused_edges = 0;
};

/// The number of neighbors that points are joined to by default: with fewer, the gaps of random samplings become
/// cycles.
inline constexpr Index default_number_of_neighbors = 24;

/// The edges from each of `points` to the `number_of_neighbors` nearest others, each once, with their lengths;
/// O(n log n) in expectation.
std::vector<Spatial_graph::Edge> neighbor_edges(const std::vector<Vector3>& points,
                                                Index number_of_neighbors = default_number_of_neighbors);

} // namespace CSCD

#ifndef CSCD_COMPILED
#include <CSCD/Graph/Spatial_graph_impl.h>
#endif

#endif // CSCD_GRAPH_SPATIAL_GRAPH_H
