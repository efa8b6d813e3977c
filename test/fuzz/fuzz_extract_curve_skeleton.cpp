// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fuzz target: any bytes, read as a polygon soup, oriented and skeletonized. The skeleton has all invariants, or the
// soup is refused by an Input_error; everything else is a bug and aborts.

#include "Coded_soup.h"
#include "support/invariants.h"
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/algorithm/string/join.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Skeleton = CSCD::Skeleton_graph<Point, Mesh::Vertex_index>;

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const CSCD::test::Coded_soup coded({data, size});
  const Mesh mesh = CSCD::test::to_mesh<Mesh>(coded);
  Skeleton skeleton;
  try {
    const CSCD::Skeletonization_report report = CSCD::extract_curve_skeleton(
        mesh, skeleton, CSCD::parameters::maximum_number_of_sources(coded.maximum_number_of_sources));
    const CSCD::test::Violations violations = CSCD::test::violated_invariants_without_area(mesh, skeleton, report);
    if (!violations.empty()) {
      CSCD::test::fail(boost::algorithm::join(violations, "\n"));
    }
  } catch (const CSCD::Input_error& error) {
    if (std::string(error.what()).empty() || num_vertices(skeleton) != 0) {
      CSCD::test::fail("refused without message, or with an output");
    }
  }
  return 0;
}
