// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A finder that does not write to the result it is given is refused.
// expected error: CSCD: SeparatorFinder requires f(source, level_hint, result) of two indices and a Search_result&

#include <CSCD/concepts.h>

struct Traits
{
};

struct Finder
{
  explicit Finder(const Traits& traits);
  CSCD::Search_result operator()(unsigned source, unsigned level_hint);
};

int main()
{
  CSCD::check_separator_finder<Finder, Traits>();
}
