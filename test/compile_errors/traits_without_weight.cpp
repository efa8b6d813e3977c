// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A traits class without the function weight() is refused, and the sentence names what is missing.
// expected error: CSCD: SkeletonizationTraits requires t.weight(i) const, convertible to double

#include <CSCD/concepts.h>

#include <array>
#include <vector>

struct Traits
{
  using Point = std::array<double, 3>;
  using Site_descriptor = int;

  int number_of_sites() const;
  Eigen::Vector3d point(int i) const;
  Eigen::Vector3d normal(int i) const;
  std::vector<int> neighbors(int i) const;
  int number_of_triangles() const;
  std::array<int, 3> triangle(int f) const;
};

int main()
{
  CSCD::check_skeletonization_traits<Traits>();
}
