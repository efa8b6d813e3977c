// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A finder that does not write to the result it is given is refused along with its policies.
// expected error: CSCD: SeparatorFinder requires f(source, level_hint, result) of two indices and a Search_result&

#include <CSCD/concepts.h>

struct Traits
{
};

struct Finder
{
  CSCD::Search_result operator()(unsigned source, unsigned level_hint);
};

struct Policies
{
  using Separator_finder = Finder;
  Finder make_separator_finder(const Traits& traits) const;
  double separator_weight(const CSCD::Separator& separator) const;
};

int main()
{
  CSCD::check_skeletonization_policies<Policies, Traits>();
}
