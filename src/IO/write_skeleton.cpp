// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes skeletons in all formats, and tables: the definitions of write_skeleton.h, write_tables.h and
// write_correspondence.h.

#include "IO/formats.h"
#include "IO/merge_equal_points.h"
#include <CSCD/IO/internal/Skeleton_content.h>
#include <CSCD/IO/internal/json_branches.h>
#include <CSCD/IO/write_correspondence.h>
#include <CSCD/IO/write_file.h>
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/IO/write_tables.h>
#include <CSCD/Measure/Rooted_forest.h>
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Measure/split_into_branches.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Tree/Tree_cylinders.h>
#include <CSCD/Tree/Tree_report.h>
#include <CSCD/Vector3.h>

#include <boost/range/iterator_range_core.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CSCD {

namespace internal {

namespace {

/// `significance` as formats write it that cannot hold infinity: the greatest number.
double finite_significance(double significance)
{
  return std::min(significance, std::numeric_limits<double>::max());
}

/// Writes a position as `x y z`.
std::ostream& write_coordinates(std::ostream& out, const Vector3& point)
{
  return out << point.x() << ' ' << point.y() << ' ' << point.z();
}

/// The structure identifier of a node in SWC: 5 a fork, 6 an end, 0 anything else.
int swc_type(std::size_t degree)
{
  constexpr int undefined = 0;
  constexpr int fork_point = 5;
  constexpr int end_point = 6;
  return degree > 2 ? fork_point : degree == 1 ? end_point : undefined;
}

/// The thickest node if it is thick enough.
Index find_soma(const Skeleton_content& skeleton, const std::optional<double>& min_radius)
{
  const auto thickest = std::max_element(skeleton.radii.begin(), skeleton.radii.end());
  const bool is_found = min_radius && thickest != skeleton.radii.end() && *thickest >= *min_radius;
  return is_found ? Index(thickest - skeleton.radii.begin()) : no_index;
}

/// Writes an array of a PolyData, a line for each of `values` as `write(value)` has it.
template <class Values, class Write>
void write_vtp_array(std::ostream& out, const std::string& attributes, const Values& values, const Write& write)
{
  out << "<DataArray " << attributes << " format=\"ascii\">\n";
  for (const auto& value : values) {
    write(value);
    out << '\n';
  }
  out << "</DataArray>\n";
}

/// Writes the branches with the numbers from `first` to `last` as cells of a PolyData, each a sequence of nodes.
void write_vtp_cells(std::ostream& out, const char* tag, const std::vector<Skeleton_branch>& branches,
                     std::vector<std::size_t>::const_iterator first, std::vector<std::size_t>::const_iterator last)
{
  const auto numbers = boost::make_iterator_range(first, last);
  out << '<' << tag << ">\n";
  write_vtp_array(out, "type=\"Int64\" Name=\"connectivity\"", numbers, [&](std::size_t number) {
    for (const Index v : branches[number].nodes) {
      out << v << ' ';
    }
  });
  std::size_t offset = 0;
  write_vtp_array(out, "type=\"Int64\" Name=\"offsets\"", numbers,
                  [&](std::size_t number) { out << (offset += branches[number].nodes.size()); });
  out << "</" << tag << ">\n";
}

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

nlohmann::ordered_json json_branches(const std::vector<Skeleton_branch>& branches)
{
  nlohmann::ordered_json result = nlohmann::ordered_json::array();
  for (const Skeleton_branch& branch : branches) {
    nlohmann::ordered_json object{{"nodes", branch.nodes},
                                  {"ends", {name(branch.ends[0]), name(branch.ends[1])}},
                                  {"length", branch.length},
                                  {"chord", branch.chord},
                                  {"tortuosity", branch.tortuosity()},
                                  {"min_radius", branch.min_radius},
                                  {"mean_radius", branch.mean_radius},
                                  {"max_radius", branch.max_radius},
                                  {"end_radii", branch.end_radii},
                                  {"cone_area", branch.cone_area},
                                  {"cone_volume", branch.cone_volume},
                                  {"significance", branch.significance}};
    if (!std::isnan(branch.volume)) {
      object["surface_area"] = branch.surface_area;
      object["volume"] = branch.volume;
    }
    if (branch.order) {
      object["parent"] = branch.parent ? nlohmann::ordered_json(*branch.parent) : nlohmann::ordered_json();
      object["order"] = *branch.order;
    }
    if (branch.limb) {
      object["limb"] = *branch.limb;
    }
    result.push_back(std::move(object));
  }
  return result;
}

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

void write_gel_graph(std::ostream& out, const internal::Skeleton_content& skeleton)
{
  internal::Exact_format format(out);
  for (const Vector3& point : skeleton.points) {
    internal::write_coordinates(out << "n ", point) << '\n';
  }
  for (const auto& [source, target] : skeleton.edges) {
    out << "c " << source << ' ' << target << '\n';
  }
  format.finish();
}

void write_json(std::ostream& out, const internal::Skeleton_content& skeleton)
{
  const std::vector<std::vector<Index>> neighbors = internal::node_neighbors(skeleton);
  nlohmann::ordered_json document{{"nodes", nlohmann::ordered_json::array()},
                                  {"edges", nlohmann::ordered_json::array()}};
  for (std::size_t v = 0; v < skeleton.number_of_nodes(); ++v) {
    const Vector3& point = skeleton.points[v];
    nlohmann::ordered_json node{{"point", std::array<double, 3>{point.x(), point.y(), point.z()}}};
    if (skeleton.has_radius) {
      node["radius"] = skeleton.radii[v];
    }
    node["degree"] = neighbors[v].size();
    if (!skeleton.is_opening.empty() && skeleton.is_opening[v] != 0) {
      node["is_opening"] = true;
    }
    if (!skeleton.number_of_vertices.empty()) {
      node["number_of_sites"] = skeleton.number_of_vertices[v];
    }
    document["nodes"].push_back(std::move(node));
  }
  for (const auto& [source, target] : skeleton.edges) {
    document["edges"].push_back({source, target});
  }
  if (skeleton.has_radius) {
    document["branches"] = internal::json_branches(internal::measure_branches(skeleton).branches);
  }
  for (std::size_t e = 0; e < skeleton.edges.size(); ++e) {
    if (skeleton.is_joined[e] != 0) {
      document["joined_edges"].push_back(skeleton.edges[e]);
    }
  }
  internal::Exact_format format(out);
  out << document.dump() << '\n';
  format.finish();
}

void write_obj(std::ostream& out, const internal::Skeleton_content& skeleton)
{
  internal::Exact_format format(out);
  for (const Vector3& point : skeleton.points) {
    internal::write_coordinates(out << "v ", point) << '\n';
  }
  for (const std::vector<Index>& branch : internal::split_into_branches(internal::node_neighbors(skeleton))) {
    out << (branch.size() == 1 ? 'p' : 'l');
    for (const Index v : branch) {
      out << ' ' << v + 1;
    }
    out << '\n';
  }
  format.finish();
}

void write_ply(std::ostream& out, const internal::Skeleton_content& skeleton)
{
  internal::Exact_format format(out);
  out << "ply\nformat ascii 1.0\nelement vertex " << skeleton.number_of_nodes()
      << "\nproperty double x\nproperty double y\nproperty double z\n"
      << (skeleton.has_radius ? "property double radius\n" : "") << "element edge " << skeleton.edges.size()
      << "\nproperty int vertex1\nproperty int vertex2\n"
      << (skeleton.has_radius ? "property double significance\n" : "") << "end_header\n";
  for (std::size_t v = 0; v < skeleton.number_of_nodes(); ++v) {
    internal::write_coordinates(out, skeleton.points[v]);
    if (skeleton.has_radius) {
      out << ' ' << skeleton.radii[v];
    }
    out << '\n';
  }
  const std::vector<double> significances = internal::edge_significances(skeleton);
  for (std::size_t e = 0; e < skeleton.edges.size(); ++e) {
    out << skeleton.edges[e][0] << ' ' << skeleton.edges[e][1];
    if (skeleton.has_radius) {
      out << ' ' << internal::finite_significance(significances[e]);
    }
    out << '\n';
  }
  format.finish();
}

void write_polylines(std::ostream& out, const internal::Skeleton_content& skeleton)
{
  internal::Exact_format format(out);
  for (const std::vector<Index>& branch : internal::split_into_branches(internal::node_neighbors(skeleton))) {
    out << branch.size();
    for (const Index v : branch) {
      internal::write_coordinates(out << ' ', skeleton.points[v]);
    }
    out << '\n';
  }
  format.finish();
}

void write_swc(std::ostream& out, const internal::Skeleton_content& skeleton, const Swc_options& options)
{
  constexpr int soma_type = 1;
  const Index soma = internal::find_soma(skeleton, options.min_soma_radius);
  std::vector<Index> roots = options.roots;
  if (soma != no_index) {
    roots.insert(roots.begin(), soma);
  }
  const internal::Rooted_forest forest(skeleton, roots);
  const std::vector<std::vector<Index>> neighbors = internal::node_neighbors(skeleton);
  std::vector<std::size_t> id(skeleton.number_of_nodes());
  for (std::size_t i = 0; i < forest.order().size(); ++i) {
    id[forest.order()[i]] = i + 1;
  }
  internal::Exact_format format(out);
  out << "# id type x y z radius parent\n";
  for (const auto& [u, v] : forest.loops()) {
    out << "# loop " << id[u] << ' ' << id[v] << '\n';
  }
  for (const Index v : forest.order()) {
    out << id[v] << ' ' << (v == soma ? soma_type : options.type.value_or(internal::swc_type(neighbors[v].size())))
        << ' ';
    internal::write_coordinates(out, options.scale * skeleton.points[v])
        << ' ' << (skeleton.has_radius ? options.scale * skeleton.radii[v] : 0) << ' '
        << (forest.is_root(v) ? "-1" : std::to_string(id[forest.parent(v)])) << '\n';
  }
  format.finish();
}

void write_vtp(std::ostream& out, const internal::Skeleton_content& skeleton)
{
  const std::vector<Skeleton_branch> branches = internal::measure_branches(skeleton).branches;
  std::vector<std::size_t> numbers(branches.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t(0));
  const auto lines = std::stable_partition(
      numbers.begin(), numbers.end(), [&branches](std::size_t number) { return branches[number].nodes.size() == 1; });
  internal::Exact_format format(out);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\""
      << skeleton.number_of_nodes() << "\" NumberOfVerts=\"" << lines - numbers.begin() << "\" NumberOfLines=\""
      << numbers.end() - lines << "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n";
  if (skeleton.has_radius) {
    out << "<PointData Scalars=\"Radius\">\n";
    for (const char* const name : {"Radius", "MaximumInscribedSphereRadius"}) { // the second one is that of VMTK
      internal::write_vtp_array(out, std::string("type=\"Float64\" Name=\"") + name + '"', skeleton.radii,
                                [&out](double radius) { out << radius; });
    }
    if (std::find(skeleton.is_opening.begin(), skeleton.is_opening.end(), 1) != skeleton.is_opening.end()) {
      internal::write_vtp_array(out, "type=\"UInt8\" Name=\"IsOpening\"", skeleton.is_opening,
                                [&out](char is_opening) { out << int(is_opening); });
    }
    out << "</PointData>\n";
  }
  out << "<CellData Scalars=\"BranchId\">\n";
  internal::write_vtp_array(out, "type=\"Int64\" Name=\"BranchId\"", numbers,
                            [&out](std::size_t number) { out << number; });
  if (skeleton.has_radius) {
    internal::write_vtp_array(out, "type=\"Float64\" Name=\"Significance\"", numbers, [&](std::size_t number) {
      out << internal::finite_significance(branches[number].significance);
    });
  }
  out << "</CellData>\n<Points>\n";
  internal::write_vtp_array(out, "type=\"Float64\" NumberOfComponents=\"3\"", skeleton.points,
                            [&out](const Vector3& point) { internal::write_coordinates(out, point); });
  out << "</Points>\n";
  internal::write_vtp_cells(out, "Verts", branches, numbers.begin(), lines);
  internal::write_vtp_cells(out, "Lines", branches, lines, numbers.end());
  out << "</Piece>\n</PolyData>\n</VTKFile>\n";
  format.finish();
}

void write_skeleton(std::ostream& out, const std::string& filename, const internal::Skeleton_content& skeleton)
{
  internal::get_format(filename, internal::skeleton_content).write(out, skeleton);
}

void write_skeleton(const std::string& filename, const internal::Skeleton_content& skeleton)
{
  const auto& format = internal::get_format(filename, internal::skeleton_content); // before there is any file
  write_file(filename, [&](std::ostream& out) { format.write(out, skeleton); });
}

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
