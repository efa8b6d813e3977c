// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The values of `--root`.

#include "roots.h"

#include "options.h"

#include <array>
#include <cmath>
#include <locale>
#include <optional>
#include <sstream>
#include <string>

namespace cscd {

std::optional<Point> root_point(const std::string& root)
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
  return (in >> std::ws).eof() ? std::optional<Point>(Point(coordinates[0], coordinates[1], coordinates[2]))
                               : std::nullopt;
}

std::string check_root(const std::string& root)
{
  const bool is_rule = root == thickest_root || root == lowest_root || root == longest_root;
  return is_rule || root_point(root) ? "" : "must be X,Y,Z, thickest, lowest or longest, not " + root;
}

} // namespace cscd
