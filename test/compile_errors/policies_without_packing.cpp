// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Policies that cannot pack separators are refused.
// expected error: CSCD: SkeletonizationPolicies requires p.pack_separators(t, separators, report) const, a P::Packing

#include <CSCD/concepts.h>

#include <vector>

struct Traits
{
};

struct Policies
{
  template <class ConcurrencyTag, class Progress>
  std::vector<CSCD::Separator> find_separators(const Traits& traits, const CSCD::Search_settings& settings,
                                               CSCD::Skeletonization_report& report, const Progress& progress) const;
};

int main()
{
  CSCD::check_skeletonization_policies<Policies, Traits>();
}
