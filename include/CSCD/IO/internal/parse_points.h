// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading points from lines of numbers: the formats XYZ and PTS.

#ifndef CSCD_IO_INTERNAL_PARSE_POINTS_H
#define CSCD_IO_INTERNAL_PARSE_POINTS_H

#include <CSCD/IO/internal/Polygon_soup.h>
#include <CSCD/IO/internal/Scanner.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace CSCD::internal {

/// Reads `text`, a point in each line: three coordinates, and perhaps three numbers of a normal; what follows is passed
/// over, as are empty lines, comments after `#`, and a first line with a single number. If in some line three further
/// numbers are missing or longer than a unit vector can be, they are taken for no normals anywhere: they may be
/// colours. \throw File_error if it is malformed or has no points
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

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_PARSE_POINTS_H
