// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A range of points is no mesh: the refusal is one sentence of ours, not an error inside Boost.
// expected error: CSCD: TriangleMesh requires faces(g), as CGAL's FaceListGraph

#include <CSCD/input_concepts.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <vector>

int main()
{
  CSCD::check_triangle_mesh<std::vector<CGAL::Simple_cartesian<double>::Point_3>>();
}
