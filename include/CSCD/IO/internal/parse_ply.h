// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads PLY files.

#ifndef CSCD_IO_INTERNAL_PARSE_PLY_H
#define CSCD_IO_INTERNAL_PARSE_PLY_H

#include <CSCD/IO/internal/Polygon_soup.h>
#include <CSCD/IO/internal/Scanner.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The types of numbers in PLY.
enum class Ply_type
{
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  float32,
  float64
};

/// A property of the items of an element: a number, or a list of numbers.
struct Ply_property
{
  std::string name;
  Ply_type type{};
  bool is_list = false;
  Ply_type size_type{}; ///< of a list
};

/// An element: items of the same properties.
struct Ply_element
{
  std::string name;
  std::size_t number_of_items = 0;
  std::vector<Ply_property> properties;
};

/// What the header of a PLY file says.
struct Ply_header
{
  enum class Encoding
  {
    ascii,
    binary_little_endian,
    binary_big_endian
  };
  Encoding encoding = Encoding::ascii;
  std::vector<Ply_element> elements;
};

/// The type of the name `name`.
/// \throw File_error if there is none
inline Ply_type ply_type(std::string_view name, const Text_scanner& scanner)
{
  constexpr std::array<std::array<std::string_view, 2>, 8> names{{{"char", "int8"},
                                                                  {"uchar", "uint8"},
                                                                  {"short", "int16"},
                                                                  {"ushort", "uint16"},
                                                                  {"int", "int32"},
                                                                  {"uint", "uint32"},
                                                                  {"float", "float32"},
                                                                  {"double", "float64"}}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (name == names[i][0] || name == names[i][1]) {
      return static_cast<Ply_type>(i);
    }
  }
  scanner.fail("the header names an unknown type", "write the file again");
}

/// Reads the next word of a header.
/// \throw File_error if the line ends before
inline std::string_view next_ply_word(Text_scanner& scanner)
{
  if (!scanner.skip_blanks_in_line()) {
    scanner.fail("the header has an incomplete line", "write the file again");
  }
  return scanner.word();
}

inline Ply_header::Encoding next_ply_encoding(Text_scanner& scanner)
{
  const std::string_view name = next_ply_word(scanner);
  if (name == "ascii") {
    return Ply_header::Encoding::ascii;
  }
  if (name == "binary_little_endian") {
    return Ply_header::Encoding::binary_little_endian;
  }
  if (name == "binary_big_endian") {
    return Ply_header::Encoding::binary_big_endian;
  }
  scanner.fail("the header names an unknown encoding", "write the file again");
}

inline Ply_property next_ply_property(Text_scanner& scanner)
{
  Ply_property property;
  std::string_view word = next_ply_word(scanner);
  if (word == "list") {
    property.is_list = true;
    property.size_type = ply_type(next_ply_word(scanner), scanner);
    word = next_ply_word(scanner);
  }
  property.type = ply_type(word, scanner);
  property.name = next_ply_word(scanner);
  return property;
}

/// Reads a header, up to and with its last line.
/// \throw File_error if it is malformed
inline Ply_header read_ply_header(Text_scanner& scanner)
{
  if (scanner.word() != "ply") {
    scanner.fail("this is no PLY file: it does not begin with ply", "check the ending of the file name");
  }
  Ply_header header;
  while (scanner.skip_blanks()) {
    const std::string_view keyword = scanner.word();
    if (keyword == "format") {
      header.encoding = next_ply_encoding(scanner);
    } else if (keyword == "element") {
      const std::string name(next_ply_word(scanner));
      scanner.skip_blanks_in_line();
      header.elements.push_back({name, scanner.count("the number of items of an element"), {}});
    } else if (keyword == "property") {
      if (header.elements.empty()) {
        scanner.fail("a property stands before any element", "write the file again");
      }
      header.elements.back().properties.push_back(next_ply_property(scanner));
    }
    scanner.skip_line(); // comments and whatever else the header holds
    if (keyword == "end_header") {
      return header;
    }
  }
  scanner.fail_at_end("the end of its header");
}

/// The numbers of an ASCII PLY file.
class Ply_text_source
{
public:
  explicit Ply_text_source(const Text_scanner& scanner) : m_scanner(scanner) {}

  std::size_t remaining() const { return m_scanner.remaining(); }

  static constexpr bool is_binary = false;

  double number(Ply_type /* type */)
  {
    if (!m_scanner.skip_blanks()) {
      m_scanner.fail_at_end("all that its header promises");
    }
    return m_scanner.number();
  }

private:
  Text_scanner m_scanner;
};

/// The numbers of a binary PLY file.
class Ply_binary_source
{
public:
  explicit Ply_binary_source(const Byte_scanner& scanner) : m_scanner(scanner) {}

  std::size_t remaining() const { return m_scanner.remaining(); }

  static constexpr bool is_binary = true;
  bool is_native() const { return m_scanner.is_native(); }
  const char* data() const { return m_scanner.data(); }
  const char* skip(std::size_t size) { return m_scanner.skip(size); }

  double number(Ply_type type) { return next_number(m_scanner, number_type(type)); }

  /// How a number of `type` is stored.
  static Number_type number_type(Ply_type type)
  {
    constexpr std::array<Number_type, 8> types{
        // in the order of `Ply_type`
        {{'i', 1}, {'u', 1}, {'i', 2}, {'u', 2}, {'i', 4}, {'u', 4}, {'f', 4}, {'f', 8}}};
    return types[std::size_t(type)];
  }

private:
  Byte_scanner m_scanner;
};

/// Reads the number of entries of a list.
/// \param filename for messages
/// \throw File_error if there cannot be as many
template <class Source>
std::size_t next_ply_size(Source& source, const Ply_property& list, const std::string& filename)
{
  const double size = source.number(list.size_type);
  if (!(size >= 0 && size <= double(source.remaining()))) {
    throw File_error(filename + ": the list " + list.name + " is longer than the file; write the file again");
  }
  return static_cast<std::size_t>(size);
}

/// Reads all numbers of an item and calls `use(property, position in the list, number)` for each.
/// \param filename for messages
/// \throw File_error if the file ends before
template <class Source, class Use>
void read_ply_item(Source& source, const Ply_element& element, const std::string& filename, const Use& use)
{
  for (const Ply_property& property : element.properties) {
    const std::size_t size = property.is_list ? next_ply_size(source, property, filename) : 1;
    for (std::size_t i = 0; i < size; ++i) {
      use(property, i, source.number(property.type));
    }
  }
}

/// Whether the items of `element` have a property `name` that is a number.
inline bool has_ply_number(const Ply_element& element, std::string_view name)
{
  return std::any_of(element.properties.begin(), element.properties.end(),
                     [&](const Ply_property& p) { return p.name == name && !p.is_list; });
}

/// Reads the vertices and faces of PLY; all other elements and properties are passed over.
template <class Source>
class Ply_parser
{
public:
  Ply_parser(const Source& source, std::string filename) : m_source(source), m_filename(std::move(filename)) {}

  Polygon_soup parse(const Ply_header& header)
  {
    for (const Ply_element& element : header.elements) {
      if (element.name == "vertex" || element.name == "vertices") {
        read_points(element);
      } else if (element.name == "face" || element.name == "faces") {
        read_polygons(element);
      } else {
        skip_items(element);
      }
    }
    check_corners();
    return std::move(m_soup);
  }

private:
  using Names = std::array<std::string_view, 3>;

  template <class Use>
  void read_item(const Ply_element& element, const Use& use)
  {
    read_ply_item(m_source, element, m_filename, use);
  }

  void skip_items(const Ply_element& element)
  {
    if (element.properties.empty()) {
      return; // such items take no room in the file, so that their number proves nothing
    }
    for (std::size_t item = 0; item < element.number_of_items; ++item) {
      read_item(element, [](const Ply_property&, std::size_t, double) {});
    }
  }

  /// Writes `number` to the coordinate of `vector` that `property` names, if it does.
  static void put(const Names& names, const Ply_property& property, double number, Vector_3& vector)
  {
    const auto name = std::find(names.begin(), names.end(), property.name);
    if (name != names.end() && !property.is_list) {
      vector[name - names.begin()] = number;
    }
  }

  void read_points(const Ply_element& element)
  {
    constexpr Names names{"x", "y", "z"};
    constexpr Names normal_names{"nx", "ny", "nz"};
    for (std::string_view name : names) {
      if (!has_ply_number(element, name)) {
        fail("its vertices have no property " + std::string(name));
      }
    }
    const bool has_normals = std::all_of(normal_names.begin(), normal_names.end(),
                                         [&](std::string_view name) { return has_ply_number(element, name); });
    m_soup.points.reserve(std::min(element.number_of_items, m_source.remaining() / names.size() + 1));
    const bool are_read =
        !has_normals && (read_point_records<float>(element, names) || read_point_records<double>(element, names));
    for (std::size_t i = are_read ? element.number_of_items : 0; i < element.number_of_items; ++i) {
      Vector_3 point = Vector_3::Zero();
      Vector_3 normal = Vector_3::Zero();
      read_item(element, [&](const Ply_property& property, std::size_t, double number) {
        put(names, property, number, point);
        put(normal_names, property, number, normal);
      });
      if (!point.allFinite()) {
        fail("vertex " + std::to_string(i) + " has a coordinate that is not finite");
      }
      m_soup.points.push_back(point);
      if (has_normals) {
        m_soup.normals.push_back(normal);
      }
    }
    check_number_of_points(m_soup.points.size(), m_filename);
  }

  /// Reads binary vertices that are records of one size with coordinates of type `Coordinate`, at the speed of memory.
  /// \return false, with nothing read, if they are not
  template <class Coordinate>
  bool read_point_records([[maybe_unused]] const Ply_element& element, [[maybe_unused]] const Names& names)
  {
    if constexpr (Source::is_binary) {
      std::size_t record_size = 0;
      std::array<std::size_t, 3> offset{};
      for (const Ply_property& property : element.properties) {
        const auto name = std::find(names.begin(), names.end(), property.name);
        const Number_type type = Source::number_type(property.type);
        if (property.is_list || (name != names.end() && (type.kind != 'f' || type.size != sizeof(Coordinate)))) {
          return false;
        }
        if (name != names.end()) {
          offset[std::size_t(name - names.begin())] = record_size;
        }
        record_size += type.size;
      }
      // A number of records that the file cannot hold is left to the other way, which tells where it ends.
      if (!m_source.is_native() || element.number_of_items > m_source.remaining() / record_size) {
        return false;
      }
      const char* record = m_source.skip(element.number_of_items * record_size);
      for (std::size_t i = 0; i < element.number_of_items; ++i, record += record_size) {
        std::array<Coordinate, 3> xyz;
        for (std::size_t axis = 0; axis < xyz.size(); ++axis) {
          std::memcpy(&xyz[axis], record + offset[axis], sizeof(Coordinate));
        }
        m_soup.points.emplace_back(double(xyz[0]), double(xyz[1]), double(xyz[2]));
        if (!m_soup.points.back().allFinite()) {
          fail("vertex " + std::to_string(i) + " has a coordinate that is not finite");
        }
      }
      return true;
    } else {
      return false;
    }
  }

  /// Reads binary triangles of nothing but their corners, one after the other, as long as there are such, and returns
  /// their number.
  std::size_t read_triangle_records([[maybe_unused]] const Ply_element& element)
  {
    std::size_t face = 0;
    if constexpr (Source::is_binary) {
      std::array<std::uint32_t, 3> corners{};
      constexpr std::size_t record_size = 1 + sizeof(corners);
      const Ply_property& list = element.properties.front();
      const Number_type type = Source::number_type(list.type);
      if (element.properties.size() > 1 || !list.is_list || list.size_type != Ply_type::uint8 || type.size != 4 ||
          type.kind == 'f' || !is_list_of_corners(list) || !m_source.is_native()) {
        return 0;
      }
      // Of signed numbers, the negative ones are those from here on.
      const std::uint32_t end = type.kind == 'i' ? std::uint32_t(1) << 31 : no_index;
      for (; face < element.number_of_items && m_source.remaining() >= record_size; ++face) {
        const char* const record = m_source.data();
        std::memcpy(corners.data(), record + 1, sizeof(corners));
        if (*record != 3 || *std::max_element(corners.begin(), corners.end()) >= end) {
          break;
        }
        m_source.skip(record_size);
        m_soup.corners.insert(m_soup.corners.end(), corners.begin(), corners.end());
        m_soup.end_polygon();
      }
    }
    return face;
  }

  static bool is_list_of_corners(const Ply_property& property)
  {
    return property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
  }

  void read_polygons(const Ply_element& element)
  {
    const std::size_t expected = std::min(element.number_of_items, m_source.remaining() / 3 + 1);
    m_soup.corners.reserve(3 * expected);
    std::size_t face = element.properties.empty() ? 0 : read_triangle_records(element);
    for (; face < element.number_of_items && !element.properties.empty(); ++face) {
      read_item(element, [&](const Ply_property& property, std::size_t, double number) {
        if (is_list_of_corners(property)) {
          m_soup.corners.push_back(corner(number, face));
        }
      });
      m_soup.end_polygon();
    }
  }

  Index corner(double number, std::size_t face) const
  {
    if (!(number >= 0 && number < double(no_index) && std::floor(number) == number)) {
      fail("face " + std::to_string(face) + " has a vertex index that is negative or no integer");
    }
    return static_cast<Index>(number);
  }

  /// Faces may stand before their vertices, so that this is known only at the end.
  void check_corners() const
  {
    for (Index corner : m_soup.corners) {
      if (corner >= m_soup.points.size()) {
        fail("a face names vertex " + std::to_string(corner) + ", but there are only " +
             std::to_string(m_soup.points.size()) + " (counted from 0)");
      }
    }
  }

  [[noreturn]] void fail(const std::string& fault) const
  {
    throw File_error(m_filename + ": " + fault + "; write the file again");
  }

  Source m_source;
  std::string m_filename;
  Polygon_soup m_soup;
};

/// Reads `content`, that of a PLY file, ASCII or binary, by a `Parser` of one of the sources of numbers.
/// \throw File_error if it is malformed
template <template <class> class Parser>
auto parse_ply_by(std::string_view content, const std::string& filename)
{
  Text_scanner scanner(content, filename);
  const Ply_header header = read_ply_header(scanner);
  if (header.encoding == Ply_header::Encoding::ascii) {
    return Parser<Ply_text_source>(Ply_text_source(scanner), filename).parse(header);
  }
  const Byte_scanner bytes(content.substr(content.size() - scanner.remaining()),
                           header.encoding == Ply_header::Encoding::binary_little_endian ? boost::endian::order::little
                                                                                         : boost::endian::order::big,
                           filename);
  return Parser<Ply_binary_source>(Ply_binary_source(bytes), filename).parse(header);
}

/// Reads the mesh or the points of `content`, that of a PLY file.
/// \throw File_error if it is malformed
inline Polygon_soup parse_ply(std::string_view content, const std::string& filename)
{
  return parse_ply_by<Ply_parser>(content, filename);
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_PARSE_PLY_H
