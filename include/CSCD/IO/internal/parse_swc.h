// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading the SWC files of neuroscience.

#ifndef CSCD_IO_INTERNAL_PARSE_SWC_H
#define CSCD_IO_INTERNAL_PARSE_SWC_H

#include <CSCD/IO/internal/Skeleton_collector.h>
#include <CSCD/IO/internal/Text_scanner.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/internal/Vector_3.h>

#include <boost/unordered_map.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CSCD::internal {

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

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_PARSE_SWC_H
