// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads Wavefront OBJ.

#include "Text_scanner.h"
#include "parse.h"
#include <CSCD/IO/Shape_file.h>
#include <CSCD/Vector_3.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace CSCD::internal {

namespace {

/// Reads vertices, and faces or lines; all other statements are passed over.
class Obj_parser
{
public:
  Obj_parser(std::string_view text, const std::string& filename, Wanted wanted)
      : m_scanner(text, filename), m_filename(filename), m_wanted(wanted)
  {
  }

  Shape_file parse()
  {
    bool has_faces = false;
    bool has_lines = false;
    while (m_scanner.skip_blanks(comment)) {
      const std::string_view statement = m_scanner.word();
      if (statement == "v") {
        read_point();
      } else if (statement == "f" && m_wanted == Wanted::surface) {
        for_each_vertex([this](std::int64_t vertex) { m_shape.corners.push_back(Index(vertex)); });
        m_shape.end_polygon();
      } else if (statement == "l" && m_wanted == Wanted::skeleton) {
        has_lines = true;
        read_line();
      }
      has_faces = has_faces || statement == "f";
      m_scanner.skip_line();
    }
    if (m_wanted == Wanted::skeleton && has_faces && !has_lines) {
      fail_without_lines(m_filename);
    }
    check_number_of_points(m_shape.points.size(), m_filename);
    check_corners(m_shape, m_filename);
    return std::move(m_shape);
  }

private:
  static constexpr char comment = '#';

  void read_point()
  {
    Vector_3 point = Vector_3::Zero();
    for (double& coordinate : point) {
      if (!m_scanner.skip_blanks_in_line()) {
        m_scanner.fail("a vertex has too few coordinates", "correct this line or write the file again");
      }
      coordinate = m_scanner.coordinate();
    }
    m_shape.points.push_back(point);
  }

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
        m_scanner.fail("vertex " + std::to_string(index) + " is named, which does not exist (they count from 1)",
                       "correct this line or write the file again");
      }
      use(vertex);
      m_scanner.word(); // indices of texture coordinates and normals
    }
  }

  void read_line()
  {
    std::int64_t previous = -1;
    for_each_vertex([&](std::int64_t vertex) {
      if (previous >= 0) {
        m_shape.lines.push_back({previous, vertex});
      }
      previous = vertex;
    });
  }

  Text_scanner m_scanner;
  std::string m_filename;
  Wanted m_wanted;
  Shape_file m_shape;
};

} // namespace

Shape_file parse_obj(std::string_view content, const std::string& filename, Wanted wanted)
{
  return Obj_parser(content, filename, wanted).parse();
}

} // namespace CSCD::internal
