// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of Local_policies.h.

#ifndef CSCD_LOCAL_POLICIES_IMPL_H
#define CSCD_LOCAL_POLICIES_IMPL_H

#include <CSCD/Local/Covering_search.h>
#include <CSCD/Local/Local_separator_finder.h>
#include <CSCD/Local_policies.h>
#include <CSCD/Packing/Separator_packing.h>
#include <CSCD/Packing/cut_handles.h>
#include <CSCD/Separator/is_around_hollow.h>
#include <CSCD/Skeleton/embed_skeleton.h>
#include <CSCD/Surface/Surface_levels.h>

namespace CSCD {

CSCD_INLINE Local_policies::Packing::Packing(std::unique_ptr<const internal::Separator_packing> packing)
    : m_packing(std::move(packing))
{
}

CSCD_INLINE Local_policies::Packing::Packing(Packing&& other) noexcept = default;
CSCD_INLINE Local_policies::Packing& Local_policies::Packing::operator=(Packing&& other) noexcept = default;
CSCD_INLINE Local_policies::Packing::~Packing() = default;

CSCD_INLINE const std::vector<Index>& Local_policies::Packing::packed() const
{
  return m_packing->packed();
}

CSCD_INLINE std::vector<Separator> Local_policies::find_separators(const Triangulated_solid& solid,
                                                                   const Search_settings& settings,
                                                                   Skeletonization_report& report,
                                                                   const Progress& progress) const
{
  const auto make_plain_finder = [&]() -> Separator_finder {
    if (m_make_finder) {
      return m_make_finder(solid);
    }
    // A std::function can be copied, a finder with its working memory cannot.
    const auto finder = std::make_shared<Local_separator_finder>(
        solid.levels(), m_detail.min_loop_area_ratio(), [&solid](Index vertex) { return solid.side_of_sheet(vertex); });
    return [finder](Index source, Index level_hint, Search_result& result) { (*finder)(source, level_hint, result); };
  };
  const auto make_finder = [&]() -> Separator_finder {
    Separator_finder plain_finder = make_plain_finder();
    if (solid.number_of_sheets() == 0) {
      return plain_finder;
    }
    return [&solid, plain_finder](Index source, Index level_hint, Search_result& result) {
      plain_finder(source, level_hint, result);
      internal::mark_open(solid, result.separator);
    };
  };
  std::vector<Separator> separators = internal::Covering_search(
      solid.levels(), settings, make_finder, m_detail.min_branch_area_ratio())(m_cost, report, progress);
  const auto first_tunnel = std::remove_if(separators.begin(), separators.end(), [&solid](const Separator& separator) {
    return internal::is_around_hollow(solid, separator);
  });
  report.number_of_tunnels = std::size_t(separators.end() - first_tunnel);
  separators.erase(first_tunnel, separators.end());
  return separators;
}

CSCD_INLINE Local_policies::Packing Local_policies::pack_separators(const Triangulated_solid& solid,
                                                                    std::vector<Separator>& separators,
                                                                    Skeletonization_report& report) const
{
  auto packing = std::make_unique<internal::Separator_packing>(
      solid.triangulation(), separators, internal::separator_costs(separators, m_cost),
      m_detail.min_branch_area_ratio(), unsigned(report.number_of_threads));
  report.number_of_handle_cuts = internal::cut_handles(solid, separators, *packing);
  for (auto added = separators.end() - std::ptrdiff_t(report.number_of_handle_cuts); added != separators.end();
       ++added) {
    internal::mark_open(solid, *added);
  }
  return Packing(std::move(packing));
}

CSCD_INLINE Embedded_skeleton Local_policies::build_skeleton(const Triangulated_solid& solid,
                                                             const std::vector<Separator>& separators,
                                                             const Packing& packing,
                                                             Skeletonization_report& report) const
{
  return internal::embed_skeleton(solid, separators, packing.packed(), packing.m_packing->cut_graph(), report);
}

} // namespace CSCD

#endif // CSCD_LOCAL_POLICIES_IMPL_H
