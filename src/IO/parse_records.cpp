// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads PLY, and PCD of the Point Cloud Library: records of numbers in text or in binary, which a header describes.

#include "IO/formats.h"
#include "IO/scanners.h"
#include <CSCD/IO/Shape_file.h>
#include <CSCD/Vector3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CSCD::internal {

namespace {

/// A property of the items of an element: some numbers, or a list of numbers.
struct Property
{
  std::string name;
  Number_type type;
  bool is_list = false;
  Number_type size_type{}; ///< of a list
  std::size_t count = 1;   ///< of the numbers, if it is not a list
};

/// An element: items of the same properties.
struct Element
{
  std::string name;
  std::size_t number_of_items = 0;
  std::vector<Property> properties;

  bool is_called(const char* singular, const char* plural) const { return name == singular || name == plural; }
  bool has_number(std::string_view its_name) const
  {
    return std::any_of(properties.begin(), properties.end(),
                       [&](const Property& p) { return p.name == its_name && !p.is_list && p.count == 1; });
  }
};

constexpr const char* remedy_of_header = "write the file again";

using Names = std::initializer_list<std::string_view>;

/// Goes through the items of elements behind a header.
class Item_scanner
{
public:
  /// \param text behind the header
  /// \param order of the bytes; none for numbers in text
  Item_scanner(const Text_scanner& text, const std::optional<Byte_order>& order, std::string filename)
      : m_text(text), m_filename(std::move(filename))
  {
    if (order) {
      m_bytes.emplace(text.rest(), *order, m_filename);
    }
  }

  /// The size of the rest of the data, in bytes.
  std::size_t remaining() const { return m_bytes ? m_bytes->remaining() : m_text.remaining(); }

  /// Reads the items of `element`. Calls `use(item, property, number)` for each of their numbers, and `end(item)`
  /// behind them.
  template <class Use, class End>
  void read_items(const Element& element, const Use& use, const End& end)
  {
    // Items without properties take no room in the file, so that their number proves nothing.
    for (std::size_t item = 0; item < element.number_of_items && !element.properties.empty(); ++item) {
      for (const Property& property : element.properties) {
        const std::size_t size = property.is_list ? next_size(property) : property.count;
        for (std::size_t i = 0; i < size; ++i) {
          use(item, property, next(property.type));
        }
      }
      end(item);
    }
  }

  /// Calls `use(item, numbers)` for each item with its properties of `names`; those that are missing are 0.
  template <class Use>
  void read_numbers(const Element& element, Names names, const Use& use)
  {
    std::vector<std::size_t> places; // of the properties among these names; their number for others
    for (const Property& property : element.properties) {
      const auto* const name = std::find(names.begin(), names.end(), property.name);
      places.push_back(property.is_list ? names.size() : std::size_t(name - names.begin()));
    }
    std::vector<double> numbers(names.size() + 1); // the last one is not needed
    const auto keep = [&](std::size_t, const Property& property, double number) {
      numbers[places[std::size_t(&property - element.properties.data())]] = number;
    };
    read_items(element, keep, [&](std::size_t item) { use(item, numbers); });
  }

private:
  double next(const Number_type& type)
  {
    if (m_bytes) {
      return m_bytes->number(type);
    }
    m_text.expect("all that its header promises");
    return m_text.number();
  }

  /// The number of entries of a list. \throw File_error if there cannot be as many
  std::size_t next_size(const Property& list)
  {
    const double size = next(list.size_type);
    if (!(size >= 0 && size <= double(remaining()))) {
      fail_in_file(m_filename, "the list " + list.name + " is longer than the file");
    }
    return static_cast<std::size_t>(size);
  }

  Text_scanner m_text;
  std::optional<Byte_scanner> m_bytes;
  std::string m_filename;
};

/// Reads vertices, and faces or edges; all other elements and properties are passed over.
class Ply_parser
{
public:
  Ply_parser(std::string_view content, const std::string& filename, unsigned contents)
      : m_scanner(content, filename), m_filename(filename), m_contents(contents)
  {
  }

  Shape_file parse()
  {
    read_header();
    for (const Element& element : m_elements) {
      const bool is_face = element.is_called("face", "faces");
      m_shape.has_polygons = m_shape.has_polygons || is_face;
      if (element.is_called("vertex", "vertices")) {
        read_points(element);
      } else if (is_face && m_contents != skeleton_content) {
        read_polygons(element);
      } else if (element.is_called("edge", "edges") && (m_contents & skeleton_content) != 0) {
        read_edges(element);
      } else {
        m_items->read_items(
            element, [](std::size_t, const Property&, double) {}, [](std::size_t) {});
      }
    }
    return std::move(m_shape);
  }

private:
  /// \name The header
  /// @{

  void read_header()
  {
    if (m_scanner.word() != "ply") {
      m_scanner.fail("this is not a PLY file: it does not begin with ply", "check the ending of the file name");
    }
    std::string_view encoding = "ascii";
    while (m_scanner.skip_blanks()) {
      const std::string_view keyword = m_scanner.word();
      if (keyword == "format") {
        encoding = next_word();
      } else if (keyword == "element") {
        const std::string name(next_word());
        m_scanner.skip_blanks_in_line();
        m_elements.push_back({name, m_scanner.count("the number of items of an element"), {}});
      } else if (keyword == "property") {
        read_property();
      }
      if (encoding != "ascii" && encoding != "binary_little_endian" && encoding != "binary_big_endian") {
        m_scanner.fail("the header names an unknown encoding", remedy_of_header);
      }
      m_scanner.skip_line(); // comments and other lines of the header
      if (keyword == "end_header") {
        const Byte_order order = encoding == "binary_big_endian" ? Byte_order::big : Byte_order::little;
        m_items.emplace(m_scanner, encoding == "ascii" ? std::nullopt : std::optional(order), m_filename);
        return;
      }
    }
    m_scanner.fail_at_end("the end of its header");
  }

  std::string_view next_word()
  {
    m_scanner.expect_in_line("the header has an incomplete line", remedy_of_header);
    return m_scanner.word();
  }

  void read_property()
  {
    if (m_elements.empty()) {
      m_scanner.fail("a property stands before any element", remedy_of_header);
    }
    Property property;
    std::string_view word = next_word();
    if (word == "list") {
      property.is_list = true;
      property.size_type = type(next_word());
      word = next_word();
    }
    property.type = type(word);
    property.name = next_word();
    m_elements.back().properties.push_back(property);
  }

  Number_type type(std::string_view name) const
  {
    const Number_type result = number_type(name);
    if (!result.is_valid()) {
      m_scanner.fail("the header names an unknown type", remedy_of_header);
    }
    return result;
  }
  /// @}

  void check_properties(const Element& element, Names names) const
  {
    for (const std::string_view name : names) {
      if (!element.has_number(name)) {
        fail("the element " + element.name + " has no property " + std::string(name));
      }
    }
  }

  void read_points(const Element& element)
  {
    const Names names{"x", "y", "z", "nx", "ny", "nz", "radius"};
    check_properties(element, {"x", "y", "z"});
    const bool has_normals = m_contents != skeleton_content && element.has_number("nx") && element.has_number("ny") &&
                             element.has_number("nz");
    const bool has_radii = (m_contents & skeleton_content) != 0 && element.has_number("radius");
    m_shape.points.reserve(m_shape.points.size() + std::min(element.number_of_items, m_items->remaining() / 3 + 1));
    m_items->read_numbers(element, names, [&](std::size_t, const std::vector<double>& values) {
      m_shape.points.emplace_back(values[0], values[1], values[2]);
      if (has_normals) {
        m_shape.normals.emplace_back(values[3], values[4], values[5]);
      }
      if (has_radii) {
        m_shape.radii.push_back(values[6]);
      }
    });
  }

  void read_polygons(const Element& element)
  {
    const std::size_t max_number = std::min(element.number_of_items, m_items->remaining() / 3 + 1);
    m_shape.corners.reserve(3 * max_number);
    m_shape.first_corner.reserve(max_number + 1);
    const Property* const properties = element.properties.data();
    const Property* const corners =
        std::find_if(properties, properties + element.properties.size(), [](const Property& p) {
          return p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index");
        });
    const auto add = [this, corners](std::size_t face, const Property& property, double number) {
      if (&property == corners) {
        m_shape.corners.push_back(to_index(number, "face", face));
      }
    };
    m_items->read_items(element, add, [this](std::size_t) { m_shape.end_polygon(); });
  }

  void read_edges(const Element& element)
  {
    check_properties(element, {"vertex1", "vertex2"});
    m_items->read_numbers(element, {"vertex1", "vertex2"}, [this](std::size_t edge, const std::vector<double>& ends) {
      m_shape.lines.push_back({to_index(ends[0], "edge", edge), to_index(ends[1], "edge", edge)});
    });
  }

  Index to_index(double number, const char* owner, std::size_t item) const
  {
    if (!(number >= 0 && number < double(no_index) && std::floor(number) == number)) {
      fail(std::string(owner) + ' ' + std::to_string(item) + " has a vertex index that is negative or not an integer");
    }
    return static_cast<Index>(number);
  }

  [[noreturn]] void fail(const std::string& fault) const { fail_in_file(m_filename, fault); }

  Text_scanner m_scanner;
  std::string m_filename;
  std::vector<Element> m_elements;
  std::optional<Item_scanner> m_items; ///< behind the header
  unsigned m_contents;
  Shape_file m_shape;
};

/// Reads the header of PCD up to its last line, which names the encoding. \return the points
Element read_pcd_header(Text_scanner& scanner, std::string& encoding)
{
  Element points{"point", 0, {}};
  std::vector<Property>& fields = points.properties;
  while (encoding.empty()) {
    scanner.expect("the keyword DATA", '#');
    const std::string keyword(scanner.word());
    if (keyword == "FIELDS") {
      while (scanner.skip_blanks_in_line()) {
        fields.push_back({std::string(scanner.word()), {'f', 4}});
      }
    } else if (keyword == "SIZE" || keyword == "COUNT" || keyword == "TYPE") {
      for (auto field = fields.begin(); field != fields.end() && scanner.skip_blanks_in_line(); ++field) {
        if (keyword == "TYPE") {
          const std::string_view type = scanner.word();
          field->type.kind = type == "I" ? 'i' : type == "U" ? 'u' : 'f';
        } else {
          (keyword == "SIZE" ? field->type.size : field->count) = scanner.count("the size of a field");
        }
      }
    } else if (keyword == "POINTS") {
      points.number_of_items = scanner.skip_blanks_in_line() ? scanner.count("the number of points") : 0;
    } else if (keyword == "DATA") {
      encoding = scanner.skip_blanks_in_line() ? std::string(scanner.word()) : "none";
    }
    scanner.skip_line();
  }
  return points;
}

} // namespace

Shape_file parse_ply(std::string_view content, const std::string& filename, unsigned contents)
{
  return Ply_parser(content, filename, contents).parse();
}

/// Reads PCD of the Point Cloud Library, ASCII or binary. Points that are not finite, which stand for missing
/// measurements, are left out.
Shape_file parse_pcd(std::string_view content, const std::string& filename, unsigned /* contents */)
{
  Text_scanner scanner(content, filename);
  std::string encoding;
  const Element points = read_pcd_header(scanner, encoding);
  const Names names{"x", "y", "z", "normal_x", "normal_y", "normal_z"};
  for (const Property& field : points.properties) {
    if (!field.type.is_valid()) {
      scanner.fail("a field has an unknown type or size", remedy_of_header);
    }
  }
  for (const std::string_view name : {"x", "y", "z"}) {
    if (!points.has_number(name)) {
      scanner.fail("the field " + std::string(name) + " is missing", remedy_of_header);
    }
  }
  if (encoding != "ascii" && encoding != "binary") {
    scanner.fail("DATA is neither ascii nor binary",
                 "write the file as DATA binary, as by `pcl_convert_pcd_ascii_binary IN.pcd OUT.pcd 1`");
  }
  const bool has_normals =
      std::all_of(names.begin() + 3, names.end(), [&points](std::string_view name) { return points.has_number(name); });
  Shape_file shape;
  Item_scanner items(scanner, encoding == "ascii" ? std::nullopt : std::optional(Byte_order::little), filename);
  items.read_numbers(points, names, [&](std::size_t, const std::vector<double>& v) {
    if (const Vector3 point(v[0], v[1], v[2]); point.allFinite()) {
      shape.points.push_back(point);
      if (has_normals) {
        const Vector3 normal(v[3], v[4], v[5]);
        shape.normals.push_back(normal.allFinite() ? normal : Vector3::Zero());
      }
    }
  });
  return shape;
}

} // namespace CSCD::internal
