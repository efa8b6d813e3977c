// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A SeparatorCost with no more than the concept asks for.

#ifndef CSCD_TEST_ARCHETYPES_SEPARATOR_COST_ARCHETYPE_H
#define CSCD_TEST_ARCHETYPES_SEPARATOR_COST_ARCHETYPE_H

#include <CSCD/Separator/Separator.h>

#include <cstddef>

namespace CSCD::test {

/// The length, counted; no default constructor, no assignment.
class Separator_cost_archetype
{
public:
  explicit Separator_cost_archetype(std::size_t& number_of_calls) : m_number_of_calls(number_of_calls) {}

  double operator()(const Separator& separator) const
  {
    ++m_number_of_calls;
    return separator.length;
  }

private:
  std::size_t& m_number_of_calls;
};

} // namespace CSCD::test

#endif // CSCD_TEST_ARCHETYPES_SEPARATOR_COST_ARCHETYPE_H
