// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A cost that is no number is refused.
// expected error: CSCD: SeparatorCost requires c(separator) const, convertible to double

#include <CSCD/concepts.h>

#include <string>

struct Cost
{
  std::string operator()(const CSCD::Separator& separator) const;
};

int main()
{
  CSCD::check_separator_cost<Cost>();
}
