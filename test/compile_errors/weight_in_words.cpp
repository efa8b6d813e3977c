// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A weight that is no number is refused.
// expected error: CSCD: SeparatorCost requires w(separator) const, convertible to double

#include <CSCD/concepts.h>

#include <string>

struct Weight
{
  std::string operator()(const CSCD::Separator& separator) const;
};

int main()
{
  CSCD::check_separator_cost<Weight>();
}
