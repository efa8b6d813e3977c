// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points and normals from all formats, and files that are refused.

#include "support/Temporary_folder.h"
#include <CSCD/IO/read_mesh_or_points.h>
#include <CSCD/IO/read_points.h>
#include <CSCD/exceptions.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using CSCD::Point_format;

struct Content
{
  std::vector<Point> points;
  std::vector<Vector> normals;
};

Content read(const std::string& text, Point_format format)
{
  std::istringstream in(text);
  Content content;
  CSCD::read_points(in, format, "cloud", content.points, content.normals);
  return content;
}

const std::vector<Point> expected_points{{1, 2, 3}, {-4, 5.5, 6e-3}};
const std::vector<Vector> expected_normals{{0, 0, 1}, {0.6, -0.8, 0}};

TEST(read_points, reads_points_of_all_formats)
{
  EXPECT_EQ(expected_points, read("1 2 3\n-4 5.5 6e-3\n", Point_format::xyz).points);
  EXPECT_EQ(expected_points, read("# comment\r\n\r\n 1\t2 3\r\n-4 5.5 .006", Point_format::xyz).points);
  EXPECT_EQ(expected_points, read("2\n1 2 3\n-4 5.5 6e-3\n", Point_format::pts).points);
  EXPECT_EQ(expected_points, read("2\n1 2 3 -99 255 0 17\n-4 5.5 6e-3 -99 0 0 0\n", Point_format::pts).points);
  EXPECT_EQ(expected_points, read("OFF\n2 0 0\n1 2 3\n-4 5.5 6e-3\n", Point_format::off).points);
  EXPECT_EQ(expected_points, read("ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                                  "property float z\nend_header\n1 2 3\n-4 5.5 6e-3\n",
                                  Point_format::ply)
                                 .points);
}

TEST(read_points, reads_normals_where_there_are_any)
{
  const std::string lines = "1 2 3 0 0 1\n-4 5.5 6e-3 .6 -.8 0\n";
  EXPECT_EQ(expected_normals, read(lines, Point_format::xyz).normals);
  EXPECT_EQ(expected_points, read(lines, Point_format::xyz).points);
  EXPECT_EQ(expected_normals, read("NOFF\n2 0 0\n" + lines, Point_format::off).normals);
  EXPECT_EQ(expected_normals,
            read("ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\nproperty double z\n"
                 "property double nx\nproperty double ny\nproperty double nz\nend_header\n" +
                     lines,
                 Point_format::ply)
                .normals);
}

TEST(read_points, takes_no_other_numbers_for_normals)
{
  EXPECT_TRUE(read("1 2 3\n1 2 4\n", Point_format::xyz).normals.empty());
  EXPECT_TRUE(read("1 2 3 255 128 0\n1 2 4 0 0 1\n", Point_format::xyz).normals.empty());
  EXPECT_TRUE(read("1 2 3 0 0 1\n1 2 4\n", Point_format::xyz).normals.empty());
  EXPECT_TRUE(read("1 2 3 0 0 0\n1 2 4 0 0 0\n", Point_format::xyz).normals.empty());
  EXPECT_TRUE(read("NOFF\n2 0 0\n1 2 3 0 0 1\n1 2 4\n", Point_format::off).normals.empty());
}

TEST(read_points, takes_columns_for_normals_by_the_unit_length_of_most_rows)
{
  const std::vector<Vector> normals =
      read("1 2 3 0 0 1\n1 2 4 0 1 0\n1 2 5 3 0 0\n1 2 6 1 0 0\n1 2 7 0 0 0\n", Point_format::xyz).normals;
  EXPECT_EQ((std::vector<Vector>{{0, 0, 1}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}}), normals);
  EXPECT_TRUE(read("1 2 3 .2 .4 .1\n1 2 4 .9 .8 1\n1 2 5 0 0 1\n", Point_format::xyz).normals.empty());
  EXPECT_TRUE(read("1 2 3 1 0 0\n1 2 4 1 0 0\n1 2 5 1 0 0\n", Point_format::xyz).normals.empty()) << "one color";
}

TEST(read_points, passes_over_comments_and_a_header)
{
  for (const char* const text :
       {"x y z\n1 2 3\n-4 5.5 6e-3\n", "// x y z\n1 2 3 // first\n# second\n-4 5.5 6e-3\n",
        "# two points\n\"x\" \"y\" \"z\"\n1 2 3 # first\n-4 5.5 6e-3\n", "2\n1 2 3\n-4 5.5 6e-3\n"}) {
    EXPECT_EQ(expected_points, read(text, Point_format::xyz).points) << text;
  }
}

/// The message with which the text is refused; points stay as they were.
std::string refusal(const std::string& text, Point_format format)
{
  std::istringstream in(text);
  std::vector<Point> points(3);
  std::vector<Vector> normals;
  try {
    CSCD::read_points(in, format, "cloud", points, normals);
  } catch (const CSCD::File_error& error) {
    EXPECT_EQ(3u, points.size());
    return error.what();
  }
  return "not refused";
}

TEST(read_points, refuses_malformed_files)
{
  EXPECT_EQ("cloud: the file is empty; fetch or write it again", refusal("", Point_format::xyz));
  EXPECT_EQ("cloud: the file has no points; fetch or write it again", refusal("# nothing\n", Point_format::xyz));
  EXPECT_EQ(0u, refusal("x y z\nx y z\n1 2 3\n", Point_format::xyz).rfind("cloud, line 2: a number", 0));
  EXPECT_EQ(0u, refusal("1 2 3\n1 2\n", Point_format::xyz).rfind("cloud, line 2: a point has fewer", 0));
  EXPECT_EQ(0u, refusal("1 2 3\n1 2 x\n", Point_format::xyz).rfind("cloud, line 2: a number", 0));
  EXPECT_EQ(0u, refusal("1 2 3\n1 nan 2\n", Point_format::xyz).rfind("cloud, line 2: a coordinate is not finite", 0));
}

TEST(read_points, takes_the_format_from_the_ending)
{
  EXPECT_EQ(Point_format::xyz, CSCD::point_format("a.b/cloud.XYZ"));
  EXPECT_EQ(Point_format::pts, CSCD::point_format("cloud.pts"));
  EXPECT_THROW(CSCD::point_format("cloud.stl"), CSCD::File_error);
  const test_support::Temporary_folder folder;
  folder.write("cloud.xyz", "1 2 3\n-4 5.5 6e-3\n");
  Content content;
  CSCD::read_points(folder.file("cloud.xyz"), content.points, content.normals);
  EXPECT_EQ(expected_points, content.points);
}

TEST(read_mesh_or_points, lets_faces_decide)
{
  CGAL::Surface_mesh<Point> mesh;
  Content content;
  std::istringstream points("OFF\n2 0 0\n1 2 3\n-4 5.5 6e-3\n");
  EXPECT_FALSE(
      CSCD::read_mesh_or_points(points, "cloud.off", "cloud", mesh, content.points, content.normals).has_value());
  EXPECT_EQ(expected_points, content.points);
  EXPECT_EQ(0u, num_vertices(mesh));
  std::istringstream faces("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_TRUE(
      CSCD::read_mesh_or_points(faces, "cloud.off", "cloud", mesh, content.points, content.normals).has_value());
  EXPECT_EQ(3u, num_vertices(mesh));
}

} // namespace
