// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The graphs that hold a cut locus, and cut loci in flat arrays, of surfaces and of point clouds.

#ifndef CSCD_PUBLISHED_CUT_LOCUS_EXTRACTION_H
#define CSCD_PUBLISHED_CUT_LOCUS_EXTRACTION_H

#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/config.h>

#include <CGAL/Iterator_range.h>

#include <boost/graph/adjacency_list.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD {

/// A point of a cut locus.
/// \tparam Point the point type of the input
/// \tparam Location identifies the place of the point in the input, see `Cut_locus_graph` and `Point_cut_locus_graph`
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
/// \tparam PointDescriptor identifies a point: its index in a `CGAL::Point_set_3`, else its number in the order of
///         iteration
template <class Point, class PointDescriptor = std::size_t>
using Point_cut_locus_graph =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Cut_locus_vertex<Point, PointDescriptor>>;

} // namespace CSCD

namespace CSCD::internal {

/// Finds the cut locus of some vertices of a surface, its loops closed, in the coordinates of that; see
/// `extract_cut_locus()`. A location is a face and the weights of the origins of its halfedges, in order.
/// \param pairing that of the faces of `triangles`, which are a manifold, perhaps with borders
/// \param distances of all vertices; none if they are to be estimated
CSCD_INLINE Cut_locus_graph<Vector3, Index> extract_cut_locus_of_surface(Indexed_triangles&& triangles,
                                                                         Halfedge_pairing&& pairing,
                                                                         const std::vector<Index>& sources,
                                                                         std::vector<double>&& distances,
                                                                         const Cut_locus_settings& settings);

/// Finds the cut locus of some points of a cloud, its loops open at one place each; see `extract_cut_locus()`. The
/// location of a vertex is the nearest point of the cloud.
/// \param sources numbers of points of the input; `cloud` holds the different points
/// \param distances of all points of the cloud; none if they are to be estimated
/// \throw Input_error if the points do not sample a surface, or a source is not on it
CSCD_INLINE Point_cut_locus_graph<Vector3, Index> extract_cut_locus_of_points(const Point_cloud& cloud,
                                                                              const std::vector<std::size_t>& sources,
                                                                              std::vector<double>&& distances,
                                                                              const Cut_locus_settings& settings);

/// A distance that was given for an element of the input. \param element what a message calls it
/// \throw Input_error if it is not a number
inline double checked_distance(double distance, const char* element, std::size_t number)
{
  if (std::isnan(distance)) {
    throw Input_error(std::string("the distance of ") + element + " " + std::to_string(number) +
                      " is not a number: use infinity where no source is connected");
  }
  return distance;
}

/// Writes a cut locus in the coordinates of a surface to a graph in those of the input.
/// \param to_input_location gives the location that the graph holds
template <class CutLocus, class ToInputLocation, class Graph>
void write_cut_locus(const CutLocus& cut_locus, const Normalization& normalization,
                     const ToInputLocation& to_input_location, Graph& graph)
{
  Graph result(num_vertices(cut_locus));
  for (const auto v : CGAL::make_range(vertices(cut_locus))) {
    using Point = std::decay_t<decltype(result[v].point)>;
    result[v] = {internal::make_point<Point>(normalization.to_input(cut_locus[v].point)),
                 to_input_location(cut_locus[v].location), normalization.unit * cut_locus[v].distance};
  }
  for (const auto edge : CGAL::make_range(edges(cut_locus))) {
    add_edge(source(edge, cut_locus), target(edge, cut_locus), result);
  }
  graph = std::move(result);
}

} // namespace CSCD::internal

#ifndef CSCD_COMPILED
#include <CSCD/Published/Cut_locus_extraction_impl.h>
#endif

#endif // CSCD_PUBLISHED_CUT_LOCUS_EXTRACTION_H
