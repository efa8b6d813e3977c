// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads Wavefront OBJ, OFF and STL.

#include "IO/Point_merger.h"
#include "IO/formats.h"
#include "IO/scanners.h"
#include <CSCD/IO/Shape_file.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace CSCD::internal {

namespace {

constexpr const char* too_few_coordinates = "a vertex has too few coordinates";

/// Reads the vertices, and the faces or the lines, of OBJ; all other statements are passed over.
class Obj_parser
{
public:
  Obj_parser(std::string_view text, const std::string& filename, unsigned contents)
      : m_scanner(text, filename), m_filename(filename), m_contents(contents)
  {
  }

  Shape_file parse()
  {
    bool has_faces = false;
    while (m_scanner.skip_blanks('#')) {
      const std::string_view statement = m_scanner.word();
      if (statement == "v") {
        m_shape.points.push_back(m_scanner.point_in_line(too_few_coordinates));
      } else if (statement == "f" && m_contents != skeleton_content) {
        for_each_vertex([this](std::int64_t vertex) { m_shape.corners.push_back(Index(vertex)); });
        m_shape.end_polygon();
      } else if (statement == "l" && (m_contents & skeleton_content) != 0) {
        m_has_lines = true;
        std::int64_t previous = -1;
        for_each_vertex([&](std::int64_t vertex) {
          if (previous >= 0) {
            m_shape.lines.push_back({previous, vertex});
          }
          previous = vertex;
        });
      }
      has_faces = has_faces || statement == "f";
      m_scanner.skip_line();
    }
    if (m_contents == skeleton_content && has_faces && !m_has_lines) {
      fail_without_lines(m_filename);
    }
    check_number_of_points(m_shape.points.size(), m_filename);
    check_corners(m_shape, m_filename);
    return std::move(m_shape);
  }

private:
  /// Calls `use` with the vertices that a statement names, from 0 on. In the file they count from 1, negative ones from
  /// the last vertex backwards.
  template <class Use>
  void for_each_vertex(const Use& use)
  {
    while (m_scanner.skip_blanks_in_line() && !m_scanner.is_at("#")) {
      if (m_scanner.is_at("\\")) { // the statement goes on in the next line
        m_scanner.skip_line();
        continue;
      }
      const std::int64_t index = m_scanner.integer("the index of a vertex");
      const std::int64_t vertex = index > 0 ? index - 1 : std::int64_t(m_shape.points.size()) + index;
      if (index == 0 || vertex < 0 || vertex >= std::int64_t(no_index)) {
        m_scanner.fail("vertex " + std::to_string(index) + " is named, which does not exist (they count from 1)");
      }
      use(vertex);
      m_scanner.word(); // indices of texture coordinates and normals
    }
  }

  Text_scanner m_scanner;
  std::string m_filename;
  unsigned m_contents;
  Shape_file m_shape;
  bool m_has_lines = false;
};

/// Reads OFF in ASCII, line by line; colors and texture coordinates are passed over.
class Off_parser
{
public:
  Off_parser(std::string_view text, const std::string& filename) : m_scanner(text, filename), m_filename(filename) {}

  Shape_file parse()
  {
    read_keyword();
    m_number_of_points = next_count("the number of vertices");
    check_number_of_points(m_number_of_points, m_filename);
    m_number_of_polygons = next_count("the number of faces");
    m_scanner.skip_line();
    read_points();
    read_polygons();
    return std::move(m_shape);
  }

private:
  static constexpr char comment = '#';
  /// The fewest bytes that a line of a point takes (`0 0 0` and a line end), and of a polygon (`1 0`).
  static constexpr std::size_t min_point_size = 6;
  static constexpr std::size_t min_polygon_size = 4;

  void read_keyword()
  {
    m_scanner.skip_blanks(comment);
    std::string_view keyword = m_scanner.word();
    const auto drop = [&keyword](std::string_view prefix) {
      const bool found = keyword.substr(0, prefix.size()) == prefix;
      keyword.remove_prefix(found ? prefix.size() : 0);
      return found;
    };
    drop("ST"); // texture coordinates, then colors
    drop("C");
    m_has_normals = drop("N");
    // Some writers leave no blank between the keyword and the number of vertices.
    if (!drop("OFF") || (!keyword.empty() && (keyword[0] < '0' || keyword[0] > '9'))) {
      m_scanner.fail("this is not an OFF file of three-dimensional points: the keyword OFF is missing",
                     "check the ending of the file name");
    }
    m_scanner.unread(keyword.size());
  }

  std::size_t next_count(const char* meaning)
  {
    m_scanner.expect(meaning, comment);
    return m_scanner.count(meaning);
  }

  void read_points()
  {
    m_shape.points.reserve(std::min(m_number_of_points, m_scanner.remaining() / min_point_size + 1));
    for (std::size_t i = 0; i < m_number_of_points; ++i) {
      if (!m_scanner.skip_blanks(comment)) {
        m_scanner.fail_at_end("vertex " + std::to_string(i) + " of " + std::to_string(m_number_of_points));
      }
      m_shape.points.push_back(m_scanner.point_in_line(too_few_coordinates));
      if (m_has_normals) {
        read_normal();
      }
      m_scanner.skip_line();
    }
  }

  /// Reads a normal; where one is incomplete, none is kept.
  void read_normal()
  {
    Vector_3 normal = Vector_3::Zero();
    for (double& coordinate : normal) {
      if (!m_scanner.skip_blanks_in_line()) {
        m_has_normals = false;
        m_shape.normals.clear();
        return;
      }
      coordinate = m_scanner.number();
    }
    m_shape.normals.push_back(normal);
  }

  void read_polygons()
  {
    m_shape.corners.reserve(3 * std::min(m_number_of_polygons, m_scanner.remaining() / min_polygon_size + 1));
    for (std::size_t i = 0; i < m_number_of_polygons; ++i) {
      if (!m_scanner.skip_blanks(comment)) {
        m_scanner.fail_at_end("face " + std::to_string(i) + " of " + std::to_string(m_number_of_polygons));
      }
      const std::size_t size = m_scanner.count("the number of vertices of a face");
      for (std::size_t k = 0; k < size; ++k) {
        m_scanner.expect("all vertices of a face", comment);
        const std::size_t corner = m_scanner.count("the index of a vertex");
        if (corner >= m_number_of_points) {
          m_scanner.fail("a face names vertex " + std::to_string(corner) + ", but there are only " +
                         std::to_string(m_number_of_points) + " (counted from 0)");
        }
        m_shape.corners.push_back(static_cast<Index>(corner));
      }
      m_shape.end_polygon();
      m_scanner.skip_line();
    }
  }

  Text_scanner m_scanner;
  std::string m_filename;
  Shape_file m_shape;
  std::size_t m_number_of_points = 0;
  std::size_t m_number_of_polygons = 0;
  bool m_has_normals = false;
};

/// Reads ASCII and binary STL. STL repeats a vertex in each of its triangles; these are made one here.
class Stl_parser
{
public:
  Stl_parser(std::string_view content, const std::string& filename) : m_content(content), m_filename(filename) {}

  Shape_file parse()
  {
    if (is_binary()) {
      read_binary();
    } else {
      read_text();
    }
    Shape_file result;
    m_points.move_to(result.points, result.corners);
    check_number_of_points(result.corners.size(), m_filename);
    result.first_corner = Corner_offsets(result.corners.size() / 3);
    return result;
  }

private:
  /// A binary file begins with a text without meaning, then the number of triangles, then the triangles: normal, three
  /// vertices, and two more bytes.
  static constexpr std::size_t text_size = 80;
  static constexpr std::size_t header_size = text_size + sizeof(std::uint32_t);
  static constexpr std::size_t normal_size = 3 * sizeof(float);
  static constexpr std::size_t attribute_size = 2;
  static constexpr std::size_t triangle_size = normal_size + 9 * sizeof(float) + attribute_size;

  /// The bytes behind the text. \pre there are as many as a header has
  Byte_scanner bytes() const { return {m_content.substr(text_size), Byte_order::little, m_filename}; }

  /// The text of a binary file may begin with `solid`, which an ASCII file must; the file's size decides then.
  bool is_binary() const
  {
    if (m_content.size() < header_size) {
      return false;
    }
    const auto number_of_triangles = std::size_t(bytes().number<std::uint32_t>());
    Text_scanner text(m_content, m_filename);
    text.skip_blanks();
    return m_content.size() == header_size + number_of_triangles * triangle_size || text.word() != "solid";
  }

  void read_binary()
  {
    Byte_scanner scanner = bytes();
    const auto number_of_triangles = std::size_t(scanner.number<std::uint32_t>());
    const std::size_t room = scanner.remaining() / triangle_size;
    if (number_of_triangles > room) {
      fail_in_file(m_filename,
                   "neither ASCII STL nor binary STL: " + std::to_string(number_of_triangles) +
                       " triangles are announced, there is room for " + std::to_string(room),
                   "check the ending of the file name, or fetch the file again");
    }
    check_number_of_points(3 * number_of_triangles, m_filename);
    m_points = Point_merger(3 * number_of_triangles);
    for (std::size_t i = 0; i < number_of_triangles; ++i) {
      scanner.skip(normal_size);
      for (int corner = 0; corner < 3; ++corner) {
        const Vector_3 point = scanner.vector<float>();
        if (!point.allFinite()) {
          fail_in_file(m_filename, "triangle " + std::to_string(i) + " has a coordinate that is not finite",
                       "remove the triangle or write the file again");
        }
        m_points.add(point);
      }
      scanner.skip(attribute_size);
    }
  }

  void read_text()
  {
    Text_scanner scanner(m_content, m_filename);
    if (!scanner.skip_blanks() || scanner.word() != "solid") {
      scanner.fail("neither ASCII STL nor binary STL: the keyword solid is missing",
                   "check the ending of the file name");
    }
    bool is_complete = false;
    while (scanner.skip_blanks()) {
      const std::string_view word = scanner.word();
      if (word == "facet") {
        read_facet(scanner);
      }
      is_complete = word == "endsolid" || word == "end"; // some write "end solid"
      if (word == "solid" || is_complete) {
        scanner.skip_line(); // the name of the solid
      }
    }
    if (!is_complete) {
      scanner.fail_at_end("the keyword endsolid");
    }
  }

  void read_facet(Text_scanner& scanner)
  {
    int number_of_vertices = 0;
    while (scanner.skip_blanks()) {
      const std::string_view word = scanner.word();
      if (word == "vertex") {
        Vector_3 point = Vector_3::Zero();
        for (double& coordinate : point) {
          scanner.expect("all coordinates of a vertex");
          coordinate = scanner.coordinate();
        }
        m_points.add(point);
        ++number_of_vertices;
      } else if (word == "endfacet") {
        if (number_of_vertices != 3) {
          scanner.fail("a facet does not have three vertices", "correct it or write the file again");
        }
        return;
      }
    }
    scanner.fail_at_end("the keyword endfacet");
  }

  std::string_view m_content;
  std::string m_filename;
  Point_merger m_points{0};
};

} // namespace

Shape_file parse_obj(std::string_view content, const std::string& filename, unsigned contents)
{
  return Obj_parser(content, filename, contents).parse();
}

Shape_file parse_off(std::string_view content, const std::string& filename, unsigned /* contents */)
{
  return Off_parser(content, filename).parse();
}

Shape_file parse_stl(std::string_view content, const std::string& filename, unsigned /* contents */)
{
  return Stl_parser(content, filename).parse();
}

} // namespace CSCD::internal
