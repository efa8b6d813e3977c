// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Invariants of every skeleton of every mesh. Each function returns one sentence for each violation, so that tests,
// fuzz targets and programs can use them alike.

#ifndef CSCD_TEST_SUPPORT_INVARIANTS_H
#define CSCD_TEST_SUPPORT_INVARIANTS_H

#include "Inside_count.h"
#include "Surface_facts.h"
#include "convert_shape.h"
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Skeletonization_report.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CSCD::test {

/// Sentences, one for each violation.
using Violations = std::vector<std::string>;

/// Counts of a skeleton.
struct Skeleton_facts
{
  std::size_t number_of_nodes = 0;
  std::size_t number_of_edges = 0;
  std::size_t number_of_components = 0;
  std::size_t betti_number = 0;
  std::size_t number_of_tips = 0;
  std::size_t number_of_junctions = 0;
};

template <class Skeleton>
Skeleton_facts skeleton_facts(const Skeleton& skeleton)
{
  Skeleton_facts facts;
  facts.number_of_nodes = num_vertices(skeleton);
  facts.number_of_edges = num_edges(skeleton);
  std::vector<std::size_t> component(facts.number_of_nodes);
  facts.number_of_components = facts.number_of_nodes == 0
                                   ? 0
                                   : static_cast<std::size_t>(boost::connected_components(skeleton, component.data()));
  facts.betti_number = facts.number_of_edges + facts.number_of_components - facts.number_of_nodes;
  for (std::size_t v = 0; v < facts.number_of_nodes; ++v) {
    facts.number_of_tips += degree(v, skeleton) == 1 ? 1 : 0;
    facts.number_of_junctions += degree(v, skeleton) >= 3 ? 1 : 0;
  }
  return facts;
}

/// Adds the sentence "`what`: `actual`, not `expected`" if the two differ.
inline void expect_equal(Violations& violations, const std::string& what, std::size_t actual, std::size_t expected)
{
  if (actual != expected) {
    violations.push_back(what + ": " + std::to_string(actual) + ", not " + std::to_string(expected));
  }
}

inline void append(Violations& violations, const Violations& more)
{
  violations.insert(violations.end(), more.begin(), more.end());
}

/// Nodes are finite, radii finite and not negative, no edge is a loop or doubled.
template <class Skeleton>
Violations violations_of_graph(const Skeleton& skeleton)
{
  Violations violations;
  for (std::size_t v = 0; v < num_vertices(skeleton); ++v) {
    for (const double coordinate : to_triple(skeleton[v].point)) {
      if (!std::isfinite(coordinate)) {
        violations.push_back("node " + std::to_string(v) + " is not finite");
      }
    }
    if constexpr (has_radius_v<Skeleton>) {
      if (!std::isfinite(skeleton[v].radius) || skeleton[v].radius < 0) {
        violations.push_back("node " + std::to_string(v) + " has radius " + std::to_string(skeleton[v].radius));
      }
    }
  }
  std::set<std::pair<std::size_t, std::size_t>> seen;
  const auto range = edges(skeleton);
  for (auto e = range.first; e != range.second; ++e) {
    const std::pair<std::size_t, std::size_t> ends = std::minmax(source(*e, skeleton), target(*e, skeleton));
    const std::string where = std::to_string(ends.first) + "-" + std::to_string(ends.second);
    if (ends.first == ends.second) {
      violations.push_back("edge " + where + " is a loop");
    }
    if (!seen.insert(ends).second) {
      violations.push_back("edge " + where + " occurs twice");
    }
  }
  return violations;
}

/// Radii are positive. A component all of whose points are on a line has none.
template <class Skeleton>
Violations violations_of_radii(const Skeleton& skeleton)
{
  Violations violations;
  if constexpr (has_radius_v<Skeleton>) {
    for (std::size_t v = 0; v < num_vertices(skeleton); ++v) {
      if (skeleton[v].radius == 0) {
        violations.push_back("node " + std::to_string(v) + " has no radius");
      }
    }
  }
  return violations;
}

/// Every vertex of `mesh` that has a face belongs to exactly one node, every isolated one to none.
template <class Mesh, class Skeleton>
Violations violations_of_partition(const Mesh& mesh, const Skeleton& skeleton)
{
  Violations violations;
  const auto count = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  for (const auto v : vertices(mesh)) {
    put(count, v, std::size_t(0));
  }
  for (std::size_t node = 0; node < num_vertices(skeleton); ++node) {
    for (const auto v : skeleton[node].vertices) {
      put(count, v, get(count, v) + 1);
    }
  }
  std::size_t number = 0;
  for (const auto v : vertices(mesh)) {
    const bool is_isolated = halfedge(v, mesh) == boost::graph_traits<Mesh>::null_halfedge();
    expect_equal(violations, "nodes of mesh vertex " + std::to_string(number++), get(count, v), is_isolated ? 0 : 1);
  }
  return violations;
}

/// The skeleton has the components of the surface and, if it is closed, its genus; cavities do not count.
/// \param number_of_cavities of the surface, which are of genus 0; if not known, the report's number is used
inline Violations violations_of_topology(const Surface_facts& surface, const Skeleton_facts& skeleton,
                                         const Skeletonization_report& report,
                                         std::optional<std::size_t> number_of_cavities)
{
  Violations violations;
  expect_equal(violations, "reported cavities", report.number_of_cavities,
               number_of_cavities.value_or(report.number_of_cavities));
  expect_equal(violations, "skeleton components", skeleton.number_of_components,
               surface.number_of_components - report.number_of_cavities);
  const bool is_closed_after_bridging = report.number_of_bridged_borders == surface.number_of_border_cycles;
  if (is_closed_after_bridging) {
    const std::size_t reported_genus = report.genus.value_or(surface.genus + 1);
    const bool is_genus_known = number_of_cavities.has_value() || report.number_of_cavities == 0;
    const std::size_t genus = is_genus_known ? surface.genus : reported_genus;
    expect_equal(violations, "first Betti number", skeleton.betti_number, genus);
    expect_equal(violations, "genus in the report", reported_genus, genus);
  }
  return violations;
}

/// The numbers of the report are those of the mesh and of the skeleton.
inline Violations violations_of_report(const Surface_facts& surface, const Skeleton_facts& skeleton,
                                       const Skeletonization_report& report)
{
  Violations violations;
  expect_equal(violations, "reported input vertices", report.number_of_input_vertices, surface.number_of_vertices);
  expect_equal(violations, "reported isolated vertices", report.number_of_isolated_vertices,
               surface.number_of_isolated_vertices);
  expect_equal(violations, "reported surface components", report.number_of_surface_components,
               surface.number_of_components - report.number_of_cavities);
  expect_equal(violations, "reported nodes", report.number_of_nodes, skeleton.number_of_nodes);
  expect_equal(violations, "reported edges", report.number_of_edges, skeleton.number_of_edges);
  expect_equal(violations, "reported skeleton components", report.number_of_skeleton_components,
               skeleton.number_of_components);
  expect_equal(violations, "reported Betti number", report.betti_number, skeleton.betti_number);
  expect_equal(violations, "reported tips", report.number_of_tips, skeleton.number_of_tips);
  expect_equal(violations, "reported junctions", report.number_of_junctions, skeleton.number_of_junctions);
  const std::size_t bridged = report.number_of_bridged_borders;
  if (bridged > surface.number_of_border_cycles) {
    violations.push_back("more borders bridged than there are: " + std::to_string(bridged));
  }
  if (report.number_of_packed_separators > report.number_of_separators + report.number_of_handle_cuts) {
    violations.push_back("more separators packed than found");
  }
  if (report.number_of_nodes_outside > report.number_of_nodes ||
      report.number_of_edges_outside > report.number_of_edges) {
    violations.push_back("more nodes or edges outside than there are");
  }
  for (const double seconds : report.seconds) {
    if (!std::isfinite(seconds) || seconds < 0) {
      violations.push_back("a stage took " + std::to_string(seconds) + " s");
    }
  }
  return violations;
}

/// The number of nodes outside of a closed body without cavities is at most that of the report.
/// \pre the nodes are finite
template <class Mesh, class Skeleton>
Violations violations_of_inside(const Mesh& mesh, const Skeleton& skeleton, const Skeletonization_report& report)
{
  Violations violations;
  const Inside_count count = count_inside(mesh, skeleton);
  if (count.number_of_nodes_outside > report.number_of_nodes_outside) {
    violations.push_back("nodes outside: " + std::to_string(count.number_of_nodes_outside) + ", reported " +
                         std::to_string(report.number_of_nodes_outside));
  }
  constexpr double tolerance = 0.001; // of the length: samples that touch the surface
  if (report.number_of_nodes_outside + report.number_of_edges_outside == 0 &&
      count.length_outside > tolerance * count.length) {
    violations.push_back("length outside: " + std::to_string(count.length_outside) + ", reported none");
  }
  return violations;
}

/// All of the above except positive radii and the inside: they hold even if components have no area.
template <class Mesh, class Skeleton>
Violations violated_invariants_without_area(const Mesh& mesh, const Skeleton& skeleton,
                                            const Skeletonization_report& report,
                                            std::optional<std::size_t> number_of_cavities = std::nullopt)
{
  const Surface_facts surface = surface_facts(mesh);
  const Skeleton_facts graph = skeleton_facts(skeleton);
  Violations violations = violations_of_graph(skeleton);
  append(violations, violations_of_partition(mesh, skeleton));
  append(violations, violations_of_topology(surface, graph, report, number_of_cavities));
  append(violations, violations_of_report(surface, graph, report));
  return violations;
}

/// All of the above.
template <class Mesh, class Skeleton>
Violations violated_invariants(const Mesh& mesh, const Skeleton& skeleton, const Skeletonization_report& report,
                               std::size_t number_of_cavities = 0)
{
  Violations violations = violated_invariants_without_area(mesh, skeleton, report, number_of_cavities);
  append(violations, violations_of_radii(skeleton));
  if (count_border_cycles(mesh) == 0 && number_of_cavities == 0 && violations_of_graph(skeleton).empty()) {
    append(violations, violations_of_inside(mesh, skeleton, report));
  }
  return violations;
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_INVARIANTS_H
