// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A traits class without the function descriptors() is refused, and the sentence names what is missing.
// expected error: CSCD: SkeletonizationTraits requires t.descriptors(v) const, a range of T::Input_descriptor

#include <CSCD/concepts.h>

#include <array>

struct Traits
{
  using Point = std::array<double, 3>;
  using Input_descriptor = int;
  struct Surface
  {
  };

  const Surface& surface() const;
  Point to_input_point(const CSCD::Vector_3& p) const;
  double to_input_length(double length) const;
  void describe_input(CSCD::Skeletonization_report& report) const;
};

int main()
{
  CSCD::check_skeletonization_traits<Traits>();
}
