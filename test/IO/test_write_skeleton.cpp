// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of skeletons written to files by their endings, with CGAL's own skeleton type too, and of SWC for neurons.

#include "Parsed_skeleton.h"
#include "sample_skeleton.h"
#include "support/Temporary_folder.h"
#include "support/convert_shape.h"
#include "write_in_foreign_locale.h"
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/exceptions.h>

#include <CGAL/Mean_curvature_flow_skeletonization.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace test_support;

/// Each ending, and the begin of files of that format.
const std::pair<const char*, const char*> beginnings[] = {
    {".graph", "n 0 "}, {".json", "{\"nodes\":["},  {".obj", "v 0 "},
    {".ply", "ply\n"},  {".polylines.txt", "3 0 "}, {".swc", "# id type x y z radius parent\n"},
    {".vtp", "<?xml"},  {".GRAPH", "n 0 "},         {".two.dots.Swc", "# id"}};

TEST(Write_skeleton, chooses_the_format_by_the_ending)
{
  const Temporary_folder folder;
  for (const auto& [ending, beginning] : beginnings) {
    const std::string filename = folder.file(std::string("skeleton") + ending);
    CSCD::write_skeleton(filename, sample_skeleton<Skeleton>());
    EXPECT_EQ(0u, read_file(filename).rfind(beginning, 0)) << filename;
  }
}

/// Without radius: a path 0 - 1 that ends in the cycle 1 - 2 - 3, and the lone node 4. Some coordinates are not exact.
Skeleton_without_radius small_skeleton()
{
  return CSCD::test::to_graph<Skeleton_without_radius>(
      {{0, 0, 1e20}, {1, 0.1, 1e20}, {2, 0, -1234567}, {3, 0, 1e-300}, {4, 0, 1e20}}, {{0, 1}, {1, 2}, {2, 3}, {3, 1}});
}

/// A format by its ending, and the small skeleton in this format.
const std::pair<const char*, const char*> texts[] = {
    {".graph", "n 0 0 1e+20\nn 1 0.10000000000000001 1e+20\nn 2 0 -1234567\nn 3 0 1e-300\nn 4 0 1e+20\n"
               "c 0 1\nc 1 2\nc 2 3\nc 3 1\n"},
    {".obj", "v 0 0 1e+20\nv 1 0.10000000000000001 1e+20\nv 2 0 -1234567\nv 3 0 1e-300\nv 4 0 1e+20\n"
             "l 1 2\nl 2 3 4 2\np 5\n"},
    {".ply", "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\nproperty double z\n"
             "element edge 4\nproperty int vertex1\nproperty int vertex2\nend_header\n"
             "0 0 1e+20\n1 0.10000000000000001 1e+20\n2 0 -1234567\n3 0 1e-300\n4 0 1e+20\n"
             "0 1\n1 2\n2 3\n3 1\n"},
    {".polylines.txt", "2 0 0 1e+20 1 0.10000000000000001 1e+20\n"
                       "4 1 0.10000000000000001 1e+20 2 0 -1234567 3 0 1e-300 1 0.10000000000000001 1e+20\n"
                       "1 4 0 1e+20\n"},
    {".swc", "# id type x y z radius parent\n# loop 4 2\n1 6 0 0 1e+20 0 -1\n2 5 1 0.10000000000000001 1e+20 0 1\n"
             "3 0 2 0 -1234567 0 2\n4 0 3 0 1e-300 0 3\n5 0 4 0 1e+20 0 -1\n"},
    {".vtp", R"(<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<PolyData>
<Piece NumberOfPoints="5" NumberOfVerts="1" NumberOfLines="2" NumberOfStrips="0" NumberOfPolys="0">
<CellData Scalars="BranchId">
<DataArray type="Int64" Name="BranchId" format="ascii">
2
0
1
</DataArray>
</CellData>
<Points>
<DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 1e+20
1 0.10000000000000001 1e+20
2 0 -1234567
3 0 1e-300
4 0 1e+20
</DataArray>
</Points>
<Verts>
<DataArray type="Int64" Name="connectivity" format="ascii">
4 
</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">
1
</DataArray>
</Verts>
<Lines>
<DataArray type="Int64" Name="connectivity" format="ascii">
0 1 
1 2 3 1 
</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">
2
6
</DataArray>
</Lines>
</Piece>
</PolyData>
</VTKFile>
)"}};

TEST(Write_skeleton, writes_known_texts_whatever_the_global_locale)
{
  const Foreign_global_locale locale;
  const Temporary_folder folder;
  for (const auto& [ending, text] : texts) {
    const std::string filename = folder.file(std::string("skeleton") + ending);
    CSCD::write_skeleton(filename, small_skeleton());
    EXPECT_EQ(text, read_file(filename));
  }
}

TEST(Write_skeleton, vtp_has_radii_and_significances)
{
  std::ostringstream out;
  CSCD::write_vtp(out, sample_skeleton<Skeleton>());
  for (const char* name : {"Radius", "MaximumInscribedSphereRadius", "Significance"}) {
    EXPECT_NE(std::string::npos, out.str().find(" Name=\"" + std::string(name) + "\"")) << name;
  }
}

TEST(Write_skeleton, writes_empty_skeletons)
{
  const Temporary_folder folder;
  for (const auto& [ending, beginning] : beginnings) {
    EXPECT_NO_THROW(CSCD::write_skeleton(folder.file(std::string("empty") + ending), Skeleton())) << beginning;
  }
}

TEST(Write_skeleton, json_reports_nodes_edges_and_branches)
{
  const auto write = [](std::ostream& out, const Skeleton& skeleton) { CSCD::write_json(out, skeleton); };
  const Skeleton skeleton = sample_skeleton<Skeleton>();
  const nlohmann::json document = nlohmann::json::parse(write_in_foreign_locale(write, skeleton));
  Parsed_skeleton parsed;
  for (std::size_t i = 0; i < num_vertices(skeleton); ++i) {
    const nlohmann::json& node = document.at("nodes").at(i);
    parsed.points.emplace_back(node.at("point")[0], node.at("point")[1], node.at("point")[2]);
    parsed.radii.push_back(node.at("radius"));
    EXPECT_EQ(out_degree(i, skeleton), node.at("degree"));
    EXPECT_EQ(i, node.at("number_of_sites"));
  }
  for (const nlohmann::json& edge : document.at("edges")) {
    parsed.edges.emplace_back(edge[0], edge[1]);
  }
  expect_sample<Skeleton>(parsed);

  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (const nlohmann::json& branch : document.at("branches")) {
    append_path(branch.at("nodes").get<std::vector<std::size_t>>(), edges);
    const bool is_limb = branch["nodes"] == std::vector<int>({0, 1, 2}) || branch["nodes"] == std::vector<int>({4, 5});
    EXPECT_EQ(is_limb, branch.at("significance").is_number()) << branch;
    EXPECT_EQ(branch["nodes"].size() > 1, branch.at("length") > 1e19) << branch;
  }
  EXPECT_EQ(normalized(sample_edges()), normalized(edges));
}

TEST(Write_skeleton, writes_skeletons_of_cgal)
{
  using Mesh = CGAL::Surface_mesh<Point>;
  using Cgal_skeleton = CGAL::Mean_curvature_flow_skeletonization<Mesh>::Skeleton;
  auto skeleton = CSCD::test::to_graph<Cgal_skeleton>({{0, 0, 0}, {1, 0, 0}, {2, 0, 0.1}}, {{0, 1}, {1, 2}});
  skeleton[1].vertices = {Mesh::Vertex_index(4), Mesh::Vertex_index(5)};
  const Temporary_folder folder;
  for (const auto& [ending, beginning] : beginnings) {
    const std::string filename = folder.file(std::string("skeleton") + ending);
    CSCD::write_skeleton(filename, skeleton);
    EXPECT_EQ(0u, read_file(filename).rfind(beginning, 0)) << filename;
  }
  EXPECT_EQ("n 0 0 0\nn 1 0 0\nn 2 0 0.10000000000000001\nc 0 1\nc 1 2\n", read_file(folder.file("skeleton.graph")));
}

TEST(Write_skeleton, unknown_ending_is_refused_with_the_known_ones)
{
  const Temporary_folder folder;
  for (const char* name : {"skeleton.txt", "skeleton", "graph", "skeleton.graph.gz", ""}) {
    const std::string filename = folder.file(name);
    try {
      CSCD::write_skeleton(filename, sample_skeleton<Skeleton>());
      ADD_FAILURE() << filename;
    } catch (const CSCD::File_error& error) {
      const std::string message = error.what();
      EXPECT_NE(std::string::npos, message.find(filename));
      EXPECT_NE(std::string::npos, message.find(".graph .json .obj .ply .polylines.txt .swc .vtp"));
    }
    EXPECT_THROW(CSCD::check_skeleton_filename(filename), CSCD::File_error);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  EXPECT_NO_THROW(CSCD::check_skeleton_filename("skeleton.vtp"));
}

struct Swc_node
{
  std::size_t id = 0;
  int type = 0;
  double x = 0;
  double y = 0;
  double z = 0;
  double radius = 0;
  long parent = 0;
};

struct Swc_file
{
  std::vector<Swc_node> nodes;
  std::vector<std::pair<std::size_t, std::size_t>> loops; ///< as identifiers
};

Swc_file parse(const std::string& content)
{
  Swc_file result;
  std::istringstream in(content);
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    if (line.rfind("# loop ", 0) == 0) {
      std::string word;
      auto& [i, j] = result.loops.emplace_back();
      EXPECT_TRUE(words >> word >> word >> i >> j);
    } else if (line[0] != '#') {
      Swc_node& n = result.nodes.emplace_back();
      EXPECT_TRUE(words >> n.id >> n.type >> n.x >> n.y >> n.z >> n.radius >> n.parent) << line;
    }
  }
  return result;
}

/// Reads SWC by the strictest rules of readers of neurons: identifiers 1, 2, ..., types 1 to 7, parents before
/// children, one root for each component; one of the roots is the soma.
Swc_file parse_strictly(const std::string& content, std::size_t number_of_components)
{
  Swc_file file = parse(content);
  std::size_t number_of_roots = 0;
  for (std::size_t i = 0; i < file.nodes.size(); ++i) {
    const Swc_node& node = file.nodes[i];
    EXPECT_EQ(i + 1, node.id);
    EXPECT_TRUE(1 <= node.type && node.type <= 7) << node.type;
    EXPECT_TRUE(node.parent == -1 || (1 <= node.parent && node.parent < long(node.id))) << node.parent;
    EXPECT_TRUE(node.type != 1 || node.parent == -1);
    number_of_roots += node.parent == -1 ? 1 : 0;
  }
  EXPECT_EQ(number_of_components, number_of_roots);
  for (const auto& [i, j] : file.loops) {
    EXPECT_TRUE(1 <= i && i <= file.nodes.size() && 1 <= j && j <= file.nodes.size());
  }
  return file;
}

std::string swc_text_with(const Skeleton& skeleton, const CSCD::Swc_options& options)
{
  std::ostringstream out;
  CSCD::write_swc(out, skeleton, options);
  return out.str();
}

/// A tail 0 - 1 of radius 1 to a ring 1 - 2 - 3 - 4, which is thinnest between 2 and 3, and a ball apart of radius 9.
Skeleton tail_with_ring()
{
  return CSCD::test::to_graph<Skeleton>({{0, 0, 0}, {2, 0, 0}, {4, 2, 0}, {6, 0, 0}, {4, -2, 0}, {50, 0, 0}},
                                        {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 1}}, {1, 2, 0.5, 0.25, 2, 9});
}

TEST(Write_swc_for_neurons, obeys_strict_rules)
{
  CSCD::Swc_options options;
  options.type = 3;
  const Swc_file dendrite = parse_strictly(swc_text_with(tail_with_ring(), options), 2);
  EXPECT_EQ(6, std::count_if(dendrite.nodes.begin(), dendrite.nodes.end(), [](auto& n) { return n.type == 3; }));
  options.min_soma_radius = 5;
  const Swc_file with_soma = parse_strictly(swc_text_with(tail_with_ring(), options), 2);
  EXPECT_EQ(1, with_soma.nodes.front().type);
  EXPECT_EQ(9, with_soma.nodes.front().radius);
  EXPECT_EQ(5, std::count_if(with_soma.nodes.begin(), with_soma.nodes.end(), [](auto& n) { return n.type == 3; }));
  options.min_soma_radius = 10; // nothing is as thick
  parse_strictly(swc_text_with(sample_skeleton<Skeleton>(), options), 4);
}

TEST(Write_swc_for_neurons, cuts_cycles_where_they_are_thinnest)
{
  const Swc_file file = parse(swc_text_with(tail_with_ring(), {}));
  ASSERT_EQ(1u, file.loops.size());
  const auto [i, j] = file.loops[0];
  EXPECT_EQ(0.75, file.nodes[i - 1].radius + file.nodes[j - 1].radius);
}

TEST(Write_swc_for_neurons, begins_at_the_roots)
{
  CSCD::Swc_options options;
  options.roots = {3};
  options.scale = 0.5;
  const Swc_file file = parse(swc_text_with(tail_with_ring(), options));
  EXPECT_EQ(3, file.nodes[0].x); // half of that of the node
  EXPECT_EQ(0.125, file.nodes[0].radius);
  EXPECT_EQ(-1, file.nodes[0].parent);
  EXPECT_EQ(25, file.nodes.back().x);
  EXPECT_EQ(-1, file.nodes.back().parent);
}

} // namespace
