// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// shorten_curve() refuses a named parameter that it does not use.
// expected error: CSCD: this named parameter is not used by this function

#include <CSCD/shorten_curve.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <iterator>
#include <vector>

int main()
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  const Mesh mesh;
  std::vector<Point> points;
  CSCD::shorten_curve(mesh, std::vector<Mesh::Vertex_index>(), false, std::back_inserter(points),
                      CSCD::parameters::random_seed(7));
}
