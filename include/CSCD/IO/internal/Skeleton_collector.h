// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nodes and edges as they come from a file.

#ifndef CSCD_IO_INTERNAL_SKELETON_COLLECTOR_H
#define CSCD_IO_INTERNAL_SKELETON_COLLECTOR_H

#include <CSCD/IO/internal/Scanner.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <boost/unordered_set.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CSCD::internal {

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

  /// \param source,target numbers of nodes, which count from 0
  void add_edge(std::int64_t source, std::int64_t target) { m_edges.emplace_back(source, target); }

  /// \throw File_error if there are no nodes, edges name nodes that do not exist, or only some nodes have radii
  Indexed_skeleton finish()
  {
    if (m_skeleton.points.empty()) {
      throw File_error(m_filename + ": the file has no nodes; fetch or write it again");
    }
    check_number_of_points(number_of_nodes(), m_filename);
    if (!m_skeleton.radii.empty() && !m_skeleton.has_radii()) {
      fail("some nodes have a radius and some have none");
    }
    boost::unordered_set<std::pair<std::int64_t, std::int64_t>> seen;
    for (const auto& [source, target] : m_edges) {
      check_node(source);
      check_node(target);
      if (source != target && seen.insert(std::minmax(source, target)).second) {
        m_skeleton.edges.push_back({Index(source), Index(target)});
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

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_SKELETON_COLLECTOR_H
