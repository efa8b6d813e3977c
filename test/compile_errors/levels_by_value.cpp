// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A finder cannot hold on to levels of detail that are given away: the sentence asks for a reference.
// expected error: CSCD: MultiresolutionSkeletonizationTraits requires t.levels() const, a reference to the levels of
// detail

#include <CSCD/concepts.h>

struct Traits
{
  CSCD::Surface_levels levels() const;
};

int main()
{
  CSCD::check_multiresolution_skeletonization_traits<Traits>();
}
