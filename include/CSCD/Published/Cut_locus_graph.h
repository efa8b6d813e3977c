// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The graphs that hold a cut locus.

#ifndef CSCD_PUBLISHED_CUT_LOCUS_GRAPH_H
#define CSCD_PUBLISHED_CUT_LOCUS_GRAPH_H

#include <boost/graph/adjacency_list.hpp>

#include <array>
#include <cstddef>
#include <utility>

namespace CSCD {

/// A point of a cut locus.
/// \tparam Point the point type of the input
/// \tparam Location what identifies the place of the point in the input, see `Cut_locus_graph` and
///         `Point_cut_locus_graph`
template <class Point, class Location>
struct Cut_locus_vertex
{
  /// Position, on the surface, or near it if that is given by points.
  Point point{};
  /// The same, in terms of the input.
  Location location{};
  /// Distance from the source along the surface, in the unit of the input.
  double distance = 0;
};

/// A cut locus on a triangle mesh: a graph on the surface. Its edges are straight segments between points that are near
/// each other. A location is a face and barycentric coordinates in it, a `Face_location` as CGAL's Polygon Mesh
/// Processing has it: in the order of the source of the face's halfedge, its target, and the target of the next one.
/// \tparam FaceDescriptor the `face_descriptor` of the mesh
template <class Point, class FaceDescriptor>
using Cut_locus_graph =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS,
                          Cut_locus_vertex<Point, std::pair<FaceDescriptor, std::array<double, 3>>>>;

/// A cut locus on a point set: a graph near the surface. Its edges are straight segments between points that are near
/// each other. A location is the nearest point of the set.
/// \tparam PointDescriptor what identifies a point: its index in a `CGAL::Point_set_3`, else its number in the order of
///         iteration
template <class Point, class PointDescriptor = std::size_t>
using Point_cut_locus_graph =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Cut_locus_vertex<Point, PointDescriptor>>;

} // namespace CSCD

#endif // CSCD_PUBLISHED_CUT_LOCUS_GRAPH_H
