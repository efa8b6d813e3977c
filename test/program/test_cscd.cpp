// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of the program cscd as its users see it: arguments, exit status, messages, files.

#include "IO/mesh_files.h"
#include "program/Cscd.h"
#include "support/Shape.h"
#include "support/Temporary_folder.h"
#include "support/limb_shapes.h"
#include "support/shape_operations.h"
#include "support/simple_shapes.h"
#include "support/skip_or_fail.h"
#include <CSCD/version.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace test_support;
using CSCD::test::Shape, CSCD::test::Triple;

/// Whether `text` holds a graph of GEL of one cycle.
bool is_graph_of_a_cycle(const std::string& text)
{
  std::istringstream in(text);
  std::size_t number_of_nodes = 0;
  std::size_t number_of_edges = 0;
  for (std::string line; std::getline(in, line);) {
    number_of_nodes += line.rfind("n ", 0) == 0 ? 1 : 0;
    number_of_edges += line.rfind("c ", 0) == 0 ? 1 : 0;
  }
  return number_of_nodes >= 3 && number_of_nodes == number_of_edges;
}

/// The number of sites that belong to the nodes of a skeleton.
std::size_t number_of_sites(const nlohmann::json& skeleton)
{
  std::size_t result = 0;
  for (const nlohmann::json& node : skeleton.at("nodes")) {
    result += node.at("number_of_sites").get<std::size_t>();
  }
  return result;
}

TEST_F(Cscd, help_begins_with_examples)
{
  for (const char* arguments : {"--help", "-h", "skeletonize --help"}) {
    const Outcome outcome = run_well(arguments);
    EXPECT_EQ(0u, outcome.out.rfind("Examples:\n", 0)) << outcome.out;
    EXPECT_EQ("", outcome.err);
  }
  EXPECT_NE(std::string::npos, run("skeletonize --help").out.find("--separators"));
  EXPECT_NE(std::string::npos, run("evaluate --help").out.find("--radii"));
  EXPECT_NE(std::string::npos, run("compare --help").out.find("--match-distance"));
}

TEST_F(Cscd, help_of_skeletonize_is_grouped_and_fits_on_a_page)
{
  const std::string help = run("skeletonize --help").out;
  std::size_t place = 0;
  for (const std::string group : {"Input", "Skeleton", "Detail", "Output", "Volumes", "Trees", "Expert"}) {
    const std::size_t next = help.find("\n" + group + ":\n");
    ASSERT_NE(std::string::npos, next) << group;
    EXPECT_LT(place, next) << group;
    place = next;
  }
  std::istringstream in(help);
  std::size_t number_of_lines = 0;
  for (std::string line; std::getline(in, line); ++number_of_lines) {
    EXPECT_LE(line.size(), 120u) << line;
  }
  EXPECT_LT(number_of_lines, 70u);
}

TEST_F(Cscd, diameter_of_each_vertex_in_the_order_of_the_file)
{
  run_well("diameter torus.off -o torus.txt");
  std::istringstream values(content("torus.txt"));
  std::size_t number = 0;
  for (double value = 0; values >> value; ++number) {
    EXPECT_NEAR(value, 2, 0.2); // the tube has radius 1
  }
  EXPECT_EQ(number, torus().points.size());
  EXPECT_EQ(run("diameter - --format off -o - < torus.off").out, content("torus.txt"));
  expect_refusal("diameter torus.off", 1, {"--output"});
  expect_refusal("diameter torus.off -o torus.off", 1, {"is the input"});
  expect_refusal("diameter missing.off -o a.txt", 2, {"missing.off"});
}

TEST_F(Cscd, part_of_each_face_in_the_order_of_the_file)
{
  for (const std::string options : {"", "--parts 4"}) {
    const Outcome outcome = run_well("segment torus.off -o torus.seg " + options);
    EXPECT_NE(std::string::npos, outcome.out.find(" parts\n"));
    std::istringstream values(content("torus.seg"));
    std::set<std::size_t> parts;
    std::size_t number = 0;
    for (std::size_t part = 0; values >> part; ++number) {
      parts.insert(part);
    }
    EXPECT_EQ(number, torus().polygons.size());
    EXPECT_EQ(*parts.rbegin() + 1, parts.size());
    if (options == "--parts 4") {
      EXPECT_EQ(parts.size(), 4u);
    }
  }
  expect_refusal("segment torus.off -o a.seg --parts 0", 1, {"--parts"});
}

/// Points that are named twice, squares and faces without area change the mesh, not the output.
TEST_F(Cscd, results_follow_the_file_although_the_mesh_was_repaired)
{
  Mesh_file_content mesh = torus();
  m_folder.write("torus.off", off(mesh));
  const std::size_t number_of_points = mesh.points.size();
  mesh.polygons.insert(mesh.polygons.begin(), {mesh.polygons[0][0], mesh.polygons[0][0], mesh.polygons[0][1]});
  mesh.polygons.insert(mesh.polygons.begin() + 5, {mesh.polygons[9][0], mesh.polygons[9][1]});
  mesh.points.insert(mesh.points.begin(), mesh.points.back()); // without a face
  for (auto& polygon : mesh.polygons) {
    for (std::size_t& corner : polygon) {
      ++corner;
    }
  }
  m_folder.write("repaired.off", off(mesh));
  const auto lines = [&](const std::string& command, const std::string& input, const std::string& output) {
    run_well(command + ' ' + input + " -o " + output);
    std::istringstream values(content(output));
    return std::vector<double>(std::istream_iterator<double>(values), {});
  };
  std::vector<double> diameters = lines("diameter", "repaired.off", "repaired.txt");
  ASSERT_EQ(diameters.size(), number_of_points + 1);
  EXPECT_GT(diameters.front(), 0); // there is a vertex at its place
  diameters.erase(diameters.begin());
  EXPECT_EQ(diameters, lines("diameter", "torus.off", "torus.txt"));
  std::vector<double> parts = lines("segment --parts 3", "repaired.off", "repaired.seg");
  ASSERT_EQ(parts.size(), mesh.polygons.size());
  parts.erase(parts.begin() + 5);
  parts.erase(parts.begin());
  EXPECT_EQ(parts, lines("segment --parts 3", "torus.off", "torus.seg"));
}

TEST_F(Cscd, loops_are_written_by_kind_and_format)
{
  run_well("loops torus.off -o loops.json");
  std::vector<std::string> kinds;
  for (const auto& loop : json("loops.json")) {
    EXPECT_GT(loop.at("length").get<double>(), 0);
    EXPECT_GE(loop.at("points").size(), 3U);
    EXPECT_EQ(3U, loop.at("points").at(0).size());
    kinds.push_back(loop.at("kind"));
  }
  EXPECT_EQ((std::vector<std::string>{"handle", "tunnel"}), kinds);
  EXPECT_EQ(2U, nlohmann::json::parse(run("loops torus.off -o -").out).size());
  EXPECT_NE(std::string::npos, run("loops torus.off -o loops.obj").out.find("2 loops"));
  EXPECT_NE(std::string::npos, content("loops.obj").find("\nl 1 2 3 "));
  EXPECT_NE(std::string::npos, run("loops torus.off -o loops.html").out.find("2 loops"));
  const std::string page = content("loops.html");
  const std::string begin = "\"separator_offsets\":[\"u\",\"";
  const std::size_t offsets = page.find(begin) + begin.size();
  EXPECT_EQ(offsets + 16, page.find('"', offsets)); // three numbers in base 64: two curves, and the end
  expect_refusal("loops torus.off -o a.txt", 1, {".obj"});
  expect_refusal("loops torus.off -o a.json --min-depth deep", 1, {"--min-depth"});
  expect_refusal("loops torus.off", 1, {"--output"});
}

TEST_F(Cscd, skeletonizes_without_the_name_of_a_command)
{
  m_folder.write("segment", off(torus())); // commands come first
  EXPECT_EQ(run("skeletonize torus.off -o -").out, run("torus.off -o -").out);
  EXPECT_TRUE(is_graph_of_a_cycle(run("-o - torus.off").out));
  EXPECT_TRUE(is_graph_of_a_cycle(run("- --format off -o - < torus.off").out));
  EXPECT_TRUE(is_graph_of_a_cycle(run("./segment --format off -o -").out));
  expect_refusal("missing.off", 2, {"missing.off: cannot be opened"});
}

TEST_F(Cscd, prints_its_version)
{
  const Outcome outcome = run_well("--version");
  EXPECT_EQ("cscd " CSCD_VERSION "\n", outcome.out);
  std::ostringstream numbers;
  numbers << CSCD_VERSION_MAJOR << '.' << CSCD_VERSION_MINOR << '.' << CSCD_VERSION_PATCH;
  EXPECT_EQ(CSCD_VERSION, numbers.str());
}

TEST_F(Cscd, refuses_bad_usage)
{
  expect_refusal("", 1, {"input", "command", "skeletonize, evaluate", "--help"});
  expect_refusal("skeletonise torus.off", 1, {"skeletonise: is neither", "skeletonize, evaluate", "--help"});
  expect_refusal("batch torus.off", 1, {"batch: is neither"});
  expect_refusal("torus.off --bad", 1, {"--bad"});
  expect_refusal("skeletonize", 1, {"INPUT"});
  expect_refusal("skeletonize torus.off --bad", 1, {"--bad"});
  expect_refusal("skeletonize torus.off second.off", 1, {"second.off"});
  expect_refusal("skeletonize torus.off -o", 1, {"--output"});
  expect_refusal("skeletonize torus.off --method unheard_of", 1, {"--method", "unheard_of"});
  expect_refusal("skeletonize torus.off --literal", 1, {"--literal", "the local method", "add --method published"});
  expect_refusal("skeletonize torus.off --detail 0.3 --method published", 1, {"--detail", "the published method"});
  expect_refusal("skeletonize torus.off --seed x", 1, {"--seed", "x"});
  expect_refusal("skeletonize torus.off --seed -1", 1, {"--seed"});
  expect_refusal("skeletonize torus.off --threads 0", 1, {"--threads"});
  expect_refusal("skeletonize torus.off --separators -5", 1, {"--separators"});
  expect_refusal("skeletonize torus.off --format dxf", 1, {"--format", "dxf"});
  expect_refusal("skeletonize torus.off -o torus.graph -o torus.doc", 1, {"torus.doc", ".graph .json", "--help"});
  expect_refusal("skeletonize - < torus.off", 1, {"--format"});
  expect_refusal("skeletonize torus.off --report ''", 1, {"--report"});
  expect_refusal("skeletonize torus.off -o - --report -", 1, {"standard output"});
  EXPECT_EQ(1, m_folder.number_of_files());
}

TEST_F(Cscd, names_the_bounds_of_numbers_shortly)
{
  for (const std::string option : {"--separators", "--threads"}) {
    const Outcome outcome = run("skeletonize torus.off " + option + " 0");
    EXPECT_EQ(1, outcome.status);
    EXPECT_GT(150u, outcome.err.size()) << outcome.err;
  }
}

TEST_F(Cscd, refuses_to_overwrite_its_input)
{
  m_folder.write("torus.obj", obj(torus()));
  std::filesystem::create_symlink("torus.obj", m_folder.path() / "link.obj");
  for (const char* output : {"-o torus.obj", "-o ./torus.obj", "-o link.obj", "--report torus.obj"}) {
    expect_refusal(std::string("skeletonize torus.obj ") + output, 1, {"is the input", "name another file"});
  }
  expect_refusal("skeletonize link.obj -o torus.obj", 1, {"is the input"});
  EXPECT_EQ(obj(torus()), content("torus.obj"));
}

TEST_F(Cscd, shows_control_characters_of_file_names_as_escape_sequences)
{
  expect_refusal("skeletonize \"$(printf 'a\\tb\\033c.off')\"", 2, {"a\\tb\\x1bc.off: cannot be opened"});
}

TEST_F(Cscd, refuses_bad_input)
{
  m_folder.write("empty.off", "");
  m_folder.write("truncated.off", off(torus()).substr(0, 3000));
  m_folder.write("points.ply", ply_header({cube().points, {}}, "ascii") + "0 0 0\n");
  m_folder.write("torus.xyz", "0 0 0\n");
  m_folder.write("torus.doc", "0 0 0\n");
  m_folder.write("flat.off", "OFF\n3 1 0\n1 1 1\n1 1 1\n1 1 1\n3 0 1 2\n");
  expect_refusal("skeletonize missing.off -o a.graph", 2, {"missing.off: cannot be opened", "; check"});
  expect_refusal("skeletonize empty.off -o a.graph", 2, {"empty.off: the file is empty; "});
  expect_refusal("skeletonize truncated.off -o a.graph", 2, {"truncated.off", "; "});
  expect_refusal("skeletonize points.ply -o a.graph", 2, {"points.ply", "; "});
  expect_refusal("skeletonize torus.xyz -o a.graph", 2, {"torus.xyz: ", "same place", "; "});
  expect_refusal("skeletonize torus.doc -o a.graph", 2, {"torus.doc: ", ".off .obj .ply .stl", ".xyz"});
  expect_refusal("skeletonize flat.off -o a.graph", 2, {"flat.off"});
  expect_refusal("skeletonize . -o a.graph", 2, {"."});
  expect_refusal("skeletonize - --format off -o a.graph < empty.off", 2, {"standard input", "; "});
  expect_refusal("skeletonize - --format off.gz -o a.graph < empty.off", 2, {"standard input", "the file is empty"});
  expect_refusal("skeletonize torus.off --format stl -o a.graph", 2, {"torus.off", "STL"});
  EXPECT_EQ(7, m_folder.number_of_files());
}

TEST_F(Cscd, refuses_outputs_that_cannot_be_written)
{
  expect_refusal("skeletonize torus.off -o missing/a.graph", 2, {"missing/a.graph: cannot be written", "; check"});
  expect_refusal("skeletonize torus.off --report missing/a.json", 2, {"missing/a.json: cannot be written"});
  expect_refusal("skeletonize torus.off -o missing/a.html", 2, {"missing/a.html: cannot be written"});
  EXPECT_EQ(1, m_folder.number_of_files());
}

TEST_F(Cscd, skeletonizes_points)
{
  std::string xyz;
  for (const auto& p : torus().points) {
    xyz += std::to_string(p[0]) + ' ' + std::to_string(p[1]) + ' ' + std::to_string(p[2]) + '\n';
  }
  m_folder.write("torus.xyz", xyz);
  const Outcome published = run_well("skeletonize torus.xyz --method published --separators 32 --report p.json -o -");
  EXPECT_TRUE(is_graph_of_a_cycle(published.out));
  EXPECT_EQ("published", json("p.json").at("method"));
  m_folder.write("torus.off", off({torus().points, {}}));
  for (const char* name : {"torus.xyz", "torus.off", "- --format xyz < torus.xyz"}) {
    const Outcome outcome = run_well(std::string("skeletonize -o t.graph --report r.json -o t.html ") + name);
    EXPECT_NE(std::string::npos, outcome.out.find("1776 points, 1 component, genus 1")) << outcome.out;
    EXPECT_TRUE(is_graph_of_a_cycle(content("t.graph")));
    const nlohmann::json report = json("r.json");
    EXPECT_EQ(1776, report.at("number_of_sites"));
    EXPECT_EQ(16, report.at("reconstruction").at("number_of_neighbors"));
    EXPECT_LT(0, report.at("reconstruction").at("spacing"));
    EXPECT_EQ(0, report.at("reconstruction").at("cut_handles").size());
  }
}

/// A cross with radii: from node 0, of radius 2, limbs of radius 1 and of lengths 20, 20, 6 and 1.5; and a node apart.
constexpr const char* cross = R"({"nodes": [{"point": [0, 0, 0], "radius": 2}, {"point": [20, 0, 0], "radius": 1},
  {"point": [-20, 0, 0], "radius": 1}, {"point": [0, 6, 0], "radius": 1}, {"point": [0, 0, 1.5], "radius": 1},
  {"point": [0, 10, 0], "radius": 1}], "edges": [[0, 1], [0, 2], [0, 3], [0, 4]]})";

/// Four strips of the bark of a pole of one limb, too few for a surface.
std::string pole()
{
  std::string xyz;
  const auto add = [&xyz](double x, double y, double z) {
    xyz += std::to_string(x) + ' ' + std::to_string(y) + ' ' + std::to_string(z) + '\n';
  };
  for (int i = 0; i <= 300; ++i) {
    const double t = 0.02 * i;
    for (int side = -1; side <= 1; side += 2) {
      add(0.05 * side, 0, t);
      add(0, 0.05 * side, t);
      if (i >= 5 && i < 100) {
        add(t, 0.03 * side, 3 + 0.4 * t);
      }
    }
  }
  return xyz;
}

TEST_F(Cscd, says_what_the_numbers_behind_coordinates_are)
{
  std::ostringstream normals;
  std::ostringstream colors;
  for (const auto& [x, y, z] : torus().points) {
    const double ring = std::hypot(x, y);
    const double share = (ring - 3) / ring; // of the radial direction in the normal, as the tube has radius 1
    normals << x << ' ' << y << ' ' << z << ' ' << share * x << ' ' << share * y << ' ' << z << '\n';
    colors << x << ' ' << y << ' ' << z << ' ' << std::abs(int(10 * x)) << " 128 0\n";
  }
  m_folder.write("normals.xyz", normals.str());
  m_folder.write("colors.xyz", colors.str());
  const Outcome with_normals = run("skeletonize normals.xyz -o a.graph");
  EXPECT_NE(std::string::npos, with_normals.out.find("1776 points with normals, ")) << with_normals.out;
  EXPECT_EQ(std::string::npos, with_normals.err.find("colors"));
  const Outcome with_colors = run("skeletonize colors.xyz -o b.graph");
  EXPECT_NE(std::string::npos, with_colors.out.find("1776 points, ")) << with_colors.out;
  EXPECT_NE(std::string::npos,
            with_colors.err.find("colors.xyz: three numbers behind the coordinates are not normals"));
}

TEST_F(Cscd, lists_the_openings_of_points)
{
  std::ostringstream tube; // open at both ends
  for (int i = 0; i < 60; ++i) {
    for (int j = 0; j < 24; ++j) {
      const double angle = (2 * j + i % 2) * CSCD::test::pi / 24;
      tube << 0.26 * i << ' ' << std::cos(angle) << ' ' << std::sin(angle) << '\n';
    }
  }
  m_folder.write("tube.xyz", tube.str());
  run_well("skeletonize tube.xyz --report t.json --branches t.csv -q");
  const nlohmann::json report = json("t.json");
  EXPECT_EQ(2, report.at("number_of_openings"));
  EXPECT_EQ(2u, report.at("openings").size());
  EXPECT_NE(std::string::npos, content("t.csv").find(",opening,opening,")) << content("t.csv");
}

TEST_F(Cscd, skeletonizes_trees)
{
  m_folder.write("pole.xyz", pole());
  const Outcome outcome = run_well("skeletonize pole.xyz --shape tree -o t.swc --report r.json -o t.html");
  EXPECT_NE(std::string::npos, outcome.out.find(" points, 1 tree\n")) << outcome.out;
  const nlohmann::json report = json("r.json");
  EXPECT_EQ("tree", report.at("method"));
  EXPECT_EQ(1, report.at("number_of_objects"));
  const nlohmann::json& limbs = report.at("limbs");
  ASSERT_EQ(2u, limbs.size());
  EXPECT_TRUE(limbs[0].at("parent").is_null());
  EXPECT_EQ(0, limbs[0].at("order"));
  EXPECT_NEAR(6, limbs[0].at("length").get<double>(), 0.1);
  EXPECT_EQ(0, limbs[1].at("parent"));
  EXPECT_EQ(1, limbs[1].at("order"));
  EXPECT_NE(std::string::npos, content("t.swc").find(" -1\n"));
  EXPECT_NE(std::string::npos, content("t.html").find("treated as a scan of trees"));
}

std::size_t number_of_lines(const std::string& text)
{
  return std::size_t(std::count(text.begin(), text.end(), '\n'));
}

TEST_F(Cscd, measures_trees)
{
  m_folder.write("pole.xyz", pole());
  const Outcome outcome =
      run_well("skeletonize pole.xyz --shape tree --report r.json --branches b.csv --cylinders c.csv "
               "-o t.json -o t.vtp --correspondence t.csv --breast-height 2");
  const nlohmann::json report = json("r.json");
  // The limb leaves in the middle: two branches of the trunk and itself, by the same numbers everywhere.
  ASSERT_EQ(3u, report.at("branches").size());
  EXPECT_EQ(4u, number_of_lines(content("b.csv")));
  const nlohmann::json branches = json("t.json").at("branches");
  for (std::size_t b = 0; b < branches.size(); ++b) {
    EXPECT_EQ(branches[b].at("nodes"), report["branches"][b].at("nodes"));
    EXPECT_EQ(report["branches"][b].at("order"), b == 0 ? 0 : 1);
    EXPECT_TRUE(report["branches"][b].contains("limb"));
  }
  const nlohmann::json& tree = report.at("trees").at(0);
  EXPECT_NEAR(6, tree.at("height").get<double>(), 0.1);
  EXPECT_NEAR(0.1, tree.at("diameter_at_breast_height").get<double>(), 0.03);
  EXPECT_LT(tree.at("trunk_volume"), tree.at("volume"));
  EXPECT_EQ(0u, content("c.csv").rfind("radius_m,length_m,start_X", 0));
  EXPECT_LT(5u, number_of_lines(content("c.csv")));
  EXPECT_EQ(number_of_lines(pole()) + 1, number_of_lines(content("t.csv")));
  EXPECT_EQ(std::string::npos, content("t.csv").find(",,")) << "a point without a node";
}

TEST_F(Cscd, writes_the_table_of_branches)
{
  m_folder.write("y.off", off(file_content(CSCD::test::y_tube(0.2))));
  run_well("skeletonize y.off --branches b.csv --report r.json --root thickest -q");
  const nlohmann::json branches = json("r.json").at("branches");
  ASSERT_EQ(3u, branches.size());
  for (const nlohmann::json& branch : branches) {
    EXPECT_EQ((std::vector<std::string>{"junction", "tip"}), [&] {
      auto ends = branch.at("ends").get<std::vector<std::string>>();
      std::sort(ends.begin(), ends.end());
      return ends;
    }());
    EXPECT_LT(0, branch.at("volume"));
    EXPECT_LT(0, branch.at("surface_area"));
    EXPECT_TRUE(branch.contains("order"));
  }
  EXPECT_EQ(4u, number_of_lines(content("b.csv")));
  EXPECT_EQ(content("b.csv"), run("skeletonize y.off --branches - --root thickest").out);
  run_well("skeletonize y.off --nodes n.csv -o y.json -q");
  EXPECT_EQ(0u, content("n.csv").rfind("node,x,y,z,degree,branch,radius,number_of_sites,inscribed_radius,section_", 0));
  EXPECT_EQ(json("y.json").at("nodes").size() + 1, number_of_lines(content("n.csv")));
  expect_refusal("skeletonize y.off --cylinders c.csv", 1, {"--cylinders", "does not apply to meshes"});
  expect_refusal("skeletonize y.off --branches y.off", 1, {"--branches", "is the input"});
}

TEST_F(Cscd, writes_which_node_each_vertex_belongs_to)
{
  // A soup of the triangles of a tube: each corner is a point of its own; and a point without faces before all others.
  const Mesh_file_content mesh = file_content(CSCD::test::y_tube(0.2));
  Mesh_file_content soup;
  soup.points.push_back({9, 9, 9});
  for (const auto& polygon : mesh.polygons) {
    soup.polygons.emplace_back();
    for (const std::size_t corner : polygon) {
      soup.polygons.back().push_back(soup.points.size());
      soup.points.push_back(mesh.points[corner]);
    }
  }
  soup.polygons.push_back(soup.polygons.front()); // makes a repair of the soup necessary, too
  m_folder.write("y.off", off(mesh));
  m_folder.write("soup.off", off(soup));
  run_well("skeletonize y.off --correspondence y.csv -q");
  const Outcome outcome = run_well("skeletonize soup.off --correspondence soup.csv");
  EXPECT_NE(std::string::npos, outcome.err.find("1 vertex of " + std::to_string(soup.points.size()))) << outcome.err;
  EXPECT_NE(std::string::npos, outcome.err.find("duplicate points merged")) << outcome.err;

  EXPECT_EQ(mesh.points.size() + 1, number_of_lines(content("y.csv")));
  EXPECT_EQ(soup.points.size() + 1, number_of_lines(content("soup.csv")));
  std::istringstream in(content("soup.csv"));
  std::string line;
  std::getline(in, line);
  EXPECT_EQ("vertex,node,branch", line);
  std::getline(in, line);
  EXPECT_EQ("0,,", line);
  std::map<std::array<double, 3>, std::string> node_at;
  for (std::size_t v = 1; std::getline(in, line); ++v) {
    const std::string label = line.substr(line.find(',') + 1);
    EXPECT_EQ(std::to_string(v), line.substr(0, line.find(',')));
    EXPECT_EQ(label, node_at.emplace(soup.points.at(v), label).first->second); // the same wherever the point is
    EXPECT_NE(',', label.front());
  }
  EXPECT_EQ(mesh.points.size(), node_at.size());
}

TEST_F(Cscd, wraps_parts_that_cut_each_other)
{
  const Shape capsule = CSCD::test::capsule(8, 1, 24);
  const Shape across = moved(capsule, [](const Triple& p) { return Triple{4 - p[2], p[1], p[0] - 4}; });
  const Shape parts = CSCD::test::merged("", {capsule, across});
  m_folder.write("parts.off", off(file_content(parts)));
  run_well("skeletonize parts.off --report parts.json -q");
  EXPECT_EQ(2, json("parts.json").at("number_of_skeleton_components"));
  run_well("skeletonize parts.off --wrap 0.03 --report wrap.json --correspondence wrap.csv");
  EXPECT_EQ(0.03, json("wrap.json").at("wrap"));
  EXPECT_EQ(1, json("wrap.json").at("number_of_skeleton_components"));
  EXPECT_EQ(4, json("wrap.json").at("number_of_tips"));
  EXPECT_EQ(0, json("wrap.json").at("number_of_edges_outside"));
  EXPECT_EQ(parts.points.size() + 1, number_of_lines(content("wrap.csv")));
  EXPECT_EQ(std::string::npos, content("wrap.csv").find(",,")) << "a vertex without a node";

  m_folder.write("pole.xyz", pole());
  expect_refusal("skeletonize pole.xyz --wrap 0.03", 1, {"--wrap", "does not apply to points", "leave it out"});
  expect_refusal("skeletonize parts.off --as graph --wrap 0.03", 1, {"--wrap", "does not apply to graphs"});
  expect_refusal("skeletonize parts.off --wrap 0", 1, {"--wrap"});
}

TEST_F(Cscd, writes_swc_for_readers_of_neurons)
{
  for (const std::string root : {"3,0,0", "thickest", "lowest", "longest", "-3,0,0.5"}) {
    run_well("skeletonize torus.off -o t.SWC -q --swc-type 3 --swc-scale 10 --root " + root);
    const std::string text = content("t.SWC");
    EXPECT_NE(std::string::npos, text.find("\n1 3 ")) << text;
    EXPECT_NE(std::string::npos, text.find("\n# loop ")) << text;
  }
  m_folder.write("cross.json", cross);
  run_well("simplify cross.json -o n.swc -q --swc-type 2 --soma 2");
  EXPECT_NE(std::string::npos, content("n.swc").find("\n1 1 0 0 0 2 -1\n")) << content("n.swc");
  for (const std::string option : {"--root thinnest", "--root 1,2", "--root 1,2,x", "--root 1,2,3,4", "--swc-type 8",
                                   "--swc-scale 0", "--soma -1"}) {
    expect_refusal("skeletonize torus.off -o t.swc " + option, 1, {option.substr(0, option.find(' '))});
  }
}

TEST_F(Cscd, recognizes_trees)
{
  m_folder.write("pole.xyz", pole());
  const Outcome outcome = run_well("skeletonize pole.xyz -o t.graph --root 0,0,6 --report r.json");
  EXPECT_NE(std::string::npos, outcome.err.find("treated as a scan of trees")) << outcome.err;
  EXPECT_EQ("tree", json("r.json").at("method"));
  double x = 1;
  double y = 1;
  double z = 0;
  std::istringstream(content("t.graph").substr(1)) >> x >> y >> z;
  EXPECT_NEAR(6, z, 0.2);
}

TEST_F(Cscd, refuses_shapes_that_do_not_fit)
{
  m_folder.write("pole.xyz", pole());
  expect_refusal("skeletonize torus.off --shape tree", 1, {"--shape tree", "does not apply to meshes", "leave it out"});
  expect_refusal("skeletonize pole.xyz --shape bush", 1, {"--shape"});
  expect_refusal("skeletonize pole.xyz --root 0,0", 1, {"--root"});
  expect_refusal("skeletonize pole.xyz --shape tree --method published", 1, {"--method published"});
}

TEST_F(Cscd, simplifies_skeletons)
{
  m_folder.write("cross.json", cross);
  const auto tips_after = [&](const std::string& options) {
    const Outcome outcome = run_well("simplify cross.json -o t.json " + options);
    EXPECT_EQ("", outcome.err);
    EXPECT_NE(std::string::npos, outcome.out.find("\nskeleton: ")) << outcome.out;
    const nlohmann::json nodes = json("t.json").at("nodes");
    return std::count_if(nodes.begin(), nodes.end(), [](const auto& node) { return node.at("degree") == 1; });
  };
  EXPECT_EQ(4, tips_after("")); // as it is
  EXPECT_EQ(3, tips_after("--min-significance 1"));
  EXPECT_EQ(2, tips_after("--min-significance 100"));
  EXPECT_EQ(3, tips_after("--min-length 2"));
  EXPECT_EQ(2, tips_after("--min-length-over-radius 5"));
  EXPECT_EQ(3, tips_after("--min-significance 1 --join")); // the tip of 6 is joined to the node apart
  EXPECT_EQ(1u, json("t.json").at("joined_edges").size());
  EXPECT_EQ(4, tips_after("--min-component 2 --spacing 0.5r"));
  EXPECT_LT(50u, json("t.json").at("nodes").size());
  EXPECT_EQ(4, tips_after("--spacing 2"));

  // Significance is written, and computing it from the written file gives the same.
  const nlohmann::json branches = json("t.json").at("branches");
  run_well("simplify t.json -o second.json -q");
  EXPECT_EQ(branches, json("second.json").at("branches"));
  run_well("simplify t.json -o t.graph -o t.swc -o t.vtp -o t.ply -o t.obj -o t.polylines.txt -q");
  for (const std::string name : {"t.graph", "t.swc", "t.vtp", "t.ply", "t.obj", "t.polylines.txt"}) {
    run_well("simplify " + name + " -o u.json --min-length 2");
    const nlohmann::json nodes = json("u.json").at("nodes");
    EXPECT_EQ(3, std::count_if(nodes.begin(), nodes.end(), [](const auto& n) { return n.at("degree") == 1; })) << name;
    EXPECT_EQ(name == "t.swc" || name == "t.ply" || name == "t.vtp", nodes[0].contains("radius")) << name;
  }
  const Outcome piped = run_well("simplify - -o - --min-length 10 < t.graph");
  EXPECT_EQ(0u, piped.out.rfind("n ", 0)) << piped.out;
}

TEST_F(Cscd, leaves_nodes_out_at_a_spacing)
{
  const auto number_of_nodes = [&](const std::string& arguments) {
    run_well("skeletonize torus.off -o torus.json " + arguments);
    return json("torus.json").at("nodes").size();
  };
  EXPECT_EQ(number_of_nodes("--spacing 2"), number_of_nodes("--spacing 2r"));
  EXPECT_LT(number_of_nodes("--spacing 2"), number_of_nodes(""));
}

TEST_F(Cscd, refuses_simplifications_that_make_no_sense)
{
  m_folder.write("cross.json", cross);
  m_folder.write("cross.graph", "n 0 0 0\nn 1 0 0\nc 0 1\n");
  m_folder.write("cloud.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n");
  expect_refusal("simplify cross.json", 1, {"--output"});
  expect_refusal("simplify cross.json -o cross.json", 1, {"is the input", "name another file"});
  expect_refusal("simplify cross.json -o cloud.off --mesh cloud.off", 1, {"cloud.off"});
  expect_refusal("simplify cross.json -o a.doc", 1, {"a.doc", ".graph .json"});
  expect_refusal("simplify cross.dot -o a.json", 1, {"cross.dot"});
  expect_refusal("simplify cross.json -o a.glb", 1, {"a.glb"});
  expect_refusal("simplify cross.json -o a.json --spacing -1", 1, {"--spacing", "-1"});
  expect_refusal("simplify cross.json -o a.json --spacing 1x", 1, {"--spacing", "1x"});
  expect_refusal("simplify cross.json -o a.json --spacing r", 1, {"--spacing"});
  expect_refusal("simplify cross.json -o a.json --min-significance nan", 1, {"--min-significance"});
  expect_refusal("simplify cross.json -o a.json --min-length 1r", 1, {"--min-length"});
  expect_refusal("simplify cross.json -o a.json --min-component 0", 1, {"--min-component"});
  expect_refusal("simplify cross.json -o - -o -", 1, {"standard output"});
  expect_refusal("simplify missing.json -o a.json", 2, {"missing.json"});
  expect_refusal("simplify cross.graph -o a.json --min-significance 1", 2, {"cross.graph", "no radii"});
  expect_refusal("simplify cross.json -o a.json --spacing 1e-9", 2, {"cross.json", "ten million"});
  expect_refusal("simplify cross.json -o a.json --mesh cloud.off -q", 2, {"cloud.off", "no faces"});
  EXPECT_EQ(4, m_folder.number_of_files());
}

TEST_F(Cscd, joins_fragments_and_leaves_out_dust)
{
  // A torus, a second one next to it, and a cube far away.
  const Shape ring = CSCD::test::torus(3, 1, 24);
  const Shape three = CSCD::test::merged(
      "", {ring, CSCD::test::translated(ring, {10, 0, 0}), CSCD::test::translated(CSCD::test::cube(), {20, 0, 0})});
  m_folder.write("three.off", off(file_content(three)));
  run_well("skeletonize three.off -o t.json --report r.json -q");
  nlohmann::json report = json("r.json");
  EXPECT_EQ(3, report.at("number_of_skeleton_components"));
  EXPECT_FALSE(report.contains("fragments"));
  const nlohmann::json written = json("t.json");
  for (const nlohmann::json& branch : written.at("branches")) {
    nlohmann::json same = report.at("branches").at(0);
    report["branches"].erase(0);
    same.erase("surface_area");
    same.erase("volume");
    EXPECT_EQ(branch, same);
  }

  const Outcome outcome = run_well("skeletonize three.off -o t.json --report r.json --join --min-component 100");
  EXPECT_NE(std::string::npos, outcome.err.find("1 component of less than 100")) << outcome.err;
  report = json("r.json");
  EXPECT_EQ(1, report.at("number_of_skeleton_components"));
  EXPECT_EQ(2, report.at("betti_number"));
  EXPECT_EQ(1, report.at("fragments").at("number_of_removed_components"));
  EXPECT_EQ(8, report.at("fragments").at("number_of_removed_sites"));
  EXPECT_EQ(1, report.at("fragments").at("number_of_joined_edges"));
  const nlohmann::json skeleton = json("t.json");
  EXPECT_EQ(1u, skeleton.at("joined_edges").size());
  EXPECT_EQ(2 * torus().points.size(), number_of_sites(skeleton));

  m_folder.write("pole.xyz", pole());
  expect_refusal("skeletonize pole.xyz --shape tree --join -o a.json", 1, {"tree", "cscd simplify"});
}

TEST_F(Cscd, notices_a_full_standard_output)
{
  if (!std::filesystem::exists("/dev/full")) {
    GTEST_SKIP() << "there is no /dev/full";
  }
  EXPECT_EQ(2, run("skeletonize torus.off -o - > /dev/full; exit $? ; :").status);
}

TEST_F(Cscd, writes_all_formats_at_once)
{
  const Outcome outcome = run_well(
      "skeletonize torus.off -o t.graph -o t.json -o t.obj --output t.ply -o t.polylines.txt -o t.swc -o t.vtp "
      "--report r.json");
  EXPECT_EQ("", outcome.err);
  EXPECT_TRUE(is_graph_of_a_cycle(content("t.graph")));
  EXPECT_EQ(9, m_folder.number_of_files());
  for (const char* name : {"t.json", "t.obj", "t.ply", "t.polylines.txt", "t.swc", "t.vtp"}) {
    EXPECT_LT(100u, content(name).size()) << name;
  }
}

TEST_F(Cscd, writes_rigs)
{
  run_well("skeletonize torus.off -o t.glb -o t.json --root longest");
  EXPECT_EQ("glTF", content("t.glb").substr(0, 4));
  EXPECT_EQ(0, run("skeletonize t.glb -o again.json -q").status) << "the mesh of a rig is read";
  expect_refusal("skeletonize t.glb -o t.glb", 1, {"is the input", "name another file"});
  for (const std::string ending : {"bvh", "dot"}) {
    expect_refusal("skeletonize t.glb -o t." + ending, 1, {"t." + ending, "use one of .graph .json .obj"});
  }
}

TEST_F(Cscd, prints_a_summary)
{
  const Outcome outcome = run_well("skeletonize torus.off");
  EXPECT_EQ(0u, outcome.out.rfind("torus.off: 1776 vertices, 1 component, genus 1\nskeleton: ", 0)) << outcome.out;
  EXPECT_NE(std::string::npos, outcome.out.find("1 component, 1 cycle, 0 tips, 0 junctions\ntime: ")) << outcome.out;
  EXPECT_EQ(3, std::count(outcome.out.begin(), outcome.out.end(), '\n'));
  // No progress bar, as this is not a terminal.
  EXPECT_EQ("cscd: torus.off: the skeleton is not written; name a file by --output\n", outcome.err);
  EXPECT_EQ(1, m_folder.number_of_files());
}

TEST_F(Cscd, writes_to_standard_output)
{
  const Outcome outcome = run_well("skeletonize torus.off -o - -o t.graph");
  EXPECT_TRUE(is_graph_of_a_cycle(outcome.out));
  EXPECT_EQ(content("t.graph"), outcome.out);
  const Outcome report = run_well("skeletonize torus.off -o t.graph --report -");
  EXPECT_EQ(1776, nlohmann::json::parse(report.out).at("number_of_sites"));
  EXPECT_EQ(2, m_folder.number_of_files());
}

TEST_F(Cscd, reads_standard_input_in_all_formats)
{
  m_folder.write("torus.obj", obj(torus()));
  m_folder.write("torus.ply", binary_ply(torus(), true));
  m_folder.write("torus.stl", binary_stl(torus(), "solid"));
  for (const std::string format : {"off", "obj", "ply", "stl"}) {
    const Outcome outcome = run_well("skeletonize - --format " + format + " -o - < torus." + format);
    EXPECT_EQ("", outcome.err);
    EXPECT_TRUE(is_graph_of_a_cycle(outcome.out)) << format;
  }
}

#ifdef CSCD_WITH_ZLIB
TEST_F(Cscd, reads_what_gzip_has_compressed)
{
  const Outcome piped = run_well("skeletonize - --format off.gz -o -", "gzip -c torus.off |");
  EXPECT_TRUE(is_graph_of_a_cycle(piped.out));
  EXPECT_EQ(piped.out, run("skeletonize torus.off.gz -o -", "gzip torus.off;").out);
}
#endif

TEST_F(Cscd, says_what_it_repaired)
{
  Mesh_file_content mesh = torus();
  std::reverse(mesh.polygons[7].begin(), mesh.polygons[7].end());
  mesh.polygons.push_back(mesh.polygons[9]);
  m_folder.write("torus.off", off(mesh));
  const Outcome outcome = run_well("skeletonize torus.off -o t.graph --report r.json");
  EXPECT_NE(std::string::npos, outcome.err.find("cscd: torus.off: 1 degenerate or duplicate face removed\n"));
  EXPECT_NE(std::string::npos, outcome.err.find("cscd: torus.off: 1 face turned to agree with its neighbors\n"));
  EXPECT_TRUE(is_graph_of_a_cycle(content("t.graph")));
  EXPECT_EQ(2u, json("r.json").at("repairs").size());
}

TEST_F(Cscd, quiet_says_nothing)
{
  Mesh_file_content mesh = torus();
  std::reverse(mesh.polygons[7].begin(), mesh.polygons[7].end());
  m_folder.write("torus.off", off(mesh));
  for (const std::string flag : {"--quiet", "-q"}) {
    const Outcome outcome = run_well("skeletonize torus.off -o t.graph " + flag);
    EXPECT_EQ("", outcome.out);
    EXPECT_EQ("", outcome.err);
  }
  expect_refusal("skeletonize missing.off -q", 2, {"missing.off"}); // but errors are told
}

TEST_F(Cscd, reports_as_json)
{
  run_well("skeletonize torus.off --seed 5 --threads 1 --report r.json -o t.json");
  const nlohmann::json report = json("r.json");
  const nlohmann::json skeleton = json("t.json");
  EXPECT_EQ(CSCD_VERSION, report.at("version"));
  EXPECT_EQ("torus.off", report.at("input"));
  EXPECT_EQ("local", report.at("method"));
  EXPECT_EQ(5, report.at("seed"));
  EXPECT_EQ((nlohmann::json{{"seed", 5}, {"threads", 1}}), report.at("options"));
  EXPECT_EQ(1, report.at("number_of_threads"));
  EXPECT_TRUE(report.at("repairs").empty());
  EXPECT_TRUE(report.at("warnings").is_array());
  EXPECT_EQ(1776, report.at("number_of_sites"));
  EXPECT_EQ(1, report.at("genus"));
  EXPECT_EQ(1, report.at("betti_number"));
  EXPECT_EQ(1, report.at("number_of_surface_components"));
  EXPECT_EQ(1, report.at("number_of_skeleton_components"));
  EXPECT_EQ(skeleton.at("nodes").size(), report.at("number_of_nodes"));
  EXPECT_EQ(skeleton.at("edges").size(), report.at("number_of_edges"));
  EXPECT_EQ(1776u, number_of_sites(skeleton)); // all vertices
  for (const nlohmann::json& node : skeleton.at("nodes")) {
    EXPECT_NEAR(1, node.at("radius").get<double>(), 0.1);
  }
  EXPECT_EQ(0, report.at("number_of_tips"));
  EXPECT_EQ(0, report.at("number_of_junctions"));
  EXPECT_EQ(0, report.at("number_of_sheets"));
  EXPECT_EQ(0, report.at("number_of_wide_borders"));
  EXPECT_EQ(0, report.at("number_of_open_separators"));
  for (const char* key :
       {"number_of_isolated_vertices", "number_of_bridged_borders", "number_of_inserted_vertices",
        "number_of_degenerate_faces", "number_of_levels", "number_of_sources", "number_of_sources_without_cut",
        "number_of_collapsed_loops", "number_of_bumps", "number_of_tunnels", "number_of_separators",
        "number_of_plane_sections", "number_of_straightened_loops", "number_of_packed_separators",
        "number_of_handle_cuts", "number_of_nodes_outside", "number_of_edges_outside"}) {
    EXPECT_TRUE(report.contains(key) && report[key].is_number_unsigned()) << key;
  }
  for (const char* stage : {"compile surface", "find separators", "pack separators", "build skeleton"}) {
    EXPECT_GT(report.at("seconds").at(stage), 0) << stage;
  }
}

TEST_F(Cscd, answer_does_not_depend_on_what_else_is_written)
{
  // A report is made with the mesh; without one no mesh is made of the triangles.
  auto mesh = file_content(CSCD::test::with_small_holes(CSCD::test::y_tube(0.2), 3, 7));
  mesh.points.push_back({9, 9, 9}); // without a face
  m_folder.write("y.off", off(mesh));
  const Outcome alone = run("skeletonize y.off -o t.json");
  const Outcome with_report = run("skeletonize y.off -o u.json --report r.json");
  EXPECT_EQ(0, alone.status) << alone.err;
  EXPECT_EQ(alone.err, with_report.err);
  EXPECT_EQ(content("t.json"), content("u.json"));
}

TEST_F(Cscd, number_of_sources_can_be_bounded)
{
  run_well("skeletonize torus.off --separators 3 --report r.json");
  const nlohmann::json report = json("r.json");
  EXPECT_LE(report.at("number_of_sources"), 3);
  EXPECT_EQ(1, report.at("betti_number"));
}

TEST_F(Cscd, knows_the_published_method)
{
  const std::string command =
      "skeletonize torus.off --method published --separators 64 --threads 1 --report r.json -o -";
  const std::string plain = run(command).out;
  EXPECT_TRUE(is_graph_of_a_cycle(plain));
  const nlohmann::json report = json("r.json");
  EXPECT_EQ("published", report.at("method"));
  EXPECT_EQ(false, report.at("literal"));
  EXPECT_EQ(64, report.at("number_of_sources"));
  std::size_t number_of_rejections = 0;
  for (const auto& [reason, number] : report.at("number_of_rejections").items()) {
    number_of_rejections += number.get<std::size_t>();
  }
  EXPECT_EQ(number_of_rejections, report.at("number_of_sources_without_cut"));
  EXPECT_EQ(plain, run("skeletonize torus.off --method published --separators 64 --threads 2 -o -").out);
  const std::string literal = run(command + " --literal").out;
  EXPECT_TRUE(is_graph_of_a_cycle(literal));
  EXPECT_NE(plain, literal);
  EXPECT_EQ(true, json("r.json").at("literal"));
}

TEST_F(Cscd, says_that_other_methods_are_left_out)
{
  const std::string skeleton = run("torus.off -o -").out;
  m_program = CSCD_PROGRAM_OF_LOCAL_METHOD;
  EXPECT_EQ(skeleton, run("torus.off --method local -o -").out);
  const std::string remedy = "-DCSCD_WITH_ALL_METHODS=ON";
  for (const std::string arguments : {"--method published", "--wrap 0.01", "--as graph"}) {
    expect_refusal("torus.off " + arguments + " -o -", 1, {arguments, remedy});
  }
  std::istringstream help(run("skeletonize --help").out);
  std::size_t number_of_remedies = 0;
  for (std::string line; std::getline(help, line);) {
    EXPECT_LE(line.size(), 120u) << line;
    number_of_remedies += line.find(remedy) != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(3u, number_of_remedies);
  EXPECT_NE(std::string::npos, run("--version").out.find("without the published method"));
}

TEST_F(Cscd, writes_a_page_with_all_in_it)
{
  std::filesystem::create_directory(m_folder.path() / "meshes");
  m_folder.write("meshes/torus.off", off(torus()));
  const Outcome outcome = run("skeletonize meshes/torus.off -o t.html");
  if (outcome.status == 1 && outcome.err.find("built without three.js") != std::string::npos) {
    CSCD_TEST_SKIP_OR_FAIL("three.js (package libjs-three) is not there");
  }
  ASSERT_EQ(0, outcome.status) << outcome.err;
  const std::string page = content("t.html");
  EXPECT_EQ(0u, page.rfind("<!doctype html>", 0)) << page.substr(0, 100);
  EXPECT_LT(500000u, page.size()); // three.js is inside
  EXPECT_EQ(std::string::npos, page.find("<script src"));
  EXPECT_NE(std::string::npos, page.find("<title>torus.off</title>"));
  EXPECT_NE(std::string::npos, page.find("OrbitControls = function"));
  expect_refusal("t.html -o t.html", 1, {"is the input"});
}

/// A graph of GEL of a circle in the middle of the torus.
std::string circle(double radius = 3, std::size_t number_of_nodes = 60)
{
  std::ostringstream out;
  for (std::size_t i = 0; i < number_of_nodes; ++i) {
    const double angle = 2 * CSCD::test::pi * double(i) / double(number_of_nodes);
    out << "n " << radius * std::cos(angle) << ' ' << radius * std::sin(angle) << " 0\n";
  }
  for (std::size_t i = 0; i < number_of_nodes; ++i) {
    out << "c " << i << ' ' << (i + 1) % number_of_nodes << '\n';
  }
  return out.str();
}

TEST_F(Cscd, evaluates_a_skeleton)
{
  m_folder.write("circle.graph", circle());
  const Outcome outcome = run_well("evaluate torus.off circle.graph --json");
  EXPECT_EQ("", outcome.err);
  const nlohmann::json measures = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(CSCD_VERSION, measures.at("version"));
  EXPECT_EQ("torus.off", measures.at("input"));
  EXPECT_EQ("circle.graph", measures.at("skeleton"));
  EXPECT_EQ("estimated", measures.at("radii"));
  EXPECT_EQ(1776, measures.at("number_of_points"));
  EXPECT_EQ(true, measures.at("has_topology_of_surface"));
  EXPECT_EQ(1, measures.at("counts").at("betti_number"));
  EXPECT_EQ(1, measures.at("position").at("genus"));
  EXPECT_EQ(1, measures.at("position").at("fraction_of_length_inside"));
  EXPECT_NEAR(0, measures.at("position").at("offset_by_length").get<double>(), 0.01);
  EXPECT_NEAR(1. / 3, measures.at("counts").at("mean_turning").get<double>(), 0.01);
  EXPECT_LT(measures.at("round_cones").at("mean"), 0.001);
  EXPECT_LT(measures.at("convolution").at("mean"), 0.01);
  EXPECT_EQ(0.005, measures.at("convolution").at("cell_size"));
  EXPECT_TRUE(measures.at("tip_recall").is_null()); // no limbs
  EXPECT_TRUE(measures.at("tip_precision").is_null());
  EXPECT_EQ(0, measures.at("limbs").at("number_of_limbs"));
  const Outcome piped = run_well("evaluate torus.off - --json < circle.graph");
  EXPECT_EQ(measures.at("convolution"), nlohmann::json::parse(piped.out).at("convolution"));
  EXPECT_EQ(2, m_folder.number_of_files());
}

TEST_F(Cscd, evaluates_tips)
{
  m_folder.write("star.off", off(file_content(CSCD::test::star(5, 6, 1, 0.3))));
  run_well("skeletonize star.off -q -o star.graph");
  const Outcome outcome = run_well("evaluate star.off star.graph --json --resolution 10");
  const nlohmann::json measures = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(1, measures.at("tip_recall"));
  EXPECT_EQ(1, measures.at("tip_precision"));
  ASSERT_EQ(5u, measures.at("limbs").at("limbs").size());
  EXPECT_EQ(true, measures.at("limbs").at("limbs").front().at("has_tip"));
}

TEST_F(Cscd, evaluates_for_people)
{
  m_folder.write("circle.graph", circle());
  const Outcome outcome = run_well("evaluate torus.off circle.graph");
  EXPECT_EQ(0u, outcome.out.rfind("torus.off: 1776 vertices, 1 component, genus 1\ncircle.graph: 60 nodes, 60 edges, "
                                  "1 component, 1 cycle, 0 tips, 0 junctions\ntopology: that of the surface\n",
                                  0))
      << outcome.out;
  EXPECT_NE(std::string::npos, outcome.out.find("inside: 100.00 % of the nodes, 100.00 % of the length\n"));
  EXPECT_NE(std::string::npos, outcome.out.find("\nlimbs: 0, of which 0 without a tip; 0 tips without a limb"));
  EXPECT_NE(std::string::npos, outcome.out.find("\nconvolution surface "));
}

TEST_F(Cscd, edges_of_a_mesh_are_a_graph)
{
  run_well("skeletonize torus.off --as graph -q -o t.graph --report t.json --correspondence t.csv");
  const auto report = json("t.json");
  EXPECT_EQ("graph", report.at("domain"));
  EXPECT_EQ(1, report.at("betti_number"));
  EXPECT_EQ(torus().points.size(), report.at("number_of_sites"));
  // A skeleton is a graph, and a curve its own skeleton.
  run_well("skeletonize t.graph --as graph -q -o again.graph --report again.json");
  EXPECT_EQ(report.at("number_of_nodes"), json("again.json").at("number_of_nodes"));
}

TEST_F(Cscd, lines_of_obj_are_graphs)
{
  m_folder.write("y.obj", "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 2 -1 0\nl 1 2 3\nl 2 4\n");
  run_well("skeletonize y.obj --as graph -q --report y.json -o y.graph");
  const auto report = json("y.json");
  EXPECT_EQ(4, report.at("number_of_nodes"));
  EXPECT_EQ(3, report.at("number_of_tips"));
  expect_refusal("skeletonize y.obj --as graph --detail 0.3", 1, {"--detail", "does not apply to graphs"});
  expect_refusal("skeletonize y.obj --neighbors 5", 1, {"--neighbors", "--as graph"});
}

TEST_F(Cscd, keeps_cavities_of_a_volume_as_bodies)
{
  std::string volume = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 12 12 12\nencoding: raw\n\n";
  const auto is_in = [](int i, int wall) { return i >= wall && i < 12 - wall; };
  for (int z = 0; z < 12; ++z) {
    for (int y = 0; y < 12; ++y) {
      for (int x = 0; x < 12; ++x) {
        volume += char(is_in(x, 3) && is_in(y, 3) && is_in(z, 3) ? 0 : 1);
      }
    }
  }
  m_folder.write("hollow.nrrd", volume);
  for (const std::string option : {"", " --keep-cavities"}) {
    run_well("skeletonize hollow.nrrd -q -o h.graph --report h.json" + option);
    const auto report = json("h.json");
    EXPECT_EQ(option.empty() ? 1 : 2, report.at("number_of_skeleton_components")) << option;
    EXPECT_EQ(0, report.at("number_of_cavities")) << option;
  }
}

TEST_F(Cscd, skeletonizes_each_label_of_a_volume)
{
  // Two bars of 12 x 2 x 2 voxels, which share a voxel's edge, and a ring of label 5.
  std::string volume = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 14 6 7\nspacings: 1 1 2\nencoding: raw\n\n";
  for (int z = 0; z < 7; ++z) {
    for (int y = 0; y < 6; ++y) {
      for (int x = 0; x < 14; ++x) {
        const bool is_in_ring = z >= 5 && !(x > 1 && x < 12 && y > 1 && y < 4);
        const bool is_in_bar = x >= 1 && x < 13 && ((y < 2 && z < 2) || (y >= 2 && y < 4 && z >= 2 && z < 4));
        volume += char(is_in_ring ? 5 : is_in_bar ? 2 : 0);
      }
    }
  }
  m_folder.write("v.nrrd", volume);
  const Outcome outcome = run_well("skeletonize v.nrrd --all-labels -o a.b.graph -o nodes.nrrd --report r.json");
  EXPECT_NE(std::string::npos, outcome.out.find("label 5, 128 voxels, 0 cavities filled"));
  EXPECT_TRUE(is_graph_of_a_cycle(content("a.b_5.graph")));
  const nlohmann::json joined = json("r_2.json");
  EXPECT_EQ(joined["domain"], "volume");
  EXPECT_EQ(joined["number_of_skeleton_components"], 1);
  EXPECT_EQ(joined["volume"]["number_of_voxels"], 96);
  const std::string nodes = content("nodes.nrrd");
  const std::string data = nodes.substr(nodes.find("\n\n") + 2);
  ASSERT_EQ(data.size(), 14u * 6 * 7 * 4);
  for (std::size_t i = 0; i < 14u * 6 * 7; ++i) {
    EXPECT_EQ(data[4 * i] != 0, volume[volume.size() - 14u * 6 * 7 + i] != 0) << i;
  }
  run_well("skeletonize v.nrrd --label 2 --connectivity 6 -q --report apart.json");
  EXPECT_EQ(json("apart.json")["number_of_skeleton_components"], 2);
  run_well("skeletonize v.nrrd --threshold 3 -q -o t.graph");
  EXPECT_TRUE(is_graph_of_a_cycle(content("t.graph")));

  // The files of a label appear together, before the next label begins, and are not made again.
  std::filesystem::create_directory(m_folder.path() / "late_5.json");
  expect_refusal("skeletonize v.nrrd --all-labels -q -o late.graph --report late.json", 2, {"late_5.json", "folder"});
  EXPECT_FALSE(std::filesystem::exists(m_folder.path() / "late_5.graph"));
  EXPECT_FALSE(content("late_2.json").empty());
  std::filesystem::remove(m_folder.path() / "late_5.json");
  m_folder.write("late_2.graph", "kept");
  run_well("skeletonize v.nrrd --all-labels --resume -q -o late.graph --report late.json");
  EXPECT_EQ("kept", content("late_2.graph"));
  EXPECT_TRUE(is_graph_of_a_cycle(content("late_5.graph")));
  expect_refusal("skeletonize v.nrrd --resume -o x.graph", 1, {"--resume", "--all-labels"});
  expect_refusal("skeletonize v.nrrd --all-labels --resume -o x.nrrd", 1, {"--resume", "needs all labels"});
  expect_refusal("skeletonize v.nrrd --label 3 -o x.graph", 2, {"v.nrrd", "no voxel"});
  expect_refusal("skeletonize v.nrrd --label 2 --threshold 3", 1, {"exclude"});
  expect_refusal("skeletonize v.nrrd --all-labels -o -", 1, {"standard output"});
  expect_refusal("skeletonize v.nrrd --connectivity 18", 1, {"--connectivity"});
  expect_refusal("skeletonize v.nrrd --as graph", 1, {"--as"});
  expect_refusal("skeletonize v.nrrd -o v.nrrd", 1, {"is the input"});
  expect_refusal("skeletonize torus.off --label 2", 1, {"--label", "does not apply to meshes", "leave it out"});
  expect_refusal("skeletonize torus.off -o torus.nrrd", 1, {".nrrd", "does not apply to meshes"});
}

TEST_F(Cscd, own_radii_are_used_on_request)
{
  run_well("skeletonize torus.off -q -o t.json -o t.graph");
  const Outcome outcome = run_well("evaluate torus.off t.json --json --radii own --resolution 60");
  const nlohmann::json measures = nlohmann::json::parse(outcome.out);
  EXPECT_EQ("own", measures.at("radii"));
  EXPECT_LT(measures.at("round_cones").at("mean"), 0.01);
  expect_refusal("evaluate torus.off t.graph --radii own", 2, {"radii", "estimated"});
}

TEST_F(Cscd, compares_two_skeletons)
{
  m_folder.write("a.graph", circle(3));
  m_folder.write("b.graph", circle(3.3, 80));
  const Outcome outcome = run_well("compare a.graph b.graph --json --match-distance 0.05");
  const nlohmann::json comparison = nlohmann::json::parse(outcome.out);
  const double diagonal = comparison.at("diagonal");
  EXPECT_NEAR(6.6 * std::sqrt(2), diagonal, 1e-6);
  EXPECT_NEAR(0.3 / diagonal, comparison.at("mean_distance").get<double>(), 0.01 / diagonal);
  EXPECT_EQ(0.05, comparison.at("match_distance"));
  const Outcome text = run_well("compare a.graph - < b.graph");
  EXPECT_EQ(0u, text.out.rfind("a.graph and -:\n", 0)) << text.out;
  EXPECT_NE(std::string::npos, text.out.find("tips:      0 of 0 and 0 match\n")) << text.out;
}

TEST_F(Cscd, refuses_what_it_cannot_measure)
{
  m_folder.write("circle.graph", circle());
  m_folder.write("far.graph", "n 1e6 0 0\n");
  m_folder.write("bad.graph", "n 1 0\n");
  expect_refusal("evaluate torus.off", 1, {"SKELETON"});
  expect_refusal("evaluate torus.off circle.dot", 1, {"circle.dot", ".swc .vtp"});
  expect_refusal("evaluate torus.off circle.graph --resolution 0", 1, {"--resolution"});
  expect_refusal("evaluate torus.off circle.graph --radii big", 1, {"--radii"});
  expect_refusal("evaluate - - --format off < torus.off", 1, {"standard input"});
  expect_refusal("evaluate torus.off missing.graph", 2, {"missing.graph: cannot be opened"});
  expect_refusal("evaluate missing.off circle.graph", 2, {"missing.off: cannot be opened"});
  expect_refusal("evaluate torus.off far.graph", 2, {"node 0 of the skeleton is far from the surface"});
  expect_refusal("evaluate torus.off bad.graph", 2, {"bad.graph, line 1"});
  expect_refusal("compare circle.graph", 1, {"B"});
  expect_refusal("compare circle.graph circle.graph --match-distance -1", 1, {"--match-distance"});
  expect_refusal("compare circle.graph circle.dot", 1, {"circle.dot"});
  expect_refusal("compare - - < circle.graph", 1, {"standard input"});
  expect_refusal("compare circle.graph bad.graph", 2, {"bad.graph, line 1"});
  EXPECT_EQ(4, m_folder.number_of_files());
}

} // namespace
