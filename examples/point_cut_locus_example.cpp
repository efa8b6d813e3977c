// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cut locus of a point of a cloud: the points of the surface that two different shortest paths from it reach. The
// points are not made into a surface. Writes the curves as point_cut_locus.polylines.txt.
// Usage: point_cut_locus_example [point file [number of the point]]

#include <CSCD/IO/read_points.h>
#include <CSCD/IO/write_file.h>
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/extract_cut_locus_from_points.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <iostream>
#include <ostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Cut_locus = CSCD::Point_cut_locus_graph<Point>;

int main(int argc, char** argv)
try {
  std::vector<Point> points;
  std::vector<Kernel::Vector_3> normals;
  CSCD::read_points(argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz"), points, normals);
  const std::size_t source = argc > 2 ? std::stoul(argv[2]) : 0;
  if (source >= points.size()) {
    std::cerr << "there is no point " << source << '\n';
    return 1;
  }

  //! [The cut locus of a point]
  Cut_locus cut_locus;
  CSCD::extract_cut_locus(points, source, cut_locus);

  CSCD::write_file("point_cut_locus.polylines.txt", [&](std::ostream& out) { CSCD::write_polylines(out, cut_locus); });
  //! [The cut locus of a point]
  const auto all = vertices(cut_locus);
  const auto farthest = std::max_element(all.first, all.second,
                                         [&](auto a, auto b) { return cut_locus[a].distance < cut_locus[b].distance; });
  std::cout << num_vertices(cut_locus) << " points; the farthest, near " << points[cut_locus[*farthest].location]
            << ", is " << cut_locus[*farthest].distance << " away\n";
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
