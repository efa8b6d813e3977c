// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A surface without the function crossings() is refused, and the sentence names what is missing.
// expected error: CSCD: SkeletonizationSurface requires s.crossings(p, q, v) const, which fills a std::vector<double>

#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/concepts.h>

#include <optional>

struct Surface
{
  const CSCD::Triangulated_surface& triangulation() const;
  bool is_inside(const CSCD::Vector_3& p) const;
  std::optional<CSCD::Vector_3> middle_behind(const CSCD::Vector_3& p) const;
};

int main()
{
  CSCD::check_skeletonization_surface<Surface>();
}
