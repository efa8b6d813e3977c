// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading the OFF format.

#ifndef CSCD_IO_INTERNAL_PARSE_OFF_H
#define CSCD_IO_INTERNAL_PARSE_OFF_H

#include <CSCD/IO/internal/Polygon_soup.h>
#include <CSCD/IO/internal/Scanner.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace CSCD::internal {

/// Reads ASCII OFF line by line; colours and texture coordinates are passed over.
class Off_parser
{
public:
  Off_parser(std::string_view text, const std::string& filename) : m_scanner(text, filename), m_filename(filename) {}

  Polygon_soup parse()
  {
    read_keyword();
    read_counts();
    read_points();
    read_polygons();
    return std::move(m_soup);
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
    drop("ST");
    drop("C");
    m_has_normals = drop("N");
    m_is_homogeneous = drop("4");
    if (keyword != "OFF") {
      m_scanner.fail("this is no OFF file of three-dimensional points: the keyword OFF is missing",
                     "check the ending of the file name");
    }
  }

  void read_counts()
  {
    if (!m_scanner.skip_blanks(comment)) {
      m_scanner.fail_at_end("the number of vertices");
    }
    Text_scanner ahead = m_scanner;
    if (ahead.word() == "BINARY") {
      m_scanner.fail("binary OFF is not supported", "convert the file to ASCII OFF or to PLY");
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
    m_soup.points.reserve(std::min(m_number_of_points, m_scanner.remaining() / min_point_size + 1));
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
      m_soup.points.push_back(point);
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
        m_soup.normals.clear();
        return;
      }
      coordinate = m_scanner.number();
    }
    m_soup.normals.push_back(normal);
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
    m_soup.corners.reserve(3 * expected);
    m_soup.first_corner.reserve(expected + 1);
    for (std::size_t i = 0; i < m_number_of_polygons; ++i) {
      if (!m_scanner.skip_blanks(comment)) {
        m_scanner.fail_at_end("face " + std::to_string(i) + " of " + std::to_string(m_number_of_polygons));
      }
      const std::size_t size = m_scanner.count("the number of vertices of a face");
      if (size < 3) {
        m_scanner.fail("a face has fewer than three vertices", "remove it");
      }
      for (std::size_t k = 0; k < size; ++k) {
        m_soup.corners.push_back(next_corner());
      }
      m_soup.end_polygon();
      m_scanner.skip_line();
    }
  }

  Index next_corner()
  {
    if (!m_scanner.skip_blanks_in_line()) {
      m_scanner.fail("a face has fewer vertices than it announces", "correct this line or write the file again");
    }
    const std::size_t corner = m_scanner.count("the index of a vertex");
    if (corner >= m_number_of_points) {
      m_scanner.fail("a face names vertex " + std::to_string(corner) + ", but there are only " +
                         std::to_string(m_number_of_points) + " (counted from 0)",
                     "correct this line or write the file again");
    }
    return static_cast<Index>(corner);
  }

  Text_scanner m_scanner;
  std::string m_filename;
  Polygon_soup m_soup;
  std::size_t m_number_of_points = 0;
  std::size_t m_number_of_polygons = 0;
  bool m_has_normals = false;
  bool m_is_homogeneous = false;
};

/// Reads `text`, the content of an OFF file.
/// \throw File_error if it is malformed
inline Polygon_soup parse_off(std::string_view text, const std::string& filename)
{
  return Off_parser(text, filename).parse();
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_PARSE_OFF_H
