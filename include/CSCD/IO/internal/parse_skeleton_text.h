// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads skeletons from text formats.

#ifndef CSCD_IO_INTERNAL_PARSE_SKELETON_TEXT_H
#define CSCD_IO_INTERNAL_PARSE_SKELETON_TEXT_H

#include <CSCD/IO/internal/Scanner.h>
#include <CSCD/IO/internal/Skeleton_collector.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Vector_3.h>

#include <boost/unordered_map.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CSCD::internal {

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

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_PARSE_SKELETON_TEXT_H
