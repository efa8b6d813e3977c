// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading the poly-lines that CGAL's examples write.

#ifndef CSCD_IO_INTERNAL_PARSE_POLYLINES_H
#define CSCD_IO_INTERNAL_PARSE_POLYLINES_H

#include <CSCD/IO/internal/Skeleton_collector.h>
#include <CSCD/IO/internal/Text_scanner.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/internal/Vector_3.h>

#include <boost/unordered_map.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace CSCD::internal {

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

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_PARSE_POLYLINES_H
