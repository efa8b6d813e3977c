// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads Wavefront OBJ, OFF and STL.

#include "IO/formats.h"
#include "IO/merge_equal_points.h"
#include "IO/scanners.h"
#include <CSCD/IO/Shape_file.h>
#include <CSCD/Vector3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace CSCD::internal {

namespace {

constexpr const char* too_few_coordinates = "a vertex has too few coordinates";

/// \name OFF
/// @{
constexpr char comment_of_off = '#';

/// Reads the keyword. \return whether normals follow the coordinates of the vertices
bool read_off_keyword(Text_scanner& scanner)
{
  scanner.skip_blanks(comment_of_off);
  std::string_view keyword = scanner.word();
  const auto drop = [&keyword](std::string_view prefix) {
    const bool found = keyword.substr(0, prefix.size()) == prefix;
    keyword.remove_prefix(found ? prefix.size() : 0);
    return found;
  };
  drop("ST"); // texture coordinates, then colors
  drop("C");
  const bool has_normals = drop("N");
  // Some writers leave no blank between the keyword and the number of vertices.
  if (!drop("OFF") || (!keyword.empty() && (keyword[0] < '0' || keyword[0] > '9'))) {
    scanner.fail("this is not an OFF file of three-dimensional points: the keyword OFF is missing",
                 "check the ending of the file name");
  }
  scanner.unread(keyword.size());
  return has_normals;
}

/// Reads points, and normals if there are any; where one is incomplete, none is kept.
void read_off_points(Text_scanner& scanner, std::size_t number, bool has_normals, Shape_file& shape)
{
  constexpr std::size_t min_point_size = 6; // bytes of `0 0 0` and a line end
  shape.points.reserve(std::min(number, scanner.remaining() / min_point_size + 1));
  for (std::size_t i = 0; i < number; ++i) {
    if (!scanner.skip_blanks(comment_of_off)) {
      scanner.fail_at_end("vertex " + std::to_string(i) + " of " + std::to_string(number));
    }
    shape.points.push_back(scanner.point_in_line(too_few_coordinates));
    Vector3 normal = Vector3::Zero();
    for (std::size_t k = 0; has_normals && k < 3; ++k) {
      has_normals = scanner.skip_blanks_in_line();
      normal[k] = has_normals ? scanner.number() : 0;
    }
    if (has_normals) {
      shape.normals.push_back(normal);
    } else {
      shape.normals.clear();
    }
    scanner.skip_line();
  }
}

void read_off_polygons(Text_scanner& scanner, std::size_t number, Shape_file& shape)
{
  constexpr std::size_t min_polygon_size = 4; // bytes of `1 0` and a line end
  shape.corners.reserve(3 * std::min(number, scanner.remaining() / min_polygon_size + 1));
  for (std::size_t i = 0; i < number; ++i) {
    if (!scanner.skip_blanks(comment_of_off)) {
      scanner.fail_at_end("face " + std::to_string(i) + " of " + std::to_string(number));
    }
    const std::size_t size = scanner.count("the number of vertices of a face");
    for (std::size_t k = 0; k < size; ++k) {
      scanner.expect("all vertices of a face", comment_of_off);
      const std::size_t corner = scanner.count("the index of a vertex");
      if (corner >= shape.points.size()) {
        scanner.fail("a face names vertex " + std::to_string(corner) + ", but there are only " +
                     std::to_string(shape.points.size()) + " (counted from 0)");
      }
      shape.corners.push_back(static_cast<Index>(corner));
    }
    shape.end_polygon();
    scanner.skip_line();
  }
}
/// @}

/// \name STL
/// A binary file begins with a text without meaning, then the number of triangles, then the triangles: normal, three
/// vertices, and two more bytes.
/// @{
constexpr std::size_t stl_text_size = 80;
constexpr std::size_t stl_header_size = stl_text_size + sizeof(std::uint32_t);
constexpr std::size_t stl_normal_size = 3 * sizeof(float);
constexpr std::size_t stl_attribute_size = 2;
constexpr std::size_t stl_triangle_size = stl_normal_size + 9 * sizeof(float) + stl_attribute_size;

/// Reads binary STL. \param scanner behind the text
void read_binary_stl(Byte_scanner& scanner, const std::string& filename, std::vector<Vector3>& points)
{
  const auto number_of_triangles = std::size_t(scanner.number<std::uint32_t>());
  const std::size_t room = scanner.remaining() / stl_triangle_size;
  if (number_of_triangles > room) {
    fail_in_file(filename,
                 "neither ASCII STL nor binary STL: " + std::to_string(number_of_triangles) +
                     " triangles are announced, there is room for " + std::to_string(room),
                 "check the ending of the file name, or fetch the file again");
  }
  points.reserve(3 * number_of_triangles);
  for (std::size_t i = 0; i < number_of_triangles; ++i) {
    scanner.skip(stl_normal_size);
    for (int corner = 0; corner < 3; ++corner) {
      points.push_back(scanner.vector<float>());
    }
    scanner.skip(stl_attribute_size);
  }
}

/// Reads ASCII STL.
void read_text_stl(Text_scanner& scanner, std::vector<Vector3>& points)
{
  if (!scanner.skip_blanks() || scanner.word() != "solid") {
    scanner.fail("neither ASCII STL nor binary STL: the keyword solid is missing", "check the ending of the file name");
  }
  bool is_complete = false;
  std::size_t first = 0; // of the points of a facet
  while (scanner.skip_blanks()) {
    const std::string_view word = scanner.word();
    is_complete = word == "endsolid" || word == "end"; // some write "end solid"
    if (word == "vertex") {
      Vector3& point = points.emplace_back();
      for (double& coordinate : point) {
        scanner.expect("all coordinates of a vertex");
        coordinate = scanner.coordinate();
      }
    } else if (word == "endfacet") {
      if (points.size() != first + 3) {
        scanner.fail("a facet does not have three vertices", "correct it or write the file again");
      }
      first = points.size();
    } else if (word == "solid" || is_complete) {
      scanner.skip_line(); // the name of the solid
    }
  }
  if (points.size() != first) {
    scanner.fail_at_end("the keyword endfacet");
  }
  if (!is_complete) {
    scanner.fail_at_end("the keyword endsolid");
  }
}
/// @}

} // namespace

/// Reads the vertices, and the faces or the lines, of OBJ; all other statements are passed over.
Shape_file parse_obj(std::string_view content, const std::string& filename, unsigned contents)
{
  Text_scanner scanner(content, filename);
  Shape_file shape;
  // Calls `use` with the vertices that a statement names, from 0 on. In the file they count from 1, negative ones from
  // the last vertex backwards.
  const auto for_each_vertex = [&](const auto& use) {
    while (scanner.skip_blanks_in_line() && !scanner.is_at("#")) {
      if (scanner.is_at("\\")) { // the statement goes on in the next line
        scanner.skip_line();
        continue;
      }
      const std::int64_t index = scanner.integer("the index of a vertex");
      const std::int64_t vertex = index > 0 ? index - 1 : std::int64_t(shape.points.size()) + index;
      if (index == 0 || vertex < 0 || vertex >= std::int64_t(no_index)) {
        scanner.fail("vertex " + std::to_string(index) + " is named, which does not exist (they count from 1)");
      }
      use(vertex);
      scanner.word(); // indices of texture coordinates and normals
    }
  };
  while (scanner.skip_blanks('#')) {
    const std::string_view statement = scanner.word();
    if (statement == "v") {
      shape.points.push_back(scanner.point_in_line(too_few_coordinates));
    } else if (statement == "f" && contents != skeleton_content) {
      for_each_vertex([&](std::int64_t vertex) { shape.corners.push_back(Index(vertex)); });
      shape.end_polygon();
    } else if (statement == "l" && (contents & skeleton_content) != 0) {
      std::int64_t previous = -1;
      for_each_vertex([&](std::int64_t vertex) {
        if (previous >= 0) {
          shape.lines.push_back({previous, vertex});
        }
        previous = vertex;
      });
    }
    shape.has_polygons = shape.has_polygons || statement == "f";
    scanner.skip_line();
  }
  return shape;
}

/// Reads OFF in ASCII, line by line; colors and texture coordinates are passed over.
Shape_file parse_off(std::string_view content, const std::string& filename, unsigned /* contents */)
{
  Text_scanner scanner(content, filename);
  const auto next_count = [&scanner](const char* meaning) {
    scanner.expect(meaning, comment_of_off);
    return scanner.count(meaning);
  };
  const bool has_normals = read_off_keyword(scanner);
  const std::size_t number_of_points = next_count("the number of vertices");
  const std::size_t number_of_polygons = next_count("the number of faces");
  scanner.skip_line();
  Shape_file shape;
  read_off_points(scanner, number_of_points, has_normals, shape);
  read_off_polygons(scanner, number_of_polygons, shape);
  return shape;
}

/// Reads ASCII and binary STL. STL repeats a vertex in each of its triangles; these are made one here.
Shape_file parse_stl(std::string_view content, const std::string& filename, unsigned /* contents */)
{
  Shape_file result;
  Text_scanner text(content, filename);
  // The text of a binary file may begin with `solid`, which an ASCII file must; the file's size decides then.
  const bool has_header = content.size() >= stl_header_size;
  Byte_scanner bytes(content.substr(has_header ? stl_text_size : content.size()), Byte_order::little, filename);
  Text_scanner first = text;
  first.skip_blanks();
  if (has_header &&
      (content.size() == stl_header_size + Byte_scanner(bytes).number<std::uint32_t>() * stl_triangle_size ||
       first.word() != "solid")) {
    read_binary_stl(bytes, filename, result.points);
  } else {
    read_text_stl(text, result.points);
  }
  check_points(result.points, filename); // equal ones are found by their coordinates, and by indices
  merge_equal_points(result.points, result.corners);
  for (std::size_t end = 3; end <= result.corners.size(); end += 3) {
    result.first_corner.push_back(end);
  }
  return result;
}

} // namespace CSCD::internal
