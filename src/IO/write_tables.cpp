// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of write_tables.h and write_correspondence.h.

#include "IO/merge_equal_points.h"
#include <CSCD/IO/internal/Skeleton_content.h>
#include <CSCD/IO/write_correspondence.h>
#include <CSCD/IO/write_tables.h>
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Tree/Tree_cylinders.h>
#include <CSCD/Tree/Tree_report.h>
#include <CSCD/Vector3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <ostream>
#include <vector>

namespace CSCD {

namespace internal {

namespace {

/// \name Fields of a table
/// Unknown numbers are empty; a vector has three fields.
/// @{
template <class Field>
void write_field(std::ostream& out, const Field& field)
{
  out << field;
}
void write_field(std::ostream& out, double number)
{
  if (!std::isnan(number)) {
    out << number;
  }
}
void write_field(std::ostream& out, const std::optional<std::size_t>& number)
{
  if (number) {
    out << *number;
  }
}
void write_field(std::ostream& out, const Vector3& v)
{
  out << v.x() << ',' << v.y() << ',' << v.z();
}
/// @}

template <class First, class... Others>
void write_row(std::ostream& out, const First& first, const Others&... others)
{
  write_field(out, first);
  ((out << ',', write_field(out, others)), ...);
  out << '\n';
}

} // namespace

std::vector<Vertex_label> label_vertices(const std::vector<Index>& node_of_vertex, const Skeleton_branches& branches)
{
  std::vector<Vertex_label> result;
  result.reserve(node_of_vertex.size());
  for (const Index node : node_of_vertex) {
    result.push_back({node, node == no_index ? no_index : branches.branch_of_node[node]});
  }
  return result;
}

std::vector<Index> vertices_of_file(const std::vector<Vector3>& points_of_file,
                                    const std::vector<Vector3>& points_of_mesh, const std::vector<char>& is_known)
{
  std::vector<Index> result(points_of_file.size());
  if (points_of_file == points_of_mesh) { // not repaired: points at the same place may be different vertices
    std::iota(result.begin(), result.end(), Index(0));
    return result;
  }
  std::vector<Vector3> places = points_of_file;
  places.insert(places.end(), points_of_mesh.begin(), points_of_mesh.end());
  std::vector<Index> place; // for the points of the file, then for those of the mesh
  merge_equal_points(places, place);
  std::vector<Index> vertex_at(places.size(), no_index);
  for (Index v = 0; v < points_of_mesh.size(); ++v) {
    Index& vertex = vertex_at[place[points_of_file.size() + v]];
    vertex = vertex != no_index && is_known[vertex] != 0 ? vertex : v;
  }
  std::transform(place.begin(), place.begin() + std::ptrdiff_t(result.size()), result.begin(),
                 [&vertex_at](Index p) { return vertex_at[p]; });
  return result;
}

std::vector<Vertex_label> labels_of_file(const std::vector<Vector3>& points_of_file,
                                         const std::vector<Vector3>& points_of_mesh,
                                         const std::vector<Vertex_label>& labels)
{
  std::vector<char> is_known;
  for (const Vertex_label& label : labels) {
    is_known.push_back(label.node != no_index ? 1 : 0);
  }
  std::vector<Vertex_label> result;
  for (const Index vertex : vertices_of_file(points_of_file, points_of_mesh, is_known)) {
    result.push_back(vertex != no_index ? labels[vertex] : Vertex_label());
  }
  return result;
}

} // namespace internal

void write_node_table(std::ostream& out, const internal::Skeleton_content& skeleton, const Skeleton_branches& branches,
                      const std::vector<Node_measures>& measures)
{
  const auto neighbors = internal::node_neighbors(skeleton);
  internal::Exact_format format(out);
  out << "node,x,y,z,degree,branch,radius,number_of_sites,inscribed_radius,section_area\n";
  for (std::size_t v = 0; v < skeleton.number_of_nodes(); ++v) {
    const Node_measures measured = measures.empty() ? Node_measures() : measures[v];
    const std::optional<std::size_t> number_of_sites =
        skeleton.number_of_vertices.empty() ? std::optional<std::size_t>() : skeleton.number_of_vertices[v];
    internal::write_row(out, v, skeleton.points[v], neighbors[v].size(), branches.branch_of_node[v],
                        skeleton.has_radii() ? skeleton.radii[v] : Skeleton_branch::unknown, number_of_sites,
                        measured.inscribed_radius, measured.section_area);
  }
  format.finish();
}

void write_branch_table(std::ostream& out, const Skeleton_branches& branches)
{
  internal::Exact_format format(out);
  out << "branch,first_node,last_node,first_end,last_end,number_of_nodes,length,chord,tortuosity,min_radius,mean_"
         "radius,max_radius,first_radius,last_radius,cone_area,cone_volume,surface_area,volume,significance,parent,"
         "order,limb\n";
  for (std::size_t i = 0; i < branches.branches.size(); ++i) {
    const Skeleton_branch& b = branches.branches[i];
    internal::write_row(out, i, b.nodes.front(), b.nodes.back(), name(b.ends[0]), name(b.ends[1]), b.nodes.size(),
                        b.length, b.chord, b.tortuosity(), b.min_radius, b.mean_radius, b.max_radius, b.end_radii[0],
                        b.end_radii[1], b.cone_area, b.cone_volume, b.surface_area, b.volume, b.significance, b.parent,
                        b.order, b.limb);
  }
  format.finish();
}

void write_cylinders(std::ostream& out, const std::vector<Tree_cylinder>& cylinders, const Tree_report& report)
{
  internal::Exact_format format(out);
  out << "radius_m,length_m,start_X,start_Y,start_Z,axis_X,axis_Y,axis_Z,parent,extension,branch,branch_order,"
         "position_in_branch,mad,SurfCov,added,UnmodRadius_m\n";
  const auto from_one = [](const std::optional<std::size_t>& index) { return index ? *index + 1 : 0; };
  for (const Tree_cylinder& c : cylinders) {
    internal::write_row(out, c.radius, c.length, c.start, c.axis, from_one(c.parent), from_one(c.extension), c.limb + 1,
                        report.branches[c.limb].order, c.position + 1, "NaN", "NaN", 0, c.radius);
  }
  format.finish();
}

void write_correspondence(std::ostream& out, const std::vector<Vertex_label>& labels)
{
  internal::Exact_format format(out);
  out << "vertex,node,branch\n";
  const auto known = [](Index index) { return index != no_index ? std::optional<std::size_t>(index) : std::nullopt; };
  for (std::size_t v = 0; v < labels.size(); ++v) {
    internal::write_row(out, v, known(labels[v].node), known(labels[v].branch));
  }
  format.finish();
}

} // namespace CSCD
