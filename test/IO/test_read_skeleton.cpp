// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of skeletons read from files: files of the writers, of other programs, and malformed files.

#include "Parsed_skeleton.h"
#include "malformed_files.h"
#include "mesh_files.h"
#include "sample_skeleton.h"
#include "support/Temporary_folder.h"
#include "write_in_foreign_locale.h"
#include <CSCD/IO/read_skeleton.h>
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/Skeleton/Branch_hierarchy.h>
#include <CSCD/exceptions.h>

#include <boost/range/iterator_range_core.hpp>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace test_support;
using Edges = std::vector<std::pair<std::size_t, std::size_t>>;

/// Reads `content` as a file with this ending.
Parsed_skeleton read(const std::string& ending, const std::string& content)
{
  std::istringstream in(content);
  Skeleton skeleton;
  const bool has_radii = CSCD::read_skeleton(in, ending, "test", skeleton);
  Parsed_skeleton result;
  for (std::size_t v = 0; v < num_vertices(skeleton); ++v) {
    result.points.push_back(skeleton[v].point);
    EXPECT_TRUE(skeleton[v].vertices.empty());
    if (has_radii) {
      result.radii.push_back(skeleton[v].radius);
    } else {
      EXPECT_EQ(0, skeleton[v].radius);
    }
  }
  for (auto e = edges(skeleton).first; e != edges(skeleton).second; ++e) {
    result.edges.emplace_back(source(*e, skeleton), target(*e, skeleton));
  }
  return result;
}

/// Numbers nodes as the sample does, by their points.
Parsed_skeleton in_order_of_sample(const Parsed_skeleton& parsed)
{
  const Skeleton sample = sample_skeleton<Skeleton>();
  std::vector<std::size_t> number;
  for (const Point& point : parsed.points) {
    std::size_t v = 0;
    while (v < num_vertices(sample) && sample[v].point != point) {
      ++v;
    }
    number.push_back(v);
  }
  Parsed_skeleton result = parsed;
  for (std::size_t i = 0; i < number.size(); ++i) {
    result.points.at(number[i]) = parsed.points[i];
    if (!parsed.radii.empty()) {
      result.radii.at(number[i]) = parsed.radii[i];
    }
  }
  for (auto& [u, v] : result.edges) {
    u = number[u];
    v = number[v];
  }
  return result;
}

TEST(Read_skeleton, reads_back_exactly_what_is_written)
{
  const Temporary_folder folder;
  for (const auto& [ending, has_radii] : std::vector<std::pair<std::string, bool>>{{".graph", false},
                                                                                   {".json", true},
                                                                                   {".obj", false},
                                                                                   {".ply", true},
                                                                                   {".polylines.txt", false},
                                                                                   {".swc", true},
                                                                                   {".vtp", true},
                                                                                   {".GRAPH", false}}) {
    SCOPED_TRACE(ending);
    const std::string filename = folder.file("skeleton" + ending);
    CSCD::write_skeleton(filename, sample_skeleton<Skeleton>());
    const Parsed_skeleton parsed = in_order_of_sample(read(ending, read_file(filename)));
    EXPECT_EQ(has_radii, !parsed.radii.empty());
    if (has_radii) {
      expect_sample<Skeleton>(parsed);
    } else {
      expect_sample<Skeleton_without_radius>(parsed);
    }
    Skeleton skeleton(99); // from the file itself, which replaces the old content
    EXPECT_EQ(has_radii, CSCD::read_skeleton(filename, skeleton));
    EXPECT_EQ(parsed.points.size(), num_vertices(skeleton));
    EXPECT_EQ(parsed.edges.size(), num_edges(skeleton));
  }
}

TEST(Read_skeleton, graph_of_gel)
{
  const Parsed_skeleton s =
      read(".graph", "# made by hand\r\nc 0 1\r\nn 0 0 0\r\n\r\n  n +1 2e0 -.5 red\r\nn 1 1 1\r\n");
  EXPECT_EQ((std::vector<Point>{Point(0, 0, 0), Point(1, 2, -0.5), Point(1, 1, 1)}), s.points);
  EXPECT_EQ((Edges{{0, 1}}), s.edges); // it may come before its nodes
}

TEST(Read_skeleton, repeated_edges_and_edges_to_the_same_node_are_left_out)
{
  const Parsed_skeleton s = read(".graph", "n 0 0 0\nn 1 0 0\nc 0 1\nc 1 0\nc 0 1\nc 1 1\n");
  EXPECT_EQ((Edges{{0, 1}}), s.edges);
}

TEST(Read_skeleton, json_and_vtp_tell_which_nodes_are_openings)
{
  Skeleton skeleton = sample_skeleton<Skeleton>();
  skeleton[3].is_opening = true;
  const Temporary_folder folder;
  for (const std::string name : {"s.json", "s.vtp"}) {
    CSCD::write_skeleton(folder.file(name), skeleton);
    Skeleton read_back;
    CSCD::read_skeleton(folder.file(name), read_back);
    ASSERT_EQ(num_vertices(skeleton), num_vertices(read_back));
    for (std::size_t v = 0; v < num_vertices(read_back); ++v) {
      EXPECT_EQ(v == 3, read_back[v].is_opening) << name;
    }
  }
}

TEST(Read_skeleton, json_tells_which_edges_were_joined)
{
  Skeleton skeleton = sample_skeleton<Skeleton>();
  const auto marked = edge(4, 5, skeleton).first;
  skeleton[marked].is_joined = true;
  std::stringstream file;
  CSCD::write_json(file, skeleton);
  Skeleton read_back;
  CSCD::read_skeleton(file, ".json", "test", read_back);
  CSCD::compute_significance(skeleton);
  ASSERT_EQ(num_edges(skeleton), num_edges(read_back));
  for (const auto e : boost::make_iterator_range(edges(read_back))) {
    const auto before = skeleton[edge(source(e, read_back), target(e, read_back), skeleton).first];
    EXPECT_EQ(before.is_joined, read_back[e].is_joined);
    EXPECT_EQ(before.significance, read_back[e].significance);
  }
}

TEST(Read_skeleton, json_of_others)
{
  const Parsed_skeleton s = read(
      ".json", R"({"edges": [[1, 0]], "name": "x", "nodes": [{"point": [0, 1, 2.5]}, {"point": [3, 4, 5], "id": 7}]})");
  EXPECT_EQ((std::vector<Point>{Point(0, 1, 2.5), Point(3, 4, 5)}), s.points);
  EXPECT_TRUE(s.radii.empty());
  EXPECT_EQ((Edges{{1, 0}}), s.edges);
}

TEST(Read_skeleton, lines_of_obj)
{
  const Parsed_skeleton s =
      read(".obj", "o skeleton\nv 0 0 0 1.0\nv 1 0 0\nl 1/1 2/2 3/3\nv 2 0 0\nvt 0 0\nl -1 -2\nv 9 9 9\nl 4\np 4\n");
  EXPECT_EQ(4u, s.points.size());
  EXPECT_EQ((Edges{{0, 1}, {1, 2}}), normalized(s.edges));
  // A mesh with lines in it: its edges are read.
  EXPECT_EQ(1u, read(".obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\n").edges.size());
}

TEST(Read_skeleton, edges_of_ply_with_other_properties)
{
  const Parsed_skeleton s =
      read(".ply",
           "ply\nformat ascii 1.0\ncomment x\nelement vertex 2\nproperty float nx\nproperty float x\nproperty float y\n"
           "property float z\nproperty uchar red\nproperty float radius\nelement face 1\nproperty list uchar int "
           "vertex_indices\nelement edge 1\nproperty list uchar int other\nproperty int vertex2\nproperty int "
           "vertex1\nend_header\n9 1 2 3 255 .5\n9 4 5 6 0 .25\n3 0 1 1\n2 8 8 1 0\n");
  EXPECT_EQ((std::vector<Point>{Point(1, 2, 3), Point(4, 5, 6)}), s.points);
  EXPECT_EQ((std::vector<double>{0.5, 0.25}), s.radii);
  EXPECT_EQ((Edges{{0, 1}}), s.edges);
}

/// A PLY file of two nodes and an edge in binary.
std::string binary_ply_of_an_edge(bool is_little_endian)
{
  const std::string result = std::string("ply\nformat binary_") + (is_little_endian ? "little" : "big") +
                             "_endian 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
                             "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n";
  return result + bytes_of<float>(std::vector<double>{1, 2, 3, 4, 5, 6.5}, is_little_endian) +
         bytes_of<std::int32_t>(std::vector<int>{1, 0}, is_little_endian);
}

TEST(Read_skeleton, lines_of_vtk)
{
  const Parsed_skeleton legacy =
      read(".vtp", "# vtk DataFile Version 4.2\nlines\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n"
                   "0 0 0 1 0 0 2 0 0 1 1 0\nLINES 2 7\n3 0 1 2\n2 1 3\nPOINT_DATA 4\nSCALARS "
                   "Radius float\nLOOKUP_TABLE default\n.5 .25 .125 1\n");
  EXPECT_EQ((Edges{{0, 1}, {1, 2}, {1, 3}}), legacy.edges);
  EXPECT_EQ((std::vector<double>{0.5, 0.25, 0.125, 1}), legacy.radii);
  const Parsed_skeleton pieces = read(
      ".vtp", "<VTKFile type='PolyData'><PolyData><Piece NumberOfPoints='2'><Points><DataArray type='Float64'>0 0 0 "
              "1 0 0</DataArray></Points><Lines><DataArray type='Int64' Name='connectivity'>0 1</DataArray><DataArray "
              "type='Int64' Name='offsets'>2</DataArray></Lines></Piece><Piece NumberOfPoints='2'><Points><DataArray "
              "type='Float64'>5 0 0 6 0 0</DataArray></Points><Lines><DataArray type='Int64' "
              "Name='connectivity'>1 0</DataArray><DataArray type='Int64' Name='offsets'>2</DataArray></Lines>"
              "</Piece></PolyData></VTKFile>");
  EXPECT_EQ((Edges{{0, 1}, {3, 2}}), pieces.edges);
  EXPECT_TRUE(pieces.radii.empty());
}

TEST(Read_skeleton, binary_ply)
{
  for (const bool is_little_endian : {true, false}) {
    const Parsed_skeleton s = read(".ply", binary_ply_of_an_edge(is_little_endian));
    EXPECT_EQ((std::vector<Point>{Point(1, 2, 3), Point(4, 5, 6.5)}), s.points);
    EXPECT_EQ((Edges{{1, 0}}), s.edges);
  }
}

TEST(Read_skeleton, polylines_share_nodes_of_equal_coordinates)
{
  const Parsed_skeleton s =
      read(".polylines.txt", "2 0 0 0 1 0 0\n3 1 0 0 2 0 0 2 0 0\n4 5 5 5 6 5 5\n5 6 5 5 5 5\n1 -0 0 0\n");
  EXPECT_EQ(6u, s.points.size());
  EXPECT_EQ((Edges{{0, 1}, {1, 2}, {3, 4}, {3, 5}, {4, 5}}), normalized(s.edges));
}

TEST(Read_skeleton, swc_of_neuroscience)
{
  const Parsed_skeleton s = read(".swc", "# ORIGINAL_SOURCE x\n#loop\n# loop of wire\n# loop\n 12 3 1 0 0 .5 7\n7 1 0 "
                                         "0 0 2 -1 # soma\n13 3 1 1 0 .25 7\n# loop 12 13\n");
  EXPECT_EQ((std::vector<Point>{Point(1, 0, 0), Point(0, 0, 0), Point(1, 1, 0)}), s.points);
  EXPECT_EQ((std::vector<double>{0.5, 2, 0.25}), s.radii);
  EXPECT_EQ((Edges{{0, 1}, {0, 2}, {1, 2}}), normalized(s.edges));
}

TEST(Read_skeleton, global_locale_does_not_matter)
{
  const Foreign_global_locale locale;
  EXPECT_EQ(Point(0.5, 0, 0), read(".graph", "n 0.5 0 0\n").points.at(0));
  EXPECT_EQ(Point(0.5, 0, 0), read(".json", R"({"nodes":[{"point":[0.5,0,0]}],"edges":[]})").points.at(0));
}

TEST(Read_skeleton, malformed_files_are_refused_with_the_reason)
{
  std::vector<Malformed_file> files = malformed_files("skeletons");
  files.push_back({".ply", binary_ply_of_an_edge(true).substr(0, 200), "ends before all that its header promises"});
  for (const Malformed_file& file : files) {
    SCOPED_TRACE(file.ending + (": " + file.content));
    std::istringstream in(file.content);
    Skeleton skeleton(3);
    try {
      CSCD::read_skeleton(in, file.ending, "name of file", skeleton);
      ADD_FAILURE() << "no exception";
    } catch (const CSCD::File_error& error) {
      const std::string message = error.what();
      EXPECT_NE(std::string::npos, message.find(file.message)) << message;
      EXPECT_EQ(0u, message.rfind("name of file", 0)) << message;
      EXPECT_NE(std::string::npos, message.find("; ")) << message; // the remedy
      EXPECT_EQ(std::string::npos, message.find('\n')) << message;
    }
    EXPECT_EQ(3u, num_vertices(skeleton));
  }
}

} // namespace
