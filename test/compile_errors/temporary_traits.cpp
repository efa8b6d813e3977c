// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pipeline refers to its traits, and refuses temporary ones whatever follows them.
// expected error: deleted

#include <CSCD/Curve_skeletonization.h>
#include <CSCD/Traits/Triangle_mesh_traits.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

int main()
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  const Mesh mesh;
  CSCD::Curve_skeletonization skeletonization{CSCD::Triangle_mesh_traits<Mesh>(mesh), CSCD::Local_policies()};
}
