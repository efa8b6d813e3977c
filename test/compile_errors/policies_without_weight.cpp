// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Policies that cannot weigh separators are refused.
// expected error: CSCD: SkeletonizationPolicies requires p.separator_weight(separator) const, convertible to double

#include <CSCD/concepts.h>

struct Traits
{
};

struct Finder
{
  void operator()(unsigned source, unsigned level_hint, CSCD::Search_result& result);
};

struct Policies
{
  using Separator_finder = Finder;
  Finder make_separator_finder(const Traits& traits) const;
};

int main()
{
  CSCD::check_skeletonization_policies<Policies, Traits>();
}
