// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the formats that hold points alone, which are tables and LAS, or skeletons alone: GEL, JSON, poly-lines and
// SWC. A table has coordinates separated by blanks, commas or semicolons, with or without names of columns.

#include "IO/formats.h"
#include "IO/merge_equal_points.h"
#include "IO/scanners.h"
#include <CSCD/IO/Shape_file.h>
#include <CSCD/Vector3.h>

#include <boost/unordered_map.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CSCD::internal {

namespace {

/// Discards columns that are not unit normals, and records it: unless most of them are of unit length, and differ, they
/// are colors or the like. Normals of another length are set to zero: they are not known.
void keep_normals_only(Shape_file& shape)
{
  std::vector<Vector3>& normals = shape.normals;
  const bool has_columns = !normals.empty();
  constexpr double tolerance = 0.01; // normals are written with few digits
  std::size_t number_of_unit_length = 0;
  bool do_differ = false;
  for (Vector3& normal : normals) {
    if (std::abs(normal.norm() - 1) <= tolerance) {
      ++number_of_unit_length;
      do_differ = do_differ || normal != normals.front();
    } else {
      normal = Vector3::Zero();
    }
  }
  if (2 * number_of_unit_length <= normals.size() || !do_differ) {
    normals.clear();
  }
  shape.has_other_columns = has_columns && normals.empty();
}

/// Which columns of a table hold coordinates and normals, and the separator of columns.
struct Point_columns
{
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  std::array<std::size_t, 6> places{0, 1, 2, 3, 4, 5}; ///< of x, y, z and of the normal
  char separator = 0;                                  ///< 0 for blanks

  bool has_normals() const { return places[3] != none && places[4] != none && places[5] != none; }
};

/// Finds the fields of a line, without the blanks and quotes around them.
/// \param separator 0 for blanks
/// \param result is replaced; its memory is used again
void split_fields(std::string_view line, char separator, std::vector<std::string_view>& result)
{
  constexpr std::string_view around = " \t\r\n\v\f\"";
  const std::string_view separators = separator == 0 ? around : std::string_view(&separator, 1);
  result.clear();
  for (std::size_t begin = 0, end = 0; begin <= line.size(); begin = end + 1) {
    end = std::min(line.find_first_of(separators, begin), line.size());
    std::string_view field = line.substr(begin, end - begin);
    field.remove_prefix(std::min(field.find_first_not_of(around), field.size()));
    field = field.substr(0, field.find_last_not_of(around) + 1);
    if (separator != 0 || !field.empty()) {
      result.push_back(field);
    }
  }
}

/// The separator of the numbers of the first line that begins with one and has several: 0 for blanks. Where a `;`
/// separates, a comma may belong to a number.
char find_separator(std::string_view text)
{
  constexpr std::string_view begin_of_number = "0123456789+-.\"";
  std::vector<std::string_view> fields;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin != std::string_view::npos && begin_of_number.find(line[begin]) != std::string_view::npos) {
      for (const char separator : {';', ','}) {
        if (line.find(separator) != std::string_view::npos) {
          return separator;
        }
      }
      split_fields(line, 0, fields);
      if (fields.size() > 1) {
        return 0;
      }
    }
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return 0;
}

/// The columns that the first line, perhaps behind `//` or `#`, names, if it names those of all three coordinates; or
/// else the first ones.
Point_columns find_columns(std::string_view text)
{
  const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  std::string_view line = text.substr(begin, text.find('\n', begin) - begin);
  Point_columns columns;
  columns.separator = find_separator(text);
  line.remove_prefix(std::min(line.find_first_not_of("#/ \t"), line.size()));
  std::vector<std::string_view> fields;
  split_fields(line, columns.separator, fields);
  constexpr std::array<std::array<std::string_view, 3>, 6> names{{{"x", "x_m", "coord_x"},
                                                                  {"y", "y_m", "coord_y"},
                                                                  {"z", "z_m", "coord_z"},
                                                                  {"nx", "normal_x", "normalx"},
                                                                  {"ny", "normal_y", "normaly"},
                                                                  {"nz", "normal_z", "normalz"}}};
  std::array<std::size_t, 6> places{};
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto field = std::find_if(fields.begin(), fields.end(), [&](std::string_view name) {
      return std::count(names[k].begin(), names[k].end(), lower_case(name)) > 0;
    });
    places[k] = field == fields.end() ? Point_columns::none : std::size_t(field - fields.begin());
  }
  const bool is_named = std::count(places.begin(), places.begin() + 3, Point_columns::none) == 0;
  columns.places = is_named ? places : columns.places;
  return columns;
}

/// The number that is all of a field of a table.
std::optional<double> to_number(std::string_view field)
{
  drop_prefix(field, "+");
  const char* const end = field.data() + field.size();
  double value = 0;
  return Text_scanner::read_number(field.data(), end, value) == end ? std::optional<double>(value) : std::nullopt;
}

using Json = nlohmann::json;

constexpr const char* remedy_of_file = "correct or write the file again";
constexpr const char* too_few_numbers = "a node has too few coordinates";

/// Reads the next integer of this line. \throw Content_error if there is none
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

/// Reads a table with a point in each line. Empty lines, comments after `#` or `//`, a first line with words, the
/// number of points before the first one and further columns are passed over. Normals are kept if every line has one.
Shape_file parse_point_table(std::string_view content, const std::string& /* filename */, unsigned /* contents */)
{
  const Point_columns columns = find_columns(content);
  Text_scanner scanner(content);
  Shape_file shape;
  bool has_normals = columns.has_normals();
  const auto add_point = [&](const std::vector<std::string_view>& fields) {
    Vector3 point;
    for (std::size_t i = 0; i < 3; ++i) {
      if (columns.places[i] >= fields.size()) {
        scanner.fail("a point has fewer than three coordinates");
      }
      const std::optional<double> number = to_number(fields[columns.places[i]]);
      if (!number) {
        scanner.fail(Text_scanner::number_expected);
      }
      if (!std::isfinite(*number)) {
        scanner.fail("a coordinate is not finite", "correct or remove this line");
      }
      point[i] = *number;
    }
    shape.points.push_back(point);
    Vector3 normal;
    for (std::size_t i = 3; has_normals && i < 6; ++i) {
      const std::size_t place = columns.places[i];
      const std::optional<double> number = place < fields.size() ? to_number(fields[place]) : std::nullopt;
      has_normals = number.has_value();
      normal[i - 3] = number.value_or(0);
    }
    if (has_normals) {
      shape.normals.push_back(normal);
    }
  };
  const auto is_at_word = [&] {
    Text_scanner ahead = scanner;
    ahead.skip_character('"');
    return !ahead.is_at_number();
  };
  bool is_first_line = true;
  std::vector<std::string_view> fields; // of a line
  while (scanner.skip_blanks()) {
    const bool is_comment = scanner.is_at("#") || scanner.is_at("//");
    const bool is_header = std::exchange(is_first_line, is_first_line && is_comment) && is_at_word();
    if (!is_header && !is_comment) {
      split_fields(scanner.rest().substr(0, scanner.rest().find('\n')), columns.separator, fields);
      if (fields.size() != 1 || !shape.points.empty()) { // else it is the number of points
        add_point(fields);
      }
    }
    scanner.skip_line();
  }
  if (!has_normals) {
    shape.normals.clear();
  }
  keep_normals_only(shape);
  return shape;
}

/// Reads versions 1.0 to 1.4, not compressed.
Shape_file parse_las(std::string_view content, const std::string& /* filename */, unsigned /* contents */)
{
  // Offsets in the header, by the specification of the ASPRS.
  constexpr std::size_t header_size = 227;
  constexpr std::size_t minor_version_at = 25;
  constexpr std::size_t data_offset_at = 96;   // then the format, the size and the number of points
  constexpr std::size_t scale_at = 131;        // then the offset
  constexpr std::size_t large_number_at = 247; // from version 1.4
  constexpr unsigned compression_bits = 0xc0;
  constexpr std::size_t min_point_size = 3 * sizeof(std::int32_t);
  const auto scanner_at = [&](std::size_t place) {
    return Byte_scanner(content.substr(std::min(place, content.size())), Byte_order::little);
  };
  if (content.substr(0, 4) != "LASF" || content.size() < header_size) {
    fail("it is not a LAS file, or its header is not complete", "fetch or write the file again");
  }
  Byte_scanner header = scanner_at(data_offset_at);
  const std::size_t data_offset = header.number<std::uint32_t>();
  header.skip(sizeof(std::uint32_t)); // the number of records of variable length
  if ((header.number<std::uint8_t>() & compression_bits) != 0) {
    fail("it is compressed (LAZ), which is not read", "convert it to LAS, as by `laszip` or `pdal translate`");
  }
  const std::size_t point_size = header.number<std::uint16_t>();
  std::uint64_t number_of_points = header.number<std::uint32_t>();
  if (number_of_points == 0 && content[minor_version_at] >= 4) {
    number_of_points = scanner_at(large_number_at).number<std::uint64_t>();
  }
  Byte_scanner transform = scanner_at(scale_at);
  const Vector3 scale = transform.vector<double>();
  const Vector3 offset = transform.vector<double>();
  const std::size_t size_of_data = content.size() - std::min(data_offset, content.size());
  if (point_size < min_point_size || number_of_points > size_of_data / point_size) {
    fail_at_end("all points that its header promises");
  }
  Shape_file shape;
  shape.points.resize(number_of_points);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const char* const first = scanner_at(data_offset).skip(0) + axis * sizeof(std::int32_t);
    const Number_view column{first, {'i', sizeof(std::int32_t)}, Byte_order::little, point_size, shape.points.size()};
    column.for_each([&](std::size_t i, auto x) { shape.points[i][axis] = double(x) * scale[axis] + offset[axis]; });
  }
  return shape;
}

/// Lines `n x y z` and `c i j`.
Shape_file parse_gel_graph(std::string_view content, const std::string& /* filename */, unsigned /* contents */)
{
  Text_scanner scanner(content);
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
Shape_file parse_polylines(std::string_view content, const std::string& /* filename */, unsigned /* contents */)
{
  Text_scanner scanner(content);
  Shape_file shape;
  while (scanner.skip_blanks('#')) {
    const std::int64_t size = next_integer(scanner, "the number of points of a poly-line");
    if (size < 1) {
      scanner.fail("a poly-line has no points", "remove this line");
    }
    for (std::int64_t i = 0; i < size; ++i) {
      scanner.expect("the last point of a poly-line");
      if (i > 0) {
        shape.lines.push_back({std::int64_t(shape.points.size()) - 1, std::int64_t(shape.points.size())});
      }
      shape.points.push_back(scanner.point_in_line(too_few_numbers) + Vector3::Zero()); // makes -0 equal to 0
    }
  }
  check_points(shape.points); // equal ones are found by indices
  std::vector<Index> node;
  merge_equal_points(shape.points, node);
  for (auto& [source, target] : shape.lines) {
    source = node[std::size_t(source)];
    target = node[std::size_t(target)];
  }
  return shape;
}

/// Reads SWC: lines `id type x y z radius parent`, in any order, and the comments `# loop i j` of `write_swc()`.
Shape_file parse_swc(std::string_view content, const std::string& /* filename */, unsigned /* contents */)
{
  constexpr const char* identifier = "the identifier of a node";
  Text_scanner scanner(content);
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
        fail("a parent or loop has the identifier " + std::to_string(end) + ", which no node has", remedy_of_file);
      }
      end = place->second;
    }
  }
  return shape;
}

/// Reads a JSON object as `write_json()` writes it: `nodes`, each with `point` and perhaps `radius` and `is_opening`;
/// `edges`, each an array of two nodes; and perhaps `joined_edges`; all else is passed over.
Shape_file parse_json_skeleton(std::string_view content, const std::string& /* filename */, unsigned /* contents */)
{
  constexpr bool has_exceptions = false;
  const Json document = Json::parse(content.begin(), content.end(), nullptr, has_exceptions);
  const auto check = [](bool is_right, const std::string& fault) {
    if (!is_right) {
      fail(fault, remedy_of_file);
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
