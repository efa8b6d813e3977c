// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which node and branch each vertex or point of the input belongs to, as tables and as labelled meshes.

#ifndef CSCD_IO_WRITE_CORRESPONDENCE_H
#define CSCD_IO_WRITE_CORRESPONDENCE_H

#include <CSCD/IO/internal/Polygon_soup.h>
#include <CSCD/IO/internal/Skeleton_content.h>
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Measure/distance_to_edges.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>
#include <CSCD/input_concepts.h>

#include <CGAL/double.h>
#include <CGAL/number_utils.h>

#include <boost/endian/conversion.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range_core.hpp>
#include <boost/unordered_map.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD {

/// What a vertex or point of the input has to do with the skeleton.
struct Vertex_label
{
  Index node = no_index;                                      ///< to which it belongs; `no_index` if to none
  Index branch = no_index;                                    ///< to which that node belongs
  double radius = std::numeric_limits<double>::quiet_NaN();   ///< of the node
  double distance = std::numeric_limits<double>::quiet_NaN(); ///< to the edges at the node, in the unit of the input
};

namespace internal {

/// \param node_of_vertex `no_index` for vertices of no node
inline std::vector<Vertex_label> label_vertices(const std::vector<Vector_3>& points,
                                                const std::vector<Index>& node_of_vertex,
                                                const Indexed_skeleton& skeleton, const Skeleton_branches& branches)
{
  const std::vector<std::vector<Index>> neighbors = node_neighbors(skeleton);
  std::vector<Vertex_label> result(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    const Index node = node_of_vertex[v];
    if (node == no_index) {
      continue;
    }
    Vertex_label& label = result[v];
    label.node = node;
    label.branch = branches.branch_of_node[node];
    label.radius = skeleton.has_radii() ? skeleton.radii[node] : label.radius;
    label.distance = distance_to_edges(skeleton, neighbors, node, points[v]);
  }
  return result;
}

/// The values of the points of a file of which a mesh was made, from those of the vertices of the mesh. Repairs merge,
/// double and drop points, but never move one: a point has the value of the vertex at its place; of several, that of
/// the first one that `is_known`. Expectedly linear.
template <class Value, class Predicate>
std::vector<Value> values_of_file(const std::vector<Vector_3>& points_of_file,
                                  const std::vector<Vector_3>& points_of_mesh, const std::vector<Value>& values,
                                  Predicate is_known)
{
  if (points_of_file == points_of_mesh) {
    return values; // not repaired: points at the same place may have different values
  }
  const auto key = [](const Vector_3& point) { // without negative zeros, whose hash differs
    return std::array<double, 3>{point.x() + 0., point.y() + 0., point.z() + 0.};
  };
  boost::unordered_map<std::array<double, 3>, Value> value_at;
  value_at.reserve(points_of_mesh.size());
  for (std::size_t v = 0; v < points_of_mesh.size(); ++v) {
    Value& value = value_at[key(points_of_mesh[v])];
    value = is_known(value) ? value : values[v];
  }
  std::vector<Value> result;
  result.reserve(points_of_file.size());
  for (const Vector_3& point : points_of_file) {
    const auto found = value_at.find(key(point));
    result.push_back(found != value_at.end() ? found->second : Value());
  }
  return result;
}

inline std::vector<Vertex_label> labels_of_file(const std::vector<Vector_3>& points_of_file,
                                                const std::vector<Vector_3>& points_of_mesh,
                                                const std::vector<Vertex_label>& labels)
{
  return values_of_file(points_of_file, points_of_mesh, labels,
                        [](const Vertex_label& label) { return label.node != no_index; });
}

/// Writes a number in binary.
template <class Number>
void write_little_endian(std::ostream& out, Number number)
{
  std::array<unsigned char, sizeof(Number)> bytes{};
  boost::endian::endian_store<Number, sizeof(Number), boost::endian::order::little>(bytes.data(), number);
  out.write(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

/// Writes the polygons, with sizes of type `Size`.
template <class Size>
void write_ply_polygons(std::ostream& out, const Polygon_soup& soup)
{
  for (std::size_t polygon = 0; polygon < soup.number_of_polygons(); ++polygon) {
    write_little_endian(out, Size(soup.size_of_polygon(polygon)));
    for (std::size_t c = soup.first_corner[polygon]; c < soup.first_corner[polygon + 1]; ++c) {
      write_little_endian(out, std::int32_t(soup.corners[c]));
    }
  }
}

inline void write_labelled_ply(std::ostream& out, const Polygon_soup& soup, const std::vector<Vertex_label>& labels)
{
  const bool has_normals = !soup.normals.empty();
  bool has_large_polygons = false;
  for (std::size_t polygon = 0; polygon < soup.number_of_polygons(); ++polygon) {
    has_large_polygons = has_large_polygons || soup.size_of_polygon(polygon) > std::numeric_limits<std::uint8_t>::max();
  }
  Exact_format format(out);
  out << "ply\nformat binary_little_endian 1.0\ncomment node and branch count from 0; -1 is none\nelement vertex "
      << soup.points.size() << "\nproperty double x\nproperty double y\nproperty double z\n"
      << (has_normals ? "property double nx\nproperty double ny\nproperty double nz\n" : "")
      << "property int node\nproperty int branch\nproperty double radius\nproperty double distance\n";
  if (soup.number_of_polygons() > 0) {
    out << "element face " << soup.number_of_polygons() << "\nproperty list " << (has_large_polygons ? "int" : "uchar")
        << " int vertex_indices\n";
  }
  out << "end_header\n";
  const auto write_vector = [&out](const Vector_3& vector) {
    for (const double coordinate : vector) {
      write_little_endian(out, coordinate);
    }
  };
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    write_vector(soup.points[v]);
    if (has_normals) {
      write_vector(soup.normals[v]);
    }
    for (const Index number : {labels[v].node, labels[v].branch}) {
      write_little_endian(out, number == no_index ? std::int32_t(-1) : std::int32_t(number));
    }
    write_little_endian(out, labels[v].radius);
    write_little_endian(out, labels[v].distance);
  }
  if (has_large_polygons) {
    write_ply_polygons<std::int32_t>(out, soup);
  } else {
    write_ply_polygons<std::uint8_t>(out, soup);
  }
  format.finish();
}

/// The points of a range as vectors.
template <class PointRange>
std::vector<Vector_3> to_vectors(const PointRange& points)
{
  std::vector<Vector_3> result;
  for (const auto& p : points) {
    result.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }
  return result;
}

} // namespace internal

/// tells of every vertex of `mesh`, in their order, to which node and branch of `skeleton` it belongs.
/// Expectedly linear.
/// \tparam TriangleMesh a model of `FaceListGraph` with an internal property map for `CGAL::vertex_point_t`
/// \tparam Skeleton a model of `CurveSkeletonGraph` that holds vertices of the mesh
/// \param branches of `skeleton`, as `measure_branches()` gives them
template <class TriangleMesh, class Skeleton, std::enable_if_t<is_triangle_mesh_v<TriangleMesh>, int> = 0>
std::vector<Vertex_label> label_vertices(const TriangleMesh& mesh, const Skeleton& skeleton,
                                         const Skeleton_branches& branches)
{
  const internal::Assigned_surface surface = internal::assigned_surface(mesh, skeleton);
  return internal::label_vertices(surface.points, surface.node_of_vertex, internal::index_skeleton(skeleton), branches);
}

/// tells of every point, in their order, to which node and branch of `skeleton` it belongs. Expectedly linear.
/// \tparam PointRange a range over points with coordinates `x()`, `y()`, `z()`
/// \tparam Skeleton a model of `CurveSkeletonGraph` that holds the numbers of the points
/// \param branches of `skeleton`, as `measure_branches()` gives them
template <class PointRange, class Skeleton, std::enable_if_t<is_point_range_v<PointRange>, int> = 0>
std::vector<Vertex_label> label_vertices(const PointRange& points, const Skeleton& skeleton,
                                         const Skeleton_branches& branches)
{
  const std::vector<Vector_3> places = internal::to_vectors(points);
  std::vector<Index> node_of_point(places.size(), no_index);
  Index node = 0;
  for (const auto v : boost::make_iterator_range(vertices(skeleton))) {
    for (const std::size_t number : skeleton[v].vertices) {
      node_of_point[number] = node;
    }
    ++node;
  }
  return internal::label_vertices(places, node_of_point, internal::index_skeleton(skeleton), branches);
}

/// writes labels as CSV: a line `vertex,node,branch` for each vertex under a line of names, all counted from 0; node
/// and branch are empty for vertices of no node. Linear. \throw File_error if `out` fails
inline void write_correspondence(std::ostream& out, const std::vector<Vertex_label>& labels)
{
  internal::Exact_format format(out);
  out << "vertex,node,branch\n";
  for (std::size_t v = 0; v < labels.size(); ++v) {
    out << v << ',';
    if (labels[v].node != no_index) {
      out << labels[v].node << ',' << labels[v].branch << '\n';
    } else {
      out << ",\n";
    }
  }
  format.finish();
}

/// writes a mesh in binary PLY, its vertices with the properties `node` and `branch`, -1 for none, `radius` and
/// `distance`. Linear.
/// \tparam TriangleMesh a model of `FaceListGraph` with an internal property map for `CGAL::vertex_point_t`
/// \param labels one for each vertex
/// \pre all faces of `mesh` are triangles
/// \throw File_error if `out` fails
template <class TriangleMesh, std::enable_if_t<is_triangle_mesh_v<TriangleMesh>, int> = 0>
void write_labelled_ply(std::ostream& out, const TriangleMesh& mesh, const std::vector<Vertex_label>& labels)
{
  using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  internal::Assigned_surface surface = internal::assigned_surface(mesh, Skeleton_graph<Vector_3, Vertex>());
  internal::Polygon_soup soup;
  soup.points = std::move(surface.points);
  for (const std::array<Index, 3>& triangle : surface.triangles) {
    soup.corners.insert(soup.corners.end(), triangle.begin(), triangle.end());
    soup.end_polygon();
  }
  internal::write_labelled_ply(out, soup, labels);
}

/// writes points in binary PLY with the same properties. Linear.
/// \tparam PointRange a range over points with coordinates `x()`, `y()`, `z()`
/// \param labels one for each point
/// \throw File_error if `out` fails
template <class PointRange, std::enable_if_t<is_point_range_v<PointRange>, int> = 0>
void write_labelled_ply(std::ostream& out, const PointRange& points, const std::vector<Vertex_label>& labels)
{
  internal::Polygon_soup soup;
  soup.points = internal::to_vectors(points);
  internal::write_labelled_ply(out, soup, labels);
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_CORRESPONDENCE_H
