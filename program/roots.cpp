// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The values of `--root`, and files whose content depends on them.

#include "types.h"
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/Measure/Rooted_forest.h>

#include <boost/algorithm/string/predicate.hpp>

#include <array>
#include <cmath>
#include <iostream>
#include <locale>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace cscd {

std::optional<Vector3> root_point(const std::string& root)
{
  std::array<double, 3> coordinates{};
  std::istringstream in(root);
  in.imbue(std::locale::classic());
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    char comma = ',';
    if ((i > 0 && !(in >> comma)) || comma != ',' || !(in >> coordinates[i]) || !std::isfinite(coordinates[i])) {
      return std::nullopt;
    }
  }
  return (in >> std::ws).eof() ? std::optional(Vector3(coordinates[0], coordinates[1], coordinates[2])) : std::nullopt;
}

std::string check_root(const std::string& root)
{
  const bool is_rule = root == thickest_root || root == lowest_root || root == longest_root;
  return is_rule || root_point(root) ? "" : "must be X,Y,Z, thickest, lowest or longest, not " + root;
}

std::vector<Index> find_roots(const Skeleton& skeleton, const std::string& root)
{
  if (root.empty()) {
    return {};
  }
  if (const std::optional<Vector3> point = root_point(root)) {
    return CSCD::internal::find_roots(skeleton, *point);
  }
  return CSCD::internal::find_roots(skeleton, root == thickest_root ? CSCD::Root_rule::thickest
                                              : root == lowest_root ? CSCD::Root_rule::lowest
                                                                    : CSCD::Root_rule::longest);
}

void write_skeleton_output(CSCD::File_group& files, const std::string& output, const Skeleton& skeleton,
                           const std::vector<Index>& roots, CSCD::Swc_options swc)
{
  if (output == standard_stream) {
    CSCD::write_gel_graph(std::cout, skeleton);
  } else if (boost::algorithm::iends_with(output, ".swc")) {
    swc.roots = roots;
    files.write(output, [&](std::ostream& out) { CSCD::write_swc(out, skeleton, swc); });
  } else {
    files.write(output, [&](std::ostream& out) { CSCD::write_skeleton(out, output, skeleton); });
  }
}

} // namespace cscd
