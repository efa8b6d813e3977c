// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The graph that holds a cut locus on a point cloud.

#ifndef CSCD_CUT_LOCUS_POINT_CUT_LOCUS_GRAPH_H
#define CSCD_CUT_LOCUS_POINT_CUT_LOCUS_GRAPH_H

#include <boost/graph/adjacency_list.hpp>

#include <cstddef>

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

} // namespace CSCD

#endif // CSCD_CUT_LOCUS_POINT_CUT_LOCUS_GRAPH_H
