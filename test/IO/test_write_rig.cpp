// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of rigs as glTF: the rules of the formats, as far as a small file can break them. The validator of
// Khronos reads a real file in test/program/test_rig.py.

#include "mesh_files.h"
#include "support/convert_shape.h"
#include "support/simple_shapes.h"
#include <CSCD/Application/make_rig.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/IO/write_rig.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace {

using Gltf_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

/// A root with two children, the second one with a tip; and a second root, if there are to be two.
CSCD::Rig rig_of_cube(std::size_t number_of_roots)
{
  CSCD::Rig rig;
  rig.joints.push_back({std::nullopt, 7, 0, {0.5, 0.5, 0.5}, 0.25, false});
  rig.joints.push_back({0, 8, 1, {0.1, 0.5, 0.5}, 0.25, true});
  rig.joints.push_back({0, 9, 2, {0.9, 0.5, 0.5}, 0.25, false});
  rig.joints.push_back({2, 10, 2, {0.9, 0.9, 0.5}, 0.125, true});
  if (number_of_roots > 1) {
    rig.joints.push_back({std::nullopt, 11, 3, {2, 2, 2}, 0.5, false});
  }
  rig.influences.assign(8, {{{2, 0.7}, {0, 0.3}}});
  return rig;
}

/// A file of glTF, taken apart.
struct Parsed_glb
{
  explicit Parsed_glb(const std::string& file)
  {
    const auto number = [&file](std::size_t at) {
      std::uint32_t result = 0;
      std::memcpy(&result, file.data() + at, sizeof result);
      return result;
    };
    EXPECT_EQ("glTF", file.substr(0, 4));
    EXPECT_EQ(2u, number(4));
    EXPECT_EQ(file.size(), number(8));
    const std::size_t size_of_json = number(12);
    EXPECT_EQ("JSON", file.substr(16, 4));
    EXPECT_EQ(0u, size_of_json % 4);
    json = nlohmann::json::parse(file.substr(20, size_of_json));
    const std::size_t binary_header = 20 + size_of_json;
    EXPECT_EQ(std::string("BIN\0", 4), file.substr(binary_header + 4, 4));
    binary = file.substr(binary_header + 8);
    EXPECT_EQ(binary.size(), number(binary_header));
    EXPECT_EQ(binary.size(), json["buffers"][0]["byteLength"].get<std::size_t>());
  }

  /// The numbers of an accessor, which must fill its view and begin at a multiple of four.
  template <class Number>
  std::vector<Number> numbers(std::size_t accessor) const
  {
    const nlohmann::json& its = json["accessors"][accessor];
    const nlohmann::json& view = json["bufferViews"][its["bufferView"].get<std::size_t>()];
    const std::map<std::string, std::size_t> components{{"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
    const std::size_t begin = view["byteOffset"];
    const std::size_t size = view["byteLength"];
    EXPECT_EQ(0u, begin % 4);
    EXPECT_LE(begin + size, binary.size());
    std::vector<Number> result(its["count"].get<std::size_t>() * components.at(its["type"]));
    EXPECT_EQ(size, result.size() * sizeof(Number));
    std::memcpy(result.data(), binary.data() + begin, size);
    return result;
  }

  nlohmann::json json;
  std::string binary;
};

Parsed_glb glb_of_cube(std::size_t number_of_roots, const std::string& name = "a cube")
{
  std::ostringstream out;
  CSCD::write_glb(out, CSCD::test::to_mesh<Gltf_mesh>(CSCD::test::cube()), rig_of_cube(number_of_roots), name);
  return Parsed_glb(out.str());
}

TEST(Write_rig, glb_holds_the_mesh)
{
  const Gltf_mesh mesh = CSCD::test::to_mesh<Gltf_mesh>(CSCD::test::cube());
  const Parsed_glb glb = glb_of_cube(1);
  const nlohmann::json& primitive = glb.json["meshes"][0]["primitives"][0];
  const auto positions = glb.numbers<float>(primitive["attributes"]["POSITION"]);
  ASSERT_EQ(24u, positions.size());
  for (const auto v : mesh.vertices()) {
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(float(mesh.point(v)[i]), positions[3 * v + std::size_t(i)]);
    }
  }
  const nlohmann::json& accessor = glb.json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
  const auto& [low, high] = std::minmax_element(positions.begin(), positions.end()); // the cube has equal sides
  EXPECT_EQ((std::vector<float>{*low, *low, *low}), accessor["min"].get<std::vector<float>>());
  EXPECT_EQ((std::vector<float>{*high, *high, *high}), accessor["max"].get<std::vector<float>>());
  const auto normals = glb.numbers<float>(primitive["attributes"]["NORMAL"]);
  for (std::size_t i = 0; i < normals.size(); i += 3) {
    EXPECT_NEAR(1, std::hypot(normals[i], normals[i + 1], normals[i + 2]), 1e-6);
  }
}

TEST(Write_rig, glb_holds_joints_and_weights)
{
  const Parsed_glb glb = glb_of_cube(1);
  const CSCD::Rig rig = rig_of_cube(1);
  const nlohmann::json& skin = glb.json["skins"][0];
  const nlohmann::json& nodes = glb.json["nodes"];
  ASSERT_EQ(rig.joints.size(), skin["joints"].size());
  const auto matrices = glb.numbers<float>(skin["inverseBindMatrices"]);
  ASSERT_EQ(16 * rig.joints.size(), matrices.size());
  std::vector<CSCD::Vector3> place(nodes.size());
  for (std::size_t j = 0; j < rig.joints.size(); ++j) { // parents come first
    const std::size_t node = skin["joints"][j];
    EXPECT_EQ(name(rig.joints[j]), nodes[node]["name"]);
    const nlohmann::json& offset = nodes[node]["translation"];
    place[node] += CSCD::Vector3(offset[0], offset[1], offset[2]);
    for (const std::size_t child : nodes[node].value("children", std::vector<std::size_t>())) {
      place[child] = place[node];
    }
    EXPECT_LT((place[node] - rig.joints[j].point).norm(), 1e-6);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(float(-rig.joints[j].point[i]), matrices[16 * j + 12 + i]);
      EXPECT_EQ(1, matrices[16 * j + 5 * i]);
    }
    EXPECT_EQ(1, matrices[16 * j + 15]);
  }
}

TEST(Write_rig, joints_move_the_mesh_that_is_read)
{
  Parsed_glb glb = glb_of_cube(1);
  glb.json["nodes"][0]["translation"] = {9, 9, 9}; // of the mesh, which has a skin
  glb.json["nodes"][1]["translation"][0] = 1.5;    // the root, by 1
  glb.json["nodes"][3]["scale"] = {2, 2, 2};
  glb.json["buffers"][0]["uri"] = "data:application/octet-stream;base64," + test_support::base64(glb.binary);
  const auto read = [&glb] {
    std::istringstream in(glb.json.dump());
    Gltf_mesh mesh;
    CSCD::read_triangle_mesh(in, ".gltf", "input", mesh);
    return mesh;
  };
  const Gltf_mesh mesh = read();
  // The place of p is 0.7 of joint + 2 (p - joint), and 0.3 of p, moved by 1.
  EXPECT_NEAR(std::pow(1.7, 3), CGAL::Polygon_mesh_processing::volume(mesh), 1e-5);
  const Gltf_mesh::Point corner = mesh.point(*mesh.vertices().begin());
  EXPECT_LT(CGAL::squared_distance(corner, Gltf_mesh::Point(1 - 0.63, -0.35, -0.35)), 1e-12);
  glb.json["scenes"][0]["nodes"] = {0}; // joints out of the scene count as if they were at rest
  EXPECT_NEAR(1, CGAL::Polygon_mesh_processing::volume(read()), 1e-6);
}

TEST(Write_rig, glb_refuses_what_it_cannot_hold)
{
  std::ostringstream out;
  Gltf_mesh mesh;
  mesh.add_vertex({0, 0, 0});
  EXPECT_THROW(CSCD::write_glb(out, mesh, rig_of_cube(1)), CSCD::Input_error);
  mesh = CSCD::test::to_mesh<Gltf_mesh>(CSCD::test::cube());
  CSCD::Rig rig = rig_of_cube(1);
  rig.joints.resize(65536);
  EXPECT_THROW(CSCD::write_glb(out, mesh, rig), CSCD::Input_error);
  mesh.point(*mesh.vertices().begin()) = {1e39, 0, 0};
  EXPECT_THROW(CSCD::write_glb(out, mesh, rig_of_cube(1)), CSCD::Input_error);
  EXPECT_EQ("", out.str());
}

} // namespace
