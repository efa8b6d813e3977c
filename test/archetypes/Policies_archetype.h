// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A SkeletonizationPolicies, with its SeparatorFinder, with no more than the concepts ask for.

#ifndef CSCD_TEST_ARCHETYPES_POLICIES_ARCHETYPE_H
#define CSCD_TEST_ARCHETYPES_POLICIES_ARCHETYPE_H

#include <CSCD/Separator/Local_separator_finder.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/internal/Vector_3.h>

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

  void operator()(CSCD::internal::Index source, CSCD::internal::Index level_hint, Search_result& result)
  {
    m_finder(source, level_hint, result);
  }

private:
  Local_separator_finder<Traits> m_finder;
};

/// Can be moved only. The weight is a function, not an object.
template <class Traits>
class Policies_archetype
{
public:
  using Separator_finder = Separator_finder_archetype<Traits>;

  /// What may be used where a double is asked for.
  class Weight
  {
  public:
    explicit Weight(double value) : m_value(value) {}
    operator double() const { return m_value; }

  private:
    double m_value;
  };

  /// Adds `offset` to the length of every separator.
  explicit Policies_archetype(double offset) : m_offset(offset) {}
  Policies_archetype(const Policies_archetype&) = delete;
  Policies_archetype& operator=(const Policies_archetype&) = delete;
  Policies_archetype(Policies_archetype&&) = default;
  Policies_archetype& operator=(Policies_archetype&&) = delete;
  ~Policies_archetype() = default;

  Separator_finder make_separator_finder(const Traits& traits) const { return Separator_finder(traits); }
  Weight separator_weight(const Separator& separator) const { return Weight(m_offset + separator.length); }

private:
  double m_offset;
};

} // namespace CSCD::test

#endif // CSCD_TEST_ARCHETYPES_POLICIES_ARCHETYPE_H
