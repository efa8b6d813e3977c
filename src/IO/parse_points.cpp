// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads points: tables of coordinates separated by blanks, commas or semicolons, with or without names of columns; PCD;
// and LAS.

#include "IO/formats.h"
#include "IO/scanners.h"
#include <CSCD/IO/Shape_file.h>
#include <CSCD/Vector3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
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
  std::vector<Vector3>& normals = shape.normals;
  const bool has_columns = !normals.empty();
  constexpr double tolerance = 0.01; // normals are written with few digits
  std::size_t number_of_unit_length = 0;
  bool do_differ = false;
  for (Vector3& normal : normals) {
    if (std::abs(normal.norm() - 1) <= tolerance) {
      ++number_of_unit_length;
      do_differ = do_differ || normal != normals.front();
    } else {
      normal = Vector3::Zero();
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

/// The number that is all of a field of a table.
std::optional<double> to_number(std::string_view field)
{
  field.remove_prefix(field.substr(0, 1) == "+" ? 1 : 0);
  const char* const end = field.data() + field.size();
  double value = 0;
  return Text_scanner::read_number(field.data(), end, value) == end ? std::optional<double>(value) : std::nullopt;
}

/// A field of the points of a file.
struct Pcd_field
{
  std::string name;
  Number_type type{'f', 4};
  std::size_t count = 1; ///< numbers of the field at each point
};

struct Pcd_header
{
  /// The places of these among the fields; the last three are the number of fields if normals are missing.
  std::array<std::size_t, 6> places{};
  std::vector<Pcd_field> fields;
  std::size_t size_of_point = 0;
  std::size_t number_of_points = 0;
  std::string encoding;

  bool has_normals() const { return *std::max_element(places.begin(), places.end()) < fields.size(); }
};

/// Finds the fields of coordinates and normals, and the size of a point.
void check_pcd_fields(const Text_scanner& scanner, Pcd_header& header)
{
  constexpr const char* remedy = "write the file again";
  constexpr std::size_t max_count = 1U << 20U; // bounds the size of a point
  for (const Pcd_field& field : header.fields) {
    if (!field.type.is_valid() || field.count > max_count) {
      scanner.fail("a field has an unknown type or size", remedy);
    }
    header.size_of_point += field.count * field.type.size;
  }
  constexpr std::array<const char*, 6> names{"x", "y", "z", "normal_x", "normal_y", "normal_z"};
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto place = std::find_if(header.fields.begin(), header.fields.end(),
                                    [&](const Pcd_field& field) { return field.name == names[k]; });
    header.places[k] = std::size_t(place - header.fields.begin());
    if (k < 3 && (place == header.fields.end() || place->count != 1)) {
      scanner.fail("the field " + std::string(names[k]) + " is missing", remedy);
    }
  }
}

Pcd_header read_pcd_header(Text_scanner& scanner)
{
  Pcd_header header;
  while (header.encoding.empty()) {
    scanner.expect("the keyword DATA", '#');
    const std::string keyword(scanner.word());
    if (keyword == "FIELDS") {
      while (scanner.skip_blanks_in_line()) {
        header.fields.push_back({std::string(scanner.word())});
      }
    } else if (keyword == "SIZE" || keyword == "COUNT" || keyword == "TYPE") {
      for (auto field = header.fields.begin(); field != header.fields.end() && scanner.skip_blanks_in_line(); ++field) {
        if (keyword == "TYPE") {
          const std::string_view type = scanner.word();
          field->type.kind = type == "I" ? 'i' : type == "U" ? 'u' : 'f';
        } else {
          (keyword == "SIZE" ? field->type.size : field->count) = scanner.count("the size of a field");
        }
      }
    } else if (keyword == "POINTS") {
      header.number_of_points = scanner.skip_blanks_in_line() ? scanner.count("the number of points") : 0;
    } else if (keyword == "DATA") {
      header.encoding = scanner.skip_blanks_in_line() ? std::string(scanner.word()) : "none";
    }
    scanner.skip_line();
  }
  check_pcd_fields(scanner, header);
  return header;
}

} // namespace

/// Reads a table with a point in each line. Empty lines, comments after `#` or `//`, a first line with words, the
/// number of points before the first one and further columns are passed over. Normals are kept if every line has one.
Shape_file parse_point_table(std::string_view content, const std::string& filename, unsigned /* contents */)
{
  const Point_columns columns = find_columns(content);
  Text_scanner scanner(content, filename);
  Shape_file shape;
  bool has_normals = columns.has_normals();
  const auto add_point = [&](const std::vector<std::string_view>& fields) {
    Vector3 point;
    for (std::size_t i = 0; i < 3; ++i) {
      if (columns.places[i] >= fields.size()) {
        scanner.fail("a point has fewer than three coordinates");
      }
      const std::optional<double> number = to_number(fields[columns.places[i]]);
      if (!number) {
        scanner.fail(Text_scanner::number_expected);
      }
      if (!std::isfinite(*number)) {
        scanner.fail("a coordinate is not finite", "correct or remove this line");
      }
      point[i] = *number;
    }
    shape.points.push_back(point);
    Vector3 normal;
    for (std::size_t i = 3; has_normals && i < 6; ++i) {
      const std::size_t place = columns.places[i];
      const std::optional<double> number = place < fields.size() ? to_number(fields[place]) : std::nullopt;
      has_normals = number.has_value();
      normal[i - 3] = number.value_or(0);
    }
    if (has_normals) {
      shape.normals.push_back(normal);
    }
  };
  const auto is_at_word = [&] {
    Text_scanner ahead = scanner;
    ahead.skip_character('"');
    return !ahead.is_at_number();
  };
  bool is_first_line = true;
  std::vector<std::string_view> fields; // of a line
  while (scanner.skip_blanks()) {
    const bool is_comment = scanner.is_at("#") || scanner.is_at("//");
    const bool is_header = std::exchange(is_first_line, is_first_line && is_comment) && is_at_word();
    if (!is_header && !is_comment) {
      split_fields(scanner.rest().substr(0, scanner.rest().find('\n')), columns.separator, fields);
      if (fields.size() != 1 || !shape.points.empty()) { // else it is the number of points
        add_point(fields);
      }
    }
    scanner.skip_line();
  }
  if (!has_normals) {
    shape.normals.clear();
  }
  keep_normals_only(shape);
  return shape;
}

/// Reads PCD of the Point Cloud Library, ASCII or binary. Points that are not finite, which stand for missing
/// measurements, are left out.
Shape_file parse_pcd(std::string_view content, const std::string& filename, unsigned /* contents */)
{
  Text_scanner scanner(content, filename);
  const Pcd_header header = read_pcd_header(scanner);
  Shape_file shape;
  std::vector<double> numbers(header.fields.size());
  const auto add = [&] {
    const auto vector = [&](std::size_t k) {
      return Vector3(numbers[header.places[k]], numbers[header.places[k + 1]], numbers[header.places[k + 2]]);
    };
    if (const Vector3 point = vector(0); point.allFinite()) {
      shape.points.push_back(point);
      if (header.has_normals()) {
        const Vector3 normal = vector(3);
        shape.normals.push_back(normal.allFinite() ? normal : Vector3::Zero());
      }
    }
  };
  if (header.encoding != "ascii" && header.encoding != "binary") {
    scanner.fail("DATA is neither ascii nor binary",
                 "write the file as DATA binary, as by `pcl_convert_pcd_ascii_binary IN.pcd OUT.pcd 1`");
  }
  const bool is_binary = header.encoding == "binary";
  if (is_binary && header.number_of_points > scanner.remaining() / header.size_of_point) {
    scanner.fail_at_end("all of its " + std::to_string(header.number_of_points) + " points");
  }
  Byte_scanner bytes(scanner.rest(), Byte_order::little, filename);
  for (std::size_t point = 0; point < header.number_of_points; ++point) {
    for (std::size_t f = 0; f < numbers.size(); ++f) {
      for (std::size_t i = 0; i < header.fields[f].count; ++i) {
        if (!is_binary && !scanner.skip_blanks()) {
          scanner.fail_at_end("point " + std::to_string(point) + " of " + std::to_string(header.number_of_points));
        }
        numbers[f] = is_binary ? bytes.number(header.fields[f].type) : scanner.number();
      }
    }
    add();
  }
  return shape;
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
  const Vector3 scale = transform.vector<double>();
  const Vector3 offset = transform.vector<double>();
  const std::size_t size_of_data = content.size() - std::min(data_offset, content.size());
  if (point_size < min_point_size || number_of_points > size_of_data / point_size) {
    fail_in_file(filename, "the file ends before all points that its header promises",
                 "it seems truncated, fetch or write it again");
  }
  Shape_file shape;
  shape.points.resize(number_of_points);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const char* const first = scanner_at(data_offset).data() + axis * sizeof(std::int32_t);
    const Number_view column{first, {'i', sizeof(std::int32_t)}, Byte_order::little, point_size, shape.points.size()};
    column.for_each([&](std::size_t i, double x) { shape.points[i][axis] = x * scale[axis] + offset[axis]; });
  }
  return shape;
}

} // namespace CSCD::internal
