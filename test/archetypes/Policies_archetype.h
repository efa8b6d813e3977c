// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A SkeletonizationPolicies, with its SeparatorFinder, with no more than the concepts ask for.

#ifndef CSCD_TEST_ARCHETYPES_POLICIES_ARCHETYPE_H
#define CSCD_TEST_ARCHETYPES_POLICIES_ARCHETYPE_H

#include "Separator_cost_archetype.h"
#include <CSCD/Local_policies.h>
#include <CSCD/Selection/Search_settings.h>
#include <CSCD/Selection/Separator_packing.h>
#include <CSCD/Separator/Local_separator_finder.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Vector_3.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::test {

/// Can neither be copied nor moved.
template <class Traits>
class Separator_finder_archetype
{
public:
  explicit Separator_finder_archetype(const Traits& traits) : m_finder(traits) {}
  Separator_finder_archetype(const Separator_finder_archetype&) = delete;
  Separator_finder_archetype& operator=(const Separator_finder_archetype&) = delete;
  ~Separator_finder_archetype() = default;

  void operator()(CSCD::Index source, CSCD::Index level_hint, Search_result& result)
  {
    m_finder(source, level_hint, result);
  }

private:
  Local_separator_finder<Traits> m_finder;
};

/// Can be moved only, and so can its packing.
template <class Traits>
class Policies_archetype
{
public:
  using Separator_finder = Separator_finder_archetype<Traits>;

  class Packing
  {
  public:
    const std::vector<CSCD::Index>& packed() const { return m_packing.packed(); }

  private:
    friend class Policies_archetype;
    explicit Packing(CSCD::internal::Separator_packing&& packing) : m_packing(std::move(packing)) {}

    CSCD::internal::Separator_packing m_packing;
  };

  /// \param number_of_weights counts the weights that are asked for
  explicit Policies_archetype(std::size_t& number_of_weights)
      : m_policies(Separator_cost_archetype(number_of_weights))
  {
  }
  Policies_archetype(const Policies_archetype&) = delete;
  Policies_archetype& operator=(const Policies_archetype&) = delete;
  Policies_archetype(Policies_archetype&&) = default;
  Policies_archetype& operator=(Policies_archetype&&) = delete;
  ~Policies_archetype() = default;

  template <class ConcurrencyTag, class Progress>
  std::vector<Separator> find_separators(const Traits& traits, const Search_settings& settings,
                                         Skeletonization_report& report, const Progress& progress) const
  {
    return m_policies.template find_separators<ConcurrencyTag>(traits, settings, report, progress);
  }

  Packing pack_separators(const Traits& traits, std::vector<Separator>& separators,
                          Skeletonization_report& report) const
  {
    return Packing(m_policies.pack_separators(traits, separators, report));
  }

  Embedded_skeleton build_skeleton(const Traits& traits, const std::vector<Separator>& separators,
                                   const Packing& packing, Skeletonization_report& report) const
  {
    return m_policies.build_skeleton(traits, separators, packing.m_packing, report);
  }

private:
  Local_policies<Traits, Separator_cost_archetype, Separator_finder> m_policies;
};

} // namespace CSCD::test

#endif // CSCD_TEST_ARCHETYPES_POLICIES_ARCHETYPE_H
