// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A set of separators that neither cross nor nearly coincide.

#ifndef CSCD_SELECTION_DISJOINT_SEPARATORS_H
#define CSCD_SELECTION_DISJOINT_SEPARATORS_H

#include <CSCD/Selection/Separator_arrangement.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Traits/Triangulated_surface.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace CSCD::internal {

/// Greedy weighted set packing of separators (section 3.2.3): the lighter one of two that overlap is kept.
class Disjoint_separators
{
public:
  /// Prepares to pack `separators`, whose weights are `weights`; both the surface and the separators are referred to.
  Disjoint_separators(const Triangulated_surface& surface, const std::vector<Separator>& separators,
                      const std::vector<double>& weights)
      : m_separators(separators), m_arrangement(surface), m_order(separators.size())
  {
    std::iota(m_order.begin(), m_order.end(), Index(0));
    std::stable_sort(m_order.begin(), m_order.end(), [&](Index a, Index b) { return weights[a] < weights[b]; });
  }

  /// Packs anew, of those for which `is_allowed(separator)` holds.
  template <class Predicate>
  void pack(const Predicate& is_allowed)
  {
    m_packed.clear();
    m_arrangement.clear();
    for (Index separator : m_order) {
      if (is_allowed(separator) && is_spaced(separator)) {
        insert(separator);
      }
    }
  }

  /// Unpacks those for which `is_allowed(separator)` does not hold, and packs none in their place.
  template <class Predicate>
  void reduce(const Predicate& is_allowed)
  {
    std::vector<Index> packed;
    packed.swap(m_packed);
    m_arrangement.clear();
    for (Index separator : packed) {
      if (is_allowed(separator)) {
        insert(separator);
      }
    }
  }

  /// Packs `separator` too if it crosses none of those that are packed and itself neither. \return whether it does not
  bool insert(Index separator)
  {
    const bool is_inserted = m_arrangement.insert(separator, m_separators[separator].crossings);
    if (is_inserted) {
      m_packed.push_back(separator);
    }
    return is_inserted;
  }

  /// The packed separators, as positions in the list of all separators, in the order in which they were packed.
  const std::vector<Index>& packed() const { return m_packed; }
  const Separator_arrangement& arrangement() const { return m_arrangement; }

private:
  /// The centers of packed separators keep this distance, relative to the radius of the shorter one.
  static constexpr double least_spacing = 0.3;

  bool is_spaced(Index candidate) const
  {
    const Separator& a = m_separators[candidate];
    return std::none_of(m_packed.begin(), m_packed.end(), [&](Index packed) {
      const Separator& b = m_separators[packed];
      const double distance = least_spacing * std::min(a.radius(), b.radius());
      return (a.center - b.center).squaredNorm() < distance * distance;
    });
  }

  const std::vector<Separator>& m_separators;
  Separator_arrangement m_arrangement;
  std::vector<Index> m_order;
  std::vector<Index> m_packed;
};

} // namespace CSCD::internal

#endif // CSCD_SELECTION_DISJOINT_SEPARATORS_H
