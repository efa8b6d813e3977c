// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of read_skeleton.h.

#ifndef CSCD_IO_READ_SKELETON_IMPL_H
#define CSCD_IO_READ_SKELETON_IMPL_H

#include <CSCD/IO/internal/Polygon_soup.h>
#include <CSCD/IO/internal/Scanner.h>
#include <CSCD/IO/internal/parse_ply.h>
#include <CSCD/IO/internal/parse_vtk.h>
#include <CSCD/IO/internal/skeleton_endings.h>
#include <CSCD/IO/read_skeleton.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/config.h>

#include <boost/unordered_map.hpp>
#include <boost/unordered_set.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <istream>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CSCD {
namespace internal {

/// Collects a skeleton. Edges may come before their nodes; they are checked at the end, where edges from a node to
/// itself and repeated ones are left out: they add nothing to a drawing but would count as cycles.
class Skeleton_collector
{
public:
  /// \param filename for messages
  explicit Skeleton_collector(std::string filename) : m_filename(std::move(filename)) {}

  const std::string& filename() const { return m_filename; }
  std::size_t number_of_nodes() const { return m_skeleton.points.size(); }

  void add_node(const Vector_3& point) { m_skeleton.points.push_back(point); }

  /// \throw File_error if the radius is negative or not finite
  void add_node(const Vector_3& point, double radius)
  {
    if (!(radius >= 0 && radius <= std::numeric_limits<double>::max())) {
      fail("node " + std::to_string(number_of_nodes()) +
           " (counted from 0) has a radius that is negative or not finite");
    }
    add_node(point);
    m_skeleton.radii.push_back(radius);
  }

  /// Tells that a limb ends at a border in the node that was added last.
  void set_opening()
  {
    m_skeleton.is_opening.resize(number_of_nodes(), 0);
    m_skeleton.is_opening.back() = 1;
  }

  /// \param source,target numbers of nodes, which count from 0
  void add_edge(std::int64_t source, std::int64_t target) { m_edges.emplace_back(source, target); }
  /// Tells that the edge between these nodes, if there is one, was added to join components.
  void add_joined_edge(std::int64_t source, std::int64_t target) { m_joined_edges.insert(std::minmax(source, target)); }

  /// \throw File_error if there are no nodes, edges name nodes that do not exist, or only some nodes have radii
  Indexed_skeleton finish()
  {
    if (m_skeleton.points.empty()) {
      throw File_error(m_filename + ": the file has no nodes; fetch or write it again");
    }
    check_number_of_points(number_of_nodes(), m_filename);
    if (!m_skeleton.is_opening.empty()) {
      m_skeleton.is_opening.resize(number_of_nodes(), 0);
    }
    if (!m_skeleton.radii.empty() && !m_skeleton.has_radii()) {
      fail("some nodes have a radius and some have none");
    }
    boost::unordered_set<std::pair<std::int64_t, std::int64_t>> seen;
    for (const auto& [source, target] : m_edges) {
      check_node(source);
      check_node(target);
      if (source != target && seen.insert(std::minmax(source, target)).second) {
        m_skeleton.edges.push_back({Index(source), Index(target)});
        m_skeleton.is_joined.push_back(m_joined_edges.count(std::minmax(source, target)) > 0 ? 1 : 0);
      }
    }
    return std::move(m_skeleton);
  }

  /// \throw File_error naming the file and `fault`
  [[noreturn]] void fail(const std::string& fault) const
  {
    throw File_error(m_filename + ": " + fault + "; correct or write the file again");
  }

private:
  void check_node(std::int64_t node) const
  {
    if (node < 0 || std::uint64_t(node) >= number_of_nodes()) {
      fail("an edge names node " + std::to_string(node) + ", but there are only " + std::to_string(number_of_nodes()) +
           " (counted from 0)");
    }
  }

  std::string m_filename;
  Indexed_skeleton m_skeleton;
  std::vector<std::pair<std::int64_t, std::int64_t>> m_edges;
  boost::unordered_set<std::pair<std::int64_t, std::int64_t>> m_joined_edges;
};

/// Reads the next coordinate of this line.
/// \throw File_error if there is none
inline double next_coordinate(Text_scanner& scanner)
{
  if (!scanner.skip_blanks_in_line()) {
    scanner.fail("a node has too few coordinates", "correct this line or write the file again");
  }
  return scanner.coordinate();
}

inline Vector_3 next_point(Text_scanner& scanner)
{
  const double x = next_coordinate(scanner);
  const double y = next_coordinate(scanner);
  const double z = next_coordinate(scanner);
  return {x, y, z};
}

/// Reads the next integer of this line.
/// \throw File_error if there is none
inline std::int64_t next_integer(Text_scanner& scanner, const char* meaning)
{
  if (!scanner.skip_blanks_in_line()) {
    scanner.fail(std::string(meaning) + " is missing", "correct this line or write the file again");
  }
  const std::int64_t result = scanner.integer(meaning);
  if (!scanner.word().empty()) {
    scanner.fail(std::string(meaning) + " is no integer", "correct this line or write the file again");
  }
  return result;
}

/// Reads `text`, the content of a `.graph` file: lines `n x y z` and `c i j`.
/// \throw File_error if it is malformed
inline Indexed_skeleton parse_gel_graph(std::string_view text, const std::string& filename)
{
  Text_scanner scanner(text, filename);
  Skeleton_collector collector(filename);
  while (scanner.skip_blanks('#')) {
    const std::string_view statement = scanner.word();
    if (statement == "n") {
      collector.add_node(next_point(scanner));
    } else if (statement == "c") {
      const std::int64_t source = next_integer(scanner, "the number of a node");
      collector.add_edge(source, next_integer(scanner, "the number of a node"));
    } else {
      scanner.fail("a line begins with neither n nor c", "check that this is a graph of GEL");
    }
    scanner.skip_line();
  }
  return collector.finish();
}

/// Reads `text`, the content of a `.polylines.txt` file: a line for each poly-line, the number of its points and then
/// `x y z` of each. Points with equal coordinates are one node.
/// \throw File_error if it is malformed
inline Indexed_skeleton parse_polylines(std::string_view text, const std::string& filename)
{
  Text_scanner scanner(text, filename);
  Skeleton_collector collector(filename);
  boost::unordered_map<std::array<double, 3>, std::int64_t> nodes;
  const auto next_node = [&] {
    if (!scanner.skip_blanks()) { // some programs break the line
      scanner.fail_at_end("the last point of a poly-line");
    }
    const Vector_3 point = next_point(scanner) + Vector_3::Zero(); // makes -0 equal to 0
    const auto [place, is_new] =
        nodes.try_emplace({point.x(), point.y(), point.z()}, std::int64_t(collector.number_of_nodes()));
    if (is_new) {
      collector.add_node(point);
    }
    return place->second;
  };
  while (scanner.skip_blanks('#')) {
    const std::int64_t size = next_integer(scanner, "the number of points of a poly-line");
    if (size < 1) {
      scanner.fail("a poly-line has no points", "remove this line");
    }
    std::int64_t previous = next_node();
    for (std::int64_t i = 1; i < size; ++i) {
      const std::int64_t next = next_node();
      collector.add_edge(previous, next);
      previous = next;
    }
  }
  return collector.finish();
}

/// Reads SWC: lines `id type x y z radius parent`, in any order, and the comments `# loop i j` of `write_swc()`.
class Swc_parser
{
public:
  Swc_parser(std::string_view text, const std::string& filename) : m_scanner(text, filename), m_collector(filename) {}

  Indexed_skeleton parse()
  {
    while (m_scanner.skip_blanks()) {
      if (m_scanner.skip_character('#')) {
        read_comment();
      } else {
        read_node();
      }
      m_scanner.skip_line();
    }
    for (const auto& [source, target] : m_edges) {
      m_collector.add_edge(node(source), node(target));
    }
    return m_collector.finish();
  }

private:
  /// Comments of others may begin with the same word, but hardly with a number after it.
  void read_comment()
  {
    const bool is_loop = m_scanner.skip_blanks_in_line() && m_scanner.word() == "loop" &&
                         m_scanner.skip_blanks_in_line() && m_scanner.is_at_digit();
    if (is_loop) {
      const std::int64_t source = next_integer(m_scanner, "the identifier of a node");
      m_edges.emplace_back(source, next_integer(m_scanner, "the identifier of a node"));
    }
  }

  void read_node()
  {
    const std::int64_t id = next_integer(m_scanner, "the identifier of a node");
    next_integer(m_scanner, "the type of a node");
    const Vector_3 point = next_point(m_scanner);
    const double radius = next_coordinate(m_scanner);
    const std::int64_t parent = next_integer(m_scanner, "the parent of a node");
    if (!m_nodes.emplace(id, std::int64_t(m_collector.number_of_nodes())).second) {
      m_scanner.fail("the identifier " + std::to_string(id) + " stands for two nodes",
                     "correct this line or write the file again");
    }
    m_collector.add_node(point, radius);
    constexpr std::int64_t no_parent = -1;
    if (parent != no_parent) {
      m_edges.emplace_back(parent, id);
    }
  }

  std::int64_t node(std::int64_t id) const
  {
    const auto place = m_nodes.find(id);
    if (place == m_nodes.end()) {
      m_collector.fail("a parent or loop has the identifier " + std::to_string(id) + ", which no node has");
    }
    return place->second;
  }

  Text_scanner m_scanner;
  Skeleton_collector m_collector;
  boost::unordered_map<std::int64_t, std::int64_t> m_nodes;   ///< by identifier
  std::vector<std::pair<std::int64_t, std::int64_t>> m_edges; ///< of identifiers
};

/// Reads `text`, the content of an SWC file.
/// \throw File_error if it is malformed
inline Indexed_skeleton parse_swc(std::string_view text, const std::string& filename)
{
  return Swc_parser(text, filename).parse();
}

/// The node that `index` of an OBJ file means: indices count from 1, negative ones from the last vertex backwards.
/// \throw File_error if it is 0
inline std::int64_t obj_node(std::int64_t index, std::size_t number_of_nodes, const Text_scanner& scanner)
{
  if (index == 0) {
    scanner.fail("a line names vertex 0 (they count from 1)", "correct this line or write the file again");
  }
  return index > 0 ? index - 1 : std::int64_t(number_of_nodes) + index;
}

/// Reads `text`, the content of an OBJ file, vertices and lines. All vertices are nodes; whatever else there is is
/// passed over, but a file of faces without lines is refused.
/// \throw File_error if it is malformed
inline Indexed_skeleton parse_obj_lines(std::string_view text, const std::string& filename)
{
  Text_scanner scanner(text, filename);
  Skeleton_collector collector(filename);
  bool has_lines = false;
  bool has_faces = false;
  while (scanner.skip_blanks('#')) {
    const std::string_view statement = scanner.word();
    if (statement == "v") {
      collector.add_node(next_point(scanner));
    } else if (statement == "l") {
      has_lines = true;
      std::vector<std::int64_t> nodes;
      while (scanner.skip_blanks_in_line()) {
        nodes.push_back(obj_node(scanner.integer("the index of a vertex"), collector.number_of_nodes(), scanner));
        scanner.word(); // indices of texture coordinates
      }
      for (std::size_t i = 1; i < nodes.size(); ++i) {
        collector.add_edge(nodes[i - 1], nodes[i]);
      }
    }
    has_faces = has_faces || statement == "f";
    scanner.skip_line();
  }
  if (has_faces && !has_lines) {
    collector.fail("it has faces but no lines: a mesh, no skeleton");
  }
  return collector.finish();
}

/// The array `name` of the object `document`.
/// \throw File_error if there is none
inline const nlohmann::json& json_array(const nlohmann::json& document, const char* name,
                                        const Skeleton_collector& collector)
{
  if (!document.is_object() || !document.contains(name) || !document[name].is_array()) {
    collector.fail(std::string("it is no JSON object with an array ") + name);
  }
  return document[name];
}

inline void add_json_node(const nlohmann::json& node, Skeleton_collector& collector)
{
  const std::string name = "node " + std::to_string(collector.number_of_nodes());
  if (!node.is_object() || !node.contains("point") || !node["point"].is_array() || node["point"].size() != 3) {
    collector.fail(name + " has no point of three numbers");
  }
  Vector_3 point = Vector_3::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const nlohmann::json& coordinate = node["point"][i];
    if (!coordinate.is_number()) {
      collector.fail(name + " has a coordinate that is no number");
    }
    point[i] = coordinate.get<double>();
  }
  if (!node.contains("radius")) {
    collector.add_node(point);
  } else if (node["radius"].is_number()) {
    collector.add_node(point, node["radius"].get<double>());
  } else {
    collector.fail(name + " has a radius that is no number");
  }
  if (node.value("is_opening", nlohmann::json(false)) == true) {
    collector.set_opening();
  }
}

/// Reads `text`, a JSON object as `write_json()` writes it: `nodes`, each with `point` and perhaps `radius`
/// and `is_opening`; `edges`, each an array of two nodes; and perhaps `joined_edges`; all else is passed over.
/// \throw File_error if it is malformed
inline Indexed_skeleton parse_json_skeleton(std::string_view text, const std::string& filename)
{
  Skeleton_collector collector(filename);
  constexpr bool has_exceptions = false;
  const nlohmann::json document = nlohmann::json::parse(text.begin(), text.end(), nullptr, has_exceptions);
  if (document.is_discarded()) {
    collector.fail("it is no valid JSON");
  }
  for (const nlohmann::json& node : json_array(document, "nodes", collector)) {
    add_json_node(node, collector);
  }
  const auto check_edge = [&](const nlohmann::json& edge) {
    if (!edge.is_array() || edge.size() != 2 || !edge[0].is_number_unsigned() || !edge[1].is_number_unsigned()) {
      collector.fail("an edge is no array of two numbers of nodes");
    }
  };
  for (const nlohmann::json& edge : json_array(document, "edges", collector)) {
    check_edge(edge);
    collector.add_edge(edge[0].get<std::int64_t>(), edge[1].get<std::int64_t>());
  }
  if (document.contains("joined_edges")) {
    for (const nlohmann::json& edge : json_array(document, "joined_edges", collector)) {
      check_edge(edge);
      collector.add_joined_edge(edge[0].get<std::int64_t>(), edge[1].get<std::int64_t>());
    }
  }
  return collector.finish();
}

/// Reads elements `vertex` with `x y z` and perhaps `radius`, and `edge` with `vertex1 vertex2`; all else is passed
/// over.
template <class Source>
class Ply_edge_parser
{
public:
  Ply_edge_parser(const Source& source, const std::string& filename) : m_source(source), m_collector(filename) {}

  Indexed_skeleton parse(const Ply_header& header)
  {
    bool has_edges = false;
    bool has_faces = false;
    for (const Ply_element& element : header.elements) {
      if (element.name == "vertex" || element.name == "vertices") {
        read_nodes(element);
      } else if (element.name == "edge" || element.name == "edges") {
        has_edges = true;
        read_edges(element);
      } else {
        has_faces = has_faces || element.name == "face" || element.name == "faces";
        read_items(element, {}, [](const std::vector<double>&) {});
      }
    }
    if (has_faces && !has_edges) {
      m_collector.fail("it has faces but no edges: a mesh, no skeleton");
    }
    return m_collector.finish();
  }

private:
  /// Reads all items of `element` and gives the numbers of those properties that `names` names to `use`, item by item.
  template <class Use>
  void read_items(const Ply_element& element, std::initializer_list<std::string_view> names, const Use& use)
  {
    if (element.properties.empty()) {
      return; // such items take no room in the file, so that their number proves nothing
    }
    std::vector<double> numbers(names.size(), 0.);
    for (std::size_t item = 0; item < element.number_of_items; ++item) {
      read_ply_item(m_source, element, m_collector.filename(),
                    [&](const Ply_property& property, std::size_t, double number) {
                      const auto name = std::find(names.begin(), names.end(), property.name);
                      if (!property.is_list && name != names.end()) {
                        numbers[std::size_t(name - names.begin())] = number;
                      }
                    });
      use(numbers);
    }
  }

  void check_properties(const Ply_element& element, std::initializer_list<std::string_view> names) const
  {
    for (const std::string_view name : names) {
      if (!has_ply_number(element, name)) {
        m_collector.fail("its element " + element.name + " has no property " + std::string(name));
      }
    }
  }

  void read_nodes(const Ply_element& element)
  {
    check_properties(element, {"x", "y", "z"});
    const bool has_radius = has_ply_number(element, "radius");
    read_items(element, {"x", "y", "z", "radius"}, [&](const std::vector<double>& numbers) {
      const Vector_3 point(numbers[0], numbers[1], numbers[2]);
      if (!point.allFinite()) {
        m_collector.fail("vertex " + std::to_string(m_collector.number_of_nodes()) +
                         " has a coordinate that is not finite");
      }
      if (has_radius) {
        m_collector.add_node(point, numbers[3]);
      } else {
        m_collector.add_node(point);
      }
    });
  }

  void read_edges(const Ply_element& element)
  {
    check_properties(element, {"vertex1", "vertex2"});
    read_items(element, {"vertex1", "vertex2"}, [&](const std::vector<double>& numbers) {
      m_collector.add_edge(to_node(numbers[0]), to_node(numbers[1]));
    });
  }

  std::int64_t to_node(double number) const
  {
    if (!(number >= 0 && number < double(no_index) && std::floor(number) == number)) {
      m_collector.fail("an edge has a vertex that is negative or no integer");
    }
    return std::int64_t(number);
  }

  Source m_source;
  Skeleton_collector m_collector;
};

/// Reads the vertices and poly-lines of PolyData, and the point arrays `Radius` and `IsOpening`, if they are there.
/// \throw File_error if it is malformed
inline Indexed_skeleton parse_vtk_lines(std::string_view content, const std::string& filename)
{
  Vtk_poly_data data = parse_vtk_data(content, filename);
  Skeleton_collector collector(filename);
  const Polygon_soup& lines = data.cells["lines"];
  if (lines.number_of_polygons() == 0 && (data.cells.count("polys") > 0 || data.cells.count("strips") > 0)) {
    collector.fail("it has faces but no lines: a mesh, no skeleton");
  }
  const std::vector<double>& radii = data.arrays[Vtk_collector::radius];
  const std::vector<double>& openings = data.arrays[Vtk_collector::is_opening];
  for (std::size_t v = 0; v < data.points.size(); ++v) {
    if (radii.empty()) {
      collector.add_node(data.points[v]);
    } else {
      collector.add_node(data.points[v], radii[v]);
    }
    if (!openings.empty() && openings[v] != 0) {
      collector.set_opening();
    }
  }
  for (std::size_t line = 0; line < lines.number_of_polygons(); ++line) {
    for (std::size_t c = lines.first_corner[line]; c + 1 < lines.first_corner[line + 1]; ++c) {
      collector.add_edge(lines.corners[c], lines.corners[c + 1]);
    }
  }
  return collector.finish();
}

inline Indexed_skeleton parse_skeleton(std::string_view content, std::size_t ending, const std::string& filename)
{
  // In the order of `skeleton_endings`.
  constexpr std::array<Indexed_skeleton (*)(std::string_view, const std::string&), number_of_read_skeleton_endings>
      parsers{parse_gel_graph, parse_json_skeleton, parse_obj_lines, parse_ply_by<Ply_edge_parser>,
              parse_polylines, parse_swc,           parse_vtk_lines};
  if (content.empty()) {
    throw File_error(filename + ": the file is empty; fetch or write it again");
  }
  return parsers[ending](content, filename);
}

CSCD_INLINE Indexed_skeleton read_indexed_skeleton(const std::string& filename)
{
  const std::size_t ending = readable_skeleton_ending(filename);
  return parse_skeleton(read_content(filename), ending, filename);
}

CSCD_INLINE Indexed_skeleton read_indexed_skeleton(std::istream& in, const std::string& ending, const std::string& name)
{
  const std::size_t number = readable_skeleton_ending(ending);
  return parse_skeleton(read_content(in, name), number, name);
}

} // namespace internal

CSCD_INLINE void check_readable_skeleton_filename(const std::string& filename)
{
  internal::readable_skeleton_ending(filename);
}

} // namespace CSCD

#endif // CSCD_IO_READ_SKELETON_IMPL_H
