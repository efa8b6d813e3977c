// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads STL.

#include "Number_view.h"
#include "Point_merger.h"
#include "Text_scanner.h"
#include "parse.h"
#include <CSCD/IO/Shape_file.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace CSCD::internal {

namespace {

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
    return shape();
  }

private:
  /// A binary file begins with a text without meaning, then the number of triangles, then the triangles: normal, three
  /// vertices, and two more bytes.
  static constexpr std::size_t text_size = 80;
  static constexpr std::size_t header_size = text_size + sizeof(std::uint32_t);
  static constexpr std::size_t normal_size = 3 * sizeof(float);
  static constexpr std::size_t attribute_size = 2;
  static constexpr std::size_t triangle_size = normal_size + 9 * sizeof(float) + attribute_size;

  /// The text of a binary file may begin with `solid`, which an ASCII file must; the file's size decides then.
  bool is_binary() const
  {
    constexpr std::string_view solid = "solid";
    if (m_content.size() < header_size) {
      return false;
    }
    Byte_scanner scanner(m_content.substr(text_size), Byte_order::little, m_filename);
    const auto number_of_triangles = std::size_t(scanner.number<std::uint32_t>());
    Text_scanner text(m_content, m_filename);
    text.skip_blanks();
    return m_content.size() == header_size + number_of_triangles * triangle_size || text.word() != solid;
  }

  void read_binary()
  {
    Byte_scanner scanner(m_content.substr(text_size), Byte_order::little, m_filename);
    const auto number_of_triangles = std::size_t(scanner.number<std::uint32_t>());
    if (number_of_triangles > scanner.remaining() / triangle_size) {
      throw File_error(m_filename + ": neither ASCII STL nor binary STL: " + std::to_string(number_of_triangles) +
                       " triangles are announced, there is room for " +
                       std::to_string(scanner.remaining() / triangle_size) +
                       "; check the ending of the file name, or fetch the file again");
    }
    check_number_of_points(3 * number_of_triangles, m_filename);
    m_points = Point_merger(3 * number_of_triangles);
    for (std::size_t i = 0; i < number_of_triangles; ++i) {
      scanner.skip(normal_size);
      for (int corner = 0; corner < 3; ++corner) {
        m_points.add(next_point(scanner, i));
      }
      scanner.skip(attribute_size);
    }
  }

  Vector_3 next_point(Byte_scanner& scanner, std::size_t triangle) const
  {
    Vector_3 point = Vector_3::Zero();
    for (double& coordinate : point) {
      coordinate = double(scanner.number<float>());
      if (!std::isfinite(coordinate)) {
        throw File_error(m_filename + ": triangle " + std::to_string(triangle) +
                         " has a coordinate that is not finite; remove the triangle or write the file again");
      }
    }
    return point;
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
        read_vertex(scanner);
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

  void read_vertex(Text_scanner& scanner)
  {
    Vector_3 point = Vector_3::Zero();
    for (double& coordinate : point) {
      if (!scanner.skip_blanks()) {
        scanner.fail_at_end("all coordinates of a vertex");
      }
      coordinate = scanner.coordinate();
    }
    m_points.add(point);
  }

  Shape_file shape()
  {
    Shape_file result;
    m_points.move_to(result.points, result.corners);
    check_number_of_points(result.corners.size(), m_filename);
    result.first_corner = Corner_offsets(result.corners.size() / 3);
    return result;
  }

  std::string_view m_content;
  std::string m_filename;
  Point_merger m_points{0};
};

} // namespace

Shape_file parse_stl(std::string_view content, const std::string& filename, Wanted /* wanted */)
{
  return Stl_parser(content, filename).parse();
}

} // namespace CSCD::internal
