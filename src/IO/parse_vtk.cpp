// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads PolyData of VTK, as XML (.vtp) or in the legacy format (.vtk).

#include "IO/decompress.h"
#include "IO/formats.h"
#include "IO/scanners.h"
#include <CSCD/IO/Shape_file.h>
#include <CSCD/Vector3.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace CSCD::internal {

namespace {

using Numbers = std::vector<double>;

Numbers to_vector(const Number_view& view)
{
  Numbers result(view.count);
  view.for_each([&result](std::size_t i, auto number) { result[i] = double(number); });
  return result;
}

/// Collects PolyData and checks them.
class Vtk_collector
{
public:
  explicit Vtk_collector(unsigned contents) : m_contents(contents) {}

  /// Whether an array at the points is of use. \param name in lower case
  static bool is_wanted(const std::string& name) { return name == radius || name == is_opening || name == normals; }

  static constexpr const char* radius = "radius";
  static constexpr const char* is_opening = "isopening";
  static constexpr const char* normals = "normals";

  void add_points(const Numbers& coordinates)
  {
    if (coordinates.size() % 3 != 0) {
      fail("a point has fewer than three coordinates");
    }
    m_shape.points.reserve(number_of_points() + coordinates.size() / 3);
    for (std::size_t i = 0; i < coordinates.size(); i += 3) {
      m_shape.points.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
    }
  }

  /// \param kind of cells: `verts`, `lines`, `polys` or `strips`
  /// \param ends of the cells in `corners`
  /// \param first_point the point that the corners count from
  void add_cells(const std::string& kind, const Numbers& corners, const Numbers& ends, std::size_t first_point)
  {
    std::size_t begin = 0;
    std::vector<Index> cell;
    for (const double end : ends) {
      if (!(end >= double(begin) && end <= double(corners.size()))) {
        fail("a cell ends before it begins, or behind the last corner");
      }
      cell.clear();
      for (; begin < std::size_t(end); ++begin) {
        cell.push_back(to_index(corners[begin], first_point));
      }
      add_cell(kind, cell);
    }
    m_shape.has_polygons = m_shape.has_polygons || kind == "polys" || kind == "strips";
  }

  void add_array(const std::string& name, const Numbers& values)
  {
    Numbers& array = m_arrays[name];
    array.insert(array.end(), values.begin(), values.end());
  }

  std::size_t number_of_points() const { return m_shape.points.size(); }

  Shape_file finish()
  {
    for (const std::vector<Index>& strip : m_strips) {
      m_shape.add_strip(strip);
    }
    m_shape.radii = complete_array(radius, 1);
    for (const double value : complete_array(is_opening, 1)) {
      m_shape.openings.push_back(value != 0 ? 1 : 0);
    }
    const Numbers n = complete_array(normals, 3);
    for (std::size_t i = 0; i < n.size(); i += 3) {
      m_shape.normals.emplace_back(n[i], n[i + 1], n[i + 2]);
    }
    return std::move(m_shape);
  }

  /// \throw Content_error naming `fault`
  [[noreturn]] static void fail(const std::string& fault) { internal::fail(fault, "correct or write the file again"); }

private:
  Index to_index(double corner, std::size_t first_point) const
  {
    const double size = double(number_of_points() - first_point);
    if (!(corner >= 0 && corner < size && corner == double(std::uint64_t(corner)))) {
      fail("a cell names a point that is not there");
    }
    return Index(first_point + std::size_t(corner));
  }

  void add_cell(const std::string& kind, const std::vector<Index>& cell)
  {
    const bool has_faces = m_contents != skeleton_content;
    if (kind == "polys" && has_faces) {
      m_shape.corners.insert(m_shape.corners.end(), cell.begin(), cell.end());
      m_shape.end_polygon();
    } else if (kind == "strips" && has_faces) {
      m_strips.push_back(cell);
    } else if (kind == "lines" && (m_contents & skeleton_content) != 0) {
      for (std::size_t i = 0; i + 1 < cell.size(); ++i) {
        m_shape.lines.push_back({cell[i], cell[i + 1]});
      }
    }
  }

  /// An array at the points; empty if it has not `number_of_components` values for each.
  Numbers complete_array(const char* name, std::size_t number_of_components)
  {
    Numbers& array = m_arrays[name];
    return array.size() == number_of_components * number_of_points() ? std::move(array) : Numbers();
  }

  unsigned m_contents;
  Shape_file m_shape;
  std::map<std::string, Numbers> m_arrays;
  std::vector<std::vector<Index>> m_strips; ///< whose triangles come behind all polygons
};

/// Reads XML PolyData, whose arrays may be text, Base64, or bytes appended to the XML, compressed by zlib or not.
class Vtp_parser : private Vtk_collector
{
public:
  Vtp_parser(std::string_view text, unsigned contents) : Vtk_collector(contents), m_text(text), m_xml(text) {}

  Shape_file parse()
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
        m_first_point = name == "Piece" ? number_of_points() : m_first_point;
      }
    }
    return finish();
  }

private:
  static constexpr std::string_view appended_data = "AppendedData";

  void read_file_tag()
  {
    if (!m_xml.next() || m_xml.name() != "VTKFile") {
      fail("this is not a file of VTK: neither its first line nor its first tag says so");
    }
    if (m_xml.attribute("type") != "PolyData") {
      fail("the file does not hold PolyData, the only kind that is read");
    }
    m_order = m_xml.attribute("byte_order") == "BigEndian" ? Byte_order::big : Byte_order::little;
    m_size_of_size = m_xml.attribute("header_type") == "UInt64" ? sizeof(std::uint64_t) : sizeof(std::uint32_t);
    m_is_compressed = !m_xml.attribute("compressor").empty();
    if (m_is_compressed && m_xml.attribute("compressor") != "vtkZLibDataCompressor") {
      fail("only vtkZLibDataCompressor is read, but the file names another compressor");
    }
    // Arrays may share data, but not so often that a small file fills the memory.
    constexpr std::size_t max_number_of_uses = 4;
    m_max_size = m_text.size() * (m_is_compressed ? max_deflate_ratio : max_number_of_uses);
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
      add_cells(lower_case(name), m_corners, m_ends, m_first_point);
    }
    m_corners.clear();
    m_ends.clear();
  }

  static bool is_section_of_cells(const std::string& name)
  {
    return name == "Verts" || name == "Lines" || name == "Strips" || name == "Polys";
  }
  /// Whether arrays stand in elements of this name. Elements within arrays are of no use here.
  static bool is_section(const std::string& name)
  {
    return is_section_of_cells(name) || name == "Piece" || name == "PointData" || name == "CellData" ||
           name == "Points";
  }

  void read_array()
  {
    const std::string name = lower_case(m_xml.attribute("Name"));
    if (m_section == "Points") {
      add_points(numbers());
    } else if (m_section == "PointData" && is_wanted(name)) {
      add_array(name, numbers());
    } else if (is_section_of_cells(m_section) && name == "connectivity") {
      m_corners = numbers();
    } else if (is_section_of_cells(m_section) && name == "offsets") {
      m_ends = numbers();
    }
  }

  /// The numbers of the array whose tag was read last.
  Numbers numbers()
  {
    const std::string_view format = m_xml.attribute("format");
    if (format == "appended") {
      return binary_numbers(appended_bytes());
    }
    if (m_xml.is_empty()) {
      return {};
    }
    return format == "binary" ? binary_numbers(Encoded_bytes(m_xml.content(), true)) : text_numbers();
  }

  Encoded_bytes appended_bytes() const
  {
    const std::string_view text = m_xml.attribute("offset");
    std::uint64_t offset = 0;
    const bool is_number = std::from_chars(text.data(), text.data() + text.size(), offset).ec == std::errc();
    if (!is_number || offset > m_appended.size()) {
      fail("an array begins behind the end of the appended data");
    }
    return {m_appended.substr(offset), m_is_appended_base64};
  }

  Numbers text_numbers() const
  {
    const std::string_view content = m_xml.content();
    const std::size_t begin = std::size_t(content.data() - m_text.data());
    Text_scanner scanner(m_text.substr(0, begin + content.size()));
    scanner.skip(begin); // so that it counts lines from the beginning of the file
    Numbers result;
    while (scanner.skip_blanks()) {
      result.push_back(scanner.number());
    }
    return result;
  }

  Numbers binary_numbers(Encoded_bytes bytes)
  {
    const Number_type type = number_type(m_xml.attribute("type"));
    if (!type.is_valid()) {
      fail("an array has an unknown type");
    }
    const std::string content = m_is_compressed ? decompress(bytes) : take(bytes);
    return to_vector({content.data(), type, m_order, type.size, content.size() / type.size});
  }

  /// Counts bytes of arrays. \throw Content_error if they are more than the file can hold
  void count_bytes(std::size_t size)
  {
    m_size += size;
    if (size > m_max_size || m_size > m_max_size) {
      fail("the arrays are larger than the file can hold");
    }
  }

  std::string take(Encoded_bytes& bytes)
  {
    const std::size_t size = next_size(bytes);
    count_bytes(std::min(size, bytes.max_remaining()));
    return bytes.take(size);
  }

  /// Reads a number of the header of an array.
  std::size_t next_size(Encoded_bytes& bytes) const
  {
    const std::string number = bytes.take(m_size_of_size);
    return m_size_of_size == sizeof(std::uint64_t) ? stored_number<std::uint64_t>(number.data(), m_order)
                                                   : stored_number<std::uint32_t>(number.data(), m_order);
  }

  /// The header: the number of blocks, their size, that of the last one if it differs, and the compressed size of each.
  std::string decompress(Encoded_bytes& bytes)
  {
    const std::size_t number_of_blocks = next_size(bytes);
    const std::size_t size_of_block = next_size(bytes);
    const std::size_t size_of_last_block = next_size(bytes);
    if (number_of_blocks > bytes.max_remaining() / m_size_of_size) {
      fail("an array has more blocks than there is room for");
    }
    std::vector<std::size_t> sizes;
    sizes.reserve(number_of_blocks);
    for (std::size_t i = 0; i < number_of_blocks; ++i) {
      sizes.push_back(next_size(bytes));
    }
    std::string result;
    for (std::size_t i = 0; i < number_of_blocks; ++i) {
      const bool is_partial = i + 1 == number_of_blocks && size_of_last_block > 0;
      const std::size_t size = is_partial ? size_of_last_block : size_of_block;
      count_bytes(size);
      std::istringstream block(bytes.take(sizes[i]));
      Inflating_buffer inflated(block);
      const std::size_t begin = result.size();
      result.resize(begin + size);
      if (inflated.sgetn(&result[begin], std::streamsize(size)) != std::streamsize(size) ||
          inflated.sgetc() != std::char_traits<char>::eof()) {
        fail("a block of an array has another size than its header says");
      }
    }
    return result;
  }

  std::string_view m_text;
  Xml_scanner m_xml;
  Byte_order m_order = Byte_order::little;
  std::size_t m_size_of_size = sizeof(std::uint32_t); ///< of a number in the header of an array, in bytes
  bool m_is_compressed = false;
  std::size_t m_max_size = 0;  ///< of all arrays that are read, in bytes
  std::size_t m_size = 0;      ///< of the arrays that were read
  std::string_view m_appended; ///< from the first byte of data on
  bool m_is_appended_base64 = false;
  std::string m_section;         ///< the element whose arrays are read
  std::size_t m_first_point = 0; ///< of the piece
  Numbers m_corners;             ///< of the cells of this section
  Numbers m_ends;
};

/// Reads legacy PolyData, ASCII or binary, of the versions to 4 and from 5.
class Vtk_legacy_parser : private Vtk_collector
{
public:
  Vtk_legacy_parser(std::string_view text, unsigned contents) : Vtk_collector(contents), m_scanner(text) {}

  Shape_file parse()
  {
    m_scanner.skip_line(); // the version
    m_scanner.skip_line(); // the title
    const std::string encoding = word("the keyword ASCII or BINARY");
    m_is_binary = encoding == "BINARY";
    if (!m_is_binary && encoding != "ASCII") {
      m_scanner.fail("the third line is neither ASCII nor BINARY", remedy);
    }
    if (word("the keyword DATASET") != "DATASET" || word("the kind of data") != "POLYDATA") {
      m_scanner.fail("only the dataset POLYDATA is read", "convert the file to PolyData");
    }
    while (m_scanner.skip_blanks()) {
      read_section(word("a keyword"));
    }
    return finish();
  }

private:
  static constexpr const char* remedy = "write the file again";

  std::string word(const char* meaning)
  {
    m_scanner.expect(meaning);
    return std::string(m_scanner.word());
  }

  std::size_t count()
  {
    m_scanner.expect("a number");
    return m_scanner.count("a number of elements");
  }

  void read_section(const std::string& keyword)
  {
    static const std::map<std::string, const char*> kinds{
        {"VERTICES", "verts"}, {"LINES", "lines"}, {"POLYGONS", "polys"}, {"TRIANGLE_STRIPS", "strips"}};
    const auto kind = kinds.find(keyword);
    if (keyword == "POINTS") {
      const std::size_t number = count();
      add_points(numbers(number, 3, word("a type")));
    } else if (kind != kinds.end()) {
      read_cells(kind->second);
    } else if (keyword == "METADATA") {
      skip_metadata();
    } else if (keyword == "CELL_DATA" || keyword == "POINT_DATA") {
      m_is_at_points = keyword == "POINT_DATA";
      m_number_of_tuples = count();
    } else if (keyword == "FIELD") {
      read_field();
    } else {
      read_attribute(keyword);
    }
  }

  void read_cells(const char* kind)
  {
    const std::size_t number = count();
    const std::size_t size = count();
    Numbers corners;
    Numbers ends;
    if (skip("OFFSETS")) {
      ends = numbers(number, 1, word("a type"));
      ends.erase(ends.begin(), ends.begin() + (ends.empty() ? 0 : 1)); // the first one is 0
      word("the keyword CONNECTIVITY");
      corners = numbers(size, 1, word("a type"));
    } else {
      split_cells(numbers(size, 1, "int"), number, corners, ends);
    }
    add_cells(kind, corners, ends, 0);
  }

  /// \param all corners of `number` cells, before each cell its size
  void split_cells(const Numbers& all, std::size_t number, Numbers& corners, Numbers& ends) const
  {
    std::size_t at = 0;
    for (; number > 0; --number) {
      const double size = at < all.size() ? all[at++] : -1;
      if (!(size >= 0 && size <= double(all.size() - at))) {
        break;
      }
      const auto begin = all.begin() + std::ptrdiff_t(at);
      corners.insert(corners.end(), begin, begin + std::ptrdiff_t(size));
      at += std::size_t(size);
      ends.push_back(double(corners.size()));
    }
    if (number > 0 || at != all.size()) {
      fail("the cells do not fill the room that their keyword promises");
    }
  }

  /// Up to an empty line.
  void skip_metadata()
  {
    do {
      m_scanner.skip_line();
    } while (m_scanner.skip_blanks_in_line());
  }

  void read_attribute(const std::string& keyword)
  {
    static const std::map<std::string, std::size_t> vectors{{"NORMALS", 3},  {"VECTORS", 3},    {"TENSORS", 9},
                                                            {"TENSORS6", 6}, {"GLOBAL_IDS", 1}, {"PEDIGREE_IDS", 1}};
    const std::string name = word("the name of an array");
    const std::string type_of_color = m_is_binary ? "unsigned_char" : "float";
    if (keyword == "SCALARS") {
      const std::string type = word("a type");
      const std::size_t number_of_components = m_scanner.skip_blanks_in_line() ? count() : 1;
      if (skip("LOOKUP_TABLE")) {
        word("the name of a table");
      }
      add_attribute(name, numbers(m_number_of_tuples, number_of_components, type));
    } else if (keyword == "COLOR_SCALARS") {
      numbers(m_number_of_tuples, count(), type_of_color);
    } else if (keyword == "LOOKUP_TABLE") {
      numbers(count(), 4, type_of_color);
    } else if (const auto vector = vectors.find(keyword); vector != vectors.end() || keyword == "TEXTURE_COORDINATES") {
      const std::size_t number_of_components = vector != vectors.end() ? vector->second : count();
      const Numbers values = numbers(m_number_of_tuples, number_of_components, word("a type"));
      add_attribute(keyword == "NORMALS" ? normals : "", values);
    } else {
      m_scanner.fail("the keyword " + printable_keyword(keyword) + " is unknown", remedy);
    }
  }

  void read_field()
  {
    word("the name of a field");
    for (std::size_t number = count(); number > 0; --number) {
      const std::string name = word("the name of an array");
      const std::size_t number_of_components = count();
      const std::size_t number_of_tuples = count();
      add_attribute(name, numbers(number_of_tuples, number_of_components, word("a type")));
      if (skip("METADATA")) {
        skip_metadata();
      }
    }
  }

  /// Passes over `keyword` if it is the next word. \return whether it is
  bool skip(std::string_view keyword)
  {
    Text_scanner ahead = m_scanner;
    const bool is_next = ahead.skip_blanks() && ahead.word() == keyword;
    m_scanner = is_next ? ahead : m_scanner;
    return is_next;
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

  void add_attribute(const std::string& name, const Numbers& values)
  {
    const std::string lower = lower_case(name);
    if (m_is_at_points && is_wanted(lower)) {
      add_array(lower, values);
    }
  }

  /// Reads an array. In binary it begins behind the line of its type.
  Numbers numbers(std::size_t number_of_tuples, std::size_t number_of_components, const std::string& type)
  {
    // A number takes at least a byte.
    if (number_of_components > 0 && number_of_tuples > m_scanner.remaining() / number_of_components) {
      fail_at_end("all numbers of an array");
    }
    const std::size_t number = number_of_tuples * number_of_components;
    if (m_is_binary) {
      return binary_numbers(number, type);
    }
    Numbers result;
    result.reserve(number);
    while (result.size() < number) {
      m_scanner.expect("all numbers of an array");
      result.push_back(m_scanner.number());
    }
    return result;
  }

  Numbers binary_numbers(std::size_t number, const std::string& type)
  {
    constexpr std::size_t size_of_long = 8;
    const Number_type its_type = number_type(type, size_of_long);
    if (!its_type.is_valid()) {
      m_scanner.fail("an array has the unknown type " + printable_keyword(type), remedy);
    }
    m_scanner.skip_line();
    if (number > m_scanner.remaining() / its_type.size) {
      fail_at_end("all numbers of an array");
    }
    const char* const bytes = m_scanner.rest().data();
    m_scanner.skip(number * its_type.size);
    return to_vector({bytes, its_type, Byte_order::big, its_type.size, number});
  }

  Text_scanner m_scanner;
  bool m_is_binary = false;
  bool m_is_at_points = false;
  std::size_t m_number_of_tuples = 0;
};

} // namespace

Shape_file parse_vtk(std::string_view content, const std::string& /* filename */, unsigned contents)
{
  constexpr std::string_view legacy = "# vtk DataFile";
  return content.substr(0, legacy.size()) == legacy ? Vtk_legacy_parser(content, contents).parse()
                                                    : Vtp_parser(content, contents).parse();
}

} // namespace CSCD::internal
