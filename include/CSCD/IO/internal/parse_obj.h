// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading the OBJ format.

#ifndef CSCD_IO_INTERNAL_PARSE_OBJ_H
#define CSCD_IO_INTERNAL_PARSE_OBJ_H

#include <CSCD/IO/internal/Polygon_soup.h>
#include <CSCD/IO/internal/Scanner.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace CSCD::internal {

/// Reads the vertices and faces of Wavefront OBJ; all other statements are passed over.
class Obj_parser
{
public:
  Obj_parser(std::string_view text, const std::string& filename) : m_scanner(text, filename), m_filename(filename) {}

  Polygon_soup parse()
  {
    while (m_scanner.skip_blanks('#')) {
      const std::string_view statement = m_scanner.word();
      if (statement == "v") {
        read_point();
      } else if (statement == "f") {
        read_polygon();
      }
      m_scanner.skip_line();
    }
    check_number_of_points(m_soup.points.size(), m_filename);
    check_corners();
    return std::move(m_soup);
  }

private:
  void read_point()
  {
    Vector_3 point = Vector_3::Zero();
    for (double& coordinate : point) {
      if (!m_scanner.skip_blanks_in_line()) {
        m_scanner.fail("a vertex has too few coordinates", "correct this line or write the file again");
      }
      coordinate = m_scanner.coordinate();
    }
    m_soup.points.push_back(point);
  }

  void read_polygon()
  {
    const std::size_t first = m_soup.corners.size();
    while (m_scanner.skip_blanks_in_line()) {
      m_soup.corners.push_back(corner(m_scanner.integer("the index of a vertex")));
      m_scanner.word(); // indices of texture coordinates and normals
    }
    if (m_soup.corners.size() - first < 3) {
      m_scanner.fail("a face has fewer than three vertices", "remove it");
    }
    m_soup.end_polygon();
  }

  /// Indices count from 1, negative ones from the last vertex backwards.
  Index corner(std::int64_t index) const
  {
    const auto size = static_cast<std::int64_t>(m_soup.points.size());
    const std::int64_t corner = index > 0 ? index - 1 : size + index;
    if (index == 0 || corner < 0 || corner >= static_cast<std::int64_t>(no_index)) {
      m_scanner.fail("a face names vertex " + std::to_string(index) + ", which does not exist (they count from 1)",
                     "correct this line or write the file again");
    }
    return static_cast<Index>(corner);
  }

  /// Faces may stand before their vertices, so that this is known only now.
  void check_corners() const
  {
    if (m_soup.corners.empty()) {
      return;
    }
    const Index last = *std::max_element(m_soup.corners.begin(), m_soup.corners.end());
    if (last >= m_soup.points.size()) {
      throw File_error(m_filename + ": a face names vertex " + std::to_string(std::size_t(last) + 1) +
                       ", but there are only " + std::to_string(m_soup.points.size()) +
                       "; the file may be truncated, fetch or write it again");
    }
  }

  Text_scanner m_scanner;
  std::string m_filename;
  Polygon_soup m_soup;
};

/// Reads `text`, the content of an OBJ file.
/// \throw File_error if it is malformed
inline Polygon_soup parse_obj(std::string_view text, const std::string& filename)
{
  return Obj_parser(text, filename).parse();
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_PARSE_OBJ_H
