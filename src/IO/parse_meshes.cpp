// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads Wavefront OBJ, OFF and STL; and PLY, and PCD of the Point Cloud Library: records of numbers in text or in
// binary, which a header describes.

#include "IO/formats.h"
#include "IO/merge_equal_points.h"
#include "IO/scanners.h"
#include <CSCD/IO/Shape_file.h>
#include <CSCD/Vector3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CSCD::internal {

namespace {

constexpr const char* too_few_coordinates = "a vertex has too few coordinates";

/// \name OFF
/// @{
constexpr char comment_of_off = '#';

/// Reads the keyword. \return whether normals follow the coordinates of the vertices
bool read_off_keyword(Text_scanner& scanner)
{
  scanner.skip_blanks(comment_of_off);
  std::string_view keyword = scanner.word();
  drop_prefix(keyword, "ST"); // texture coordinates, then colors
  drop_prefix(keyword, "C");
  const bool has_normals = drop_prefix(keyword, "N");
  // Some writers leave no blank between the keyword and the number of vertices.
  if (!drop_prefix(keyword, "OFF") || (!keyword.empty() && (keyword[0] < '0' || keyword[0] > '9'))) {
    scanner.fail("this is not an OFF file of three-dimensional points: the keyword OFF is missing",
                 "check the ending of the file name");
  }
  scanner.unread(keyword.size());
  return has_normals;
}

/// Reads points, and normals if there are any; where one is incomplete, none is kept.
void read_off_points(Text_scanner& scanner, std::size_t number, bool has_normals, Shape_file& shape)
{
  constexpr std::size_t min_point_size = 6; // bytes of `0 0 0` and a line end
  shape.points.reserve(std::min(number, scanner.remaining() / min_point_size + 1));
  for (std::size_t i = 0; i < number; ++i) {
    if (!scanner.skip_blanks(comment_of_off)) {
      fail_at_end("vertex " + std::to_string(i) + " of " + std::to_string(number));
    }
    shape.points.push_back(scanner.point_in_line(too_few_coordinates));
    Vector3 normal = Vector3::Zero();
    for (std::size_t k = 0; has_normals && k < 3; ++k) {
      has_normals = scanner.skip_blanks_in_line();
      normal[k] = has_normals ? scanner.number() : 0;
    }
    if (has_normals) {
      shape.normals.push_back(normal);
    } else {
      shape.normals.clear();
    }
    scanner.skip_line();
  }
}

void read_off_polygons(Text_scanner& scanner, std::size_t number, Shape_file& shape)
{
  constexpr std::size_t min_polygon_size = 4; // bytes of `1 0` and a line end
  shape.corners.reserve(3 * std::min(number, scanner.remaining() / min_polygon_size + 1));
  for (std::size_t i = 0; i < number; ++i) {
    if (!scanner.skip_blanks(comment_of_off)) {
      fail_at_end("face " + std::to_string(i) + " of " + std::to_string(number));
    }
    const std::size_t size = scanner.count("the number of vertices of a face");
    for (std::size_t k = 0; k < size; ++k) {
      scanner.expect("all vertices of a face", comment_of_off);
      const std::size_t corner = scanner.count("the index of a vertex");
      if (corner >= shape.points.size()) {
        scanner.fail("a face names vertex " + std::to_string(corner) + ", but there are only " +
                     std::to_string(shape.points.size()) + " (counted from 0)");
      }
      shape.corners.push_back(static_cast<Index>(corner));
    }
    shape.end_polygon();
    scanner.skip_line();
  }
}
/// @}

/// \name STL
/// A binary file begins with a text without meaning, then the number of triangles, then the triangles: normal, three
/// vertices, and two more bytes.
/// @{
constexpr std::size_t stl_text_size = 80;
constexpr std::size_t stl_header_size = stl_text_size + sizeof(std::uint32_t);
constexpr std::size_t stl_normal_size = 3 * sizeof(float);
constexpr std::size_t stl_attribute_size = 2;
constexpr std::size_t stl_triangle_size = stl_normal_size + 9 * sizeof(float) + stl_attribute_size;

/// Reads binary STL. \param scanner behind the text
void read_binary_stl(Byte_scanner& scanner, std::vector<Vector3>& points)
{
  const auto number_of_triangles = std::size_t(scanner.number<std::uint32_t>());
  const std::size_t room = scanner.remaining() / stl_triangle_size;
  if (number_of_triangles > room) {
    fail("neither ASCII STL nor binary STL: " + std::to_string(number_of_triangles) +
             " triangles are announced, there is room for " + std::to_string(room),
         "check the ending of the file name, or fetch the file again");
  }
  points.reserve(3 * number_of_triangles);
  for (std::size_t i = 0; i < number_of_triangles; ++i) {
    scanner.skip(stl_normal_size);
    for (int corner = 0; corner < 3; ++corner) {
      points.push_back(scanner.vector<float>());
    }
    scanner.skip(stl_attribute_size);
  }
}

void read_text_stl(Text_scanner& scanner, std::vector<Vector3>& points)
{
  if (!scanner.skip_blanks() || scanner.word() != "solid") {
    scanner.fail("neither ASCII STL nor binary STL: the keyword solid is missing", "check the ending of the file name");
  }
  bool is_complete = false;
  std::size_t first = 0; // of the points of a facet
  while (scanner.skip_blanks()) {
    const std::string_view word = scanner.word();
    is_complete = word == "endsolid" || word == "end"; // some write "end solid"
    if (word == "vertex") {
      Vector3& point = points.emplace_back();
      for (double& coordinate : point) {
        scanner.expect("all coordinates of a vertex");
        coordinate = scanner.coordinate();
      }
    } else if (word == "endfacet") {
      if (points.size() != first + 3) {
        scanner.fail("a facet does not have three vertices", "correct it or write the file again");
      }
      first = points.size();
    } else if (word == "solid" || is_complete) {
      scanner.skip_line(); // the name of the solid
    }
  }
  if (points.size() != first || !is_complete) {
    fail_at_end(points.size() != first ? "the keyword endfacet" : "the keyword endsolid");
  }
}
/// @}

/// A property of the items of an element: some numbers, or a list of numbers.
struct Property
{
  std::string name;
  Number_type type;
  bool is_list = false;
  Number_type size_type{}; ///< of a list
  std::size_t count = 1;   ///< of the numbers, if it is not a list
};

using Names = std::initializer_list<std::string_view>;

/// An element: items of the same properties.
struct Element
{
  std::string name;
  std::size_t number_of_items = 0;
  std::vector<Property> properties;

  bool is_called(const char* singular, const char* plural) const { return name == singular || name == plural; }
  /// The first of `names` that is not the name of a property with one number for each item; empty if all are.
  std::string missing_number(Names names) const
  {
    const auto is_missing = [&](std::string_view its_name) {
      return std::none_of(properties.begin(), properties.end(),
                          [&](const Property& p) { return p.name == its_name && !p.is_list && p.count == 1; });
    };
    const auto* const missing = std::find_if(names.begin(), names.end(), is_missing);
    return missing == names.end() ? "" : std::string(*missing);
  }
  bool has_numbers(Names names) const { return missing_number(names).empty(); }
};

constexpr const char* remedy_of_header = "write the file again";

/// Goes through the items of elements behind a header.
class Item_scanner
{
public:
  /// \param text behind the header
  /// \param order of the bytes; none for numbers in text
  Item_scanner(const Text_scanner& text, const std::optional<Byte_order>& order) : m_text(text)
  {
    if (order) {
      m_bytes.emplace(text.rest(), *order);
    }
  }

  /// The size of the rest of the data, in bytes.
  std::size_t remaining() const { return m_bytes ? m_bytes->remaining() : m_text.remaining(); }

  /// Calls `use(item, numbers, corners)` for each item with its numbers of these `names`, 0 for those that are missing,
  /// and with its list of vertices, which is empty if there is none.
  template <class Use>
  void read_items(const Element& element, Names names, const Use& use)
  {
    const auto is_list_of_corners = [](const Property& p) {
      return p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index");
    };
    const std::vector<Property>& properties = element.properties;
    const auto list_of_corners = std::find_if(properties.begin(), properties.end(), is_list_of_corners);
    std::vector<double> numbers(names.size() + 1); // the last one is not needed
    std::vector<double*> places;                   // of the properties among these numbers
    for (const Property& property : properties) {
      const auto* const name = property.is_list ? names.end() : std::find(names.begin(), names.end(), property.name);
      places.push_back(&numbers[std::size_t(name - names.begin())]);
    }
    std::vector<double> corners;
    // Items without properties take no room in the file, so that their number proves nothing.
    for (std::size_t item = 0; item < element.number_of_items && !properties.empty(); ++item) {
      corners.clear();
      auto place = places.begin();
      for (auto property = properties.begin(); property != properties.end(); ++property, ++place) {
        const std::size_t size = property->is_list ? next_size(*property) : property->count;
        for (std::size_t i = 0; i < size; ++i) {
          **place = next(property->type);
          if (property == list_of_corners) {
            corners.push_back(**place);
          }
        }
      }
      use(item, numbers, corners);
    }
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

  /// The number of entries of a list. \throw Content_error if there cannot be as many
  std::size_t next_size(const Property& list)
  {
    const double size = next(list.size_type);
    if (!(size >= 0 && size <= double(remaining()))) {
      fail("the list " + list.name + " is longer than the file");
    }
    return static_cast<std::size_t>(size);
  }

  Text_scanner m_text;
  std::optional<Byte_scanner> m_bytes;
};

/// Reads vertices, and faces, strips or edges; all other elements and properties are passed over.
class Ply_parser
{
public:
  Ply_parser(std::string_view content, unsigned contents) : m_scanner(content), m_contents(contents) {}

  Shape_file parse()
  {
    read_header();
    for (const Element& element : m_elements) {
      const bool is_face = element.is_called("face", "faces");
      const bool is_strip = element.is_called("tristrip", "tristrips");
      m_shape.has_polygons = m_shape.has_polygons || is_face || is_strip;
      if (element.is_called("vertex", "vertices")) {
        read_points(element);
      } else if (is_face && m_contents != skeleton_content) {
        read_polygons(element);
      } else if (is_strip && m_contents != skeleton_content) {
        read_strips(element);
      } else if (element.is_called("edge", "edges") && (m_contents & skeleton_content) != 0) {
        read_edges(element);
      } else {
        m_items->read_items(element, {}, [](const auto&...) {}); // passes over them
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
        m_items.emplace(m_scanner, encoding == "ascii" ? std::nullopt : std::optional(order));
        return;
      }
    }
    fail_at_end("the end of its header");
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
    if (const std::string missing = element.missing_number(names); !missing.empty()) {
      fail("the element " + element.name + " has no property " + missing);
    }
  }

  void read_points(const Element& element)
  {
    check_properties(element, {"x", "y", "z"});
    const bool has_normals = m_contents != skeleton_content && element.has_numbers({"nx", "ny", "nz"});
    const bool has_radii = (m_contents & skeleton_content) != 0 && element.has_numbers({"radius"});
    m_shape.points.reserve(m_shape.points.size() + std::min(element.number_of_items, m_items->remaining() / 3 + 1));
    const auto add = [&](std::size_t, const std::vector<double>& values, const auto&) {
      m_shape.points.emplace_back(values[0], values[1], values[2]);
      if (has_normals) {
        m_shape.normals.emplace_back(values[3], values[4], values[5]);
      }
      if (has_radii) {
        m_shape.radii.push_back(values[6]);
      }
    };
    m_items->read_items(element, {"x", "y", "z", "nx", "ny", "nz", "radius"}, add);
  }

  void read_polygons(const Element& element)
  {
    const std::size_t max_number = std::min(element.number_of_items, m_items->remaining() / 3 + 1);
    m_shape.corners.reserve(3 * max_number);
    m_shape.first_corner.reserve(max_number + 1);
    m_items->read_items(element, {}, [this](std::size_t face, const auto&, const std::vector<double>& corners) {
      for (const double corner : corners) {
        m_shape.corners.push_back(to_index(corner, "face", face));
      }
      m_shape.end_polygon();
    });
  }

  /// Reads strips of triangles, which -1 ends.
  void read_strips(const Element& element)
  {
    m_items->read_items(element, {}, [this](std::size_t item, const auto&, const std::vector<double>& corners) {
      std::vector<Index> strip;
      for (const double corner : corners) {
        if (corner != -1) {
          strip.push_back(to_index(corner, "strip", item));
        } else {
          m_shape.add_strip(std::exchange(strip, {}));
        }
      }
      m_shape.add_strip(strip);
    });
  }

  void read_edges(const Element& element)
  {
    check_properties(element, {"vertex1", "vertex2"});
    const auto add = [this](std::size_t edge, const std::vector<double>& ends, const auto&) {
      m_shape.lines.push_back({to_index(ends[0], "edge", edge), to_index(ends[1], "edge", edge)});
    };
    m_items->read_items(element, {"vertex1", "vertex2"}, add);
  }

  Index to_index(double number, const char* owner, std::size_t item) const
  {
    if (!(number >= 0 && number < double(no_index) && std::floor(number) == number)) {
      fail(std::string(owner) + ' ' + std::to_string(item) + " has a vertex index that is negative or not an integer");
    }
    return static_cast<Index>(number);
  }

  Text_scanner m_scanner;
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

/// Reads the vertices, and the faces or the lines, of OBJ; all other statements are passed over.
Shape_file parse_obj(std::string_view content, const std::string& /* filename */, unsigned contents)
{
  Text_scanner scanner(content);
  Shape_file shape;
  // Calls `use` with the vertices that a statement names, from 0 on. In the file they count from 1, negative ones from
  // the last vertex backwards.
  const auto for_each_vertex = [&](const auto& use) {
    while (scanner.skip_blanks_in_line() && !scanner.is_at("#")) {
      if (scanner.is_at("\\")) { // the statement goes on in the next line
        scanner.skip_line();
        continue;
      }
      const std::int64_t index = scanner.integer("the index of a vertex");
      const std::int64_t vertex = index > 0 ? index - 1 : std::int64_t(shape.points.size()) + index;
      if (index == 0 || vertex < 0 || vertex >= std::int64_t(no_index)) {
        scanner.fail("vertex " + std::to_string(index) + " is named, which does not exist (they count from 1)");
      }
      use(vertex);
      scanner.word(); // indices of texture coordinates and normals
    }
  };
  while (scanner.skip_blanks('#')) {
    const std::string_view statement = scanner.word();
    if (statement == "v") {
      shape.points.push_back(scanner.point_in_line(too_few_coordinates));
    } else if (statement == "f" && contents != skeleton_content) {
      for_each_vertex([&](std::int64_t vertex) { shape.corners.push_back(Index(vertex)); });
      shape.end_polygon();
    } else if (statement == "l" && (contents & skeleton_content) != 0) {
      std::int64_t previous = -1;
      for_each_vertex([&](std::int64_t vertex) {
        if (previous >= 0) {
          shape.lines.push_back({previous, vertex});
        }
        previous = vertex;
      });
    }
    shape.has_polygons = shape.has_polygons || statement == "f";
    scanner.skip_line();
  }
  return shape;
}

/// Reads OFF in ASCII, line by line; colors and texture coordinates are passed over.
Shape_file parse_off(std::string_view content, const std::string& /* filename */, unsigned /* contents */)
{
  Text_scanner scanner(content);
  const auto next_count = [&scanner](const char* meaning) {
    scanner.expect(meaning, comment_of_off);
    return scanner.count(meaning);
  };
  const bool has_normals = read_off_keyword(scanner);
  const std::size_t number_of_points = next_count("the number of vertices");
  const std::size_t number_of_polygons = next_count("the number of faces");
  scanner.skip_line();
  Shape_file shape;
  read_off_points(scanner, number_of_points, has_normals, shape);
  read_off_polygons(scanner, number_of_polygons, shape);
  return shape;
}

/// Reads ASCII and binary STL. STL repeats a vertex in each of its triangles; these are made one here.
Shape_file parse_stl(std::string_view content, const std::string& /* filename */, unsigned /* contents */)
{
  Shape_file result;
  Text_scanner text(content);
  // The text of a binary file may begin with `solid`, which an ASCII file must; the file's size decides then.
  const bool has_header = content.size() >= stl_header_size;
  Byte_scanner bytes(content.substr(has_header ? stl_text_size : content.size()), Byte_order::little);
  Text_scanner first = text;
  first.skip_blanks();
  if (has_header &&
      (content.size() == stl_header_size + Byte_scanner(bytes).number<std::uint32_t>() * stl_triangle_size ||
       first.word() != "solid")) {
    read_binary_stl(bytes, result.points);
  } else {
    read_text_stl(text, result.points);
  }
  check_points(result.points); // equal ones are found by their coordinates, and by indices
  merge_equal_points(result.points, result.corners);
  for (std::size_t end = 3; end <= result.corners.size(); end += 3) {
    result.first_corner.push_back(end);
  }
  return result;
}

Shape_file parse_ply(std::string_view content, const std::string& /* filename */, unsigned contents)
{
  return Ply_parser(content, contents).parse();
}

/// Reads PCD of the Point Cloud Library, ASCII or binary. Points that are not finite, which stand for missing
/// measurements, are left out.
Shape_file parse_pcd(std::string_view content, const std::string& /* filename */, unsigned /* contents */)
{
  Text_scanner scanner(content);
  std::string encoding;
  const Element points = read_pcd_header(scanner, encoding);
  for (const Property& field : points.properties) {
    if (!field.type.is_valid()) {
      scanner.fail("a field has an unknown type or size", remedy_of_header);
    }
  }
  if (const std::string missing = points.missing_number({"x", "y", "z"}); !missing.empty()) {
    scanner.fail("the field " + missing + " is missing", remedy_of_header);
  }
  if (encoding != "ascii" && encoding != "binary") {
    scanner.fail("DATA is neither ascii nor binary",
                 "write the file as DATA binary, as by `pcl_convert_pcd_ascii_binary IN.pcd OUT.pcd 1`");
  }
  const bool has_normals = points.has_numbers({"normal_x", "normal_y", "normal_z"});
  Shape_file shape;
  Item_scanner items(scanner, encoding == "ascii" ? std::nullopt : std::optional(Byte_order::little));
  const auto add = [&](std::size_t, const std::vector<double>& v, const auto&) {
    if (const Vector3 point(v[0], v[1], v[2]); point.allFinite()) {
      shape.points.push_back(point);
      if (has_normals) {
        const Vector3 normal(v[3], v[4], v[5]);
        shape.normals.push_back(normal.allFinite() ? normal : Vector3::Zero());
      }
    }
  };
  items.read_items(points, {"x", "y", "z", "normal_x", "normal_y", "normal_z"}, add);
  return shape;
}

} // namespace CSCD::internal
