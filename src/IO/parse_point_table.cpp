// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads tables of points: coordinates separated by blanks, commas or semicolons, with or without names of columns.

#include "Text_scanner.h"
#include "parse.h"
#include <CSCD/IO/Shape_file.h>
#include <CSCD/Vector_3.h>

#include <boost/algorithm/string/case_conv.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <locale>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace CSCD::internal {

namespace {

/// Discards columns that are not unit normals, and records it: unless most of them are of unit length, and differ, they
/// are colors or the like. Normals of another length are set to zero: they are not known.
void keep_normals_only(Shape_file& shape)
{
  std::vector<Vector_3>& normals = shape.normals;
  shape.has_other_columns = !normals.empty();
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
  shape.has_other_columns = shape.has_other_columns && normals.empty();
}

/// Reads `text`, a point in each line: three coordinates, and perhaps three numbers of a normal; further columns are
/// passed over, as are empty lines, comments after `#` or `//`, and a first line with a single number or with words. If
/// in some line three further numbers are missing, no line has a normal.
/// \throw File_error if it is malformed or has no points
Shape_file parse_xyz(std::string_view text, const std::string& filename)
{
  constexpr std::size_t with_normal = 6;
  Shape_file shape;
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
    if (size == 1 && shape.points.empty()) {
      continue; // the number of points
    }
    if (size < 3) {
      scanner.fail("a point has fewer than three coordinates", "correct this line or write the file again");
    }
    for (; has_normals && size < with_normal && scanner.skip_blanks_in_line() && !is_comment(); ++size) {
      numbers[size] = scanner.number();
    }
    scanner.skip_line();
    shape.points.emplace_back(numbers[0], numbers[1], numbers[2]);
    has_normals = has_normals && size == with_normal;
    if (has_normals) {
      shape.normals.emplace_back(numbers[3], numbers[4], numbers[5]);
    }
  }
  if (!has_normals) {
    shape.normals.clear();
  }
  check_number_of_points(shape.points.size(), filename);
  return shape;
}

/// Which columns of a table hold coordinates and normals, and what stands between columns.
struct Point_columns
{
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  std::array<std::size_t, 6> places{0, 1, 2, none, none, none}; ///< of x, y, z and of the normal
  char separator = 0;                                           ///< 0 for blanks

  bool has_normals() const { return places[3] != none && places[4] != none && places[5] != none; }
};

/// The fields of a line, without the blanks and quotes around them.
std::vector<std::string_view> split_fields(std::string_view line, char separator)
{
  constexpr std::string_view around = " \t\r\n\"";
  std::vector<std::string_view> result;
  while (true) {
    const std::size_t begin = separator == 0 ? line.find_first_not_of(around) : 0;
    if (begin == std::string_view::npos || (separator == 0 && line.empty())) {
      return result;
    }
    const std::size_t end = separator == 0 ? line.find_first_of(around, begin) : line.find(separator);
    std::string_view field = line.substr(begin, end == std::string_view::npos ? end : end - begin);
    field.remove_prefix(std::min(field.find_first_not_of(around), field.size()));
    const std::size_t last = field.find_last_not_of(around);
    result.push_back(field.substr(0, last == std::string_view::npos ? 0 : last + 1));
    if (end == std::string_view::npos) {
      return result;
    }
    line.remove_prefix(end + (separator == 0 ? 0 : 1));
  }
}

/// What separates the numbers of the first line that begins with one and has several: 0 for blanks. Where a `;`
/// separates, a comma may belong to a number.
char find_separator(std::string_view text)
{
  constexpr std::string_view begin_of_number = "0123456789+-.\"";
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin != std::string_view::npos && begin_of_number.find(line[begin]) != std::string_view::npos) {
      for (const char separator : {';', ','}) {
        if (line.find(separator) != std::string_view::npos) {
          return separator;
        }
      }
      if (split_fields(line, 0).size() > 1) {
        return 0;
      }
    }
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return 0;
}

/// The columns, if other than blanks separate them, or if the first line, perhaps behind `//` or `#`, names those of
/// all three coordinates.
std::optional<Point_columns> find_columns(std::string_view text)
{
  const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  std::string_view line = text.substr(begin, text.find('\n', begin) - begin);
  Point_columns columns;
  columns.separator = find_separator(text);
  line.remove_prefix(std::min(line.find_first_not_of("#/ \t"), line.size()));
  const std::vector<std::string_view> fields = split_fields(line, columns.separator);
  constexpr std::array<std::array<std::string_view, 3>, 6> names{{{"x", "x_m", "coord_x"},
                                                                  {"y", "y_m", "coord_y"},
                                                                  {"z", "z_m", "coord_z"},
                                                                  {"nx", "normal_x", "normalx"},
                                                                  {"ny", "normal_y", "normaly"},
                                                                  {"nz", "normal_z", "normalz"}}};
  std::array<std::size_t, 6> places{};
  places.fill(Point_columns::none);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::string name = boost::algorithm::to_lower_copy(std::string(fields[i]), std::locale::classic());
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (std::find(names[k].begin(), names[k].end(), name) != names[k].end() && places[k] == Point_columns::none) {
        places[k] = i;
      }
    }
  }
  const bool is_named = std::count(places.begin(), places.begin() + 3, Point_columns::none) == 0;
  if (is_named) {
    columns.places = places;
  } else if (columns.separator != 0) {
    columns.places = {0, 1, 2, 3, 4, 5};
  }
  return is_named || columns.separator != 0 ? std::optional<Point_columns>(columns) : std::nullopt;
}

/// Reads a table with a point in each line. Empty lines, comments after `#` or `//`, a first line with words, and the
/// number of points before the first one are passed over. Normals are kept if every line has one.
/// \throw File_error if a line has no coordinates, or there are no points
class Point_table_parser
{
public:
  Point_table_parser(std::string_view text, const Point_columns& columns, const std::string& filename)
      : m_scanner(text, filename), m_columns(columns), m_filename(filename), m_has_normals(columns.has_normals())
  {
  }

  Shape_file parse()
  {
    bool is_first_line = true;
    while (m_scanner.skip_blanks()) {
      const bool is_header = std::exchange(is_first_line, false) && !is_number_next();
      if (!is_header && !m_scanner.is_at("#") && !m_scanner.is_at("//")) {
        const std::string_view rest = m_scanner.rest();
        read_line(split_fields(rest.substr(0, rest.find('\n')), m_columns.separator));
      }
      m_scanner.skip_line();
    }
    if (!m_has_normals) {
      m_shape.normals.clear();
    }
    check_number_of_points(m_shape.points.size(), m_filename);
    return std::move(m_shape);
  }

private:
  bool is_number_next() const
  {
    Text_scanner ahead = m_scanner;
    ahead.skip_character('"');
    return ahead.is_at_number();
  }

  void read_line(const std::vector<std::string_view>& fields)
  {
    if (fields.size() == 1 && m_shape.points.empty()) {
      return; // the number of points
    }
    Vector_3 point;
    for (std::size_t i = 0; i < 3; ++i) {
      if (m_columns.places[i] >= fields.size()) {
        m_scanner.fail("a point has fewer than three coordinates", "correct this line or write the file again");
      }
      const std::optional<double> number = to_number(fields[m_columns.places[i]]);
      if (!number) {
        m_scanner.fail("a number with a decimal point is expected", "correct this line or write the file again");
      }
      if (!std::isfinite(*number)) {
        m_scanner.fail("a coordinate is not finite", "correct or remove this line");
      }
      point[i] = *number;
    }
    m_shape.points.push_back(point);
    for (std::size_t i = 3; m_has_normals && i < 6; ++i) {
      const std::size_t place = m_columns.places[i];
      const std::optional<double> number = place < fields.size() ? to_number(fields[place]) : std::nullopt;
      m_has_normals = number.has_value();
      m_normal[i - 3] = number.value_or(0);
    }
    if (m_has_normals) {
      m_shape.normals.push_back(m_normal);
    }
  }

  std::optional<double> to_number(std::string_view field) const
  {
    Text_scanner scanner(field, m_filename);
    if (!scanner.is_at_number()) {
      return std::nullopt;
    }
    scanner.skip_character('+');
    double value = 0;
    const std::from_chars_result result = number_from_chars(scanner.rest().data(), field.data() + field.size(), value);
    const bool is_all = result.ptr == field.data() + field.size() && result.ec == std::errc();
    return is_all ? std::optional<double>(value) : std::nullopt;
  }

  Text_scanner m_scanner;
  Point_columns m_columns;
  std::string m_filename;
  bool m_has_normals;
  Vector_3 m_normal;
  Shape_file m_shape;
};

} // namespace

/// Reads a table with commas or names of columns, or else a file as `parse_xyz()` does.
Shape_file parse_point_table(std::string_view content, const std::string& filename, Wanted /* wanted */)
{
  const std::optional<Point_columns> columns = find_columns(content);
  Shape_file shape = columns ? Point_table_parser(content, *columns, filename).parse() : parse_xyz(content, filename);
  keep_normals_only(shape);
  return shape;
}

} // namespace CSCD::internal
