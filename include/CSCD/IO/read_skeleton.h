// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons from files of any program.

#ifndef CSCD_IO_READ_SKELETON_H
#define CSCD_IO_READ_SKELETON_H

#include <CSCD/IO/Shape_file.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton/Branch_hierarchy.h>
#include <CSCD/Skeleton_graph.h>

#include <istream>
#include <string>
#include <utility>
#include <vector>

namespace CSCD {

namespace internal {

/// Whether `filename` has an ending of a format for graphs alone.
bool is_graph_filename(const std::string& filename);

/// The skeleton that was read from a file of such.
Skeleton to_skeleton(Shape_file&& shape);

/// Replaces `graph` by one of the nodes and edges of a file, in their order. \return whether there are radii
template <class Graph>
bool convert_to_skeleton(Shape_file&& shape, Graph& graph)
{
  Skeleton skeleton = to_skeleton(std::move(shape));
  const bool has_radii = skeleton.has_radii();
  if (!has_radii) {
    skeleton.radii.assign(skeleton.number_of_nodes(), 0.);
  }
  skeleton.significance = significance_levels(skeleton);
  graph = make_skeleton_graph<Graph>(skeleton, std::vector<Skeleton_descriptor<Graph>>());
  return has_radii;
}

} // namespace internal

/// reads the skeleton that the file `filename` holds, in the format that its ending names:
/// - `.graph`, of GEL: lines `n x y z` and `c i j`;
/// - `.json`, as `write_json()` writes it;
/// - `.obj`: vertices and lines;
/// - `.ply`, ASCII or binary: elements `vertex` and `edge`, the latter with `vertex1` and `vertex2`;
/// - `.polylines.txt`, as CGAL's examples write it: points with equal coordinates are one node;
/// - `.swc`: a node and its parent a line; the comments `# loop i j` of `write_swc()` are edges;
/// - `.vtp`: points and poly-lines of VTK's PolyData, and perhaps the point arrays `Radius` and `IsOpening`, of any
///   encoding; data compressed by zlib only if CSCD was built with zlib.
///
/// Edges from a node to itself and repeated edges are left out. No vertices of an input belong to the nodes, and radii
/// are 0 where the file holds none. Significances are computed; only `.json` holds `is_joined`, and only `.json` and
/// `.vtp` hold `is_opening`. The properties of nodes and edges from `write_skeleton()` are read back exactly; nodes and
/// edges keep their order in `.graph`, `.json` and `.ply`, nodes also in `.vtp`. Expectedly linear.
/// \tparam Skeleton a model of `CurveSkeletonGraph` whose points can be made of three coordinates
/// \param skeleton is replaced; when an exception is thrown it is as it was
/// \return whether the file holds radii
/// \throw File_error if the ending is not one of these, or the file cannot be read, is malformed or has no nodes
template <class Skeleton>
bool read_skeleton(const std::string& filename, Skeleton& skeleton)
{
  return internal::convert_to_skeleton(internal::read_shape(filename, internal::skeleton_content), skeleton);
}

/// reads a skeleton from a stream, which for binary PLY must not translate line ends; see the function for files.
/// \param ending of the format, such as `.graph`
/// \param name the name of the stream in messages
template <class Skeleton>
bool read_skeleton(std::istream& in, const std::string& ending, const std::string& name, Skeleton& skeleton)
{
  return internal::convert_to_skeleton(internal::read_shape(in, ending, name, internal::skeleton_content), skeleton);
}

} // namespace CSCD

#endif // CSCD_IO_READ_SKELETON_H
