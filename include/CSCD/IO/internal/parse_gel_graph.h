// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading the graphs of the GEL library.

#ifndef CSCD_IO_INTERNAL_PARSE_GEL_GRAPH_H
#define CSCD_IO_INTERNAL_PARSE_GEL_GRAPH_H

#include <CSCD/IO/internal/Skeleton_collector.h>
#include <CSCD/IO/internal/Text_scanner.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>

#include <cstdint>
#include <string>
#include <string_view>

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

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_PARSE_GEL_GRAPH_H
