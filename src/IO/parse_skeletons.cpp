// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the formats that hold skeletons alone: GEL, JSON, poly-lines and SWC.

#include "IO/formats.h"
#include "IO/scanners.h"
#include <CSCD/IO/Shape_file.h>
#include <CSCD/Vector3.h>

#include <boost/unordered_map.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace CSCD::internal {

namespace {

using Json = nlohmann::json;

constexpr const char* remedy_of_file = "correct or write the file again";
constexpr const char* too_few_numbers = "a node has too few coordinates";

/// Reads the next integer of this line. \throw File_error if there is none
std::int64_t next_integer(Text_scanner& scanner, const char* meaning)
{
  if (!scanner.skip_blanks_in_line()) {
    scanner.fail(std::string(meaning) + " is missing");
  }
  const std::int64_t result = scanner.integer(meaning);
  if (!scanner.word().empty()) {
    scanner.fail(std::string(meaning) + " is not an integer");
  }
  return result;
}

} // namespace

/// Lines `n x y z` and `c i j`.
Shape_file parse_gel_graph(std::string_view content, const std::string& filename, unsigned /* contents */)
{
  Text_scanner scanner(content, filename);
  Shape_file shape;
  while (scanner.skip_blanks('#')) {
    const std::string_view statement = scanner.word();
    if (statement == "n") {
      shape.points.push_back(scanner.point_in_line(too_few_numbers));
    } else if (statement == "c") {
      const std::int64_t source = next_integer(scanner, "a node index");
      shape.lines.push_back({source, next_integer(scanner, "a node index")});
    } else {
      scanner.fail("a line begins with neither n nor c", "check that this is a graph of GEL");
    }
    scanner.skip_line();
  }
  return shape;
}

/// For each poly-line, the number of its points and then `x y z` of each. Points with equal coordinates are one node.
Shape_file parse_polylines(std::string_view content, const std::string& filename, unsigned /* contents */)
{
  Text_scanner scanner(content, filename);
  Shape_file shape;
  boost::unordered_map<std::array<double, 3>, std::int64_t> nodes;
  const auto next_node = [&] {
    scanner.expect("the last point of a poly-line");
    const Vector3 point = scanner.point_in_line(too_few_numbers) + Vector3::Zero(); // makes -0 equal to 0
    const auto [place, is_new] =
        nodes.try_emplace({point.x(), point.y(), point.z()}, std::int64_t(shape.points.size()));
    if (is_new) {
      shape.points.push_back(point);
    }
    return place->second;
  };
  while (scanner.skip_blanks('#')) {
    const std::int64_t size = next_integer(scanner, "the number of points of a poly-line");
    if (size < 1) {
      scanner.fail("a poly-line has no points", "remove this line");
    }
    std::int64_t previous = next_node();
    for (std::int64_t i = 1; i < size; ++i) {
      const std::int64_t next = next_node();
      shape.lines.push_back({previous, next});
      previous = next;
    }
  }
  return shape;
}

/// Reads SWC: lines `id type x y z radius parent`, in any order, and the comments `# loop i j` of `write_swc()`.
Shape_file parse_swc(std::string_view content, const std::string& filename, unsigned /* contents */)
{
  constexpr const char* identifier = "the identifier of a node";
  Text_scanner scanner(content, filename);
  boost::unordered_map<std::int64_t, std::int64_t> nodes; // by identifier
  Shape_file shape;                                       // whose lines join identifiers as long as nodes are missing
  const auto read_comment = [&] {
    // Comments of others may begin with the same word, but hardly with a number after it.
    const bool is_loop = scanner.skip_blanks_in_line() && scanner.word() == "loop" && scanner.skip_blanks_in_line() &&
                         scanner.is_at_digit();
    if (is_loop) {
      const std::int64_t source = next_integer(scanner, identifier);
      shape.lines.push_back({source, next_integer(scanner, identifier)});
    }
  };
  const auto read_node = [&] {
    const std::int64_t id = next_integer(scanner, identifier);
    next_integer(scanner, "the type of a node");
    const Vector3 point = scanner.point_in_line(too_few_numbers);
    scanner.expect_in_line(too_few_numbers);
    shape.radii.push_back(scanner.coordinate());
    const std::int64_t parent = next_integer(scanner, "the parent of a node");
    if (!nodes.emplace(id, std::int64_t(shape.points.size())).second) {
      scanner.fail("the identifier " + std::to_string(id) + " stands for two nodes");
    }
    shape.points.push_back(point);
    constexpr std::int64_t no_parent = -1;
    if (parent != no_parent) {
      shape.lines.push_back({parent, id});
    }
  };
  while (scanner.skip_blanks()) {
    if (scanner.skip_character('#')) {
      read_comment();
    } else {
      read_node();
    }
    scanner.skip_line();
  }
  for (auto& line : shape.lines) {
    for (std::int64_t& end : line) {
      const auto place = nodes.find(end);
      if (place == nodes.end()) {
        fail_in_file(filename, "a parent or loop has the identifier " + std::to_string(end) + ", which no node has",
                     remedy_of_file);
      }
      end = place->second;
    }
  }
  return shape;
}

/// Reads a JSON object as `write_json()` writes it: `nodes`, each with `point` and perhaps `radius` and `is_opening`;
/// `edges`, each an array of two nodes; and perhaps `joined_edges`; all else is passed over.
Shape_file parse_json_skeleton(std::string_view content, const std::string& filename, unsigned /* contents */)
{
  constexpr bool has_exceptions = false;
  const Json document = Json::parse(content.begin(), content.end(), nullptr, has_exceptions);
  const auto check = [&filename](bool is_right, const std::string& fault) {
    if (!is_right) {
      fail_in_file(filename, fault, remedy_of_file);
    }
  };
  const auto array = [&](const char* name) -> const Json& {
    check(document.is_object() && document.contains(name) && document[name].is_array(),
          std::string("the file is not a JSON object with an array ") + name);
    return document[name];
  };
  const auto edges = [&](const char* name) {
    std::vector<std::array<std::int64_t, 2>> result;
    for (const Json& edge : array(name)) {
      check(edge.is_array() && edge.size() == 2 && edge[0].is_number_unsigned() && edge[1].is_number_unsigned(),
            "an edge is not an array of two node indices");
      result.push_back({edge[0].get<std::int64_t>(), edge[1].get<std::int64_t>()});
    }
    return result;
  };
  check(!document.is_discarded(), "the file is not valid JSON");
  Shape_file shape;
  for (const Json& node : array("nodes")) {
    const std::string name = "node " + std::to_string(shape.points.size());
    check(node.is_object() && node.contains("point") && node["point"].is_array() && node["point"].size() == 3,
          name + " does not have a point of three numbers");
    Vector3& point = shape.points.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      check(node["point"][i].is_number(), name + " has a coordinate that is not a number");
      point[i] = node["point"][i].get<double>();
    }
    if (node.contains("radius")) {
      check(node["radius"].is_number(), name + " has a radius that is not a number");
      shape.radii.push_back(node["radius"].get<double>());
    }
    shape.openings.push_back(node.value("is_opening", Json(false)) == true ? 1 : 0);
  }
  shape.lines = edges("edges");
  if (document.contains("joined_edges")) {
    shape.joined_lines = edges("joined_edges");
  }
  return shape;
}

} // namespace CSCD::internal
