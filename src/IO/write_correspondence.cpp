// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of write_correspondence.h.

#include "write_little_endian.h"
#include <CSCD/IO/Shape_file.h>
#include <CSCD/IO/internal/Skeleton_content.h>
#include <CSCD/IO/write_correspondence.h>
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Measure/distance_to_edges.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Vector_3.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <vector>

namespace CSCD {

namespace internal {

namespace {

/// Writes the polygons, with sizes of type `Size`.
template <class Size>
void write_ply_polygons(std::ostream& out, const Shape_file& file)
{
  for (std::size_t polygon = 0; polygon < file.number_of_polygons(); ++polygon) {
    write_little_endian(out, Size(file.size_of_polygon(polygon)));
    for (std::size_t c = file.first_corner[polygon]; c < file.first_corner[polygon + 1]; ++c) {
      write_little_endian(out, std::int32_t(file.corners[c]));
    }
  }
}

} // namespace

std::vector<Vertex_label> label_vertices(const std::vector<Vector_3>& points, const std::vector<Index>& node_of_vertex,
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

std::vector<Vertex_label> labels_of_file(const std::vector<Vector_3>& points_of_file,
                                         const std::vector<Vector_3>& points_of_mesh,
                                         const std::vector<Vertex_label>& labels)
{
  return values_of_file(points_of_file, points_of_mesh, labels,
                        [](const Vertex_label& label) { return label.node != no_index; });
}

void write_labelled_ply(std::ostream& out, const Shape_file& file, const std::vector<Vertex_label>& labels)
{
  const bool has_normals = !file.normals.empty();
  bool has_large_polygons = false;
  for (std::size_t polygon = 0; polygon < file.number_of_polygons(); ++polygon) {
    has_large_polygons = has_large_polygons || file.size_of_polygon(polygon) > std::numeric_limits<std::uint8_t>::max();
  }
  Exact_format format(out);
  out << "ply\nformat binary_little_endian 1.0\ncomment node and branch count from 0; -1 is none\nelement vertex "
      << file.points.size() << "\nproperty double x\nproperty double y\nproperty double z\n"
      << (has_normals ? "property double nx\nproperty double ny\nproperty double nz\n" : "")
      << "property int node\nproperty int branch\nproperty double radius\nproperty double distance\n";
  if (file.number_of_polygons() > 0) {
    out << "element face " << file.number_of_polygons() << "\nproperty list " << (has_large_polygons ? "int" : "uchar")
        << " int vertex_indices\n";
  }
  out << "end_header\n";
  const auto write_vector = [&out](const Vector_3& vector) {
    for (const double coordinate : vector) {
      write_little_endian(out, coordinate);
    }
  };
  for (std::size_t v = 0; v < file.points.size(); ++v) {
    write_vector(file.points[v]);
    if (has_normals) {
      write_vector(file.normals[v]);
    }
    for (const Index number : {labels[v].node, labels[v].branch}) {
      write_little_endian(out, number == no_index ? std::int32_t(-1) : std::int32_t(number));
    }
    write_little_endian(out, labels[v].radius);
    write_little_endian(out, labels[v].distance);
  }
  if (has_large_polygons) {
    write_ply_polygons<std::int32_t>(out, file);
  } else {
    write_ply_polygons<std::uint8_t>(out, file);
  }
  format.finish();
}

} // namespace internal

void write_correspondence(std::ostream& out, const std::vector<Vertex_label>& labels)
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

} // namespace CSCD
