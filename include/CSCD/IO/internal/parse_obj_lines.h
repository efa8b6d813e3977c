// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading the poly-lines of Wavefront OBJ.

#ifndef CSCD_IO_INTERNAL_PARSE_OBJ_LINES_H
#define CSCD_IO_INTERNAL_PARSE_OBJ_LINES_H

#include <CSCD/IO/internal/Skeleton_collector.h>
#include <CSCD/IO/internal/Text_scanner.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace CSCD::internal {

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

#endif // CSCD_IO_INTERNAL_PARSE_OBJ_LINES_H
