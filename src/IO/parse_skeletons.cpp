// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the formats that hold skeletons alone: GEL, JSON, poly-lines and SWC.

#include "IO/formats.h"
#include "IO/scanners.h"
#include <CSCD/IO/Shape_file.h>
#include <CSCD/Vector_3.h>

#include <boost/unordered_map.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CSCD::internal {

namespace {

using Json = nlohmann::json;

constexpr const char* remedy_of_file = "correct or write the file again";

Vector_3 next_point(Text_scanner& scanner)
{
  return scanner.point_in_line("a node has too few coordinates");
}

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

/// Reads SWC: lines `id type x y z radius parent`, in any order, and the comments `# loop i j` of `write_swc()`.
class Swc_parser
{
public:
  Swc_parser(std::string_view text, const std::string& filename) : m_scanner(text, filename), m_filename(filename) {}

  Shape_file parse()
  {
    while (m_scanner.skip_blanks()) {
      if (m_scanner.skip_character('#')) {
        read_comment();
      } else {
        read_node();
      }
      m_scanner.skip_line();
    }
    for (auto& [source, target] : m_shape.lines) {
      source = node(source);
      target = node(target);
    }
    return std::move(m_shape);
  }

private:
  /// Comments of others may begin with the same word, but hardly with a number after it.
  void read_comment()
  {
    const bool is_loop = m_scanner.skip_blanks_in_line() && m_scanner.word() == "loop" &&
                         m_scanner.skip_blanks_in_line() && m_scanner.is_at_digit();
    if (is_loop) {
      const std::int64_t source = next_integer(m_scanner, "the identifier of a node");
      m_shape.lines.push_back({source, next_integer(m_scanner, "the identifier of a node")});
    }
  }

  void read_node()
  {
    const std::int64_t id = next_integer(m_scanner, "the identifier of a node");
    next_integer(m_scanner, "the type of a node");
    const Vector_3 point = next_point(m_scanner);
    m_scanner.expect_in_line("a node has too few coordinates");
    m_shape.radii.push_back(m_scanner.coordinate());
    const std::int64_t parent = next_integer(m_scanner, "the parent of a node");
    if (!m_nodes.emplace(id, std::int64_t(m_shape.points.size())).second) {
      m_scanner.fail("the identifier " + std::to_string(id) + " stands for two nodes");
    }
    m_shape.points.push_back(point);
    constexpr std::int64_t no_parent = -1;
    if (parent != no_parent) {
      m_shape.lines.push_back({parent, id});
    }
  }

  std::int64_t node(std::int64_t id) const
  {
    const auto place = m_nodes.find(id);
    if (place == m_nodes.end()) {
      fail_in_file(m_filename, "a parent or loop has the identifier " + std::to_string(id) + ", which no node has",
                   remedy_of_file);
    }
    return place->second;
  }

  Text_scanner m_scanner;
  std::string m_filename;
  boost::unordered_map<std::int64_t, std::int64_t> m_nodes; ///< by identifier
  Shape_file m_shape; ///< whose lines join identifiers as long as nodes are missing
};

/// Reads a JSON object as `write_json()` writes it: `nodes`, each with `point` and perhaps `radius` and `is_opening`;
/// `edges`, each an array of two nodes; and perhaps `joined_edges`; all else is passed over.
class Json_parser
{
public:
  explicit Json_parser(const std::string& filename) : m_filename(filename) {}

  Shape_file parse(std::string_view text)
  {
    constexpr bool has_exceptions = false;
    const Json document = Json::parse(text.begin(), text.end(), nullptr, has_exceptions);
    if (document.is_discarded()) {
      fail("the file is not valid JSON");
    }
    for (const Json& node : array(document, "nodes")) {
      add_node(node);
    }
    m_shape.lines = edges(document, "edges");
    if (document.contains("joined_edges")) {
      m_shape.joined_lines = edges(document, "joined_edges");
    }
    return std::move(m_shape);
  }

private:
  const Json& array(const Json& document, const char* name) const
  {
    if (!document.is_object() || !document.contains(name) || !document[name].is_array()) {
      fail(std::string("the file is not a JSON object with an array ") + name);
    }
    return document[name];
  }

  void add_node(const Json& node)
  {
    const std::string name = "node " + std::to_string(m_shape.points.size());
    if (!node.is_object() || !node.contains("point") || !node["point"].is_array() || node["point"].size() != 3) {
      fail(name + " does not have a point of three numbers");
    }
    Vector_3 point = Vector_3::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      point[i] = number(node["point"][i], name + " has a coordinate that is not a number");
    }
    m_shape.points.push_back(point);
    if (node.contains("radius")) {
      m_shape.radii.push_back(number(node["radius"], name + " has a radius that is not a number"));
    }
    m_shape.openings.push_back(node.value("is_opening", Json(false)) == true ? 1 : 0);
  }

  double number(const Json& json, const std::string& fault) const
  {
    if (!json.is_number()) {
      fail(fault);
    }
    return json.get<double>();
  }

  std::vector<std::array<std::int64_t, 2>> edges(const Json& document, const char* name) const
  {
    std::vector<std::array<std::int64_t, 2>> result;
    for (const Json& edge : array(document, name)) {
      if (!edge.is_array() || edge.size() != 2 || !edge[0].is_number_unsigned() || !edge[1].is_number_unsigned()) {
        fail("an edge is not an array of two node indices");
      }
      result.push_back({edge[0].get<std::int64_t>(), edge[1].get<std::int64_t>()});
    }
    return result;
  }

  [[noreturn]] void fail(const std::string& fault) const { fail_in_file(m_filename, fault, remedy_of_file); }

  std::string m_filename;
  Shape_file m_shape;
};

} // namespace

/// Lines `n x y z` and `c i j`.
Shape_file parse_gel_graph(std::string_view content, const std::string& filename, unsigned /* contents */)
{
  Text_scanner scanner(content, filename);
  Shape_file shape;
  while (scanner.skip_blanks('#')) {
    const std::string_view statement = scanner.word();
    if (statement == "n") {
      shape.points.push_back(next_point(scanner));
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
    const Vector_3 point = next_point(scanner) + Vector_3::Zero(); // makes -0 equal to 0
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

Shape_file parse_swc(std::string_view content, const std::string& filename, unsigned /* contents */)
{
  return Swc_parser(content, filename).parse();
}

Shape_file parse_json_skeleton(std::string_view content, const std::string& filename, unsigned /* contents */)
{
  return Json_parser(filename).parse(content);
}

} // namespace CSCD::internal
