// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads PolyData of VTK, as XML (.vtp) or in the legacy format (.vtk).

#ifndef CSCD_IO_INTERNAL_PARSE_VTK_H
#define CSCD_IO_INTERNAL_PARSE_VTK_H

#include <CSCD/IO/internal/Polygon_soup.h>
#include <CSCD/IO/internal/Scanner.h>
#include <CSCD/IO/internal/Xml_scanner.h>
#include <CSCD/IO/internal/decode_bytes.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <locale>
#include <map>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// What a file of VTK holds. Of arrays at the points, those are kept that have a name that is asked for.
struct Vtk_poly_data
{
  std::vector<Vector_3> points;
  /// Cells of all kinds, each a sequence of points: `verts`, `lines`, `polys` and `strips`, as in the file.
  std::map<std::string, Polygon_soup> cells{};
  /// Arrays at the points, by their names in lower case, if there is a value for each.
  std::map<std::string, std::vector<double>> arrays{};
};

/// Collects PolyData and checks them.
class Vtk_collector
{
public:
  explicit Vtk_collector(std::string filename) : m_filename(std::move(filename)) {}

  /// Whether an array at the points is of use.
  static bool is_wanted(const std::string& name) { return name == radius || name == is_opening || name == normals; }

  static constexpr const char* radius = "radius";
  static constexpr const char* is_opening = "isopening";
  static constexpr const char* normals = "normals";

  void add_points(const std::vector<double>& coordinates)
  {
    if (coordinates.size() % 3 != 0) {
      fail("a point has fewer than three coordinates");
    }
    for (std::size_t i = 0; i < coordinates.size(); i += 3) {
      m_data.points.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
      if (!m_data.points.back().allFinite()) {
        fail("point " + std::to_string(m_data.points.size() - 1) +
             " (counted from 0) has a coordinate that is not "
             "finite");
      }
    }
    check_number_of_points(m_data.points.size(), m_filename);
  }

  /// \param ends of the cells in `corners`
  /// \param first_point of those that the corners count from
  void add_cells(const std::string& kind, const std::vector<double>& corners, const std::vector<double>& ends,
                 std::size_t first_point)
  {
    Polygon_soup& cells = m_data.cells[kind];
    const double number_of_points = double(m_data.points.size() - first_point);
    std::size_t begin = 0;
    for (const double end : ends) {
      if (!(end >= double(begin) && end <= double(corners.size()))) {
        fail("a cell ends before it begins, or behind the last corner");
      }
      for (; begin < std::size_t(end); ++begin) {
        const double corner = corners[begin];
        if (!(corner >= 0 && corner < number_of_points && corner == double(std::uint64_t(corner)))) {
          fail("a cell names a point that is not there");
        }
        cells.corners.push_back(Index(first_point + std::size_t(corner)));
      }
      cells.end_polygon();
    }
  }

  void add_array(const std::string& name, const std::vector<double>& values)
  {
    std::vector<double>& array = m_data.arrays[name];
    array.insert(array.end(), values.begin(), values.end());
  }

  std::size_t number_of_points() const { return m_data.points.size(); }

  Vtk_poly_data finish()
  {
    for (auto array = m_data.arrays.begin(); array != m_data.arrays.end();) {
      const std::size_t number_of_components = array->first == normals ? 3 : 1;
      const bool is_complete = array->second.size() == number_of_components * m_data.points.size();
      array = is_complete ? std::next(array) : m_data.arrays.erase(array);
    }
    return std::move(m_data);
  }

  /// \throw File_error naming the file and `fault`
  [[noreturn]] void fail(const std::string& fault) const
  {
    throw File_error(m_filename + ": " + fault + "; correct or write the file again");
  }

private:
  std::string m_filename;
  Vtk_poly_data m_data;
};

/// Reads XML PolyData, whose arrays may be text, Base64, or bytes appended to the XML, compressed by zlib or not.
class Vtp_parser
{
public:
  Vtp_parser(std::string_view text, std::string filename)
      : m_text(text), m_filename(std::move(filename)), m_xml(text, m_filename), m_collector(m_filename)
  {
  }

  Vtk_poly_data parse()
  {
    read_file_tag();
    find_appended_data();
    while (m_xml.next() && m_xml.name() != appended_data) {
      const std::string name(m_xml.name());
      if (name == "DataArray" && !m_xml.is_closing()) {
        read_array();
      } else if (is_section(name) && m_xml.is_closing()) {
        close(name);
      } else if (is_section(name) && !m_xml.is_empty()) {
        m_section = name;
        m_first_point = name == "Piece" ? m_collector.number_of_points() : m_first_point;
      }
    }
    return m_collector.finish();
  }

private:
  static constexpr std::string_view appended_data = "AppendedData";

  void read_file_tag()
  {
    if (!m_xml.next() || m_xml.name() != "VTKFile") {
      m_collector.fail("it is no file of VTK: neither its first line nor its first tag says so");
    }
    if (m_xml.attribute("type") != "PolyData") {
      m_collector.fail("it holds no PolyData, the only kind that is read");
    }
    m_order = m_xml.attribute("byte_order") == "BigEndian" ? boost::endian::order::big : boost::endian::order::little;
    m_header_size = m_xml.attribute("header_type") == "UInt64" ? sizeof(std::uint64_t) : sizeof(std::uint32_t);
    m_is_compressed = !m_xml.attribute("compressor").empty();
    if (m_is_compressed && m_xml.attribute("compressor") != "vtkZLibDataCompressor") {
      m_collector.fail("it is compressed by another compressor than vtkZLibDataCompressor, the only one that is read");
    }
  }

  void find_appended_data()
  {
    const std::size_t tag = m_text.find("<AppendedData");
    const std::size_t begin = tag == std::string_view::npos ? tag : m_text.find('_', tag);
    if (begin != std::string_view::npos) {
      const std::string_view encoding = m_text.substr(tag, begin - tag);
      m_is_appended_base64 = encoding.find("base64") != std::string_view::npos;
      m_appended = m_text.substr(begin + 1);
    }
  }

  /// \pre the element is a section
  void close(const std::string& name)
  {
    if (!m_corners.empty() || !m_ends.empty()) {
      m_collector.add_cells(boost::algorithm::to_lower_copy(name, std::locale::classic()), m_corners, m_ends,
                            m_first_point);
    }
    m_corners.clear();
    m_ends.clear();
  }

  /// Whether arrays stand in elements of this name; those in arrays tell nothing that is of use here.
  static bool is_section(const std::string& name)
  {
    constexpr std::array<std::string_view, 8> sections{"Piece", "PointData", "CellData", "Points",
                                                       "Verts", "Lines",     "Strips",   "Polys"};
    return std::find(sections.begin(), sections.end(), name) != sections.end();
  }

  void read_array()
  {
    const std::string name =
        boost::algorithm::to_lower_copy(std::string(m_xml.attribute("Name")), std::locale::classic());
    if (m_section == "Points") {
      m_collector.add_points(numbers());
    } else if (m_section == "PointData" && Vtk_collector::is_wanted(name)) {
      m_collector.add_array(name, numbers());
    } else if (m_section == "Verts" || m_section == "Lines" || m_section == "Strips" || m_section == "Polys") {
      if (name == "connectivity") {
        m_corners = numbers();
      } else if (name == "offsets") {
        m_ends = numbers();
      }
    }
  }

  /// The numbers of the array whose tag was read last.
  std::vector<double> numbers() const
  {
    const std::string_view format = m_xml.attribute("format");
    if (m_xml.is_empty() && format != "appended") {
      return {};
    }
    if (format == "appended") {
      return binary_numbers(appended_bytes());
    }
    return format == "binary" ? binary_numbers(Encoded_bytes(m_xml.content(), true, m_filename)) : text_numbers();
  }

  Encoded_bytes appended_bytes() const
  {
    const std::string_view text = m_xml.attribute("offset");
    std::uint64_t offset = 0;
    const bool is_number = std::from_chars(text.data(), text.data() + text.size(), offset).ec == std::errc();
    if (!is_number || offset > m_appended.size()) {
      m_collector.fail("an array begins behind the end of the appended data");
    }
    return {m_appended.substr(offset), m_is_appended_base64, m_filename};
  }

  std::vector<double> text_numbers() const
  {
    const std::string_view content = m_xml.content();
    const std::size_t begin = std::size_t(content.data() - m_text.data());
    Text_scanner scanner(m_text.substr(0, begin + content.size()), m_filename);
    scanner.skip(begin); // so that it counts lines from the beginning of the file
    std::vector<double> result;
    while (scanner.skip_blanks()) {
      result.push_back(scanner.number());
    }
    return result;
  }

  Number_type type() const
  {
    const std::string_view name = m_xml.attribute("type");
    const std::size_t digit = name.find_first_of("0123456789");
    std::size_t bits = 0;
    if (digit != std::string_view::npos) {
      std::from_chars(name.data() + digit, name.data() + name.size(), bits);
    }
    const Number_type result{name.substr(0, 1) == "F" ? 'f' : name.substr(0, 1) == "U" ? 'u' : 'i', bits / 8};
    if (!result.is_valid()) {
      m_collector.fail("an array has an unknown type");
    }
    return result;
  }

  std::vector<double> binary_numbers(Encoded_bytes bytes) const
  {
    const Number_type its_type = type();
    const std::string content = m_is_compressed ? decompress(bytes) : bytes.take(next_size(bytes));
    Byte_scanner scanner(content, m_order, m_filename);
    std::vector<double> result;
    result.reserve(content.size() / its_type.size);
    while (scanner.remaining() >= its_type.size) {
      result.push_back(next_number(scanner, its_type));
    }
    return result;
  }

  /// Reads a number of the header of an array.
  std::size_t next_size(Encoded_bytes& bytes) const
  {
    const std::string number = bytes.take(m_header_size);
    Byte_scanner scanner(number, m_order, m_filename);
    return m_header_size == sizeof(std::uint64_t) ? scanner.number<std::uint64_t>() : scanner.number<std::uint32_t>();
  }

  /// The header: the number of blocks, their size, that of the last one if it differs, and what each is compressed to.
  std::string decompress(Encoded_bytes& bytes) const
  {
    const std::size_t number_of_blocks = next_size(bytes);
    const std::size_t size_of_block = next_size(bytes);
    const std::size_t size_of_last_block = next_size(bytes);
    if (number_of_blocks > bytes.max_remaining() / m_header_size) {
      m_collector.fail("an array has more blocks than there is room for");
    }
    std::vector<std::size_t> sizes;
    sizes.reserve(number_of_blocks);
    for (std::size_t i = 0; i < number_of_blocks; ++i) {
      sizes.push_back(next_size(bytes));
    }
    std::string result;
    for (std::size_t i = 0; i < number_of_blocks; ++i) {
      const bool is_partial = i + 1 == number_of_blocks && size_of_last_block > 0;
      result += inflate(bytes.take(sizes[i]), is_partial ? size_of_last_block : size_of_block, m_filename);
    }
    return result;
  }

  std::string_view m_text;
  std::string m_filename;
  Xml_scanner m_xml;
  Vtk_collector m_collector;
  boost::endian::order m_order = boost::endian::order::little;
  std::size_t m_header_size = sizeof(std::uint32_t);
  bool m_is_compressed = false;
  std::string_view m_appended; ///< from the first byte of data on
  bool m_is_appended_base64 = false;
  std::string m_section;         ///< the element whose arrays are read
  std::size_t m_first_point = 0; ///< of the piece
  std::vector<double> m_corners; ///< of the cells of this section
  std::vector<double> m_ends;
};

/// Reads legacy PolyData, ASCII or binary, of the versions to 4 and from 5.
class Vtk_legacy_parser
{
public:
  Vtk_legacy_parser(std::string_view text, std::string filename)
      : m_filename(std::move(filename)), m_scanner(text, m_filename), m_collector(m_filename)
  {
  }

  Vtk_poly_data parse()
  {
    m_scanner.skip_line(); // the version
    m_scanner.skip_line(); // the title
    const std::string encoding = word("the keyword ASCII or BINARY");
    m_is_binary = encoding == "BINARY";
    if (!m_is_binary && encoding != "ASCII") {
      m_scanner.fail("the third line is neither ASCII nor BINARY", "write the file again");
    }
    if (word("the keyword DATASET") != "DATASET" || word("the kind of data") != "POLYDATA") {
      m_scanner.fail("only the dataset POLYDATA is read", "convert the file to PolyData");
    }
    while (m_scanner.skip_blanks()) {
      read_section(word("a keyword"));
    }
    return m_collector.finish();
  }

private:
  std::string word(const char* meaning)
  {
    if (!m_scanner.skip_blanks()) {
      m_scanner.fail_at_end(meaning);
    }
    return std::string(m_scanner.word());
  }

  std::size_t count()
  {
    if (!m_scanner.skip_blanks()) {
      m_scanner.fail_at_end("a number");
    }
    return m_scanner.count("a number of elements");
  }

  void read_section(const std::string& keyword)
  {
    const std::map<std::string, const char*> kinds{
        {"VERTICES", "verts"}, {"LINES", "lines"}, {"POLYGONS", "polys"}, {"TRIANGLE_STRIPS", "strips"}};
    const auto kind = kinds.find(keyword);
    if (keyword == "POINTS") {
      const std::size_t number = count();
      m_collector.add_points(numbers(number, 3, word("a type")));
    } else if (kind != kinds.end()) {
      read_cells(kind->second);
    } else if (keyword == "METADATA") {
      skip_metadata();
    } else if (keyword == "CELL_DATA" || keyword == "POINT_DATA") {
      m_is_at_points = keyword == "POINT_DATA";
      m_number_of_tuples = count();
    } else {
      read_attribute(keyword);
    }
  }

  void read_cells(const char* kind)
  {
    std::size_t number = count();
    const std::size_t size = count();
    std::vector<double> corners;
    std::vector<double> ends;
    Text_scanner ahead = m_scanner;
    if (ahead.skip_blanks() && ahead.word() == "OFFSETS") {
      word("the keyword OFFSETS");
      ends = numbers(number, 1, word("a type"));
      ends.erase(ends.begin(), ends.begin() + (ends.empty() ? 0 : 1)); // the first one is 0
      word("the keyword CONNECTIVITY");
      corners = numbers(size, 1, word("a type"));
    } else { // before each cell its size
      const std::vector<double> all = numbers(size, 1, "int");
      std::size_t at = 0;
      for (; number > 0; --number) {
        const double its_size = at < all.size() ? all[at++] : -1;
        if (!(its_size >= 0 && its_size <= double(all.size() - at))) {
          m_collector.fail("the cells do not fill the room that their keyword promises");
        }
        corners.insert(corners.end(), all.begin() + std::ptrdiff_t(at),
                       all.begin() + std::ptrdiff_t(at) + std::ptrdiff_t(its_size));
        at += std::size_t(its_size);
        ends.push_back(double(corners.size()));
      }
      if (at != all.size()) {
        m_collector.fail("the cells do not fill the room that their keyword promises");
      }
    }
    m_collector.add_cells(kind, corners, ends, 0);
  }

  /// Up to an empty line.
  void skip_metadata()
  {
    m_scanner.skip_line();
    while (m_scanner.remaining() > 0 && m_scanner.skip_blanks_in_line()) {
      m_scanner.skip_line();
    }
  }

  void read_attribute(const std::string& keyword)
  {
    if (keyword == "FIELD") {
      word("the name of a field");
      for (std::size_t number = count(); number > 0; --number) {
        const std::string name = word("the name of an array");
        const std::size_t number_of_components = count();
        const std::size_t number_of_tuples = count();
        add_array(name, numbers(number_of_tuples, number_of_components, word("a type")));
        skip_metadata_behind_array();
      }
      return;
    }
    const std::string name = word("the name of an array");
    if (keyword == "SCALARS") {
      const std::string type = word("a type");
      const std::size_t number_of_components = m_scanner.skip_blanks_in_line() ? count() : 1;
      Text_scanner ahead = m_scanner;
      if (ahead.skip_blanks() && ahead.word() == "LOOKUP_TABLE") {
        word("the keyword LOOKUP_TABLE");
        word("the name of a table");
      }
      add_array(name, numbers(m_number_of_tuples, number_of_components, type));
    } else if (keyword == "COLOR_SCALARS") {
      numbers(m_number_of_tuples, count(), m_is_binary ? "unsigned_char" : "float");
    } else if (keyword == "LOOKUP_TABLE") {
      numbers(count(), 4, m_is_binary ? "unsigned_char" : "float");
    } else if (keyword == "NORMALS") {
      const std::vector<double> normals = numbers(m_number_of_tuples, 3, word("a type"));
      add_array(Vtk_collector::normals, normals);
    } else if (keyword == "TEXTURE_COORDINATES") {
      const std::size_t number_of_components = count();
      numbers(m_number_of_tuples, number_of_components, word("a type"));
    } else {
      const std::map<std::string, std::size_t> others{
          {"VECTORS", 3}, {"TENSORS", 9}, {"TENSORS6", 6}, {"GLOBAL_IDS", 1}, {"PEDIGREE_IDS", 1}};
      const auto other = others.find(keyword);
      if (other == others.end()) {
        m_scanner.fail("the keyword " + printable_keyword(keyword) + " is unknown", "write the file again");
      }
      numbers(m_number_of_tuples, other->second, word("a type"));
    }
  }

  void skip_metadata_behind_array()
  {
    Text_scanner ahead = m_scanner;
    if (ahead.skip_blanks() && ahead.word() == "METADATA") {
      word("the keyword METADATA");
      skip_metadata();
    }
  }

  /// What stands in place of a keyword may be anything.
  static std::string printable_keyword(const std::string& keyword)
  {
    constexpr std::size_t max_length = 20;
    std::string result = keyword.substr(0, max_length);
    std::replace_if(
        result.begin(), result.end(), [](char c) { return c <= ' ' || c > '~'; }, '?');
    return result;
  }

  void add_array(const std::string& name, const std::vector<double>& values)
  {
    const std::string lower = boost::algorithm::to_lower_copy(name, std::locale::classic());
    if (m_is_at_points && Vtk_collector::is_wanted(lower)) {
      m_collector.add_array(lower, values);
    }
  }

  /// Reads an array. In binary it begins behind the line of its type.
  std::vector<double> numbers(std::size_t number_of_tuples, std::size_t number_of_components, const std::string& type)
  {
    // A number takes at least a byte.
    if (number_of_components > 0 && number_of_tuples > m_scanner.remaining() / number_of_components) {
      m_scanner.fail_at_end("all numbers of an array");
    }
    const std::size_t number = number_of_tuples * number_of_components;
    return m_is_binary ? binary_numbers(number, type) : text_numbers(number);
  }

  std::vector<double> text_numbers(std::size_t number)
  {
    std::vector<double> result;
    result.reserve(number);
    while (result.size() < number) {
      if (!m_scanner.skip_blanks()) {
        m_scanner.fail_at_end("all numbers of an array");
      }
      result.push_back(m_scanner.number());
    }
    return result;
  }

  std::vector<double> binary_numbers(std::size_t number, const std::string& type)
  {
    const std::map<std::string, Number_type> types{
        {"char", {'i', 1}},          {"signed_char", {'i', 1}},    {"unsigned_char", {'u', 1}},
        {"short", {'i', 2}},         {"unsigned_short", {'u', 2}}, {"int", {'i', 4}},
        {"unsigned_int", {'u', 4}},  {"vtkIdType", {'i', 4}},      {"long", {'i', 8}},
        {"unsigned_long", {'u', 8}}, {"vtktypeint64", {'i', 8}},   {"vtktypeuint64", {'u', 8}},
        {"float", {'f', 4}},         {"double", {'f', 8}}};
    const auto its_type = types.find(type);
    if (its_type == types.end()) {
      m_scanner.fail("an array has the unknown type " + printable_keyword(type), "write the file again");
    }
    m_scanner.skip_line();
    Byte_scanner bytes(m_scanner.rest(), boost::endian::order::big, m_filename);
    if (number > bytes.remaining() / its_type->second.size) {
      m_scanner.fail_at_end("all numbers of an array");
    }
    std::vector<double> result;
    result.reserve(number);
    while (result.size() < number) {
      result.push_back(next_number(bytes, its_type->second));
    }
    m_scanner.skip(number * its_type->second.size);
    return result;
  }

  std::string m_filename;
  Text_scanner m_scanner;
  Vtk_collector m_collector;
  bool m_is_binary = false;
  bool m_is_at_points = false;
  std::size_t m_number_of_tuples = 0;
};

/// Reads `content`, that of a file of VTK, whichever its ending.
/// \throw File_error if it is malformed
inline Vtk_poly_data parse_vtk_data(std::string_view content, const std::string& filename)
{
  constexpr std::string_view legacy = "# vtk DataFile";
  return content.substr(0, legacy.size()) == legacy ? Vtk_legacy_parser(content, filename).parse()
                                                    : Vtp_parser(content, filename).parse();
}

/// Reads points, their normals, polygons and triangle strips.
/// \throw File_error if the file is malformed
inline Polygon_soup parse_vtk(std::string_view content, const std::string& filename)
{
  Vtk_poly_data data = parse_vtk_data(content, filename);
  Polygon_soup soup = std::move(data.cells["polys"]);
  soup.points = std::move(data.points);
  const std::vector<double>& normals = data.arrays[Vtk_collector::normals];
  for (std::size_t i = 0; i + 2 < normals.size(); i += 3) {
    soup.normals.emplace_back(normals[i], normals[i + 1], normals[i + 2]);
  }
  const Polygon_soup& strips = data.cells["strips"];
  for (std::size_t strip = 0; strip < strips.number_of_polygons(); ++strip) {
    const Index* const corners = strips.corners.data() + strips.first_corner[strip];
    for (std::size_t i = 0; i + 2 < strips.size_of_polygon(strip); ++i) { // every other one is turned
      soup.corners.insert(soup.corners.end(), {corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]});
      soup.end_polygon();
    }
  }
  return soup;
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_PARSE_VTK_H
