// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The weights of a list of separators.

#ifndef CSCD_SELECTION_WEIGH_H
#define CSCD_SELECTION_WEIGH_H

#include <CSCD/Separator/Separator.h>

#include <vector>

namespace CSCD::internal {

/// The weights of `separators`, each by `weight`, a model of `SeparatorWeight`.
template <class SeparatorWeight>
std::vector<double> weigh(const std::vector<Separator>& separators, const SeparatorWeight& weight)
{
  std::vector<double> result;
  result.reserve(separators.size());
  for (const Separator& separator : separators) {
    result.push_back(weight(separator));
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_SELECTION_WEIGH_H
