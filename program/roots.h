// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a skeleton begins, and files whose content depends on it.

#ifndef CSCD_PROGRAM_ROOTS_H
#define CSCD_PROGRAM_ROOTS_H

#include "options.h"
#include "types.h"
#include <CSCD/IO/write_file.h>
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/Measure/Rooted_forest.h>
#include <CSCD/Vector_3.h>

#include <boost/algorithm/string/predicate.hpp>

#include <iostream>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace cscd {

/// The coordinates that the value of `--root` gives; none if it names a rule.
/// \pre `check_root()` has accepted it
std::optional<Point> root_point(const std::string& root);

/// The roots that the value of `--root` chooses; none if it is empty.
/// \throw CSCD::Input_error if they cannot be chosen
template <class AnySkeleton>
std::vector<CSCD::Index> find_roots(const AnySkeleton& skeleton, const std::string& root)
{
  if (root.empty()) {
    return {};
  }
  if (const std::optional<Point> point = root_point(root)) {
    return CSCD::find_roots(skeleton, *point);
  }
  return CSCD::find_roots(skeleton, root == thickest_root ? CSCD::Root_rule::thickest
                                    : root == lowest_root ? CSCD::Root_rule::lowest
                                                          : CSCD::Root_rule::longest);
}

/// Writes a skeleton to a file of `files` in the format of its ending, or to standard output as a graph of GEL.
template <class AnySkeleton>
void write_skeleton_output(CSCD::File_group& files, const std::string& output, const AnySkeleton& skeleton,
                           const std::vector<CSCD::Index>& roots, const Swc_arguments& swc)
{
  if (output == standard_stream) {
    CSCD::write_gel_graph(std::cout, skeleton);
  } else if (boost::algorithm::iends_with(output, ".swc")) {
    CSCD::Swc_options options;
    options.type = swc.type;
    options.min_soma_radius = swc.min_soma_radius.value_or(options.min_soma_radius);
    options.scale = swc.scale;
    options.roots = roots;
    files.write(output, [&](std::ostream& out) { CSCD::write_swc(out, skeleton, options); });
  } else {
    files.write(output, [&](std::ostream& out) { CSCD::write_skeleton(out, output, skeleton); });
  }
}

} // namespace cscd

#endif // CSCD_PROGRAM_ROOTS_H
