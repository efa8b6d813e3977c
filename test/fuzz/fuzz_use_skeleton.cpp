// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fuzz target: any two graphs as skeletons, compared, simplified, and evaluated against points. A simplified skeleton
// keeps its Betti number and is finite, or an Input_error refuses the request and leaves the skeleton as it was.
//
// The bytes: options; eight parameters of simplify_skeleton(); then for both graphs the numbers of nodes and edges,
// four bytes for each node, three of them signed, and two for each edge.

#include "Bytes.h"
#include "support/invariants.h"
#include <CSCD/Measure/compare_skeletons.h>
#include <CSCD/Measure/evaluate_skeleton.h>
#include <CSCD/Measure/simplify_skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/exceptions.h>

#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Skeleton = CSCD::Skeleton_graph<Point, std::size_t>;
using CSCD::test::Bytes, CSCD::test::fail;

/// Bits of the first byte.
enum Use : unsigned
{
  huge_coordinates = 1, ///< near the largest numbers
  tiny_coordinates = 2, ///< near the smallest numbers
  evaluated = 4,        ///< the first is evaluated against the nodes of the second
  by_radii = 8          ///< by its own radii
};

constexpr unsigned max_number_of_nodes = 64;  // for many executions a second
constexpr std::size_t coarse_resolution = 12; // likewise

Skeleton take_skeleton(Bytes& bytes, double scale)
{
  const std::size_t number_of_nodes = bytes.take() % max_number_of_nodes;
  const std::size_t number_of_edges = bytes.take();
  const auto coordinate = [&] { return scale * static_cast<std::int8_t>(bytes.take()); };
  Skeleton skeleton(number_of_nodes);
  for (std::size_t v = 0; v < number_of_nodes; ++v) {
    const double x = coordinate();
    const double y = coordinate();
    skeleton[v].point = Point(x, y, coordinate());
    skeleton[v].radius = scale * bytes.take() / 8;
  }
  for (std::size_t i = 0; number_of_nodes > 0 && i < number_of_edges && !bytes.is_at_end(); ++i) {
    const std::size_t a = bytes.take() % number_of_nodes;
    const std::size_t b = bytes.take() % number_of_nodes;
    if (a != b && !edge(a, b, skeleton).second) {
      add_edge(a, b, skeleton);
    }
  }
  return skeleton;
}

/// Distances are relative to the common diagonal.
void compare(const Skeleton& first, const Skeleton& second)
{
  constexpr double rounding = 1e-9;
  try {
    const CSCD::Skeleton_comparison comparison = CSCD::compare_skeletons(first, second);
    if (!(comparison.mean_distance() >= 0) || !(comparison.hausdorff_distance() <= 1 + rounding)) {
      fail("skeletons at no distance");
    }
  } catch (const CSCD::Input_error&) {
    if (num_vertices(first) != 0 && num_vertices(second) != 0) {
      fail("skeletons that are not compared");
    }
  }
}

void simplify(Skeleton& skeleton, Bytes& bytes, double scale)
{
  const CSCD::test::Skeleton_facts before = CSCD::test::skeleton_facts(skeleton);
  const std::size_t minimum_component_size = bytes.take() % 16;
  const double significance = bytes.take() / 16.;
  const double length = scale * bytes.take() / 8;
  const double length_over_radius = bytes.take() / 16.;
  const bool join_components = bytes.take() % 2 != 0;
  const std::uint8_t spacing = bytes.take();
  try {
    CSCD::simplify_skeleton(skeleton, CSCD::parameters::minimum_component_size(minimum_component_size)
                                          .minimum_significance(significance)
                                          .minimum_branch_length(length)
                                          .minimum_length_over_radius(length_over_radius)
                                          .join_components(join_components)
                                          .spacing(spacing % 2 == 0 ? scale * spacing / 8 : 0)
                                          .spacing_over_radius(spacing % 2 == 0 ? 0 : spacing / 64.));
  } catch (const CSCD::Input_error&) {
    if (num_vertices(skeleton) != before.number_of_nodes || num_edges(skeleton) != before.number_of_edges) {
      fail("refused with an output");
    }
    return;
  }
  const CSCD::test::Violations violations = CSCD::test::violations_of_graph(skeleton);
  if (!violations.empty()) {
    fail(violations.front());
  }
  const CSCD::test::Skeleton_facts after = CSCD::test::skeleton_facts(skeleton);
  if (minimum_component_size == 0 && after.betti_number != before.betti_number) {
    fail("a handle was cut or made");
  }
  if (join_components && before.number_of_nodes > 0 && after.number_of_components != 1) {
    fail("components were not joined");
  }
}

void evaluate(const Skeleton& skeleton, const Skeleton& other, bool uses_radii)
{
  std::vector<Point> points;
  for (std::size_t v = 0; v < num_vertices(other); ++v) {
    points.push_back(other[v].point);
  }
  try {
    CSCD::evaluate_skeleton(points, skeleton,
                            CSCD::parameters::resolution(coarse_resolution).use_skeleton_radii(uses_radii));
  } catch (const CSCD::Input_error& error) {
    if (std::string(error.what()).empty()) {
      fail("refused without message");
    }
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Bytes bytes(data, size);
  const unsigned options = bytes.take();
  const double scale = (options & huge_coordinates) != 0 ? 1e300 : (options & tiny_coordinates) != 0 ? 1e-300 : 1;
  Bytes simplification = bytes;
  constexpr int number_of_parameters = 8;
  for (int i = 0; i < number_of_parameters; ++i) {
    bytes.take();
  }
  Skeleton first = take_skeleton(bytes, scale);
  const Skeleton second = take_skeleton(bytes, scale);
  compare(first, second);
  if ((options & evaluated) != 0) {
    evaluate(first, second, (options & by_radii) != 0);
  }
  simplify(first, simplification, scale);
  return 0;
}
