// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of meshes read from good, mendable and malformed files.

#include "malformed_files.h"
#include "mesh_files.h"
#include "support/Temporary_folder.h"
#include "support/skip_or_fail.h"
#include "write_in_foreign_locale.h"
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/IO/write_correspondence.h>
#include <CSCD/exceptions.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace test_support;
namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Sentences = std::vector<std::string>;

struct Result
{
  Mesh mesh;
  CSCD::Mesh_repair_report report;
};

Result read(const std::string& content, const std::string& format)
{
  std::istringstream in(content);
  Result result;
  result.report = CSCD::read_triangle_mesh(in, format, "input", result.mesh);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(result.mesh));
  EXPECT_TRUE(CGAL::is_triangle_mesh(result.mesh));
  return result;
}

Result read_off(const Mesh_file_content& mesh)
{
  return read(off(mesh), ".off");
}

/// Expects the mesh to be the unit cube of 8 vertices.
void expect_cube(const Mesh& mesh)
{
  EXPECT_EQ(8u, num_vertices(mesh));
  EXPECT_EQ(12u, num_faces(mesh));
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_DOUBLE_EQ(1, PMP::volume(mesh));
}

/// The message that refuses the content; mesh stays as it was.
std::string refusal(const std::string& content, const std::string& format)
{
  std::istringstream in(content);
  Mesh mesh;
  mesh.add_vertex(Kernel::Point_3(1, 2, 3));
  try {
    CSCD::read_triangle_mesh(in, format, "input", mesh);
  } catch (const CSCD::File_error& error) {
    const std::string message = error.what();
    EXPECT_EQ(0u, message.rfind("input", 0)) << message;         // names the file
    EXPECT_NE(std::string::npos, message.find("; ")) << message; // and a remedy
    EXPECT_EQ(std::string::npos, message.find('\n')) << message;
    EXPECT_EQ(1u, num_vertices(mesh));
    return message;
  }
  ADD_FAILURE() << "accepted: " << content.substr(0, 200);
  return "";
}

/// A text and a format.
using Formatted = std::pair<std::string, std::string>;

/// The cube in all formats and their variants.
std::map<std::string, Formatted> files_of_the_cube()
{
  return {{"off", {off(cube()), ".off"}},
          {"obj", {obj(cube()), ".obj"}},
          {"ply", {ascii_ply(cube()), ".ply"}},
          {"binary ply", {binary_ply(cube(), true), ".ply"}},
          {"ply of the other byte order", {binary_ply(cube(), false), ".ply"}},
          {"stl", {ascii_stl(cube()), ".stl"}},
          {"binary stl", {binary_stl(cube(), "any text"), ".stl"}},
          {"binary stl that begins as text", {binary_stl(cube(), "solid text, though binary"), ".stl"}},
          {"vtk", {legacy_vtk(cube(), false, false), ".vtk"}},
          {"vtk with offsets", {legacy_vtk(cube(), false, true), ".vtk"}},
          {"binary vtk without offsets", {legacy_vtk(cube(), true, false), ".vtk"}},
          {"binary vtk", {legacy_vtk(cube(), true, true), ".vtk"}},
          {"vtp", {vtp(cube(), "ascii"), ".vtk"}},
          {"encoded vtp", {vtp(cube(), "binary"), ".vtk"}},
          {"raw vtp", {vtp(cube(), "appended"), ".vtk"}},
          {"vtp with encoded data behind", {vtp(cube(), "appended", "base64"), ".vtk"}},
          {"gltf", {gltf(cube()), ".glb"}},
          {"glb", {glb(cube()), ".glb"}}};
}

TEST(Read_triangle_mesh, reads_all_formats)
{
  for (const auto& [name, file] : files_of_the_cube()) {
    SCOPED_TRACE(name);
    const Result result = read(file.first, file.second);
    expect_cube(result.mesh);
    EXPECT_EQ(Sentences{}, result.report.sentences());
    EXPECT_TRUE(result.report.is_empty());
  }
}

TEST(Read_triangle_mesh, keeps_the_numbering_of_the_file)
{
  const Mesh mesh = read_off(cube()).mesh;
  for (std::size_t i = 0; i < 8; ++i) {
    const auto p = cube().points[i];
    EXPECT_EQ(Kernel::Point_3(p[0], p[1], p[2]), mesh.point(Mesh::Vertex_index(std::uint32_t(i))));
  }
  for (std::size_t f = 0; f < 12; ++f) {
    std::vector<std::size_t> corners;
    for (auto v : CGAL::vertices_around_face(mesh.halfedge(Mesh::Face_index(std::uint32_t(f))), mesh)) {
      corners.push_back(v);
    }
    const std::vector<std::size_t> expected = cube().polygons[f];
    std::rotate(corners.begin(), std::find(corners.begin(), corners.end(), expected[0]), corners.end());
    EXPECT_EQ(expected, corners);
  }
}

TEST(Read_triangle_mesh, reads_files_by_their_ending)
{
  const Temporary_folder folder;
  Mesh mesh;
  CSCD::read_triangle_mesh(folder.write("cube.off", off(cube())), mesh);
  expect_cube(mesh);
  CSCD::read_triangle_mesh(folder.write("CUBE.STL", ascii_stl(cube())), mesh);
  expect_cube(mesh);
}

TEST(Read_triangle_mesh, does_not_depend_on_the_global_locale)
{
  const Foreign_global_locale locale;
  expect_cube(read("OFF\n8 12 0\n0.0 0 0\n1.0 0 0\n1 1.0e0 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n" +
                       off(cube()).substr(off(cube()).find("3 0 3 2")),
                   ".off")
                  .mesh);
}

TEST(Read_triangle_mesh, accepts_the_variants_of_off)
{
  const std::string body = off(cube()).substr(4);
  for (const std::string& content : {
           "# a comment\nOFF # another\n\n" + body,
           "OFF " + body,
           "OFF" + body, // without a blank before the number of vertices
           " \t OFF" + body,
           "OFF\r\n8 12 0\r\n" + body.substr(body.find('\n') + 1),
       }) {
    expect_cube(read(content, ".off").mesh);
  }
  const std::string tetrahedron = "4 4 6\n0 0 0 X\n1 0 0 X\n0 1 0 X\n0 0 1 X\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  const auto with = [&tetrahedron](const std::string& keyword, const std::string& extra) {
    std::string result = keyword + "\n" + tetrahedron;
    for (std::size_t at = result.find('X'); at != std::string::npos; at = result.find('X')) {
      result.replace(at, 1, extra);
    }
    return result;
  };
  for (const auto& [keyword, extra] : {std::pair<const char*, const char*>{"COFF", "255 0 0 255"},
                                       {"NOFF", "0 0 1"},
                                       {"STOFF", "0.5 0.5"},
                                       {"STCNOFF", "0 0 1 255 0 0 0.5 0.5"},
                                       {"OFF", "255 0 0"}}) {
    EXPECT_DOUBLE_EQ(1. / 6, PMP::volume(read(with(keyword, extra), ".off").mesh)) << keyword;
  }
}

TEST(Read_triangle_mesh, accepts_the_variants_of_obj)
{
  const std::string content = "# cube\nmtllib a.mtl\no cube\n"
                              "v 0 0 0\nv +1 0 0 1.0\nv 1 1 0 0.5 0.5 0.5\nv 0 1 0\n"
                              "vt 0 0\nvn 0 0 1\ng sides\nusemtl red\ns off\n"
                              "f 1/1/1 4/1 3//1 2 # the first face\n"
                              "v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                              "f -4 -3 -2 -1\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nl 1 2\np 3\n";
  for (const std::string& variant : {content, std::string(content).replace(content.find("-4 -3"), 5, "-4 \\\r\n -3")}) {
    const Result result = read(variant, ".obj");
    expect_cube(result.mesh);
    EXPECT_EQ(6u, result.report.number_of_triangulated_polygons);
  }
}

TEST(Read_triangle_mesh, accepts_the_variants_of_ply)
{
  const std::string content =
      "ply\r\nformat ascii 1.0\r\nobj_info nothing\r\nelement material 1\r\nproperty int shininess\r\n"
      "element vertex 4\r\nproperty uchar red\r\nproperty double z\r\nproperty int y\r\nproperty short x\r\n"
      "property list uchar float tags\r\nproperty float quality\r\n"
      "element face 4\r\nproperty float weight\r\nproperty list uint ushort vertex_index\r\n"
      "element edge 1\r\nproperty int vertex1\r\nproperty int vertex2\r\nend_header\r\n"
      "7\r\n255 0 0 0 0 nan\r\n255 0 0 1 1 0.5 1\r\n255 0 1 0 2 0.5 0.5 1\r\n255 1 0 0 0 inf\r\n"
      "1 3 0 2 1\r\n1 3 0 1 3\r\n1 3 1 2 3\r\n1 3 0 3 2\r\n0 1\r\n";
  EXPECT_DOUBLE_EQ(1. / 6, PMP::volume(read(content, ".ply").mesh));
}

/// Triangles of nothing but corners are read at once; others between them must not disturb that.
TEST(Read_triangle_mesh, reads_binary_ply_of_mixed_polygons)
{
  Mesh_file_content mesh = cube();
  const Mesh_file_content squares = cube_of_squares();
  mesh.points = squares.points;
  mesh.polygons = squares.polygons;
  for (const std::size_t i : {0u, 2u, 3u, 5u}) {
    const std::vector<std::size_t> square = squares.polygons[i];
    mesh.polygons[i] = {square[0], square[1], square[2]};
    mesh.polygons.push_back({square[0], square[2], square[3]});
  }
  for (const bool is_little_endian : {true, false}) {
    const Result result = read(binary_ply(mesh, is_little_endian), ".ply");
    expect_cube(result.mesh);
    EXPECT_EQ(Sentences{"2 polygons triangulated"}, result.report.sentences());
  }
}

TEST(Read_triangle_mesh, triangulates_polygons)
{
  const Result result = read_off(cube_of_squares());
  expect_cube(result.mesh);
  EXPECT_EQ(Sentences{"6 polygons triangulated"}, result.report.sentences());
}

/// The area is that of the polygon only if no triangle lies outside of it.
TEST(Read_triangle_mesh, triangulates_polygons_that_are_not_convex)
{
  Mesh_file_content dart{{{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {1, 1, 0}}, {{0, 1, 2, 3}}};
  for (int turn = 0; turn < 4; ++turn) {
    const Result result = read_off(dart);
    EXPECT_EQ(2u, num_faces(result.mesh));
    EXPECT_DOUBLE_EQ(1, PMP::area(result.mesh));
    std::rotate(dart.polygons[0].begin(), dart.polygons[0].begin() + 1, dart.polygons[0].end());
  }
  // the letter E, which is seen whole from none of its corners
  const Mesh_file_content letter{{{0, 0, 0},
                                  {3, 0, 0},
                                  {3, 1, 0},
                                  {1, 1, 0},
                                  {1, 2, 0},
                                  {3, 2, 0},
                                  {3, 3, 0},
                                  {1, 3, 0},
                                  {1, 4, 0},
                                  {3, 4, 0},
                                  {3, 5, 0},
                                  {0, 5, 0}},
                                 {{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}}};
  const Result result = read_off(letter);
  EXPECT_EQ(10u, num_faces(result.mesh));
  EXPECT_DOUBLE_EQ(11, PMP::area(result.mesh));
  EXPECT_EQ(Sentences{"1 polygon triangulated"}, result.report.sentences());
}

TEST(Read_triangle_mesh, stitches_a_soup)
{
  Mesh_file_content soup;
  for (const auto& polygon : cube().polygons) {
    soup.polygons.push_back({soup.points.size(), soup.points.size() + 1, soup.points.size() + 2});
    for (std::size_t i : polygon) {
      soup.points.push_back(cube().points[i]);
    }
  }
  soup.points[0][0] = -0.0; // equals 0
  const Result result = read_off(soup);
  expect_cube(result.mesh);
  EXPECT_EQ(Sentences{"28 duplicate points merged"}, result.report.sentences());
}

/// The cube with corners of its own for each triangle, which lie up to `gap` apart.
Mesh_file_content cube_with_gaps(double gap)
{
  Mesh_file_content soup;
  for (const auto& polygon : cube().polygons) {
    soup.polygons.push_back({soup.points.size(), soup.points.size() + 1, soup.points.size() + 2});
    for (std::size_t i : polygon) {
      soup.points.push_back(cube().points[i]);
      soup.points.back()[soup.points.size() % 3] += gap * double(soup.points.size() % 5) / 4;
    }
  }
  return soup;
}

TEST(Read_triangle_mesh, closes_gaps_of_rounding)
{
  for (const double gap : {1e-7, 1e-17}) {
    const Result result = read(binary_ply(cube_with_gaps(gap), true), ".ply");
    EXPECT_EQ(8u, num_vertices(result.mesh));
    EXPECT_NEAR(1, PMP::volume(result.mesh), 1e-6);
    EXPECT_EQ(Sentences{"28 duplicate points merged"}, result.report.sentences());
  }
}

TEST(Read_triangle_mesh, points_of_the_file_are_found_where_gaps_were_closed)
{
  std::istringstream in(binary_ply(cube_with_gaps(1e-7), true));
  const auto manifold = CSCD::internal::make_manifold(
      CSCD::internal::read_shape(in, ".ply", "input", CSCD::internal::mesh_content), "input");
  const std::vector<CSCD::Index> vertices = CSCD::internal::vertices_of_file(
      manifold.places_in_file, manifold.triangles.points, std::vector<char>(manifold.triangles.points.size(), 1));
  EXPECT_EQ(36u, vertices.size());
  EXPECT_EQ(0, std::count(vertices.begin(), vertices.end(), CSCD::no_index));
}

TEST(Read_triangle_mesh, keeps_gaps_wider_than_rounding_and_the_points_of_borders)
{
  EXPECT_FALSE(CGAL::is_closed(read(binary_ply(cube_with_gaps(1e-5), true), ".ply").mesh));
  Mesh_file_content open = cube(); // at whose border some coordinates nearly agree
  open.polygons.resize(10);
  open.points[0][0] = 1e-9F;
  const Result result = read(binary_ply(open, true), ".ply");
  EXPECT_EQ(Sentences{}, result.report.sentences());
  EXPECT_EQ(1e-9F, result.mesh.point(Mesh::Vertex_index(0)).x());
}

TEST(Read_triangle_mesh, turns_faces_that_contradict_their_neighbors)
{
  Mesh_file_content mesh = cube();
  std::reverse(mesh.polygons[4].begin(), mesh.polygons[4].end());
  std::reverse(mesh.polygons[9].begin(), mesh.polygons[9].end());
  const Result result = read_off(mesh);
  expect_cube(result.mesh);
  EXPECT_EQ(2u, result.report.number_of_turned_faces + 10 * result.report.number_of_turned_components);
}

TEST(Read_triangle_mesh, turns_components_outwards)
{
  Mesh_file_content mesh = cube();
  for (auto& polygon : mesh.polygons) {
    std::reverse(polygon.begin(), polygon.end());
  }
  const Result result = read_off(mesh);
  expect_cube(result.mesh);
  EXPECT_EQ(Sentences{"1 component turned outwards"}, result.report.sentences());
}

TEST(Read_triangle_mesh, removes_degenerate_and_duplicate_faces)
{
  Mesh_file_content mesh = cube();
  mesh.polygons.push_back({0, 0, 1});
  mesh.polygons.push_back({mesh.polygons[3][1], mesh.polygons[3][2], mesh.polygons[3][0]});
  mesh.polygons.push_back({mesh.polygons[5][2], mesh.polygons[5][1], mesh.polygons[5][0]});
  const Result result = read_off(mesh);
  expect_cube(result.mesh);
  EXPECT_EQ(Sentences{"3 degenerate or duplicate faces removed"}, result.report.sentences());
}

TEST(Read_triangle_mesh, removes_small_flaps)
{
  // flaps of one face and of two, and doubled faces; a larger plate stays
  const auto add_fin = [](Mesh_file_content& mesh, double height) {
    mesh.points.push_back({0.5, -height, -height});
    mesh.polygons.push_back({0, 1, mesh.points.size() - 1});
  };
  Mesh_file_content mesh = cube();
  ASSERT_EQ(1, std::abs(mesh.points[1][0] - mesh.points[0][0]));
  add_fin(mesh, 0.03);
  mesh.points.push_back({1.01, -0.01, -0.01});
  mesh.polygons.push_back({1, mesh.points.size() - 2, mesh.points.size() - 1});
  const Result result = read_off(mesh);
  expect_cube(result.mesh);
  EXPECT_EQ((Sentences{"2 faces that hung on the surface removed", "2 points without faces removed"}),
            result.report.sentences());

  mesh = cube();
  add_fin(mesh, 1);
  EXPECT_EQ(13u, num_faces(read_off(mesh).mesh));
}

TEST(Read_triangle_mesh, splits_an_edge_of_four_faces)
{
  // two cubes that touch along the edge from (1, 1, 0) to (1, 1, 1)
  Mesh_file_content mesh = cube();
  for (const auto& polygon : cube().polygons) {
    mesh.polygons.emplace_back();
    for (std::size_t i : polygon) {
      auto p = cube().points[i];
      p[0] += 1;
      p[1] += 1;
      auto at = std::find(mesh.points.begin(), mesh.points.end(), p);
      mesh.polygons.back().push_back(std::size_t(at - mesh.points.begin()));
      if (at == mesh.points.end()) {
        mesh.points.push_back(p);
      }
    }
  }
  ASSERT_EQ(14u, mesh.points.size());
  const Result result = read_off(mesh);
  EXPECT_EQ(24u, num_faces(result.mesh));
  EXPECT_EQ(16u, num_vertices(result.mesh));
  EXPECT_TRUE(CGAL::is_closed(result.mesh));
  EXPECT_DOUBLE_EQ(2, PMP::volume(result.mesh));
  EXPECT_EQ(Sentences{"2 points duplicated where the surface is not a manifold"}, result.report.sentences());
}

TEST(Read_triangle_mesh, splits_a_pinched_point)
{
  // two tetrahedra that touch in point 3
  const Mesh_file_content mesh{
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 2}, {1, 0, 2}, {0, 1, 2}},
      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {4, 5, 6}, {4, 3, 5}, {5, 3, 6}, {4, 6, 3}}};
  const Result result = read_off(mesh);
  EXPECT_EQ(8u, num_vertices(result.mesh));
  EXPECT_TRUE(CGAL::is_closed(result.mesh));
  EXPECT_DOUBLE_EQ(1. / 3, PMP::volume(result.mesh));
  EXPECT_EQ(Sentences{"1 point duplicated where the surface is not a manifold"}, result.report.sentences());
}

TEST(Read_triangle_mesh, cuts_a_one_sided_surface_open)
{
  // a Moebius strip of 5 triangles on 5 points
  const Mesh_file_content strip{{{2, 0, 0}, {0, 2, 1}, {-2, 0, 0}, {0, -2, 1}, {1, -1, 2}},
                                {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}}};
  const Result result = read_off(strip);
  EXPECT_EQ(5u, num_faces(result.mesh));
  EXPECT_GT(result.report.number_of_duplicated_points, 0u);
}

/// In a closed manifold, points of equal coordinates may be meant to be apart.
TEST(Read_triangle_mesh, leaves_a_closed_manifold_alone)
{
  Mesh_file_content mesh = cube();
  const std::size_t n = mesh.points.size();
  for (const auto& polygon : cube().polygons) {
    mesh.polygons.push_back({polygon[0] + n, polygon[1] + n, polygon[2] + n});
  }
  for (auto p : cube().points) {
    p[0] += 1; // touches the first cube in a whole side
    mesh.points.push_back(p);
  }
  mesh.points.push_back({7, 7, 7}); // without a face
  std::istringstream in(off(mesh));
  Mesh result;
  EXPECT_TRUE(CSCD::read_triangle_mesh(in, ".off", "input", result).is_empty());
  EXPECT_EQ(17u, num_vertices(result));
  EXPECT_EQ(24u, num_faces(result));
}

TEST(Read_triangle_mesh, keeps_borders)
{
  Mesh_file_content mesh = cube();
  mesh.polygons.erase(mesh.polygons.begin() + 2); // has no vertex in common with the next one
  mesh.polygons.erase(mesh.polygons.begin());
  const Result result = read_off(mesh);
  EXPECT_EQ(8u, num_vertices(result.mesh));
  EXPECT_EQ(10u, num_faces(result.mesh));
  EXPECT_TRUE(result.report.is_empty());
  std::size_t number_of_border_halfedges = 0;
  for (auto h : halfedges(result.mesh)) {
    number_of_border_halfedges += is_border(h, result.mesh) ? 1 : 0;
  }
  EXPECT_EQ(6u, number_of_border_halfedges);
}

TEST(Read_triangle_mesh, refuses_malformed_files)
{
  for (const Malformed_file& file : malformed_files("meshes")) {
    refusal(file.content, file.ending);
  }
  EXPECT_EQ("input, line 4: a coordinate is not finite; correct or remove this line",
            refusal("OFF\n3 1 0\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n", ".off"));
  EXPECT_EQ("input, line 7: a face names vertex 3, but there are only 3 (counted from 0); correct this line or write "
            "the file again",
            refusal("OFF\n3 1 0\n0 0 0\n1 0 0\n\n0 1 0\n3 0 1 3\n", ".off"));
  EXPECT_EQ("input: the file has no faces; name a triangle mesh, or write the points as .xyz or .ply",
            refusal("v 0 0 0\nv 1 0 0\nv 0 1 0\n", ".obj"));
  EXPECT_EQ("input: the file is text in UTF-16; save it as UTF-8", refusal({"\xFF\xFEv\0 \0", 6}, ".obj"));
  EXPECT_EQ("input: the file is text in UTF-16; save it as UTF-8", refusal({"\xFE\xFF\0v\0 ", 6}, ".obj"));
}

/// A file of the cube, cut off behind some bytes, or with another text in the place of one.
TEST(Read_triangle_mesh, refuses_damaged_files)
{
  std::map<std::string, Formatted> files = files_of_the_cube();
  files.erase("obj"); // which may end behind any line
  for (const nlohmann::json& change : malformed_data("changed meshes")) {
    auto [text, format] = files.at(change.at("of"));
    const std::string old_text = change.at("old");
    ASSERT_NE(std::string::npos, text.find(old_text)) << change;
    refusal(text.replace(text.find(old_text), old_text.size(), change.at("new").get<std::string>()), format);
  }
  for (const auto& [name, file] : files) {
    SCOPED_TRACE(name);
    for (const std::size_t size : {std::size_t(3), std::size_t(40), std::size_t(100), file.first.size() / 2}) {
      refusal(file.first.substr(0, size), file.second);
    }
  }
  const auto changed = [&files](const std::string& name, std::size_t position, const std::string& bytes) {
    const auto& [text, format] = files.at(name);
    return refusal(std::string(text).replace(position, bytes.size(), bytes), format);
  };
  const std::size_t body = files.at("binary ply").first.find("end_header\n") + 11;
  changed("binary ply", body + 16, std::string("\0\0\xc0\x7f", 4)); // no number
  EXPECT_NE(std::string::npos, changed("binary ply", body + 8 * 12, "\xff").find("is longer than the file")); // a face
  changed("binary ply", files.at("binary ply").first.size() - 1, "\xff");
  EXPECT_NE(std::string::npos, changed("binary stl", 80, std::string("\0\x28\x6b\xee", 4)) // four billion triangles
                                   .find("triangles are announced, there is room for 12"));
  changed("binary stl", 84 + 12, std::string("\0\0\x80\x7f", 4)); // infinity
  changed("glb", 4, "\1");
  refusal(std::string(84, '\0'), ".stl");
  refusal("[]", ".glb");
  refusal("{}", ".glb");
}

TEST(Read_triangle_mesh, reads_off_with_faces_on_several_lines)
{
  std::istringstream lines(off(cube()));
  std::string text;
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line); ++number) {
    // Behind the keyword, the counts and eight points.
    std::replace(line.begin(), line.end(), ' ', number < 10 ? ' ' : '\n');
    text += line + '\n';
  }
  expect_cube(read(text, ".off").mesh);
}

TEST(Read_triangle_mesh, reads_compressed_vtp)
{
  // By zlib, in blocks of 32 bytes, as vtkXMLPolyDataWriter does in larger ones.
  const std::string content =
      "<VTKFile type=\"PolyData\" compressor=\"vtkZLibDataCompressor\"><PolyData><Piece NumberOfPoints=\"4\">"
      "<Points><DataArray type=\"Float32\" format=\"binary\">"
      "AgAAACAAAAAQAAAAEAAAAA0AAAA=eJxjYEAGDfYMaHwADo4Bf3icY2BABg32AAFPAMA="
      "</DataArray></Points><Polys><DataArray type=\"Int32\" Name=\"connectivity\" format=\"binary\">"
      "AgAAACAAAAAQAAAAGAAAABIAAAA=eJxjYGBgYAJiRgYIANHMUBokDgAAtAALeJxjZmBgYGKAAGYgBgAAZAAJ"
      "</DataArray><DataArray type=\"Int32\" Name=\"offsets\" format=\"binary\">"
      "AQAAACAAAAAQAAAAEwAAAA==eJxjZmBgYANiTiDmAWIAAQAAHw=="
      "</DataArray></Polys></Piece></PolyData></VTKFile>";
  std::istringstream in(content);
  Mesh mesh;
  try {
    CSCD::read_triangle_mesh(in, ".vtk", "input", mesh);
    EXPECT_DOUBLE_EQ(1. / 6, PMP::volume(mesh));
  } catch (const CSCD::File_error& error) { // of a build without zlib
    EXPECT_NE(std::string::npos, std::string(error.what()).find("install zlib1g-dev")) << error.what();
  }
  refusal(std::string(content).replace(content.find("vtkZLib"), 7, "vtkLZ4"), ".vtk");
}

TEST(Read_triangle_mesh, reads_what_gzip_has_compressed)
{
  // A tetrahedron in OFF, as two members of a file.
  const std::string gzipped = from_base64("H4sIAAAAAAACA/N3c+MyUTBRMOAyUABCLkMwaaBgCBUx5DIGkkZAGgBSzT"
                                          "+iKgAAAB+LCAAAAAAAAgMzVjBQMFQw5jIGkkZg2ggoYswFAHwgM/EYAAAA");
  const test_support::Temporary_folder folder;
  const auto read_part = [&](std::size_t size) {
    Mesh mesh;
    CSCD::read_triangle_mesh(folder.write("tetrahedron.off.GZ", gzipped.substr(0, size)), mesh);
    return mesh;
  };
  try {
    EXPECT_DOUBLE_EQ(1. / 6, PMP::volume(read_part(gzipped.size())));
  } catch (const CSCD::File_error& error) { // of a build without zlib
    EXPECT_NE(std::string::npos, std::string(error.what()).find("install zlib1g-dev")) << error.what();
  }
  for (const std::size_t size : {std::size_t(0), std::size_t(5), gzipped.size() / 2, gzipped.size() - 1}) {
    EXPECT_THROW(read_part(size), CSCD::File_error) << size;
  }
}

TEST(Read_triangle_mesh, nodes_of_gltf_move_meshes)
{
  const Mesh of_gltf = read(glb(cube()), ".glb").mesh;
  // (1, 0, 0) is mirrored, turned by a third of a circle around (1, 1, 1), and moved by (2, 0, 1).
  EXPECT_EQ(Kernel::Point_3(2, -1, 1), of_gltf.point(Mesh::Vertex_index(1)));
}

TEST(Read_triangle_mesh, reads_gltf_with_its_data_beside)
{
  const test_support::Temporary_folder folder;
  folder.write("the cube.bin", bytes_of<float>(coordinates(cube())) + bytes_of<std::uint32_t>(corners(cube())));
  const auto with = [&folder](const std::string& uri) {
    folder.write("cube.gltf", gltf_json(cube(), "\"uri\":\"" + uri + "\","));
    Mesh mesh;
    CSCD::read_triangle_mesh(folder.file("cube.gltf"), mesh);
    return mesh;
  };
  EXPECT_DOUBLE_EQ(1, PMP::volume(with("the cube.bin")));
  EXPECT_DOUBLE_EQ(1, PMP::volume(with("./the%20cube.bin")));
  for (const std::string uri : {"missing.bin", "", ".", "../the cube.bin", "http://a/the%20cube.bin"}) {
    EXPECT_THROW(with(uri), CSCD::File_error) << uri;
  }
  EXPECT_THROW(with(folder.file("the cube.bin")), CSCD::File_error); // not relative
}

TEST(Read_triangle_mesh, faces_of_a_repaired_mesh_are_found_in_the_file)
{
  // A face of two vertices, squares, and a corner of its own for one of them.
  CSCD::Shape_file file;
  Mesh_file_content content = cube_of_squares();
  content.points.push_back(content.points[6]);
  content.polygons[3][2] = 8;
  content.polygons.insert(content.polygons.begin() + 1, {0, 1});
  for (const auto& [x, y, z] : content.points) {
    file.points.emplace_back(x, y, z);
  }
  for (const auto& polygon : content.polygons) {
    file.corners.insert(file.corners.end(), polygon.begin(), polygon.end());
    file.end_polygon();
  }
  const auto manifold = CSCD::internal::make_manifold(CSCD::Shape_file(file), "input");
  EXPECT_EQ(1u, manifold.report.number_of_merged_points);
  const auto& triangles = manifold.triangles;
  const std::vector<CSCD::Index> faces = CSCD::internal::faces_of_polygons(file, triangles.points, triangles.faces);
  ASSERT_EQ(7u, faces.size());
  for (std::size_t polygon = 0; polygon < 7; ++polygon) {
    ASSERT_LT(faces[polygon], 12u);
    for (const CSCD::Index corner : triangles.faces[faces[polygon]]) { // each is one of the polygon
      const auto is_at = [&](CSCD::Index v) { return file.points[v] == triangles.points[corner]; };
      const auto* const first = &file.corners[file.first_corner[polygon]];
      EXPECT_TRUE(polygon == 1 || std::any_of(first, first + 4, is_at)); // that one has no face of its own
    }
  }
}

TEST(Read_triangle_mesh, reads_strips_of_vtk_and_gltf)
{
  const std::string strip =
      "# vtk DataFile Version 2.0\nstrip\nASCII\nDATASET POLYDATA\nPOINTS 4 double\n0 0 0 1 0 0 0 1 "
      "0 1 1 0\nTRIANGLE_STRIPS 1 5\n4 0 1 2 3\n";
  const Result result = read(strip, ".vtk");
  EXPECT_EQ(2u, num_faces(result.mesh));
  EXPECT_TRUE(result.report.is_empty()) << "both triangles turn the same way";
}

TEST(Read_triangle_mesh, reads_strips_of_ply)
{
  // The cube as a strip around four sides and two strips of a square.
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float "
      "z\nelement tristrips 2\nproperty list int int vertex_indices\nend_header\n";
  const std::string points = off(cube()).substr(std::string("OFF\n8 12 0\n").size());
  const std::string strips = "15 0 4 1 5 2 6 3 7 0 4 -1 0 1 3 2\n4 4 7 5 6\n";
  const Result result = read(header + points.substr(0, 8 * std::string("0 0 0\n").size()) + strips, ".ply");
  expect_cube(result.mesh);
  EXPECT_EQ(Sentences{"1 component turned outwards"}, result.report.sentences()) << "all triangles agree";
}

TEST(Read_triangle_mesh, arrays_of_vtp_that_share_data_are_counted)
{
  std::string content = "<VTKFile type='PolyData'><PolyData><Piece><Points>";
  for (int i = 0; i < 100; ++i) {
    content += "<DataArray type='Float32' format='appended' offset='0'/>";
  }
  const std::vector<std::size_t> size{12 * 10000};
  content += "</Points></Piece></PolyData><AppendedData encoding='raw'>_" + bytes_of<std::uint32_t>(size) +
             std::string(size.front(), '\0') + "</AppendedData></VTKFile>";
  EXPECT_EQ("input: the arrays are larger than the file can hold; correct or write the file again",
            refusal(content, ".vtk"));
}

TEST(Read_triangle_mesh, buffers_of_gltf_without_uri_share_the_chunk)
{
  // As copies of the chunk, these buffers would take 100 GB.
  std::string buffers;
  for (int i = 0; i < 100000; ++i) {
    buffers += ",{}";
  }
  expect_cube(read(glb(cube(), std::string(1 << 20, '\0'), buffers), ".glb").mesh);
}

TEST(Read_triangle_mesh, refuses_noise)
{
  std::mt19937 random(7);
  for (int i = 0; i < 200; ++i) {
    std::string noise;
    for (int k = 0; k < 300; ++k) {
      noise.push_back(static_cast<char>(random()));
    }
    for (const char* const format : {".off", ".obj", ".ply", ".stl", ".vtk", ".glb"}) {
      refusal(noise, format);
    }
  }
}

/// Damaged files are read or refused, and a mesh that is read is valid.
TEST(Read_triangle_mesh, survives_damaged_bytes)
{
  std::map<std::string, Formatted> files = files_of_the_cube();
  files["off"].first = off(cube_of_squares());
  files["obj"].first = obj(cube_of_squares());
  std::mt19937 random(7);
  const std::string alphabet = "0123456789 -.e\nf/v";
  for (const auto& [name, file] : files) {
    for (int i = 0; i < 300; ++i) {
      std::string damaged = file.first;
      for (int k = 0; k < 3; ++k) {
        damaged[random() % damaged.size()] = k % 2 == 0 ? alphabet[random() % alphabet.size()] : char(random());
      }
      std::istringstream in(damaged);
      Mesh mesh;
      try {
        CSCD::read_triangle_mesh(in, file.second, "input", mesh);
        EXPECT_TRUE(CGAL::is_triangle_mesh(mesh)) << name << ": " << damaged;
      } catch (const CSCD::File_error&) {
        EXPECT_EQ(0u, num_vertices(mesh));
      } catch (const CSCD::Input_error&) {
        EXPECT_EQ(0u, num_vertices(mesh));
      }
    }
  }
}

TEST(Read_triangle_mesh, refuses_files_that_cannot_be_opened)
{
  const Temporary_folder folder;
  Mesh mesh;
  for (const std::string& filename : {folder.file("missing.off"), folder.path().string() + ".off",
                                      folder.write("mesh.xyz", "0 0 0\n"), folder.write("mesh", off(cube()))}) {
    EXPECT_THROW(CSCD::read_triangle_mesh(filename, mesh), CSCD::File_error) << filename;
  }
  std::filesystem::create_directory(folder.file("folder.off"));
  EXPECT_THROW(CSCD::read_triangle_mesh(folder.file("folder.off"), mesh), CSCD::File_error);
}

/// All meshes of CGAL's data are read. Meshes that CGAL itself reads as closed triangle meshes are read equally.
TEST(Read_triangle_mesh, reads_the_meshes_of_cgal)
{
  const std::filesystem::path folder(CSCD_CGAL_DATA_DIR);
  if (!std::filesystem::exists(folder)) {
    CSCD_TEST_SKIP_OR_FAIL("CGAL's data (package libcgal-demo) is missing");
  }
  std::size_t number_of_equal_meshes = 0;
  for (const char* name :
       {"elephant.off", "eight.off", "knot1.off", "hand.off", "camel.off", "sphere.off", "cube_quad.off", "man.off",
        "blobby-shuffled.off", "cheese.off", "sphere.stl", "pig.stl", "colored_tetra.ply"}) {
    SCOPED_TRACE(name);
    const std::string filename = (folder / name).string();
    Mesh mesh;
    CSCD::Mesh_repair_report report;
    ASSERT_NO_THROW(report = CSCD::read_triangle_mesh(filename, mesh));
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
    Mesh expected;
    if (report.is_empty() && CGAL::IO::read_polygon_mesh(filename, expected) && CGAL::is_closed(expected)) {
      ++number_of_equal_meshes;
      EXPECT_EQ(num_vertices(expected), num_vertices(mesh));
      EXPECT_EQ(num_faces(expected), num_faces(mesh));
      EXPECT_NEAR(PMP::volume(expected), PMP::volume(mesh), 1e-12 * std::abs(PMP::volume(expected)));
    }
  }
  EXPECT_GE(number_of_equal_meshes, 5u);
}

} // namespace
