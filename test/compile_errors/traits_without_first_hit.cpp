// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A traits class whose body cannot be asked where a ray enters it is refused.
// expected error: CSCD: TriangulatedSolidSkeletonizationTraits requires t.first_hit(p, d) const

#include <CSCD/concepts.h>

struct Traits
{
  struct Answer
  {
    Eigen::Vector3d point;
  };

  const CSCD::Surface_levels& levels() const;
  const CSCD::Triangulated_surface& surface() const;
  const CSCD::Triangulated_surface& solid_surface() const;
  bool is_inside(const Eigen::Vector3d& p) const;
  std::optional<Eigen::Vector3d> middle_behind(const Eigen::Vector3d& p) const;
  void crossings(const Eigen::Vector3d& p, const Eigen::Vector3d& q, std::vector<double>& distances) const;
  Answer closest_point(const Eigen::Vector3d& p) const;
};

int main()
{
  CSCD::check_triangulated_solid_skeletonization_traits<Traits>();
}
