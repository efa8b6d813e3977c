// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads points from PCD and LAS.

#include "Number_view.h"
#include "Text_scanner.h"
#include "parse.h"
#include <CSCD/IO/Shape_file.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CSCD::internal {

namespace {

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
  struct Field
  {
    std::string name;
    Number_type type{'f', 4};
    std::size_t count = 1; ///< numbers of the field at each point
  };

  void read_header()
  {
    while (m_encoding.empty()) {
      if (!m_scanner.skip_blanks('#')) {
        m_scanner.fail_at_end("the keyword DATA");
      }
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
        m_scanner.fail("a field has an unknown type or size", "write the file again");
      }
      m_field_of.emplace(m_fields[i].name, i);
      m_size_of_point += m_fields[i].count * m_fields[i].type.size;
    }
    for (const char* name : {"x", "y", "z"}) {
      if (m_field_of.count(name) == 0 || m_fields[m_field_of[name]].count != 1) {
        m_scanner.fail("the field " + std::string(name) + " is missing", "write the file again");
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

Shape_file parse_pcd(std::string_view content, const std::string& filename, Wanted /* wanted */)
{
  return Pcd_parser(content, filename).parse();
}

/// Reads versions 1.0 to 1.4, not compressed.
Shape_file parse_las(std::string_view content, const std::string& filename, Wanted /* wanted */)
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
    throw File_error(filename + ": it is not a LAS file, or its header is not complete; fetch or write the file again");
  }
  Byte_scanner header = scanner_at(data_offset_at);
  const std::size_t data_offset = header.number<std::uint32_t>();
  header.skip(sizeof(std::uint32_t)); // the number of records of variable length
  if ((header.number<std::uint8_t>() & compression_bits) != 0) {
    throw File_error(filename + ": it is compressed (LAZ), which is not read; convert it to LAS, as by `laszip` or "
                                "`pdal translate`");
  }
  const std::size_t point_size = header.number<std::uint16_t>();
  std::uint64_t number_of_points = header.number<std::uint32_t>();
  if (number_of_points == 0 && content[minor_version_at] >= 4) {
    number_of_points = scanner_at(large_number_at).number<std::uint64_t>();
  }
  Byte_scanner transform = scanner_at(scale_at);
  Vector_3 scale;
  Vector_3 offset;
  for (Vector_3* const vector : {&scale, &offset}) {
    for (double& coordinate : *vector) {
      coordinate = transform.number<double>();
    }
  }
  const std::size_t size_of_data = content.size() - std::min(data_offset, content.size());
  if (point_size < min_point_size || number_of_points > size_of_data / point_size) {
    throw File_error(filename + ": the file ends before all points that its header promises; it seems truncated, fetch "
                                "or write it again");
  }
  check_number_of_points(number_of_points, filename);
  Shape_file shape;
  shape.points.reserve(number_of_points);
  Byte_scanner scanner = scanner_at(data_offset);
  for (std::uint64_t i = 0; i < number_of_points; ++i) {
    Vector_3 point;
    for (int axis = 0; axis < 3; ++axis) {
      point[axis] = scanner.number<std::int32_t>() * scale[axis] + offset[axis];
    }
    if (!point.allFinite()) {
      throw File_error(filename + ": the scale or offset in the header is not finite; write the file again");
    }
    scanner.skip(point_size - min_point_size);
    shape.points.push_back(point);
  }
  return shape;
}

} // namespace CSCD::internal
