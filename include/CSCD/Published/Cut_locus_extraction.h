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

#include <boost/graph/adjacency_list.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
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

/// A point of a face: the sum of its corners, the origins of its halfedges in order, by barycentric weights.
struct Face_point
{
  Index face = no_index;
  std::array<double, 3> weights{};
};

/// A cut locus in the coordinates of the surface. \tparam Location where on the surface a vertex is
template <class Location>
struct Extracted_cut_locus
{
  struct Vertex
  {
    Vector3 point;
    Location location;
    double distance;
  };

  std::vector<Vertex> vertices;
  std::vector<std::pair<Index, Index>> edges;
};

/// Finds the cut locus of some vertices of a surface, its loops closed; see `extract_cut_locus()`.
/// \param pairing that of the faces of `triangles`, which are a manifold, perhaps with borders
/// \param distances of all vertices; none if they are to be estimated
CSCD_INLINE Extracted_cut_locus<Face_point> extract_cut_locus_of_surface(Indexed_triangles&& triangles,
                                                                         Halfedge_pairing&& pairing,
                                                                         const std::vector<Index>& sources,
                                                                         std::vector<double>&& distances,
                                                                         const Cut_locus_settings& settings);

/// Finds the cut locus of some points of a cloud, its loops open at one place each; see `extract_cut_locus()`. The
/// location of a vertex is the nearest point of the cloud.
/// \param sources numbers of points of the input; `cloud` holds the different points
/// \param distances of all points of the cloud; none if they are to be estimated
/// \throw Input_error if the points do not sample a surface, or a source is not on it
CSCD_INLINE Extracted_cut_locus<Index> extract_cut_locus_of_points(const Point_cloud& cloud,
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

/// Writes a cut locus to a graph. \param to_input_location gives the location that the graph holds
template <class Location, class ToInputLocation, class Graph>
void write_cut_locus(const Extracted_cut_locus<Location>& cut_locus, const Normalization& normalization,
                     const ToInputLocation& to_input_location, Graph& graph)
{
  Graph result(cut_locus.vertices.size());
  for (Index i = 0; i < cut_locus.vertices.size(); ++i) {
    const auto& vertex = cut_locus.vertices[i];
    using Point = std::decay_t<decltype(result[i].point)>;
    result[i].point = internal::make_point<Point>(normalization.to_input(vertex.point));
    result[i].location = to_input_location(vertex.location);
    result[i].distance = normalization.unit * vertex.distance;
  }
  for (const auto& [a, b] : cut_locus.edges) {
    add_edge(a, b, result);
  }
  graph = std::move(result);
}

} // namespace CSCD::internal

#ifndef CSCD_COMPILED
#include <CSCD/Published/Cut_locus_extraction_impl.h>
#endif

#endif // CSCD_PUBLISHED_CUT_LOCUS_EXTRACTION_H
