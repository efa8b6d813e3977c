// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stages of the default engine on a prepared body: search, packing, skeleton.

#ifndef CSCD_LOCAL_LOCAL_STAGES_H
#define CSCD_LOCAL_LOCAL_STAGES_H

#include <CSCD/Local/Covering_search.h>
#include <CSCD/Options.h>
#include <CSCD/Packing/Separator_packing.h>
#include <CSCD/Packing/cut_handles.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/limb_tests.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Triangulated_solid.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace CSCD::internal {

/// Seeks separators until they cover the surface, or until the bound of `options` on the number of sources is reached.
/// Separators around a hollow are not returned.
inline std::vector<Separator> find_local_separators(const Triangulated_solid& solid, const Options& options,
                                                    Skeletonization_report& report, const Progress& progress)
{
  std::vector<Separator> separators = Covering_search(solid, options)(report, progress);
  const auto first_tunnel = std::remove_if(separators.begin(), separators.end(), [&solid](const Separator& separator) {
    return is_around_hollow(solid, separator);
  });
  report.number_of_tunnels = std::size_t(separators.end() - first_tunnel);
  separators.erase(first_tunnel, separators.end());
  return separators;
}

/// Packs `separators` and cuts the surface along the packed ones. Appends separators around handles that no source has
/// found.
inline std::unique_ptr<Separator_packing> pack_local_separators(const Triangulated_solid& solid, const Detail& detail,
                                                                std::vector<Separator>& separators,
                                                                Skeletonization_report& report)
{
  auto packing = std::make_unique<Separator_packing>(solid.triangulation(), separators, separator_costs(separators),
                                                     detail.min_branch_area_ratio());
  report.number_of_handle_cuts = cut_handles(solid, separators, *packing);
  for (std::size_t i = separators.size() - report.number_of_handle_cuts; i < separators.size(); ++i) {
    mark_open(solid, separators[i]);
  }
  return packing;
}

} // namespace CSCD::internal

#endif // CSCD_LOCAL_LOCAL_STAGES_H
