// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the triangles of 3MF.

#ifndef CSCD_IO_INTERNAL_PARSE_3MF_H
#define CSCD_IO_INTERNAL_PARSE_3MF_H

#include <CSCD/IO/internal/Polygon_soup.h>
#include <CSCD/IO/internal/Scanner.h>
#include <CSCD/IO/internal/Xml_scanner.h>
#include <CSCD/IO/internal/decode_bytes.h>
#include <CSCD/IO/internal/parse_gltf.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The content of the first member of a ZIP archive whose name ends with `ending`. Layout: PKWARE's APPNOTE 6.3.
/// \throw File_error if there is none, it is damaged, or it needs zlib and this is built without
inline std::string unzip(std::string_view archive, std::string_view ending, const std::string& filename)
{
  constexpr std::string_view end_signature = "PK\5\6";
  constexpr std::size_t directory_offset_at = 16; // in the record of the end
  constexpr std::string_view member_signature = "PK\1\2";
  constexpr std::string_view local_signature = "PK\3\4";
  constexpr std::size_t local_header_size = 30;
  constexpr std::size_t local_lengths_at = 26; // of the name and of what else is before the data
  constexpr unsigned stored = 0;
  constexpr unsigned deflated = 8;
  const auto fail = [&]() -> std::string {
    throw File_error(filename + ": is no ZIP archive with a model of 3MF, or it is damaged; fetch it again");
  };
  const auto scanner_at = [&](std::size_t place) {
    return Byte_scanner(archive.substr(std::min(place, archive.size())), boost::endian::order::little, filename);
  };
  const std::size_t end = archive.rfind(end_signature);
  if (end == std::string_view::npos) {
    return fail();
  }
  std::size_t place = scanner_at(end + directory_offset_at).number<std::uint32_t>();
  while (place < archive.size() && archive.substr(place, 4) == member_signature) {
    Byte_scanner member = scanner_at(place + 10);
    const unsigned method = member.number<std::uint16_t>();
    member.skip(8); // time and checksum
    const std::size_t compressed_size = member.number<std::uint32_t>();
    const std::size_t size = member.number<std::uint32_t>();
    const std::size_t length_of_name = member.number<std::uint16_t>();
    const std::size_t length_of_rest = std::size_t(member.number<std::uint16_t>()) + member.number<std::uint16_t>();
    member.skip(8); // attributes
    const std::size_t local = member.number<std::uint32_t>();
    constexpr std::size_t header_size = 46;
    const std::string_view name = archive.substr(std::min(place + header_size, archive.size()), length_of_name);
    if (name.size() >= ending.size() && name.substr(name.size() - ending.size()) == ending) {
      if (local >= archive.size() || archive.substr(local, 4) != local_signature) {
        return fail();
      }
      Byte_scanner lengths = scanner_at(local + local_lengths_at);
      const std::size_t skipped = std::size_t(lengths.number<std::uint16_t>()) + lengths.number<std::uint16_t>();
      const std::size_t begin = local + local_header_size + skipped;
      if (begin > archive.size() || compressed_size > archive.size() - begin) {
        return fail();
      }
      const std::string_view bytes = archive.substr(begin, compressed_size);
      constexpr bool has_header = false;
      return method == deflated                         ? inflate(bytes, size, has_header, filename)
             : method == stored && size == bytes.size() ? std::string(bytes)
                                                        : fail();
    }
    place += header_size + length_of_name + length_of_rest;
  }
  return fail();
}

/// Reads the model of 3MF: all objects at the places that the build gives them.
class Model_parser
{
public:
  Model_parser(std::string_view text, const std::string& filename) : m_xml(text, filename), m_filename(filename) {}

  Polygon_soup parse()
  {
    while (m_xml.next()) {
      const std::string_view name = m_xml.name();
      if (m_xml.is_closing()) {
        m_object = name == "object" ? nullptr : m_object;
      } else if (name == "object") {
        m_object = &m_objects[std::string(m_xml.attribute("id"))];
      } else if (name == "vertex" && m_object != nullptr) {
        add_point();
      } else if (name == "triangle" && m_object != nullptr) {
        add_triangle();
      } else if (name == "component" && m_object != nullptr) {
        add_component();
      } else if (name == "item") {
        place(object(), m_soup);
      }
    }
    check_number_of_points(m_soup.points.size(), m_filename);
    return std::move(m_soup);
  }

private:
  struct Object
  {
    std::vector<Vector_3> points;
    std::vector<std::array<Index, 3>> triangles;
  };

  /// Components could multiply a small file without end.
  static constexpr std::size_t max_number_of_elements = std::size_t(1) << 24U;

  double number(std::string_view text) const
  {
    double value = 0;
    const std::from_chars_result result = number_from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc() || !std::isfinite(value)) {
      m_xml.fail("a coordinate or a matrix of the model is not made of finite numbers");
    }
    return value;
  }

  void add_point()
  {
    m_object->points.emplace_back(number(m_xml.attribute("x")), number(m_xml.attribute("y")),
                                  number(m_xml.attribute("z")));
  }

  void add_triangle()
  {
    std::array<Index, 3> triangle{};
    std::size_t i = 0;
    for (const char* name : {"v1", "v2", "v3"}) {
      const std::string_view text = m_xml.attribute(name);
      const auto result = std::from_chars(text.data(), text.data() + text.size(), triangle[i]);
      if (result.ec != std::errc() || triangle[i] >= m_object->points.size()) {
        m_xml.fail("a triangle names a vertex that is not there");
      }
      ++i;
    }
    m_object->triangles.push_back(triangle);
  }

  /// The object that the tag names; those that it can name come before.
  const Object& object() const
  {
    const auto found = m_objects.find(std::string(m_xml.attribute("objectid")));
    if (found == m_objects.end() || &found->second == m_object) {
      m_xml.fail("an object is named that is not there");
    }
    return found->second;
  }

  void add_component()
  {
    Polygon_soup soup;
    place(object(), soup);
    const Index first = Index(m_object->points.size());
    m_object->points.insert(m_object->points.end(), soup.points.begin(), soup.points.end());
    for (std::size_t c = 0; c < soup.corners.size(); c += 3) {
      m_object->triangles.push_back(
          {first + soup.corners[c], first + soup.corners[c + 1], first + soup.corners[c + 2]});
    }
    m_number_of_elements += soup.points.size() + soup.corners.size();
  }

  /// Appends an object at the place that the tag says, to `soup`.
  void place(const Object& object, Polygon_soup& soup)
  {
    m_number_of_elements += object.points.size() + object.triangles.size();
    if (m_number_of_elements > max_number_of_elements) {
      m_xml.fail("its objects have more than 2^24 vertices and triangles in all");
    }
    const std::size_t first = soup.points.size();
    append_mapped(soup, object.points, object.triangles, map());
    for (std::size_t i = first; i < soup.points.size(); ++i) {
      if (!soup.points[i].allFinite()) {
        m_xml.fail("a vertex is moved out of the range of numbers");
      }
    }
  }

  /// Twelve numbers: the images of the axes, and the offset.
  Affine_map map() const
  {
    Affine_map result;
    const std::string_view text = m_xml.attribute("transform");
    if (text.empty()) {
      return result;
    }
    Text_scanner scanner(text, m_filename);
    for (Vector_3* const column : {&result.columns[0], &result.columns[1], &result.columns[2], &result.offset}) {
      for (double& coordinate : *column) {
        if (!scanner.skip_blanks()) {
          m_xml.fail("a matrix of the model has fewer than twelve numbers");
        }
        coordinate = number(scanner.word());
      }
    }
    return result;
  }

  Xml_scanner m_xml;
  std::string m_filename;
  std::map<std::string, Object> m_objects;
  Object* m_object = nullptr; ///< in which the tag is
  std::size_t m_number_of_elements = 0;
  Polygon_soup m_soup;
};

/// Reads `content`, that of a 3MF file: the model, a member of an archive.
/// \throw File_error if it is malformed, or compressed and this is built without zlib
inline Polygon_soup parse_3mf(std::string_view content, const std::string& filename)
{
  const std::string model = unzip(content, ".model", filename);
  return Model_parser(model, filename).parse();
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_PARSE_3MF_H
