// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From many separators to few, as published, and the regions that belong to them.

#ifndef CSCD_SELECTION_REGION_PACKING_H
#define CSCD_SELECTION_REGION_PACKING_H

#include <CSCD/Selection/Balance_and_roundness.h>
#include <CSCD/Selection/Separator_overlaps.h>
#include <CSCD/Selection/Separator_regions.h>
#include <CSCD/Selection/pack_by_overlap.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/internal/Vector_3.h>

#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// Packed separators, and the regions of the surface that are nearest to them.
class Region_packing
{
public:
  /// Weighs, prunes and packs `separators`; counts in `report`.
  /// \tparam Traits a model of `SolidSkeletonizationTraits`
  template <class Traits>
  Region_packing(const Traits& traits, const std::vector<Separator>& separators, Skeletonization_report& report)
      : m_packed(pack(traits, separators, report)), m_regions(traits.surface(), separators, m_packed)
  {
  }

  /// The packed separators, as positions in the list of all separators, the first packed first.
  const std::vector<Index>& packed() const { return m_packed; }
  const Separator_regions& regions() const { return m_regions; }

private:
  template <class Traits>
  static std::vector<Index> pack(const Traits& traits, const std::vector<Separator>& separators,
                                 Skeletonization_report& report)
  {
    using Judge = Balance_and_roundness<Traits>;
    Judge judge(traits);
    std::vector<double> weights(separators.size());
    report.number_of_bumps = 0;
    report.number_of_tunnels = 0;
    for (std::size_t i = 0; i < separators.size(); ++i) {
      const typename Judge::Verdict verdict = judge(separators[i], weights[i]);
      report.number_of_bumps += verdict == Judge::Verdict::bump ? 1 : 0;
      report.number_of_tunnels += verdict == Judge::Verdict::tunnel ? 1 : 0;
    }
    return pack_by_overlap(Separator_overlaps(traits.surface(), separators), weights);
  }

  std::vector<Index> m_packed;
  Separator_regions m_regions;
};

} // namespace CSCD::internal

#endif // CSCD_SELECTION_REGION_PACKING_H
