// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of skeletons written to files by their endings, with CGAL's own skeleton type too.

#include "sample_skeleton.h"
#include "support/Temporary_folder.h"
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/exceptions.h>

#include <CGAL/Mean_curvature_flow_skeletonization.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace {

using namespace test_support;

/// Each ending, and how files of that format begin.
const std::pair<const char*, const char*> beginnings[] = {
    {".graph", "n 0 "},       {".json", "{\"nodes\":["},  {".obj", "v 0 "},
    {".ply", "ply\n"},        {".polylines.txt", "3 0 "}, {".swc", "# id type x y z radius parent\n"},
    {".vtp", "<?xml"},        {".graphml", "<?xml"},      {".GRAPH", "n 0 "},
    {".two.dots.Swc", "# id"}};

TEST(Write_skeleton, chooses_the_format_by_the_ending)
{
  const Temporary_folder folder;
  for (const auto& [ending, beginning] : beginnings) {
    const std::string filename = folder.file(std::string("skeleton") + ending);
    CSCD::write_skeleton(filename, sample_skeleton<Skeleton>());
    EXPECT_EQ(0u, read_file(filename).rfind(beginning, 0)) << filename;
  }
}

TEST(Write_skeleton, writes_skeletons_of_cgal)
{
  using Mesh = CGAL::Surface_mesh<Point>;
  using Cgal_skeleton = CGAL::Mean_curvature_flow_skeletonization<Mesh>::Skeleton;
  Cgal_skeleton skeleton(3);
  skeleton[0].point = Point(0, 0, 0);
  skeleton[1].point = Point(1, 0, 0);
  skeleton[2].point = Point(2, 0, 0.1);
  skeleton[1].vertices = {Mesh::Vertex_index(4), Mesh::Vertex_index(5)};
  add_edge(0, 1, skeleton);
  add_edge(1, 2, skeleton);
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
      EXPECT_NE(std::string::npos, message.find(".graph .json .obj .ply .polylines.txt .swc .vtp .graphml"));
    }
    EXPECT_THROW(CSCD::check_skeleton_filename(filename), CSCD::File_error);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  EXPECT_NO_THROW(CSCD::check_skeleton_filename("skeleton.vtp"));
}

} // namespace
