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

/// A member of a ZIP archive.
struct Zip_member
{
  std::string_view name;
  std::string content;
};

/// Reads the members of a ZIP archive, also those with the sizes of Zip64, which streaming writers use for small
/// members, too. Layout: PKWARE's APPNOTE 6.3.
class Zip_reader
{
public:
  Zip_reader(std::string_view archive, const std::string& filename) : m_archive(archive), m_filename(filename) {}

  /// The members whose names end with `ending`, in the order of the directory.
  /// \throw File_error if the archive is damaged, or needs zlib and this is built without
  std::vector<Zip_member> members(std::string_view ending) const
  {
    constexpr std::string_view end_signature = "PK\5\6";
    constexpr std::size_t directory_offset_at = 16; // in the record of the end
    constexpr std::string_view member_signature = "PK\1\2";
    std::vector<Zip_member> result;
    const std::size_t end = m_archive.rfind(end_signature);
    if (end == std::string_view::npos) {
      fail();
    }
    std::size_t place = scanner_at(end + directory_offset_at).number<std::uint32_t>();
    while (place < m_archive.size() && m_archive.substr(place, 4) == member_signature) {
      const Entry entry = read_entry(place);
      if (entry.name.size() >= ending.size() && entry.name.substr(entry.name.size() - ending.size()) == ending) {
        result.push_back({entry.name, content(entry)});
      }
      place = entry.end;
    }
    return result;
  }

  [[noreturn]] void fail() const
  {
    throw File_error(m_filename + ": is no ZIP archive with a model of 3MF, or it is damaged; fetch it again");
  }

private:
  /// What the directory says of a member.
  struct Entry
  {
    unsigned method = 0;
    std::size_t compressed_size = 0;
    std::size_t size = 0;
    std::size_t local_header = 0; ///< where it begins
    std::string_view name;
    std::size_t end = 0; ///< of the entry
  };

  Byte_scanner scanner_at(std::size_t place) const
  {
    return {m_archive.substr(std::min(place, m_archive.size())), boost::endian::order::little, m_filename};
  }

  Entry read_entry(std::size_t place) const
  {
    constexpr std::size_t header_size = 46;
    Entry entry;
    Byte_scanner member = scanner_at(place + 10);
    entry.method = member.number<std::uint16_t>();
    member.skip(8); // time and checksum
    entry.compressed_size = member.number<std::uint32_t>();
    entry.size = member.number<std::uint32_t>();
    const std::size_t length_of_name = member.number<std::uint16_t>();
    const std::size_t length_of_extra = member.number<std::uint16_t>();
    const std::size_t length_of_comment = member.number<std::uint16_t>();
    member.skip(8); // attributes
    entry.local_header = member.number<std::uint32_t>();
    const std::size_t begin_of_name = place + header_size;
    entry.name = m_archive.substr(std::min(begin_of_name, m_archive.size()), length_of_name);
    read_long_sizes(begin_of_name + length_of_name, length_of_extra, entry);
    entry.end = begin_of_name + length_of_name + length_of_extra + length_of_comment;
    return entry;
  }

  /// Reads the numbers of Zip64 for those that have all bits set.
  void read_long_sizes(std::size_t place, std::size_t length, Entry& entry) const
  {
    constexpr unsigned zip64 = 1;
    constexpr std::size_t absent = 0xffffffff;
    for (const std::size_t end = place + length; place + 4 <= end;) {
      Byte_scanner field = scanner_at(place);
      const unsigned id = field.number<std::uint16_t>();
      place += 4 + std::size_t(field.number<std::uint16_t>());
      for (std::size_t* number : {&entry.size, &entry.compressed_size, &entry.local_header}) {
        if (id == zip64 && *number == absent) {
          *number = field.number<std::uint64_t>();
        }
      }
    }
  }

  std::string content(const Entry& entry) const
  {
    constexpr std::string_view local_signature = "PK\3\4";
    constexpr std::size_t local_header_size = 30;
    constexpr std::size_t local_lengths_at = 26; // of the name and of what else is before the data
    constexpr unsigned stored = 0;
    constexpr unsigned deflated = 8;
    constexpr bool has_header = false;
    if (entry.local_header >= m_archive.size() || m_archive.substr(entry.local_header, 4) != local_signature) {
      fail();
    }
    Byte_scanner lengths = scanner_at(entry.local_header + local_lengths_at);
    const std::size_t skipped = std::size_t(lengths.number<std::uint16_t>()) + lengths.number<std::uint16_t>();
    const std::size_t begin = entry.local_header + local_header_size + skipped;
    if (begin > m_archive.size() || entry.compressed_size > m_archive.size() - begin) {
      fail();
    }
    const std::string_view bytes = m_archive.substr(begin, entry.compressed_size);
    if (entry.method == deflated) {
      return inflate(bytes, entry.size, has_header, m_filename);
    }
    if (entry.method != stored || entry.size != bytes.size()) {
      fail();
    }
    return std::string(bytes);
  }

  std::string_view m_archive;
  const std::string& m_filename;
};

/// Reads the models of 3MF: all objects at the places that the build gives them.
class Model_parser
{
public:
  explicit Model_parser(const std::string& filename) : m_xml("", filename), m_filename(filename) {}

  /// Reads one model after the other; those that a model refers to come before it.
  /// \param path of the model in the archive
  void parse(std::string_view text, std::string_view path)
  {
    m_xml = Xml_scanner(text, m_filename);
    m_path = path;
    m_object = nullptr;
    while (m_xml.next()) {
      const std::string_view name = m_xml.name();
      if (m_xml.is_closing()) {
        m_object = name == "object" ? nullptr : m_object;
      } else if (name == "object") {
        m_object = &m_objects[{m_path, std::string(m_xml.attribute("id"))}];
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
  }

  /// What all models hold.
  Polygon_soup take_soup()
  {
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

  /// The object that the tag names, in this model or, by the production extension, in another one; those that it can
  /// name come before.
  const Object& object() const
  {
    const std::string_view path = m_xml.attribute("p:path"); // begins with a slash
    const auto found =
        m_objects.find({path.empty() ? m_path : std::string(path.substr(1)), std::string(m_xml.attribute("objectid"))});
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
  std::string m_path;                                              ///< of the model that is read
  std::map<std::pair<std::string, std::string>, Object> m_objects; ///< by path and number
  Object* m_object = nullptr;                                      ///< in which the tag is
  std::size_t m_number_of_elements = 0;
  Polygon_soup m_soup;
};

/// Reads `content`, that of a 3MF file: its models, members of an archive.
/// \throw File_error if it is malformed, or compressed and this is built without zlib
inline Polygon_soup parse_3mf(std::string_view content, const std::string& filename)
{
  constexpr std::string_view root = "3dmodel.model"; // which refers to the others
  const Zip_reader archive(content, filename);
  std::vector<Zip_member> models = archive.members(".model");
  if (models.empty()) {
    archive.fail();
  }
  std::stable_partition(models.begin(), models.end(),
                        [&](const Zip_member& model) { return model.name.find(root) == std::string_view::npos; });
  Model_parser parser(filename);
  for (const Zip_member& model : models) {
    parser.parse(model.content, model.name);
  }
  return parser.take_soup();
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_PARSE_3MF_H
