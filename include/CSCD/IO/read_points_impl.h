// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of read_points.h.

#ifndef CSCD_IO_READ_POINTS_IMPL_H
#define CSCD_IO_READ_POINTS_IMPL_H

#include <CSCD/IO/Mesh_format.h>
#include <CSCD/IO/internal/Polygon_soup.h>
#include <CSCD/IO/internal/Scanner.h>
#include <CSCD/IO/internal/parse_mesh.h>
#include <CSCD/IO/internal/parse_ply.h>
#include <CSCD/IO/read_points.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/config.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <istream>
#include <string>
#include <string_view>

namespace CSCD::internal {

/// Reads `text`, a point in each line: three coordinates, and perhaps three numbers of a normal; what follows is passed
/// over, as are empty lines, comments after `#`, and a first line with a single number. If in some line three further
/// numbers are missing or longer than a unit vector can be, they are taken for no normals anywhere: they may be
/// colors. \throw File_error if it is malformed or has no points
inline Polygon_soup parse_xyz(std::string_view text, const std::string& filename)
{
  constexpr char comment = '#';
  constexpr double longest_normal = 1.01; // normals written with few digits may be a little longer than 1
  constexpr std::size_t with_normal = 6;
  Polygon_soup soup;
  bool has_normals = true;
  Text_scanner scanner(text, filename);
  for (bool is_first_line = true; scanner.skip_blanks(comment); is_first_line = false) {
    std::array<double, with_normal> numbers{};
    std::size_t size = 0;
    for (; size < 3 && scanner.skip_blanks_in_line(); ++size) {
      numbers[size] = scanner.coordinate();
    }
    if (size == 1 && is_first_line) {
      continue;
    }
    if (size < 3) {
      scanner.fail("a point has fewer than three coordinates", "correct this line or write the file again");
    }
    for (; has_normals && size < with_normal && scanner.skip_blanks_in_line(); ++size) {
      numbers[size] = scanner.number();
    }
    scanner.skip_line();
    soup.points.emplace_back(numbers[0], numbers[1], numbers[2]);
    const Vector_3 normal(numbers[3], numbers[4], numbers[5]);
    has_normals = has_normals && size == with_normal && normal.norm() <= longest_normal;
    if (has_normals) {
      soup.normals.push_back(normal);
    }
  }
  const bool are_known =
      std::any_of(soup.normals.begin(), soup.normals.end(), [](const Vector_3& n) { return n != Vector_3::Zero(); });
  if (!has_normals || !are_known) {
    soup.normals.clear();
  }
  check_number_of_points(soup.points.size(), filename);
  return soup;
}

/// Reads the points of a file of which `content` is the content, and its faces, if it has any.
/// \throw File_error if it is malformed or has no points
inline Polygon_soup parse_points(std::string_view content, Point_format format, const std::string& filename)
{
  if (content.empty()) {
    throw File_error(filename + ": the file is empty; fetch or write it again");
  }
  Polygon_soup soup = format == Point_format::off   ? parse_off(content, filename)
                      : format == Point_format::ply ? parse_ply(content, filename)
                                                    : parse_xyz(content, filename);
  if (soup.points.empty()) {
    throw File_error(filename + ": the file has no points; fetch or write it again");
  }
  return soup;
}

CSCD_INLINE Polygon_soup read_point_soup(const std::string& filename)
{
  const Point_format format = point_format(filename);
  return parse_points(read_content(filename), format, filename);
}

CSCD_INLINE Polygon_soup read_point_soup(std::istream& in, Point_format format, const std::string& name)
{
  return parse_points(read_content(in, name), format, name);
}

} // namespace CSCD::internal

#endif // CSCD_IO_READ_POINTS_IMPL_H
