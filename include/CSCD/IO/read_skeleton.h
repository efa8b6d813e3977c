// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons from files, whoever wrote them.

#ifndef CSCD_IO_READ_SKELETON_H
#define CSCD_IO_READ_SKELETON_H

#include <CSCD/IO/internal/parse_json_skeleton.h>
#include <CSCD/IO/internal/parse_ply_edges.h>
#include <CSCD/IO/internal/parse_skeleton_text.h>
#include <CSCD/IO/internal/read_content.h>
#include <CSCD/IO/internal/skeleton_access.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD {

namespace internal {

/// The parsers, in the order of `skeleton_endings`.
inline constexpr std::array<Indexed_skeleton (*)(std::string_view, const std::string&), number_of_read_skeleton_endings>
    skeleton_parsers{parse_gel_graph, parse_json_skeleton, parse_obj_lines,
                     parse_ply_edges, parse_polylines,     parse_swc};

/// Makes a graph of `indexed`, nodes and edges in their order.
template <class Skeleton>
Skeleton to_skeleton_graph(const Indexed_skeleton& indexed)
{
  Skeleton result;
  std::vector<typename boost::graph_traits<Skeleton>::vertex_descriptor> nodes;
  for (std::size_t v = 0; v < indexed.number_of_nodes(); ++v) {
    nodes.push_back(add_vertex(result));
    auto& node = result[nodes.back()];
    const Vector_3& point = indexed.points[v];
    using Point = std::decay_t<decltype(node.point)>;
    using Coordinate = std::decay_t<decltype(std::declval<const Point&>().x())>;
    node.point = Point(Coordinate(point.x()), Coordinate(point.y()), Coordinate(point.z()));
    if constexpr (has_radius_v<Skeleton>) {
      node.radius = indexed.has_radii() ? indexed.radii[v] : 0;
    }
  }
  for (const auto& [source, target] : indexed.edges) {
    add_edge(nodes[source], nodes[target], result);
  }
  return result;
}

inline Indexed_skeleton parse_skeleton(std::string_view content, std::size_t ending, const std::string& filename)
{
  if (content.empty()) {
    throw File_error(filename + ": the file is empty; fetch or write it again");
  }
  return skeleton_parsers[ending](content, filename);
}

} // namespace internal

/// reads the skeleton that the file `filename` holds, in the format that its ending names:
/// - `.graph`, of GEL: lines `n x y z` and `c i j`;
/// - `.json`, as `write_json()` writes it;
/// - `.obj`: vertices and lines;
/// - `.ply`, ASCII or binary: elements `vertex` and `edge`, the latter with `vertex1` and `vertex2`;
/// - `.polylines.txt`, as CGAL's examples write it: points with equal coordinates are one node;
/// - `.swc`: a node and its parent a line; the comments `# loop i j` of `write_swc()` are edges.
///
/// Edges from a node to itself and repeated edges are left out. Nodes have no sites, and radius 0 where the file holds
/// none. What `write_skeleton()` writes is read back exactly, but for the sites; nodes and edges keep their order in
/// `.graph`, `.json` and `.ply`. Expectedly linear.
/// \tparam Skeleton a model of `CurveSkeletonGraph` whose points can be made of three coordinates
/// \param skeleton is replaced; when an exception is thrown it is as it was
/// \return whether the file holds radii
/// \throw File_error if the ending is not one of these, or the file cannot be read, is malformed or has no nodes
template <class Skeleton>
bool read_skeleton(const std::string& filename, Skeleton& skeleton)
{
  const std::size_t ending = internal::readable_skeleton_ending(filename);
  const internal::Indexed_skeleton indexed =
      internal::parse_skeleton(internal::read_content(filename), ending, filename);
  skeleton = internal::to_skeleton_graph<Skeleton>(indexed);
  return indexed.has_radii();
}

/// reads a skeleton from a stream, which for binary PLY must not translate line ends; see the function for files.
/// \param ending of the format, such as `.graph`
/// \param name what to call the stream in messages
template <class Skeleton>
bool read_skeleton(std::istream& in, const std::string& ending, const std::string& name, Skeleton& skeleton)
{
  const std::size_t number = internal::readable_skeleton_ending(ending);
  const internal::Indexed_skeleton indexed = internal::parse_skeleton(internal::read_content(in, name), number, name);
  skeleton = internal::to_skeleton_graph<Skeleton>(indexed);
  return indexed.has_radii();
}

/// checks that `read_skeleton()` knows the ending of `filename`, before anything else is done.
/// \throw File_error if not
inline void check_readable_skeleton_filename(const std::string& filename)
{
  internal::readable_skeleton_ending(filename);
}

} // namespace CSCD

#endif // CSCD_IO_READ_SKELETON_H
