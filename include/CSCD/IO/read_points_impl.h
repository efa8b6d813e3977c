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
#include <CSCD/IO/internal/parse_scans.h>
#include <CSCD/IO/internal/parse_vtk.h>
#include <CSCD/IO/read_points.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/config.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Removes normals that are none, and tells so: unless most of them are of unit length, and differ, they are colors or
/// the like. Of normals, those of another length are set to zero: they are not known.
inline void keep_normals_only(Polygon_soup& soup)
{
  std::vector<Vector_3>& normals = soup.normals;
  soup.has_other_columns = !normals.empty();
  constexpr double tolerance = 0.01; // normals are written with few digits
  std::size_t number_of_unit_length = 0;
  bool do_differ = false;
  for (Vector_3& normal : normals) {
    if (std::abs(normal.norm() - 1) <= tolerance) {
      ++number_of_unit_length;
      do_differ = do_differ || normal != normals.front();
    } else {
      normal = Vector_3::Zero();
    }
  }
  if (2 * number_of_unit_length <= normals.size() || !do_differ) {
    normals.clear();
  }
  soup.has_other_columns = soup.has_other_columns && normals.empty();
}

/// Reads `text`, a point in each line: three coordinates, and perhaps three numbers of a normal; what follows is passed
/// over, as are empty lines, comments after `#` or `//`, and a first line with a single number or with words. If in
/// some line three further numbers are missing, they are taken for no normals anywhere.
/// \throw File_error if it is malformed or has no points
inline Polygon_soup parse_xyz(std::string_view text, const std::string& filename)
{
  constexpr std::size_t with_normal = 6;
  Polygon_soup soup;
  bool has_normals = true;
  bool is_first_line = true;
  Text_scanner scanner(text, filename);
  const auto is_comment = [&scanner] { return scanner.is_at("#") || scanner.is_at("//"); };
  while (scanner.skip_blanks()) {
    const bool is_header = std::exchange(is_first_line, is_first_line && is_comment()) && !scanner.is_at_number();
    if (is_comment() || is_header) {
      scanner.skip_line();
      continue;
    }
    std::array<double, with_normal> numbers{};
    std::size_t size = 0;
    for (; size < 3 && scanner.skip_blanks_in_line() && !is_comment(); ++size) {
      numbers[size] = scanner.coordinate();
    }
    if (size == 1 && soup.points.empty()) {
      continue; // the number of points
    }
    if (size < 3) {
      scanner.fail("a point has fewer than three coordinates", "correct this line or write the file again");
    }
    for (; has_normals && size < with_normal && scanner.skip_blanks_in_line() && !is_comment(); ++size) {
      numbers[size] = scanner.number();
    }
    scanner.skip_line();
    soup.points.emplace_back(numbers[0], numbers[1], numbers[2]);
    has_normals = has_normals && size == with_normal;
    if (has_normals) {
      soup.normals.emplace_back(numbers[3], numbers[4], numbers[5]);
    }
  }
  if (!has_normals) {
    soup.normals.clear();
  }
  keep_normals_only(soup);
  check_number_of_points(soup.points.size(), filename);
  return soup;
}

/// Reads a table with commas or names of columns, or else a file as `parse_xyz()` does.
/// \throw File_error if it is malformed or has no points
inline Polygon_soup parse_point_table(std::string_view content, const std::string& filename)
{
  const std::optional<Point_columns> columns = find_columns(content);
  if (!columns) {
    return parse_xyz(content, filename);
  }
  Polygon_soup soup = Point_table_parser(content, *columns, filename).parse();
  keep_normals_only(soup);
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
                      : format == Point_format::vtk ? parse_vtk(content, filename)
                      : format == Point_format::pcd ? Pcd_parser(content, filename).parse()
                      : format == Point_format::las ? parse_las(content, filename)
                                                    : parse_point_table(content, filename);
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
