// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads points: tables of coordinates separated by blanks, commas or semicolons, with or without names of columns; PCD;
// and LAS.

#include "IO/formats.h"
#include "IO/scanners.h"
#include <CSCD/IO/Shape_file.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CSCD::internal {

namespace {

/// Discards columns that are not unit normals, and records it: unless most of them are of unit length, and differ, they
/// are colors or the like. Normals of another length are set to zero: they are not known.
void keep_normals_only(Shape_file& shape)
{
  std::vector<Vector_3>& normals = shape.normals;
  const bool has_columns = !normals.empty();
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
  shape.has_other_columns = has_columns && normals.empty();
}

/// Which columns of a table hold coordinates and normals, and the separator of columns.
struct Point_columns
{
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  std::array<std::size_t, 6> places{0, 1, 2, 3, 4, 5}; ///< of x, y, z and of the normal
  char separator = 0;                                  ///< 0 for blanks

  bool has_normals() const { return places[3] != none && places[4] != none && places[5] != none; }
};

/// Finds the fields of a line, without the blanks and quotes around them.
/// \param result is replaced; its memory is used again
void split_fields(std::string_view line, char separator, std::vector<std::string_view>& result)
{
  constexpr std::string_view around = " \t\r\n\v\f\"";
  result.clear();
  while (true) {
    const std::size_t begin = separator == 0 ? line.find_first_not_of(around) : 0;
    if (begin == std::string_view::npos || (separator == 0 && line.empty())) {
      return;
    }
    const std::size_t end = separator == 0 ? line.find_first_of(around, begin) : line.find(separator);
    std::string_view field = line.substr(begin, end == std::string_view::npos ? end : end - begin);
    field.remove_prefix(std::min(field.find_first_not_of(around), field.size()));
    const std::size_t last = field.find_last_not_of(around);
    result.push_back(field.substr(0, last == std::string_view::npos ? 0 : last + 1));
    if (end == std::string_view::npos) {
      return;
    }
    line.remove_prefix(end + (separator == 0 ? 0 : 1));
  }
}

/// The separator of the numbers of the first line that begins with one and has several: 0 for blanks. Where a `;`
/// separates, a comma may belong to a number.
char find_separator(std::string_view text)
{
  constexpr std::string_view begin_of_number = "0123456789+-.\"";
  std::vector<std::string_view> fields;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin != std::string_view::npos && begin_of_number.find(line[begin]) != std::string_view::npos) {
      for (const char separator : {';', ','}) {
        if (line.find(separator) != std::string_view::npos) {
          return separator;
        }
      }
      split_fields(line, 0, fields);
      if (fields.size() > 1) {
        return 0;
      }
    }
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return 0;
}

/// The columns that the first line, perhaps behind `//` or `#`, names, if it names those of all three coordinates; or
/// else the first ones.
Point_columns find_columns(std::string_view text)
{
  const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  std::string_view line = text.substr(begin, text.find('\n', begin) - begin);
  Point_columns columns;
  columns.separator = find_separator(text);
  line.remove_prefix(std::min(line.find_first_not_of("#/ \t"), line.size()));
  std::vector<std::string_view> fields;
  split_fields(line, columns.separator, fields);
  constexpr std::array<std::array<std::string_view, 3>, 6> names{{{"x", "x_m", "coord_x"},
                                                                  {"y", "y_m", "coord_y"},
                                                                  {"z", "z_m", "coord_z"},
                                                                  {"nx", "normal_x", "normalx"},
                                                                  {"ny", "normal_y", "normaly"},
                                                                  {"nz", "normal_z", "normalz"}}};
  std::array<std::size_t, 6> places{};
  places.fill(Point_columns::none);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::string name = lower_case(fields[i]);
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (std::find(names[k].begin(), names[k].end(), name) != names[k].end() && places[k] == Point_columns::none) {
        places[k] = i;
      }
    }
  }
  const bool is_named = std::count(places.begin(), places.begin() + 3, Point_columns::none) == 0;
  columns.places = is_named ? places : columns.places;
  return columns;
}

/// Reads a table with a point in each line. Empty lines, comments after `#` or `//`, a first line with words, the
/// number of points before the first one and further columns are passed over. Normals are kept if every line has one.
/// \throw File_error if a line has no coordinates, or the table has no points
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
      const bool is_comment = m_scanner.is_at("#") || m_scanner.is_at("//");
      const bool is_header = std::exchange(is_first_line, is_first_line && is_comment) && !is_number_next();
      if (!is_header && !is_comment) {
        const std::string_view rest = m_scanner.rest();
        split_fields(rest.substr(0, rest.find('\n')), m_columns.separator, m_fields);
        read_line(m_fields);
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
        m_scanner.fail("a point has fewer than three coordinates");
      }
      const std::optional<double> number = to_number(fields[m_columns.places[i]]);
      if (!number) {
        m_scanner.fail(Text_scanner::number_expected);
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

  static std::optional<double> to_number(std::string_view field)
  {
    field.remove_prefix(field.substr(0, 1) == "+" ? 1 : 0);
    const char* const end = field.data() + field.size();
    double value = 0;
    return Text_scanner::read_number(field.data(), end, value) == end ? std::optional<double>(value) : std::nullopt;
  }

  Text_scanner m_scanner;
  Point_columns m_columns;
  std::string m_filename;
  bool m_has_normals;
  std::vector<std::string_view> m_fields; ///< of a line
  Vector_3 m_normal;
  Shape_file m_shape;
};

/// Reads PCD of the Point Cloud Library, ASCII or binary. Points that are not finite, which stand for missing
/// measurements, are left out.
class Pcd_parser
{
public:
  Pcd_parser(std::string_view text, const std::string& filename) : m_scanner(text, filename), m_filename(filename) {}

  Shape_file parse()
  {
    read_header();
    if (m_encoding == "ascii") {
      read_text();
    } else if (m_encoding == "binary") {
      read_binary(m_scanner.rest());
    } else {
      m_scanner.fail("DATA is neither ascii nor binary",
                     "write the file as DATA binary, as by `pcl_convert_pcd_ascii_binary IN.pcd OUT.pcd 1`");
    }
    return std::move(m_shape);
  }

private:
  static constexpr const char* remedy = "write the file again";

  struct Field
  {
    std::string name;
    Number_type type{'f', 4};
    std::size_t count = 1; ///< numbers of the field at each point
  };

  void read_header()
  {
    while (m_encoding.empty()) {
      m_scanner.expect("the keyword DATA", '#');
      const std::string keyword(m_scanner.word());
      if (keyword == "FIELDS") {
        while (m_scanner.skip_blanks_in_line()) {
          m_fields.push_back({std::string(m_scanner.word())});
        }
      } else if (keyword == "SIZE" || keyword == "COUNT" || keyword == "TYPE") {
        for (std::size_t i = 0; i < m_fields.size() && m_scanner.skip_blanks_in_line(); ++i) {
          read_property(keyword, m_fields[i]);
        }
      } else if (keyword == "POINTS") {
        m_number_of_points = m_scanner.skip_blanks_in_line() ? m_scanner.count("the number of points") : 0;
      } else if (keyword == "DATA") {
        m_encoding = m_scanner.skip_blanks_in_line() ? std::string(m_scanner.word()) : "none";
      }
      m_scanner.skip_line();
    }
    check_fields();
    check_number_of_points(m_number_of_points, m_filename);
  }

  void read_property(const std::string& keyword, Field& field)
  {
    if (keyword == "TYPE") {
      const std::string_view type = m_scanner.word();
      field.type.kind = type == "I" ? 'i' : type == "U" ? 'u' : 'f';
    } else {
      (keyword == "SIZE" ? field.type.size : field.count) = m_scanner.count("the size of a field");
    }
  }

  void check_fields()
  {
    constexpr std::size_t max_count = 1U << 20U; // bounds the size of a point
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
      if (!m_fields[i].type.is_valid() || m_fields[i].count > max_count) {
        m_scanner.fail("a field has an unknown type or size", remedy);
      }
      m_field_of.emplace(m_fields[i].name, i);
      m_size_of_point += m_fields[i].count * m_fields[i].type.size;
    }
    for (const char* name : {"x", "y", "z"}) {
      if (m_field_of.count(name) == 0 || m_fields[m_field_of[name]].count != 1) {
        m_scanner.fail("the field " + std::string(name) + " is missing", remedy);
      }
    }
    m_has_normals = m_field_of.count("normal_x") + m_field_of.count("normal_y") + m_field_of.count("normal_z") == 3;
  }

  void add(const std::vector<double>& numbers)
  {
    const auto vector = [&](const char* x, const char* y, const char* z) {
      return Vector_3(numbers[m_field_of[x]], numbers[m_field_of[y]], numbers[m_field_of[z]]);
    };
    const Vector_3 point = vector("x", "y", "z");
    if (point.allFinite()) {
      m_shape.points.push_back(point);
      if (m_has_normals) {
        const Vector_3 normal = vector("normal_x", "normal_y", "normal_z");
        m_shape.normals.push_back(normal.allFinite() ? normal : Vector_3::Zero());
      }
    }
  }

  void read_text()
  {
    std::vector<double> numbers(m_fields.size());
    for (std::size_t point = 0; point < m_number_of_points; ++point) {
      for (std::size_t f = 0; f < m_fields.size(); ++f) {
        for (std::size_t i = 0; i < m_fields[f].count; ++i) {
          if (!m_scanner.skip_blanks()) {
            m_scanner.fail_at_end("point " + std::to_string(point) + " of " + std::to_string(m_number_of_points));
          }
          numbers[f] = m_scanner.number();
        }
      }
      add(numbers);
    }
  }

  void read_binary(std::string_view bytes)
  {
    if (m_number_of_points > bytes.size() / m_size_of_point) {
      m_scanner.fail_at_end("all of its " + std::to_string(m_number_of_points) + " points");
    }
    std::vector<Number_view> columns;
    std::size_t offset = 0;
    for (const Field& field : m_fields) {
      columns.push_back({bytes.data() + offset, field.type, Byte_order::little, m_size_of_point, m_number_of_points});
      offset += field.count * field.type.size;
    }
    std::vector<double> numbers(m_fields.size());
    for (std::size_t point = 0; point < m_number_of_points; ++point) {
      for (std::size_t f = 0; f < m_fields.size(); ++f) {
        numbers[f] = m_fields[f].count == 1 ? columns[f][point] : 0;
      }
      add(numbers);
    }
  }

  Text_scanner m_scanner;
  std::string m_filename;
  std::vector<Field> m_fields;
  std::map<std::string, std::size_t> m_field_of;
  std::size_t m_size_of_point = 0;
  std::size_t m_number_of_points = 0;
  bool m_has_normals = false;
  std::string m_encoding;
  Shape_file m_shape;
};

} // namespace

Shape_file parse_point_table(std::string_view content, const std::string& filename, unsigned /* contents */)
{
  Shape_file shape = Point_table_parser(content, find_columns(content), filename).parse();
  keep_normals_only(shape);
  return shape;
}

Shape_file parse_pcd(std::string_view content, const std::string& filename, unsigned /* contents */)
{
  return Pcd_parser(content, filename).parse();
}

/// Reads versions 1.0 to 1.4, not compressed.
Shape_file parse_las(std::string_view content, const std::string& filename, unsigned /* contents */)
{
  // Offsets in the header, by the specification of the ASPRS.
  constexpr std::size_t header_size = 227;
  constexpr std::size_t minor_version_at = 25;
  constexpr std::size_t data_offset_at = 96;   // then the format, the size and the number of points
  constexpr std::size_t scale_at = 131;        // then the offset
  constexpr std::size_t large_number_at = 247; // from version 1.4
  constexpr unsigned compression_bits = 0xc0;
  constexpr std::size_t min_point_size = 3 * sizeof(std::int32_t);
  const auto scanner_at = [&](std::size_t place) {
    return Byte_scanner(content.substr(std::min(place, content.size())), Byte_order::little, filename);
  };
  if (content.substr(0, 4) != "LASF" || content.size() < header_size) {
    fail_in_file(filename, "it is not a LAS file, or its header is not complete", "fetch or write the file again");
  }
  Byte_scanner header = scanner_at(data_offset_at);
  const std::size_t data_offset = header.number<std::uint32_t>();
  header.skip(sizeof(std::uint32_t)); // the number of records of variable length
  if ((header.number<std::uint8_t>() & compression_bits) != 0) {
    fail_in_file(filename, "it is compressed (LAZ), which is not read",
                 "convert it to LAS, as by `laszip` or `pdal translate`");
  }
  const std::size_t point_size = header.number<std::uint16_t>();
  std::uint64_t number_of_points = header.number<std::uint32_t>();
  if (number_of_points == 0 && content[minor_version_at] >= 4) {
    number_of_points = scanner_at(large_number_at).number<std::uint64_t>();
  }
  Byte_scanner transform = scanner_at(scale_at);
  const Vector_3 scale = transform.vector<double>();
  const Vector_3 offset = transform.vector<double>();
  const std::size_t size_of_data = content.size() - std::min(data_offset, content.size());
  if (point_size < min_point_size || number_of_points > size_of_data / point_size) {
    fail_in_file(filename, "the file ends before all points that its header promises",
                 "it seems truncated, fetch or write it again");
  }
  check_number_of_points(number_of_points, filename);
  Shape_file shape;
  shape.points.reserve(number_of_points);
  Byte_scanner scanner = scanner_at(data_offset);
  for (std::uint64_t i = 0; i < number_of_points; ++i) {
    Vector_3 point = scanner.vector<std::int32_t>();
    for (int axis = 0; axis < 3; ++axis) {
      point[axis] = point[axis] * scale[axis] + offset[axis];
    }
    if (!point.allFinite()) {
      fail_in_file(filename, "the scale or offset in the header is not finite");
    }
    scanner.skip(point_size - min_point_size);
    shape.points.push_back(point);
  }
  return shape;
}

} // namespace CSCD::internal
