// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads OFF, and raw meshes of Neuroglancer.

#include "Number_view.h"
#include "Text_scanner.h"
#include "parse.h"
#include <CSCD/IO/Shape_file.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace CSCD::internal {

namespace {

/// Reads OFF, ASCII line by line or binary; colors and texture coordinates are passed over.
class Off_parser
{
public:
  Off_parser(std::string_view text, const std::string& filename) : m_scanner(text, filename), m_filename(filename) {}

  Shape_file parse()
  {
    read_keyword();
    if (Text_scanner ahead = m_scanner; ahead.skip_blanks(comment) && ahead.word() == "BINARY") {
      ahead.skip_line();
      read_binary(ahead.rest());
    } else {
      read_counts();
      read_points();
      read_polygons();
    }
    return std::move(m_shape);
  }

private:
  static constexpr char comment = '#';
  /// The fewest bytes that a line of a point takes (`0 0 0` and a line end), and of a polygon (`1 0`).
  static constexpr std::size_t min_point_size = 6;
  static constexpr std::size_t min_polygon_size = 4;
  /// In binary files, of numbers of all kinds in bytes, and of colors in numbers.
  static constexpr std::size_t number_size = sizeof(std::uint32_t);
  static constexpr std::uint32_t max_size_of_color = 4;

  void read_keyword()
  {
    m_scanner.skip_blanks(comment);
    std::string_view keyword = m_scanner.word();
    const auto drop = [&keyword](std::string_view prefix) {
      const bool found = keyword.substr(0, prefix.size()) == prefix;
      keyword.remove_prefix(found ? prefix.size() : 0);
      return found;
    };
    m_size_of_appearance = drop("ST") ? 2 : 0;
    m_size_of_appearance += drop("C") ? max_size_of_color : 0;
    m_has_normals = drop("N");
    m_is_homogeneous = drop("4");
    // Some writers leave no blank between the keyword and the number of vertices.
    if (!drop("OFF") || (!keyword.empty() && (keyword[0] < '0' || keyword[0] > '9'))) {
      m_scanner.fail("this is not an OFF file of three-dimensional points: the keyword OFF is missing",
                     "check the ending of the file name");
    }
    m_scanner.unread(keyword.size());
  }

  void read_counts()
  {
    if (!m_scanner.skip_blanks(comment)) {
      m_scanner.fail_at_end("the number of vertices");
    }
    m_number_of_points = m_scanner.count("the number of vertices");
    check_number_of_points(m_number_of_points, m_filename);
    if (!m_scanner.skip_blanks(comment)) {
      m_scanner.fail_at_end("the number of faces");
    }
    m_number_of_polygons = m_scanner.count("the number of faces");
    m_scanner.skip_line();
  }

  void read_points()
  {
    m_shape.points.reserve(std::min(m_number_of_points, m_scanner.remaining() / min_point_size + 1));
    for (std::size_t i = 0; i < m_number_of_points; ++i) {
      if (!m_scanner.skip_blanks(comment)) {
        m_scanner.fail_at_end("vertex " + std::to_string(i) + " of " + std::to_string(m_number_of_points));
      }
      Vector_3 point = Vector_3::Zero();
      for (double& coordinate : point) {
        coordinate = next_coordinate();
      }
      if (m_is_homogeneous) {
        divide(point, next_coordinate());
      }
      m_shape.points.push_back(point);
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

  double next_coordinate()
  {
    if (!m_scanner.skip_blanks_in_line()) {
      m_scanner.fail("a vertex has too few coordinates", "correct this line or write the file again");
    }
    return m_scanner.coordinate();
  }

  void divide(Vector_3& point, double weight) const
  {
    if (weight != 0) {
      point /= weight;
    }
    if (weight == 0 || !point.allFinite()) {
      m_scanner.fail("a homogeneous vertex lies at infinity", "correct this line");
    }
  }

  void read_polygons()
  {
    const std::size_t expected = std::min(m_number_of_polygons, m_scanner.remaining() / min_polygon_size + 1);
    m_shape.corners.reserve(3 * expected);
    for (std::size_t i = 0; i < m_number_of_polygons; ++i) {
      if (!m_scanner.skip_blanks(comment)) {
        m_scanner.fail_at_end("face " + std::to_string(i) + " of " + std::to_string(m_number_of_polygons));
      }
      const std::size_t size = m_scanner.count("the number of vertices of a face");
      for (std::size_t k = 0; k < size; ++k) {
        m_shape.corners.push_back(next_corner());
      }
      m_shape.end_polygon();
      m_scanner.skip_line();
    }
  }

  Index next_corner()
  {
    if (!m_scanner.skip_blanks(comment)) { // some write each index on a line of its own
      m_scanner.fail_at_end("all vertices of a face");
    }
    const std::size_t corner = m_scanner.count("the index of a vertex");
    if (corner >= m_number_of_points) {
      m_scanner.fail("a face names vertex " + std::to_string(corner) + ", but there are only " +
                         std::to_string(m_number_of_points) + " (counted from 0)",
                     "correct this line or write the file again");
    }
    return static_cast<Index>(corner);
  }

  /// Reads the numbers behind the line of the keyword in a binary file: the same numbers as in ASCII, big endian, and
  /// with each polygon the number of its color's components. Or else, as pmp-library writes, little endian without
  /// that; a number of points that the file cannot hold tells so.
  void read_binary(std::string_view content)
  {
    const bool is_little =
        Byte_scanner(content, Byte_order::big, m_filename).number<std::uint32_t>() > content.size() / (3 * number_size);
    Byte_scanner bytes(content, is_little ? Byte_order::little : Byte_order::big, m_filename);
    m_number_of_points = bytes.number<std::uint32_t>();
    check_number_of_points(m_number_of_points, m_filename);
    m_number_of_polygons = bytes.number<std::uint32_t>();
    bytes.skip(number_size); // the number of edges
    m_shape.points.reserve(std::min(m_number_of_points, bytes.remaining() / (3 * number_size)));
    for (std::size_t i = 0; i < m_number_of_points; ++i) {
      Vector_3 point = next_vector(bytes);
      point /= m_is_homogeneous ? double(bytes.number<float>()) : 1.;
      if (!point.allFinite()) {
        throw File_error(m_filename + ": vertex " + std::to_string(i) + " is not finite; write the file again");
      }
      m_shape.points.push_back(point);
      if (m_has_normals) {
        m_shape.normals.push_back(next_vector(bytes));
      }
      bytes.skip(number_size * m_size_of_appearance);
    }
    for (std::size_t i = 0; i < m_number_of_polygons; ++i) {
      read_binary_polygon(bytes);
      if (!is_little) {
        skip_color_of_polygon(bytes);
      }
      m_shape.end_polygon();
    }
  }

  static Vector_3 next_vector(Byte_scanner& bytes)
  {
    Vector_3 vector = Vector_3::Zero();
    for (double& coordinate : vector) {
      coordinate = double(bytes.number<float>());
    }
    return vector;
  }

  void read_binary_polygon(Byte_scanner& bytes)
  {
    const auto size = bytes.number<std::uint32_t>();
    for (std::uint32_t k = 0; k < size; ++k) {
      const auto corner = bytes.number<std::uint32_t>();
      if (corner >= m_number_of_points) {
        fail_at_polygon("names vertex " + std::to_string(corner) + ", but there are only " +
                        std::to_string(m_number_of_points) + " (counted from 0)");
      }
      m_shape.corners.push_back(corner);
    }
  }

  void skip_color_of_polygon(Byte_scanner& bytes) const
  {
    const auto size_of_color = bytes.number<std::uint32_t>();
    if (size_of_color > max_size_of_color) {
      fail_at_polygon("has a color of " + std::to_string(size_of_color) + " components");
    }
    bytes.skip(number_size * size_of_color);
  }

  [[noreturn]] void fail_at_polygon(const std::string& fault) const
  {
    throw File_error(m_filename + ": face " + std::to_string(m_shape.number_of_polygons()) + " " + fault +
                     "; write the file again");
  }

  Text_scanner m_scanner;
  std::string m_filename;
  Shape_file m_shape;
  std::size_t m_size_of_appearance = 0; ///< the numbers that a vertex has for color and texture, in binary files
  std::size_t m_number_of_points = 0;
  std::size_t m_number_of_polygons = 0;
  bool m_has_normals = false;
  bool m_is_homogeneous = false;
};

} // namespace

Shape_file parse_off(std::string_view content, const std::string& filename, Wanted /* wanted */)
{
  return Off_parser(content, filename).parse();
}

/// Little endian: the number of vertices as `uint32`, three `float` for each, then three numbers of vertices, `uint32`,
/// for each triangle up to the end of the file.
Shape_file parse_neuroglancer(std::string_view content, const std::string& filename, Wanted /* wanted */)
{
  constexpr std::size_t vertex_size = 3 * sizeof(float);
  constexpr std::size_t triangle_size = 3 * sizeof(std::uint32_t);
  Byte_scanner scanner(content, Byte_order::little, filename);
  const std::size_t number_of_points = scanner.number<std::uint32_t>();
  if (number_of_points > scanner.remaining() / vertex_size ||
      (scanner.remaining() - number_of_points * vertex_size) % triangle_size != 0) {
    fail_in_file(filename,
                 "the file is too short or too long for a raw mesh of Neuroglancer with " +
                     std::to_string(number_of_points) + " vertices",
                 "check the ending of the file name, or fetch it again");
  }
  Shape_file shape;
  shape.points.resize(number_of_points);
  scanner.numbers({'f', sizeof(float)}, 3 * number_of_points).for_each([&shape](std::size_t i, double coordinate) {
    shape.points[i / 3][i % 3] = coordinate;
  });
  for (const Vector_3& point : shape.points) {
    if (!point.allFinite()) {
      fail_in_file(filename, "a vertex has a coordinate that is not finite");
    }
  }
  shape.corners.resize(scanner.remaining() / sizeof(std::uint32_t));
  for (Index& corner : shape.corners) {
    corner = scanner.number<std::uint32_t>();
  }
  check_corners(shape, filename);
  shape.first_corner = Corner_offsets(shape.corners.size() / 3);
  return shape;
}

} // namespace CSCD::internal
