// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletonizes a graph that is not a surface: the bonds of a tube of atoms, and of a chain that hangs on it.

#include <CSCD/IO/write_skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/extract_curve_skeleton_from_graph.h>

#include <CGAL/Simple_cartesian.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>

using Point = CGAL::Simple_cartesian<double>::Point_3;

//! [A graph]
struct Atom
{
  Point point; // read by default; `vertex_point_map` names another map
};
using Molecule = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Atom>;
//! [A graph]

int main()
try {
  // A triangular lattice, rolled up: vertex (i, j) is the j-th one of ring i.
  constexpr std::size_t size = 60;
  constexpr std::size_t around = 12;
  Molecule molecule(size * around);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < around; ++j) {
      const double angle = boost::math::double_constants::two_pi * (double(j) + double(i % 2) / 2) / around;
      const std::size_t atom = i * around + j;
      molecule[atom].point = Point(2 * std::cos(angle), 2 * std::sin(angle), double(i));
      add_edge(atom, i * around + (j + 1) % around, molecule);
      if (i > 0) {
        add_edge(atom, atom - around, molecule);
        add_edge(atom, (i - 1) * around + (j + (i % 2 == 1 ? 1 : around - 1)) % around, molecule);
      }
    }
  }
  std::size_t last = size / 2 * around;
  for (int k = 1; k <= 20; ++k) {
    const auto atom = add_vertex(molecule);
    molecule[atom].point = Point(2 + k, 0, double(size) / 2);
    add_edge(last, atom, molecule);
    last = atom;
  }
  CSCD::Skeleton_graph<Point, std::size_t> skeleton;
  const auto report = CSCD::extract_curve_skeleton(molecule, skeleton);
  CSCD::write_skeleton("molecule.graph", skeleton);
  std::cout << report.number_of_nodes << " nodes, " << report.number_of_junctions << " junction, "
            << report.number_of_tips << " tips\n";
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
