// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A traits class whose body cannot be asked where a ray enters it is refused.
// expected error: CSCD: SolidSkeletonizationTraits requires t.first_hit(p, d) const

#include <CSCD/concepts.h>

struct Traits
{
  struct Answer
  {
    Eigen::Vector3d point;
    unsigned face;
  };

  const CSCD::internal::Surface_levels& levels() const;
  const CSCD::internal::Triangulated_surface& solid_surface() const;
  bool is_inside(const Eigen::Vector3d& p) const;
  Answer closest_point(const Eigen::Vector3d& p) const;
};

int main()
{
  CSCD::check_solid_skeletonization_traits<Traits>();
}
