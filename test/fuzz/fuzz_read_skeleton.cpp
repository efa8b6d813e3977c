// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fuzz target: any bytes, read as a skeleton file. The result is a simple graph of finite nodes which is written and
// read again without a change, or the content is refused in one line that names the file; everything else is a bug and
// aborts.
//
// The bytes: the format, then the content of the file.

#include "Coded_file.h"
#include <CSCD/IO/read_skeleton.h>
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/exceptions.h>

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <sstream>
#include <string>
#include <utility>

namespace {

using Skeleton = CSCD::Skeleton_graph<CGAL::Simple_cartesian<double>::Point_3, std::size_t>;

void check_graph(const Skeleton& skeleton)
{
  for (std::size_t v = 0; v < num_vertices(skeleton); ++v) {
    const auto& point = skeleton[v].point;
    const double radius = skeleton[v].radius;
    if (!std::isfinite(point.x()) || !std::isfinite(point.y()) || !std::isfinite(point.z()) || !(radius >= 0) ||
        !std::isfinite(radius)) {
      CSCD::test::fail("a node is not finite");
    }
  }
  std::set<std::pair<std::size_t, std::size_t>> seen;
  const auto range = edges(skeleton);
  for (auto e = range.first; e != range.second; ++e) {
    const std::pair<std::size_t, std::size_t> ends = std::minmax(source(*e, skeleton), target(*e, skeleton));
    if (ends.first == ends.second || !seen.insert(ends).second) {
      CSCD::test::fail("the graph is not simple");
    }
  }
}

std::string written(const Skeleton& skeleton)
{
  std::ostringstream out;
  CSCD::write_json(out, skeleton);
  return out.str();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  CSCD::test::Coded_file file({data, size}, CSCD::test::endings_of_skeletons);
  Skeleton skeleton;
  try {
    CSCD::read_skeleton(file.content, file.ending, "fuzz", skeleton);
  } catch (const CSCD::File_error& error) {
    CSCD::test::check_refusal(error, "fuzz");
    if (num_vertices(skeleton) != 0) {
      CSCD::test::fail("refused with an output");
    }
    return 0;
  }
  check_graph(skeleton);
  const std::string text = written(skeleton);
  std::istringstream again(text);
  CSCD::read_skeleton(again, ".json", "fuzz", skeleton);
  if (written(skeleton) != text) {
    CSCD::test::fail("changed by writing and reading");
  }
  return 0;
}
