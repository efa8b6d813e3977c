// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The graphs that hold a cut locus.

#ifndef CSCD_CUT_LOCUS_CUT_LOCUS_GRAPH_H
#define CSCD_CUT_LOCUS_CUT_LOCUS_GRAPH_H

#include <boost/graph/adjacency_list.hpp>

#include <array>
#include <cstddef>
#include <utility>

namespace CSCD {

/// A point of a cut locus on a point cloud.
/// \tparam Point the point type of the cloud
/// \tparam PointDescriptor what identifies a point of the cloud: its index in a `CGAL::Point_set_3`, else its number in
///         the order of iteration
template <class Point, class PointDescriptor = std::size_t>
struct Point_cut_locus_vertex
{
  /// Position, on the surface that the cloud samples, or near it.
  Point point{};
  /// The nearest point of the cloud.
  PointDescriptor nearest{};
  /// Distance from the source along the surface, in the unit of the cloud.
  double distance = 0;
};

/// A cut locus on a point cloud: a graph near the surface. Its edges are straight segments between points that are near
/// each other.
template <class Point, class PointDescriptor = std::size_t>
using Point_cut_locus_graph =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Point_cut_locus_vertex<Point, PointDescriptor>>;

/// A point of a cut locus.
/// \tparam Point the point type of the mesh
/// \tparam FaceDescriptor the `face_descriptor` of the mesh
template <class Point, class FaceDescriptor>
struct Cut_locus_vertex
{
  /// Position, on the surface.
  Point point{};
  /// The same as a face and barycentric coordinates in it: a `Face_location` as CGAL's Polygon Mesh Processing has it,
  /// in the order of the source of the face's halfedge, its target, and the target of the next one.
  std::pair<FaceDescriptor, std::array<double, 3>> location{};
  /// Distance from the source along the surface, in the unit of the mesh.
  double distance = 0;
};

/// A cut locus: a graph on a surface. Its edges are straight segments between points that are near each other.
template <class Point, class FaceDescriptor>
using Cut_locus_graph =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Cut_locus_vertex<Point, FaceDescriptor>>;

} // namespace CSCD

#endif // CSCD_CUT_LOCUS_CUT_LOCUS_GRAPH_H
