// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The results for small inputs are those of the table results.txt next to this file: the contents of the files of the
// fuzz corpora, and the skeletons of their soups and of generated shapes, as meshes, points and graphs.
//
// Where a change is wanted, this command writes the table anew, and the difference shows what changed:
//   CSCD_WRITE_RESULTS=1 build-checked/bin/test/test_other_domains --gtest_filter=Results.*

#include "fuzz/Coded_file.h"
#include "fuzz/Coded_soup.h"
#include "support/Temporary_folder.h"
#include "support/convert_shape.h"
#include "support/invariants.h"
#include "support/sampling.h"
#include "support/shapes.h"
#include "support/sheet_shapes.h"
#include <CSCD/IO/read_points.h>
#include <CSCD/IO/read_skeleton.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/IO/read_volume.h>
#include <CSCD/extract_curve_skeleton.h>
#include <CSCD/extract_curve_skeleton_from_graph.h>
#include <CSCD/extract_curve_skeleton_from_points.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/adjacency_list.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

namespace {

using nlohmann::json;
using namespace CSCD::test;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Mesh_skeleton = CSCD::Skeleton_graph<Point, Mesh::Vertex_index>;
using Skeleton = CSCD::Skeleton_graph<Point, std::size_t>;
using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Skeleton::vertex_bundled>;

constexpr const char* table_path = CSCD_TEST_DIR "/results.txt";
constexpr double tolerance = 1e-6; // of lengths, relative: libraries of mathematics round differently
constexpr std::size_t number_of_points = 2000;
constexpr double noise = 0.01; // of shapes, in edge lengths: in symmetric ones, rounding decides between equals
constexpr std::size_t max_size_of_graphs = 1000; // vertices: larger ones take seconds

/// The sum of the distances from a place that is different for all axes and signs.
template <class Points>
double sum_of_distances(const Points& points)
{
  double sum = 0;
  for (const auto& p : points) {
    sum += std::hypot(p[0] - 1, p[1] - 2, p[2] - 3);
  }
  return sum;
}

template <class Graph>
json row_of(const Graph& skeleton)
{
  const Skeleton_facts facts = skeleton_facts(skeleton);
  double largest_radius = 0;
  std::size_t largest_part = 0;
  std::vector<Triple> points;
  for (std::size_t v = 0; v < num_vertices(skeleton); ++v) {
    largest_radius = std::max(largest_radius, skeleton[v].radius);
    largest_part = std::max(largest_part, skeleton[v].vertices.size());
    points.push_back(to_triple(skeleton[v].point));
  }
  double length = 0;
  for (auto [e, end] = edges(skeleton); e != end; ++e) {
    length += norm(points[source(*e, skeleton)] - points[target(*e, skeleton)]);
  }
  return {{"nodes", facts.number_of_nodes},
          {"components", facts.number_of_components},
          {"cycles", facts.betti_number},
          {"tips", facts.number_of_tips},
          {"length", length},
          {"sum_of_distances", sum_of_distances(points)},
          {"largest_radius", largest_radius},
          {"largest_part", largest_part}};
}

template <class Graph, class Input>
json extract(const Input& input)
{
  Graph skeleton;
  const CSCD::Skeletonization_report report = CSCD::extract_curve_skeleton(input, skeleton);
  json row = row_of(skeleton);
  row["nodes_outside"] = report.number_of_nodes_outside;
  row["edges_outside"] = report.number_of_edges_outside;
  return row;
}

json skeletonize_soup(Bytes bytes)
{
  return extract<Mesh_skeleton>(to_mesh<Mesh>(Coded_soup(bytes)));
}

json read_points(Bytes bytes)
{
  Coded_file file(bytes, endings_of_points);
  std::vector<Point> points;
  std::vector<Kernel::Vector_3> normals;
  CSCD::read_points(file.content, file.ending, "fuzz", points, normals);
  return {{"points", points.size()}, {"normals", normals.size()}, {"sum_of_distances", sum_of_distances(points)}};
}

json read_skeleton(Bytes bytes)
{
  Coded_file file(bytes, endings_of_skeletons);
  Skeleton skeleton;
  CSCD::read_skeleton(file.content, file.ending, "fuzz", skeleton);
  return row_of(skeleton);
}

json read_triangle_mesh(Bytes bytes)
{
  Coded_file file(bytes, endings_of_meshes);
  Mesh mesh;
  const CSCD::Mesh_repair_report repairs = CSCD::read_triangle_mesh(file.content, file.ending, "fuzz", mesh);
  return {{"points", mesh.number_of_vertices()},
          {"faces", mesh.number_of_faces()},
          {"sum_of_distances", sum_of_distances(mesh.points())},
          {"repairs", repairs.sentences()}};
}

json read_volume(Bytes bytes)
{
  const Coded_file file(bytes, endings_of_volumes);
  const std::string name = "fuzz" + file.ending;
  std::ofstream(name, std::ios::binary) << file.content.str();
  json row;
  for (const CSCD::Voxel_surface& surface : CSCD::read_voxel_surfaces(name, {std::nullopt, std::nullopt, true})) {
    row[std::to_string(surface.label)] = {{"voxels", surface.number_of_voxels},
                                          {"faces", surface.triangles.faces.size()},
                                          {"sum_of_distances", sum_of_distances(surface.triangles.points)}};
  }
  return row;
}

/// The row that `make_row` returns, or the message of its refusal.
template <class Make_row>
json row_or_refusal(const Make_row& make_row)
{
  try {
    return make_row();
  } catch (const std::exception& error) {
    return error.what();
  }
}

void add_corpus(json& table, const std::string& name, json (*make_row)(Bytes))
{
  for (const auto& entry : std::filesystem::directory_iterator(CSCD_TEST_DIR "/fuzz/corpus/" + name)) {
    const std::string content = test_support::read_file(entry.path().string());
    const Bytes bytes(reinterpret_cast<const std::uint8_t*>(content.data()), content.size());
    table[name + ':' + entry.path().filename().string()] = row_or_refusal([&] { return make_row(bytes); });
  }
}

void add_shape(json& table, const std::string& name, const Shape& smooth)
{
  const Shape shape = noisy(smooth, noise, 1);
  table["mesh:" + name] = row_or_refusal([&] { return extract<Mesh_skeleton>(to_mesh<Mesh>(shape)); });
  const auto points = to_points<Point>(sampled(shape, number_of_points, 1));
  table["points:" + name] = row_or_refusal([&] { return extract<Skeleton>(points); });
  if (shape.points.size() <= max_size_of_graphs) {
    const auto graph = to_graph<Graph>(shape.points, edges_of(shape));
    table["graph:" + name] = row_or_refusal([&] { return extract<Skeleton>(graph); });
  }
}

json make_table()
{
  json table;
  add_corpus(table, "extract_curve_skeleton", skeletonize_soup);
  add_corpus(table, "read_points", read_points);
  add_corpus(table, "read_skeleton", read_skeleton);
  add_corpus(table, "read_triangle_mesh", read_triangle_mesh);
  add_corpus(table, "read_volume", read_volume);
  for (const auto& list : {shapes_with_known_skeleton(), hard_closed_shapes(), asymmetric_shapes(), open_shapes()}) {
    for (const Shape_maker& maker : list) {
      add_shape(table, maker.name, maker.make());
    }
  }
  int number = 0;
  for (const Sheet_shape& sheet : sheets_with_known_middle()) {
    add_shape(table, "sheet_" + std::to_string(++number), sheet.shape);
  }
  return table;
}

TEST(Results, are_those_of_the_table)
{
  const test_support::Temporary_folder folder;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path()); // no message has the name of the folder
  json found = make_table();
  std::filesystem::current_path(before);
  if (std::getenv("CSCD_WRITE_RESULTS") != nullptr) {
    std::ofstream out(table_path);
    for (const auto& [input, row] : found.items()) {
      out << input << ' ' << row << '\n';
    }
  }
  json table;
  std::ifstream in(table_path);
  for (std::string input, row; in >> input && std::getline(in, row);) {
    table[input] = json::parse(row);
  }
  found = found.flatten();
  table = table.flatten();
  EXPECT_EQ(found.size(), table.size());
  for (const auto& [place, value] : found.items()) {
    const json expected = table.value(place, json("missing"));
    if (value.is_number_float() && expected.is_number_float()) {
      EXPECT_NEAR(value, expected, tolerance * std::fabs(double(expected))) << place;
    } else {
      EXPECT_EQ(value.dump(), expected.dump()) << place;
    }
  }
  EXPECT_FALSE(HasFailure()) << "where this is wanted, write the table anew: CSCD_WRITE_RESULTS=1 "
                                "build-checked/bin/test/test_other_domains --gtest_filter=Results.*";
}

} // namespace
