// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points and normals from all formats, and files that are refused.

#include "mesh_files.h"
#include "support/Temporary_folder.h"
#include <CSCD/IO/read_points.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/exceptions.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace test_support;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;

struct Content
{
  std::vector<Point> points;
  std::vector<Vector> normals;
};

Content read(const std::string& text, const std::string& format)
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
  EXPECT_EQ(expected_points, read("1 2 3\n-4 5.5 6e-3\n", ".xyz").points);
  EXPECT_EQ(expected_points, read("# comment\r\n\r\n 1\t2 3\r\n-4 5.5 .006", ".xyz").points);
  EXPECT_EQ(expected_points, read("2\n1 2 3\n-4 5.5 6e-3\n", ".pts").points);
  EXPECT_EQ(expected_points, read("2\n1 2 3 -99 255 0 17\n-4 5.5 6e-3 -99 0 0 0\n", ".pts").points);
  EXPECT_EQ(expected_points, read("OFF\n2 0 0\n1 2 3\n-4 5.5 6e-3\n", ".off").points);
  EXPECT_EQ(expected_points, read("ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                                  "property float z\nend_header\n1 2 3\n-4 5.5 6e-3\n",
                                  ".ply")
                                 .points);
}

TEST(read_points, reads_normals_where_there_are_any)
{
  const std::string lines = "1 2 3 0 0 1\n-4 5.5 6e-3 .6 -.8 0\n";
  EXPECT_EQ(expected_normals, read(lines, ".xyz").normals);
  EXPECT_EQ(expected_points, read(lines, ".xyz").points);
  EXPECT_EQ(expected_normals, read("NOFF\n2 0 0\n" + lines, ".off").normals);
  EXPECT_EQ(expected_normals,
            read("ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\nproperty double z\n"
                 "property double nx\nproperty double ny\nproperty double nz\nend_header\n" +
                     lines,
                 ".ply")
                .normals);
}

TEST(read_points, takes_no_other_numbers_for_normals)
{
  EXPECT_TRUE(read("1 2 3\n1 2 4\n", ".xyz").normals.empty());
  EXPECT_TRUE(read("1 2 3 255 128 0\n1 2 4 0 0 1\n", ".xyz").normals.empty());
  EXPECT_TRUE(read("1 2 3 0 0 1\n1 2 4\n", ".xyz").normals.empty());
  EXPECT_TRUE(read("1 2 3 0 0 0\n1 2 4 0 0 0\n", ".xyz").normals.empty());
  EXPECT_TRUE(read("NOFF\n2 0 0\n1 2 3 0 0 1\n1 2 4\n", ".off").normals.empty());
}

TEST(read_points, takes_columns_for_normals_by_the_unit_length_of_most_rows)
{
  const std::vector<Vector> normals =
      read("1 2 3 0 0 1\n1 2 4 0 1 0\n1 2 5 3 0 0\n1 2 6 1 0 0\n1 2 7 0 0 0\n", ".xyz").normals;
  EXPECT_EQ((std::vector<Vector>{{0, 0, 1}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}}), normals);
  EXPECT_TRUE(read("1 2 3 .2 .4 .1\n1 2 4 .9 .8 1\n1 2 5 0 0 1\n", ".xyz").normals.empty());
  EXPECT_TRUE(read("1 2 3 1 0 0\n1 2 4 1 0 0\n1 2 5 1 0 0\n", ".xyz").normals.empty()) << "one color";
}

TEST(read_points, passes_over_comments_and_a_header)
{
  for (const char* const text :
       {"x y z\n1 2 3\n-4 5.5 6e-3\n", "// x y z\n1 2 3 // first\n# second\n-4 5.5 6e-3\n",
        "# two points\n\"x\" \"y\" \"z\"\n1 2 3 # first\n-4 5.5 6e-3\n", "2\n1 2 3\n-4 5.5 6e-3\n"}) {
    EXPECT_EQ(expected_points, read(text, ".xyz").points) << text;
  }
}

/// The message that refuses the text; points stay as they were.
std::string refusal(const std::string& text, const std::string& format)
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

TEST(read_points, reads_tables_by_the_names_of_their_columns)
{
  for (const char* text : {"1,2,3\n-4,5.5,6e-3\n", "1;2;3\r\n-4;5.5;6e-3\r\n", "x,y,z\n1,2,3\n-4,5.5,6e-3",
                           "2\n1, 2, 3\n-4, 5.5, 6e-3\n", "\"id\",\"z\",\"Y\",\"X\"\n\"a\",3,2,1\n\"b\",6e-3,5.5,-4\n",
                           "//X Y Z R G B\n2\n1 2 3 255 0 0\n-4 5.5 6e-3 0 0 9\n",
                           "# exported, with commas\n1 2 3\n-4 5.5 6e-3\n", "id x y z\n7 1 2 3\n8 -4 5.5 6e-3\n",
                           "x,y,z,intensity\n1,2,3,\n-4,5.5,6e-3,1\n", "1,2,3,,,\n-4,5.5,6e-3,,,\n"}) {
    EXPECT_EQ(expected_points, read(text, ".xyz").points) << text;
    EXPECT_TRUE(read(text, ".xyz").normals.empty()) << text;
  }
  const char* const with_normals = "//X Y Z R G B Nx Ny Nz\n1 2 3 9 9 9 0 0 1\n-4 5.5 6e-3 9 9 9 0.6 -.8 0\n";
  EXPECT_EQ(expected_points, read(with_normals, ".xyz").points);
  EXPECT_EQ(expected_normals, read(with_normals, ".xyz").normals);
  EXPECT_EQ(expected_normals, read("1,2,3,0,0,1\n-4,5.5,6e-3,.6,-.8,0\n", ".xyz").normals);
}

/// A PCD file of the expected points and normals, with a field between them and a point that was not measured.
std::string pcd(const std::string& encoding)
{
  std::string file = "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z rgb normal_x normal_y normal_z\nSIZE 8 8 8 4 4 4 4\n"
                     "TYPE F F F U F F F\nCOUNT 1 1 1 1 1 1 1\nWIDTH 3\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3\n"
                     "DATA " +
                     encoding + '\n';
  if (encoding == "ascii") {
    return file + "1 2 3 77 0 0 1\nnan nan nan 0 nan nan nan\n-4 5.5 0.006 77 0.6 -0.8 0\n";
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::array<std::array<double, 7>, 3> rows{
      {{1, 2, 3, 77, 0, 0, 1}, {nan, nan, nan, 0, nan, nan, nan}, {-4, 5.5, 6e-3, 77, 0.6, -0.8, 0}}};
  for (const std::array<double, 7>& row : rows) {
    for (std::size_t field = 0; field < row.size(); ++field) {
      file += field < 3    ? number_bytes(row[field])
              : field == 3 ? number_bytes(std::uint32_t(row[field]))
                           : number_bytes(float(row[field]));
    }
  }
  return file;
}

TEST(read_points, reads_pcd)
{
  for (const char* encoding : {"ascii", "binary"}) {
    SCOPED_TRACE(encoding);
    const Content content = read(pcd(encoding), ".pcd");
    EXPECT_EQ(expected_points, content.points) << "what is not finite is left out";
    ASSERT_EQ(2u, content.normals.size());
    EXPECT_EQ(expected_normals[0], content.normals[0]);
    EXPECT_NEAR(-0.8, content.normals[1].y(), 1e-7);
  }
}

/// A LAS file of version 1.2, of points of format 0, each with 8 bytes more than its coordinates.
std::string las(std::uint32_t number_of_points)
{
  std::string file = "LASF";
  file.resize(24, '\0');
  file += std::string("\1\2", 2);
  file.resize(94, '\0');
  file += number_bytes(std::uint16_t(227));
  file += number_bytes(std::uint32_t(230)); // with a gap behind the header
  file.resize(file.size() + 5, '\0');
  file += number_bytes(std::uint16_t(20)) + number_bytes(number_of_points);
  file.resize(131, '\0');
  file += bytes_of<double>(std::vector<double>{0.5, 0.25, 0.001, 10, 0, -1}); // scales and offsets
  file.resize(230, '\0');
  for (const std::vector<int>& point : {std::vector<int>{-18, 8, 4000}, {-28, 22, 1006}}) {
    file += bytes_of<std::int32_t>(point) + std::string(8, '\x7f');
  }
  return file;
}

TEST(read_points, reads_las)
{
  const Content content = read(las(2), ".las");
  ASSERT_EQ(2u, content.points.size());
  EXPECT_LT(CGAL::squared_distance(expected_points[0], content.points[0]), 1e-20);
  EXPECT_LT(CGAL::squared_distance(expected_points[1], content.points[1]), 1e-20);
}

TEST(read_points, reads_points_of_vtk)
{
  EXPECT_EQ(expected_points,
            read("# vtk DataFile Version 3.0\npoints\nASCII\nDATASET POLYDATA\nPOINTS 2 double\n1 2 3 -4 "
                 "5.5 6e-3\nVERTICES 1 3\n2 0 1\n",
                 ".vtk")
                .points);
}

TEST(read_points, survives_damaged_scans)
{
  std::mt19937 random(7);
  for (const auto& [content, format] :
       std::vector<std::pair<std::string, std::string>>{{pcd("ascii"), ".pcd"},
                                                        {pcd("binary"), ".pcd"},
                                                        {las(2), ".las"},
                                                        {"//X Y Z Nx Ny Nz\n1 2 3 0 0 1\n", ".xyz"},
                                                        {"id,x,y,z\n7,1,2,3\n", ".xyz"}}) {
    for (int i = 0; i < 400; ++i) {
      std::string damaged = content;
      for (int k = 0; k < 3; ++k) {
        damaged[random() % damaged.size()] = char(random());
      }
      damaged.resize(i % 4 == 0 ? random() % damaged.size() : damaged.size());
      std::istringstream in(damaged);
      Content read;
      try {
        CSCD::read_points(in, format, "cloud", read.points, read.normals);
        EXPECT_FALSE(read.points.empty());
      } catch (const CSCD::File_error&) {
        EXPECT_TRUE(read.points.empty());
      }
    }
  }
}

TEST(read_points, refuses_malformed_files)
{
  using Contents_and_messages = std::vector<std::pair<std::string, std::string>>;
  EXPECT_EQ("cloud: the file is empty; fetch or write it again", refusal("", ".xyz"));
  EXPECT_EQ("cloud: the file has no points; fetch or write it again", refusal("# nothing\n", ".xyz"));
  for (const auto& [content, beginning] :
       Contents_and_messages{{"x y z\nx y z\n1 2 3\n", "2: a number"},
                             {"1 2 3\n1 2\n", "2: a point has fewer"},
                             {"1 2 3\n1 2 x\n", "2: a number"},
                             {"x,y,z\n1,2,3\n1,,3\n", "3: a number"},
                             {"1;2;3\n1,5;2,5;3\n", "2: a number"},
                             {"x,y,z\n1,2\n", "2: a point has fewer"},
                             {"x,y,z\n1,2,inf\n", "2: a coordinate is not finite"},
                             {"1 2 3\n1 nan 2\n", "2: a coordinate is not finite"}}) {
    EXPECT_EQ(0u, refusal(content, ".xyz").rfind("cloud, line " + beginning, 0)) << content;
  }
  for (const char* encoding : {"ascii", "binary"}) {
    const std::string file = pcd(encoding);
    for (const auto& [old_text, new_text] :
         std::vector<std::pair<std::string, std::string>>{{"POINTS 3", "POINTS 4"},
                                                          {"POINTS 3", "POINTS 3000000000"},
                                                          {"x y z", "u v w"},
                                                          {"SIZE 8", "SIZE 3"},
                                                          {"COUNT 1", "COUNT 9999999"},
                                                          {"DATA ", "DATA x"},
                                                          {"POINTS", "DATA"}}) {
      std::string changed = file;
      EXPECT_EQ(0u,
                refusal(changed.replace(changed.find(old_text), old_text.size(), new_text), ".pcd").rfind("cloud", 0));
    }
    EXPECT_EQ(0u, refusal(file.substr(0, file.size() - 9), ".pcd").rfind("cloud", 0));
    EXPECT_EQ(0u, refusal(file.substr(0, 100), ".pcd").rfind("cloud", 0));
  }
  EXPECT_NE(std::string::npos, refusal(pcd("binary_compressed"), ".pcd").find("write the file as DATA binary"))
      << "names the remedy";
  for (const std::string& file : {las(3), las(4000000000U), las(2).substr(0, 200)}) {
    EXPECT_EQ(0u, refusal(file, ".las").rfind("cloud", 0));
  }
  EXPECT_NE(std::string::npos, refusal(las(2).replace(104, 1, "\x80"), ".las").find("laszip")) << "names the remedy";
}

TEST(read_points, takes_the_format_from_the_ending)
{
  const Temporary_folder folder;
  folder.write("a.b.XYZ", "1 2 3\n-4 5.5 6e-3\n");
  Content content;
  CSCD::read_points(folder.file("a.b.XYZ"), content.points, content.normals);
  EXPECT_EQ(expected_points, content.points);
  EXPECT_THROW(CSCD::read_points(folder.file("cloud.stl"), content.points, content.normals), CSCD::File_error);
}

} // namespace
