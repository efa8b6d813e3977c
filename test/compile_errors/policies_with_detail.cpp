// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The detail is a parameter of the default policies, and refused where others are given.
// expected error: CSCD: detail belongs to the default policies and cannot be given with policies

#include <CSCD/Curve_skeletonization.h>
#include <CSCD/Local_policies.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

int main()
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  const Mesh mesh;
  CSCD::Skeleton_graph<Mesh::Point, Mesh::Vertex_index> skeleton;
  CSCD::extract_curve_skeleton(mesh, skeleton, CSCD::parameters::policies(CSCD::Local_policies()).detail(0.5));
}
