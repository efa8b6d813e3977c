// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Limbs begin where they leave their parents.

#ifndef CSCD_TREE_LIMB_BASE_ABSORPTION_H
#define CSCD_TREE_LIMB_BASE_ABSORPTION_H

#include <CSCD/Tree/Limb.h>
#include <CSCD/Tree/Section.h>
#include <CSCD/Tree/Slice.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Gives the first slices of limbs to their parents as long as they lie on the bark of these. Where a trunk is seen
/// from two sides only, its points fall apart into two strips: so they become one again, and all that grows from them
/// is hung up anew.
class Limb_base_absorption
{
public:
  Limb_base_absorption(std::vector<Slice>& slices, const std::vector<Section>& sections, std::vector<Limb>& limbs)
      : m_slices(slices), m_sections(sections), m_limbs(limbs), m_new_slice(slices.size()),
        m_limb_of_slice(slices.size(), no_index)
  {
    for (Index slice = 0; slice < slices.size(); ++slice) {
      m_new_slice[slice] = slice;
    }
  }

  /// \return for every slice itself, or the slice that its points went to
  std::vector<Index> operator()()
  {
    std::vector<Limb> kept;
    for (Index i = 0; i < m_limbs.size(); ++i) {
      Limb limb = std::move(m_limbs[i]);
      if (limb.joint != no_index) {
        limb.joint = m_new_slice[limb.joint];
        limb.parent = m_limb_of_slice[limb.joint];
        absorb_base(kept[limb.parent], limb);
      }
      if (!limb.slices.empty()) {
        for (Index slice : limb.slices) {
          m_limb_of_slice[slice] = Index(kept.size());
        }
        kept.push_back(std::move(limb));
      }
    }
    m_limbs = std::move(kept);
    return std::move(m_new_slice);
  }

private:
  /// How far from the axis of its parent a slice is on its bark, relative to the radius.
  static constexpr double bark = 1.25;
  /// The part of the slices to give away that are on the bark.
  static constexpr double least_part = 0.75;
  /// How far beyond the end of its parent a slice may be, likewise.
  static constexpr double longest_overhang = 2;

  /// The slice of `parent` nearest to a place, from `first` on as long as it gets nearer.
  std::size_t nearest_slice(const Limb& parent, std::size_t first, const Vector_3& place) const
  {
    std::size_t result = first;
    const auto distance = [&](std::size_t i) { return (m_sections[parent.slices[i]].center - place).norm(); };
    while (result + 1 < parent.slices.size() && distance(result + 1) < distance(result)) {
      ++result;
    }
    return result;
  }

  /// Whether a place is on the bark of a section, and not beyond its end.
  bool is_on_bark(const Vector_3& place, const Section& section) const
  {
    const Vector_3 d = place - section.center;
    return d.cross(section.direction).norm() <= bark * section.radius &&
           std::abs(d.dot(section.direction)) <= longest_overhang * section.radius;
  }

  void absorb_base(const Limb& parent, Limb& limb)
  {
    auto at = std::size_t(std::find(parent.slices.begin(), parent.slices.end(), limb.joint) - parent.slices.begin());
    std::vector<Index> hosts;
    std::size_t number_on_bark = 0;
    std::size_t number = 0; // of the slices to give away
    for (Index slice : limb.slices) {
      at = nearest_slice(parent, at, m_slices[slice].centroid);
      hosts.push_back(parent.slices[at]);
      if (is_on_bark(m_slices[slice].centroid, m_sections[parent.slices[at]])) {
        ++number_on_bark;
        if (double(number_on_bark) >= least_part * double(hosts.size())) {
          number = hosts.size();
        }
      }
    }
    for (std::size_t i = 0; i < number; ++i) {
      give(limb.slices[i], hosts[i]);
      limb.joint = hosts[i];
    }
    limb.slices.erase(limb.slices.begin(), limb.slices.begin() + std::ptrdiff_t(number));
  }

  void give(Index slice, Index host)
  {
    Slice& from = m_slices[slice];
    Slice& to = m_slices[host];
    const double number = double(to.points.size() + from.points.size());
    to.centroid = (double(to.points.size()) * to.centroid + double(from.points.size()) * from.centroid) / number;
    to.points.insert(to.points.end(), from.points.begin(), from.points.end());
    from.points.clear();
    m_new_slice[slice] = host;
  }

  std::vector<Slice>& m_slices;
  const std::vector<Section>& m_sections;
  std::vector<Limb>& m_limbs;
  std::vector<Index> m_new_slice;
  std::vector<Index> m_limb_of_slice;
};

} // namespace CSCD::internal

#endif // CSCD_TREE_LIMB_BASE_ABSORPTION_H
