// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Policies that cannot pack separators are refused.
// expected error: CSCD: SkeletonizationPolicies requires p.pack_separators(s, separators, report) const, a P::Packing

#include <CSCD/concepts.h>

#include <vector>

struct Surface
{
};

struct Policies
{
  struct Packing
  {
    const std::vector<CSCD::Index>& packed() const;
  };
  std::vector<CSCD::Separator> find_separators(const Surface& surface, const CSCD::Options& settings,
                                               CSCD::Skeletonization_report& report,
                                               const CSCD::Progress& progress) const;
};

int main()
{
  CSCD::check_skeletonization_policies<Policies, Surface>();
}
