// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of Local_policies.h.

#ifndef CSCD_LOCAL_POLICIES_IMPL_H
#define CSCD_LOCAL_POLICIES_IMPL_H

#include <CSCD/Local/Covering_search.h>
#include <CSCD/Local_policies.h>
#include <CSCD/Packing/Separator_packing.h>
#include <CSCD/Packing/cut_handles.h>
#include <CSCD/Skeleton/embed_skeleton.h>

namespace CSCD {

CSCD_INLINE const std::vector<Index>& Local_policies::Packing::packed() const
{
  return m_packing->packed();
}

CSCD_INLINE std::vector<Separator> Local_policies::find_separators(const Triangulated_solid& solid,
                                                                   const Options& settings,
                                                                   Skeletonization_report& report,
                                                                   const Progress& progress) const
{
  Options options = settings;
  options.detail = m_detail.value();
  return internal::find_local_separators(solid, options, report, progress);
}

CSCD_INLINE Local_policies::Packing Local_policies::pack_separators(const Triangulated_solid& solid,
                                                                    std::vector<Separator>& separators,
                                                                    Skeletonization_report& report) const
{
  Packing result;
  result.m_packing = internal::pack_local_separators(solid, m_detail, separators, report);
  return result;
}

CSCD_INLINE Embedded_skeleton Local_policies::build_skeleton(const Triangulated_solid& solid,
                                                             const std::vector<Separator>& separators,
                                                             const Packing& packing,
                                                             Skeletonization_report& report) const
{
  return internal::embed_skeleton(solid, separators, packing.packed(), packing.m_packing->cut_graph(), m_node_spacing,
                                  report);
}

} // namespace CSCD

#endif // CSCD_LOCAL_POLICIES_IMPL_H
