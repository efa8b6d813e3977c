// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which curves are not simple.

#ifndef CSCD_SELECTION_FIND_SELF_CROSSINGS_H
#define CSCD_SELECTION_FIND_SELF_CROSSINGS_H

#include <CSCD/Selection/Separator_arrangement.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Traits/Edge_crossing.h>
#include <CSCD/Traits/Triangulated_surface.h>
#include <CSCD/internal/Epoch_marks.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace CSCD::internal {

/// For each of `separators`, 1 if it crosses itself in a face. Linear in the number of crossings.
inline std::vector<std::uint8_t> find_self_crossings(const Triangulated_surface& surface,
                                                     const std::vector<Separator>& separators)
{
  std::vector<std::uint8_t> result;
  result.reserve(separators.size());
  Separator_arrangement arrangement(surface);
  for (Index i = 0; i < separators.size(); ++i) {
    arrangement.clear();
    result.push_back(arrangement.insert(i, separators[i].crossings) ? 0 : 1);
  }
  return result;
}

/// For each of `separators`, 1 if it crosses an edge twice: among points there are no faces in which curves could be
/// followed more closely. Linear in the number of crossings.
template <class Surface>
std::vector<std::uint8_t> find_self_crossings(const Surface& surface, const std::vector<Separator>& separators)
{
  std::vector<std::uint8_t> result;
  result.reserve(separators.size());
  Epoch_marks crossed(surface.number_of_halfedges());
  for (const Separator& separator : separators) {
    crossed.clear();
    const bool is_simple =
        std::all_of(separator.crossings.begin(), separator.crossings.end(),
                    [&](const Edge_crossing& crossing) { return crossed.mark(surface.edge(crossing.halfedge)); });
    result.push_back(is_simple ? 0 : 1);
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_SELECTION_FIND_SELF_CROSSINGS_H
