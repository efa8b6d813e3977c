// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads polygons from OFF, OBJ, STL, and raw meshes of Neuroglancer.

#ifndef CSCD_IO_INTERNAL_PARSE_MESH_H
#define CSCD_IO_INTERNAL_PARSE_MESH_H

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

/// Hashes a point by its coordinates; equal points have equal hashes.
inline std::uint64_t hash_point(const Vector_3& point)
{
  constexpr std::uint64_t factor = 0x9e3779b97f4a7c15; // 2^64 by the golden ratio, odd: spreads near numbers
  std::uint64_t hash = 0;
  for (double coordinate : point) {
    coordinate += 0.0; // turns -0 into 0, which is equal
    std::uint64_t bits = 0;
    std::memcpy(&bits, &coordinate, sizeof(bits));
    hash = (hash ^ bits) * factor;
    hash ^= hash >> 32;
  }
  return hash;
}

/// Makes points of exactly equal coordinates one, the first of them. Open addressing in one array, at most half full:
/// the nodes of std::unordered_map take five times as long. The array grows with the number of different points: the
/// smaller it is, the more of it is in the cache.
class Point_merger
{
public:
  /// \param expected the number of points that will be added
  explicit Point_merger(std::size_t expected) : m_places(first_size, no_index) { m_indices.reserve(expected); }

  /// Adds a finite point.
  void add(const Vector_3& point)
  {
    Pending& pending = m_pending[m_number % m_pending.size()];
    if (m_number >= m_pending.size()) {
      insert(pending);
    }
    pending = {point, hash_point(point)};
#ifdef __GNUC__
    __builtin_prefetch(&m_places[place_of(pending.hash)]);
#endif
    ++m_number;
  }

  /// Hands over the different points, in the order in which they were added first, and for each point that was added,
  /// which of these it is. To be called once, at the end.
  void move_to(std::vector<Vector_3>& points, std::vector<Index>& indices)
  {
    for (std::size_t i = m_number - std::min(m_number, m_pending.size()); i < m_number; ++i) {
      insert(m_pending[i % m_pending.size()]);
    }
    points = std::move(m_points);
    indices = std::move(m_indices);
  }

private:
  /// A point that waits for the memory that its place needs.
  struct Pending
  {
    Vector_3 point;
    std::uint64_t hash;
  };

  static constexpr std::size_t first_size = 1024; // a power of 2, as all sizes
  static constexpr std::size_t number_of_pending = 16;

  std::size_t place_of(std::uint64_t hash) const
  {
    return std::size_t(hash) & (m_places.size() - 1);
  }

  /// The place of a point, or a free one.
  std::size_t find_place(const Pending& pending) const
  {
    std::size_t place = place_of(pending.hash);
    while (m_places[place] != no_index && m_points[m_places[place]] != pending.point) {
      place = place_of(place + 1);
    }
    return place;
  }

  void insert(const Pending& pending)
  {
    std::size_t place = find_place(pending);
    if (m_places[place] == no_index) {
      if (2 * (m_points.size() + 1) > m_places.size()) {
        grow();
        place = find_place(pending);
      }
      m_places[place] = Index(m_points.size());
      m_points.push_back(pending.point);
    }
    m_indices.push_back(m_places[place]);
  }

  void grow()
  {
    m_places.assign(4 * m_places.size(), no_index);
    for (Index point = 0; point < m_points.size(); ++point) {
      m_places[find_place({m_points[point], hash_point(m_points[point])})] = point;
    }
  }

  std::vector<Index> m_places; // by hash
  std::vector<Vector_3> m_points;
  std::vector<Index> m_indices;
  std::array<Pending, number_of_pending> m_pending;
  std::size_t m_number = 0; // of points that were added
};

/// Merges points of exactly equal coordinates into the first of them; the others keep their order. Linear.
/// \param[out] new_index for each old point, its new index
/// \return the number of points that vanished
/// \pre the points are finite
inline std::size_t merge_equal_points(std::vector<Vector_3>& points, std::vector<Index>& new_index)
{
  const std::size_t size = points.size();
  Point_merger merger(size);
  for (const Vector_3& point : points) {
    merger.add(point);
  }
  merger.move_to(points, new_index);
  return size - points.size();
}

/// Reads OFF, ASCII line by line or binary; colors and texture coordinates are passed over.
class Off_parser
{
public:
  Off_parser(std::string_view text, const std::string& filename) : m_scanner(text, filename), m_filename(filename) {}

  Polygon_soup parse()
  {
    read_keyword();
    if (Text_scanner ahead = m_scanner; ahead.skip_blanks(comment) && ahead.word() == "BINARY") {
      ahead.skip_line();
      read_binary(ahead.rest());
    } else {
      read_counts();
      read_points();
      read_polygons();
    }
    return std::move(m_soup);
  }

private:
  static constexpr char comment = '#';
  /// The fewest bytes that a line of a point takes (`0 0 0` and a line end), and of a polygon (`1 0`).
  static constexpr std::size_t min_point_size = 6;
  static constexpr std::size_t min_polygon_size = 4;
  /// In binary files, of numbers of all kinds in bytes, and of colors in numbers.
  static constexpr std::size_t number_size = sizeof(std::uint32_t);
  static constexpr std::uint32_t max_size_of_color = 4;

  void read_keyword()
  {
    m_scanner.skip_blanks(comment);
    std::string_view keyword = m_scanner.word();
    const auto drop = [&keyword](std::string_view prefix) {
      const bool found = keyword.substr(0, prefix.size()) == prefix;
      keyword.remove_prefix(found ? prefix.size() : 0);
      return found;
    };
    m_size_of_look = drop("ST") ? 2 : 0;
    m_size_of_look += drop("C") ? max_size_of_color : 0;
    m_has_normals = drop("N");
    m_is_homogeneous = drop("4");
    // Some writers leave no blank between the keyword and the number of vertices.
    if (!drop("OFF") || (!keyword.empty() && (keyword[0] < '0' || keyword[0] > '9'))) {
      m_scanner.fail("this is no OFF file of three-dimensional points: the keyword OFF is missing",
                     "check the ending of the file name");
    }
    m_scanner.unread(keyword.size());
  }

  void read_counts()
  {
    if (!m_scanner.skip_blanks(comment)) {
      m_scanner.fail_at_end("the number of vertices");
    }
    m_number_of_points = m_scanner.count("the number of vertices");
    check_number_of_points(m_number_of_points, m_filename);
    if (!m_scanner.skip_blanks(comment)) {
      m_scanner.fail_at_end("the number of faces");
    }
    m_number_of_polygons = m_scanner.count("the number of faces");
    m_scanner.skip_line();
  }

  void read_points()
  {
    m_soup.points.reserve(std::min(m_number_of_points, m_scanner.remaining() / min_point_size + 1));
    for (std::size_t i = 0; i < m_number_of_points; ++i) {
      if (!m_scanner.skip_blanks(comment)) {
        m_scanner.fail_at_end("vertex " + std::to_string(i) + " of " + std::to_string(m_number_of_points));
      }
      Vector_3 point = Vector_3::Zero();
      for (double& coordinate : point) {
        coordinate = next_coordinate();
      }
      if (m_is_homogeneous) {
        divide(point, next_coordinate());
      }
      m_soup.points.push_back(point);
      if (m_has_normals) {
        read_normal();
      }
      m_scanner.skip_line();
    }
  }

  /// Reads a normal; where one is incomplete, none is kept.
  void read_normal()
  {
    Vector_3 normal = Vector_3::Zero();
    for (double& coordinate : normal) {
      if (!m_scanner.skip_blanks_in_line()) {
        m_has_normals = false;
        m_soup.normals.clear();
        return;
      }
      coordinate = m_scanner.number();
    }
    m_soup.normals.push_back(normal);
  }

  double next_coordinate()
  {
    if (!m_scanner.skip_blanks_in_line()) {
      m_scanner.fail("a vertex has too few coordinates", "correct this line or write the file again");
    }
    return m_scanner.coordinate();
  }

  void divide(Vector_3& point, double weight) const
  {
    if (weight != 0) {
      point /= weight;
    }
    if (weight == 0 || !point.allFinite()) {
      m_scanner.fail("a homogeneous vertex lies at infinity", "correct this line");
    }
  }

  void read_polygons()
  {
    const std::size_t expected = std::min(m_number_of_polygons, m_scanner.remaining() / min_polygon_size + 1);
    m_soup.corners.reserve(3 * expected);
    for (std::size_t i = 0; i < m_number_of_polygons; ++i) {
      if (!m_scanner.skip_blanks(comment)) {
        m_scanner.fail_at_end("face " + std::to_string(i) + " of " + std::to_string(m_number_of_polygons));
      }
      const std::size_t size = m_scanner.count("the number of vertices of a face");
      for (std::size_t k = 0; k < size; ++k) {
        m_soup.corners.push_back(next_corner());
      }
      m_soup.end_polygon();
      m_scanner.skip_line();
    }
  }

  Index next_corner()
  {
    if (!m_scanner.skip_blanks(comment)) { // some write each index on a line of its own
      m_scanner.fail_at_end("all vertices of a face");
    }
    const std::size_t corner = m_scanner.count("the index of a vertex");
    if (corner >= m_number_of_points) {
      m_scanner.fail("a face names vertex " + std::to_string(corner) + ", but there are only " +
                         std::to_string(m_number_of_points) + " (counted from 0)",
                     "correct this line or write the file again");
    }
    return static_cast<Index>(corner);
  }

  /// Reads what is behind the line of the keyword in a binary file: the same numbers as in ASCII, big endian, and with
  /// each polygon the number of its color's components. Or else, as pmp-library writes, little endian without that; a
  /// number of points that the file cannot hold tells so.
  void read_binary(std::string_view content)
  {
    using boost::endian::order;
    const bool is_little =
        Byte_scanner(content, order::big, m_filename).number<std::uint32_t>() > content.size() / (3 * number_size);
    Byte_scanner bytes(content, is_little ? order::little : order::big, m_filename);
    m_number_of_points = bytes.number<std::uint32_t>();
    check_number_of_points(m_number_of_points, m_filename);
    m_number_of_polygons = bytes.number<std::uint32_t>();
    bytes.skip(number_size); // the number of edges
    m_soup.points.reserve(std::min(m_number_of_points, bytes.remaining() / (3 * number_size)));
    for (std::size_t i = 0; i < m_number_of_points; ++i) {
      Vector_3 point = next_vector(bytes);
      point /= m_is_homogeneous ? double(bytes.number<float>()) : 1.;
      if (!point.allFinite()) {
        throw File_error(m_filename + ": vertex " + std::to_string(i) + " is not finite; write the file again");
      }
      m_soup.points.push_back(point);
      if (m_has_normals) {
        m_soup.normals.push_back(next_vector(bytes));
      }
      bytes.skip(number_size * m_size_of_look);
    }
    for (std::size_t i = 0; i < m_number_of_polygons; ++i) {
      read_binary_polygon(bytes);
      if (!is_little) {
        skip_color_of_polygon(bytes);
      }
      m_soup.end_polygon();
    }
  }

  static Vector_3 next_vector(Byte_scanner& bytes)
  {
    Vector_3 vector = Vector_3::Zero();
    for (double& coordinate : vector) {
      coordinate = double(bytes.number<float>());
    }
    return vector;
  }

  void read_binary_polygon(Byte_scanner& bytes)
  {
    const auto size = bytes.number<std::uint32_t>();
    for (std::uint32_t k = 0; k < size; ++k) {
      const auto corner = bytes.number<std::uint32_t>();
      if (corner >= m_number_of_points) {
        fail_at_polygon("names vertex " + std::to_string(corner) + ", but there are only " +
                        std::to_string(m_number_of_points) + " (counted from 0)");
      }
      m_soup.corners.push_back(corner);
    }
  }

  void skip_color_of_polygon(Byte_scanner& bytes) const
  {
    const auto size_of_color = bytes.number<std::uint32_t>();
    if (size_of_color > max_size_of_color) {
      fail_at_polygon("has a color of " + std::to_string(size_of_color) + " components");
    }
    bytes.skip(number_size * size_of_color);
  }

  [[noreturn]] void fail_at_polygon(const std::string& fault) const
  {
    throw File_error(m_filename + ": face " + std::to_string(m_soup.number_of_polygons()) + " " + fault +
                     "; write the file again");
  }

  Text_scanner m_scanner;
  std::string m_filename;
  Polygon_soup m_soup;
  std::size_t m_size_of_look = 0; ///< the numbers that a vertex has for color and texture, in binary files
  std::size_t m_number_of_points = 0;
  std::size_t m_number_of_polygons = 0;
  bool m_has_normals = false;
  bool m_is_homogeneous = false;
};

/// Reads `text`, the content of an OFF file.
/// \throw File_error if it is malformed
inline Polygon_soup parse_off(std::string_view text, const std::string& filename)
{
  return Off_parser(text, filename).parse();
}

/// Reads the vertices and faces of Wavefront OBJ; all other statements are passed over.
class Obj_parser
{
public:
  Obj_parser(std::string_view text, const std::string& filename) : m_scanner(text, filename), m_filename(filename) {}

  Polygon_soup parse()
  {
    while (m_scanner.skip_blanks('#')) {
      const std::string_view statement = m_scanner.word();
      if (statement == "v") {
        read_point();
      } else if (statement == "f") {
        read_polygon();
      }
      m_scanner.skip_line();
    }
    check_number_of_points(m_soup.points.size(), m_filename);
    check_corners();
    return std::move(m_soup);
  }

private:
  void read_point()
  {
    Vector_3 point = Vector_3::Zero();
    for (double& coordinate : point) {
      if (!m_scanner.skip_blanks_in_line()) {
        m_scanner.fail("a vertex has too few coordinates", "correct this line or write the file again");
      }
      coordinate = m_scanner.coordinate();
    }
    m_soup.points.push_back(point);
  }

  void read_polygon()
  {
    while (m_scanner.skip_blanks_in_line()) {
      if (m_scanner.is_at("\\")) { // the statement goes on in the next line
        m_scanner.skip_line();
        continue;
      }
      m_soup.corners.push_back(corner(m_scanner.integer("the index of a vertex")));
      m_scanner.word(); // indices of texture coordinates and normals
    }
    m_soup.end_polygon();
  }

  /// Indices count from 1, negative ones from the last vertex backwards.
  Index corner(std::int64_t index) const
  {
    const auto size = static_cast<std::int64_t>(m_soup.points.size());
    const std::int64_t corner = index > 0 ? index - 1 : size + index;
    if (index == 0 || corner < 0 || corner >= static_cast<std::int64_t>(no_index)) {
      m_scanner.fail("a face names vertex " + std::to_string(index) + ", which does not exist (they count from 1)",
                     "correct this line or write the file again");
    }
    return static_cast<Index>(corner);
  }

  /// Faces may stand before their vertices, so that this is known only now.
  void check_corners() const
  {
    if (m_soup.corners.empty()) {
      return;
    }
    const Index last = *std::max_element(m_soup.corners.begin(), m_soup.corners.end());
    if (last >= m_soup.points.size()) {
      throw File_error(m_filename + ": a face names vertex " + std::to_string(std::size_t(last) + 1) +
                       ", but there are only " + std::to_string(m_soup.points.size()) +
                       "; the file may be truncated, fetch or write it again");
    }
  }

  Text_scanner m_scanner;
  std::string m_filename;
  Polygon_soup m_soup;
};

/// Reads `text`, the content of an OBJ file.
/// \throw File_error if it is malformed
inline Polygon_soup parse_obj(std::string_view text, const std::string& filename)
{
  return Obj_parser(text, filename).parse();
}

/// Reads ASCII and binary STL. STL repeats a vertex in each of its triangles; these are made one here.
class Stl_parser
{
public:
  Stl_parser(std::string_view content, const std::string& filename) : m_content(content), m_filename(filename) {}

  Polygon_soup parse()
  {
    if (is_binary()) {
      read_binary();
    } else {
      read_text();
    }
    return soup();
  }

private:
  /// A binary file begins with a text without meaning, then the number of triangles, then the triangles: normal, three
  /// vertices, and two more bytes.
  static constexpr std::size_t text_size = 80;
  static constexpr std::size_t header_size = text_size + sizeof(std::uint32_t);
  static constexpr std::size_t normal_size = 3 * sizeof(float);
  static constexpr std::size_t attribute_size = 2;
  static constexpr std::size_t triangle_size = normal_size + 9 * sizeof(float) + attribute_size;

  /// The text of a binary file may begin with `solid`, which an ASCII file must; the file's size decides then.
  bool is_binary() const
  {
    constexpr std::string_view solid = "solid";
    if (m_content.size() < header_size) {
      return false;
    }
    Byte_scanner scanner(m_content.substr(text_size), boost::endian::order::little, m_filename);
    const auto number_of_triangles = std::size_t(scanner.number<std::uint32_t>());
    Text_scanner text(m_content, m_filename);
    text.skip_blanks();
    return m_content.size() == header_size + number_of_triangles * triangle_size || text.word() != solid;
  }

  void read_binary()
  {
    Byte_scanner scanner(m_content.substr(text_size), boost::endian::order::little, m_filename);
    const auto number_of_triangles = std::size_t(scanner.number<std::uint32_t>());
    if (number_of_triangles > scanner.remaining() / triangle_size) {
      throw File_error(m_filename + ": neither ASCII STL nor binary STL: " + std::to_string(number_of_triangles) +
                       " triangles are announced, there is room for " +
                       std::to_string(scanner.remaining() / triangle_size) +
                       "; check the ending of the file name, or fetch the file again");
    }
    check_number_of_points(3 * number_of_triangles, m_filename);
    m_points = Point_merger(3 * number_of_triangles);
    for (std::size_t i = 0; i < number_of_triangles; ++i) {
      scanner.skip(normal_size);
      for (int corner = 0; corner < 3; ++corner) {
        m_points.add(next_point(scanner, i));
      }
      scanner.skip(attribute_size);
    }
  }

  Vector_3 next_point(Byte_scanner& scanner, std::size_t triangle) const
  {
    Vector_3 point = Vector_3::Zero();
    for (double& coordinate : point) {
      coordinate = double(scanner.number<float>());
      if (!std::isfinite(coordinate)) {
        throw File_error(m_filename + ": triangle " + std::to_string(triangle) +
                         " has a coordinate that is not finite; remove the triangle or write the file again");
      }
    }
    return point;
  }

  void read_text()
  {
    Text_scanner scanner(m_content, m_filename);
    if (!scanner.skip_blanks() || scanner.word() != "solid") {
      scanner.fail("neither ASCII STL nor binary STL: the keyword solid is missing",
                   "check the ending of the file name");
    }
    bool is_complete = false;
    while (scanner.skip_blanks()) {
      const std::string_view word = scanner.word();
      if (word == "facet") {
        read_facet(scanner);
      }
      is_complete = word == "endsolid" || word == "end"; // some write "end solid"
      if (word == "solid" || is_complete) {
        scanner.skip_line(); // the name of the solid
      }
    }
    if (!is_complete) {
      scanner.fail_at_end("the keyword endsolid");
    }
  }

  void read_facet(Text_scanner& scanner)
  {
    int number_of_vertices = 0;
    while (scanner.skip_blanks()) {
      const std::string_view word = scanner.word();
      if (word == "vertex") {
        read_vertex(scanner);
        ++number_of_vertices;
      } else if (word == "endfacet") {
        if (number_of_vertices != 3) {
          scanner.fail("a facet does not have three vertices", "correct it or write the file again");
        }
        return;
      }
    }
    scanner.fail_at_end("the keyword endfacet");
  }

  void read_vertex(Text_scanner& scanner)
  {
    Vector_3 point = Vector_3::Zero();
    for (double& coordinate : point) {
      if (!scanner.skip_blanks()) {
        scanner.fail_at_end("all coordinates of a vertex");
      }
      coordinate = scanner.coordinate();
    }
    m_points.add(point);
  }

  Polygon_soup soup()
  {
    Polygon_soup result;
    m_points.move_to(result.points, result.corners);
    check_number_of_points(result.corners.size(), m_filename);
    result.first_corner = Corner_offsets(result.corners.size() / 3);
    return result;
  }

  std::string_view m_content;
  std::string m_filename;
  Point_merger m_points{0};
};

/// Reads `content`, that of an STL file.
/// \throw File_error if it is malformed
inline Polygon_soup parse_stl(std::string_view content, const std::string& filename)
{
  return Stl_parser(content, filename).parse();
}

/// Reads `content`, that of a raw mesh of Neuroglancer, little endian: the number of vertices as `uint32`, three
/// `float` for each, then three numbers of vertices, `uint32`, for each triangle up to the end of the file.
/// \throw File_error if it is malformed
inline Polygon_soup parse_neuroglancer(std::string_view content, const std::string& filename)
{
  constexpr std::size_t vertex_size = 3 * sizeof(float);
  constexpr std::size_t triangle_size = 3 * sizeof(std::uint32_t);
  Byte_scanner scanner(content, boost::endian::order::little, filename);
  const std::size_t number_of_points = scanner.number<std::uint32_t>();
  if (number_of_points > scanner.remaining() / vertex_size ||
      (scanner.remaining() - number_of_points * vertex_size) % triangle_size != 0) {
    throw File_error(filename + ": the file is too short or too long for a raw mesh of Neuroglancer with " +
                     std::to_string(number_of_points) +
                     " vertices; check the ending of the file name, or fetch it again");
  }
  Polygon_soup soup;
  soup.points.resize(number_of_points);
  for (Vector_3& point : soup.points) {
    for (double& coordinate : point) {
      coordinate = double(scanner.number<float>());
    }
    if (!point.allFinite()) {
      throw File_error(filename + ": a vertex has a coordinate that is not finite; write the file again");
    }
  }
  soup.corners.resize(scanner.remaining() / sizeof(std::uint32_t));
  for (Index& corner : soup.corners) {
    corner = scanner.number<std::uint32_t>();
    if (corner >= number_of_points) {
      throw File_error(filename + ": a triangle names vertex " + std::to_string(corner) + ", but there are only " +
                       std::to_string(number_of_points) + " (counted from 0); write the file again");
    }
  }
  soup.first_corner = Corner_offsets(soup.corners.size() / 3);
  return soup;
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_PARSE_MESH_H
