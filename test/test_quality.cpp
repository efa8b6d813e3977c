// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The quality of skeletons of CGAL's closed meshes is not worse than in the table quality.txt next to this file.
//
// Where a change is better on the whole, this command writes the table anew, and the difference shows what got worse:
//   CSCD_WRITE_QUALITY=1 build-checked/bin/test/test_real_meshes

#include "support/real_meshes.h"
#include "support/skip_or_fail.h"
#include <CSCD/Measure/evaluate_skeleton.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/range/iterator_range_core.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <map>
#include <ostream>
#include <sstream>
#include <string>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Skeleton = CSCD::Skeleton_graph<Kernel::Point_3, Mesh::Vertex_index>;
using CSCD::test::Real_mesh;

/// The columns of the table: the less, the better.
enum Figure : std::size_t
{
  limbs_without_tip,
  tips_without_limb,
  edges_outside,
  sharp_turns, ///< of more than 90 degrees, at nodes with two edges
  offset,      ///< from the center, in percent of the distance to the surface
  cone_error,  ///< of the surface from the union of round cones, in thousandths of the diagonal
  number_of_figures
};
constexpr std::array<const char*, number_of_figures> names{
    "limbs_without_tip", "tips_without_limb", "edges_outside", "sharp_turns", "offset", "cone_error"};
using Figures = std::array<double, number_of_figures>;
using Table = std::map<std::string, Figures>;

constexpr const char* table_path = CSCD_QUALITY_TABLE;

Table read_table()
{
  Table table;
  std::ifstream in(table_path);
  for (std::string line; std::getline(in, line);) {
    std::istringstream fields(line);
    std::string mesh;
    if (line.empty() || line.front() == '#' || !(fields >> mesh)) {
      continue;
    }
    for (double& figure : table[mesh]) {
      EXPECT_TRUE(fields >> figure) << table_path << ": " << line;
    }
  }
  return table;
}

void write_table(std::ostream& out, const Table& table)
{
  out << "# The quality of skeletons of CGAL's closed meshes: see test_quality.cpp, which writes this table.\n"
      << "# Offset in percent of the distance to the surface, cone error in thousandths of the diagonal.\n#"
      << std::setw(21) << "mesh";
  for (const char* name : names) {
    out << "  " << name;
  }
  out << '\n' << std::fixed << std::setprecision(3);
  for (const auto& [mesh, figures] : table) {
    out << std::setw(22) << mesh;
    for (std::size_t i = 0; i < number_of_figures; ++i) {
      out << std::setw(int(std::string(names[i]).size()) + 2) << std::setprecision(i < offset ? 0 : 3) << figures[i];
    }
    out << '\n';
  }
}

std::size_t count_sharp_turns(const Skeleton& skeleton)
{
  std::size_t number = 0;
  for (const auto node : boost::make_iterator_range(vertices(skeleton))) {
    if (degree(node, skeleton) == 2) {
      const auto [first, last] = boost::adjacent_vertices(node, skeleton);
      const Kernel::Vector_3 before = skeleton[node].point - skeleton[*first].point;
      const Kernel::Vector_3 behind = skeleton[*(last - 1)].point - skeleton[node].point;
      number += before * behind < 0 ? 1 : 0;
    }
  }
  return number;
}

Mesh read_mesh(const Real_mesh& real)
{
  Mesh mesh;
  std::ifstream file(real.path());
  EXPECT_TRUE(CGAL::IO::read_OFF(file, mesh)) << real.name;
  if (!CGAL::is_triangle_mesh(mesh)) {
    EXPECT_TRUE(CGAL::Polygon_mesh_processing::triangulate_faces(mesh)) << real.name;
  }
  return mesh;
}

/// Fails if the topology is not that of the surface.
Figures figures_of(const Real_mesh& real)
{
  constexpr std::size_t resolution = 20; // of surfaces that are not looked at
  const Mesh mesh = read_mesh(real);
  Skeleton skeleton;
  const CSCD::Skeletonization_report report = CSCD::extract_curve_skeleton(mesh, skeleton);
  const CSCD::Skeleton_measures measures =
      CSCD::evaluate_skeleton(mesh, skeleton, CSCD::parameters::resolution(resolution));
  EXPECT_EQ(measures.counts.number_of_components, real.number_of_components) << real.name;
  EXPECT_EQ(measures.counts.betti_number, real.genus) << real.name;
  Figures result{};
  result[limbs_without_tip] = double(measures.limbs.number_of_limbs_without_tip);
  result[tips_without_limb] = double(measures.limbs.number_of_tips_without_limb);
  result[edges_outside] = double(report.number_of_edges_outside);
  result[sharp_turns] = double(count_sharp_turns(skeleton));
  result[offset] = 100 * measures.position.offset_by_length;
  result[cone_error] = 1000 * measures.mean_distance_from_round_cones;
  return result;
}

TEST(Quality, is_not_worse_than_in_the_table)
{
  const bool is_written = std::getenv("CSCD_WRITE_QUALITY") != nullptr;
  const Table table = is_written ? Table() : read_table();
  Table found;
  for (const Real_mesh& real : CSCD::test::closed_real_meshes()) {
    if (!real.exists()) {
      CSCD_TEST_SKIP_OR_FAIL(real.path() << " is missing: it comes with the Debian package libcgal-demo");
    }
    const Figures& figures = found[real.name] = figures_of(real);
    const auto row = table.find(real.name);
    EXPECT_EQ(row != table.end(), !is_written) << "of " << real.name << " the table has nothing";
    for (std::size_t i = 0; row != table.end() && i < number_of_figures; ++i) {
      constexpr double tolerance = 1.03;
      constexpr double rounding = 0.0006; // of the table
      EXPECT_LE(figures[i], tolerance * row->second[i] + rounding) << names[i] << " of " << real.name;
    }
  }
  if (is_written) {
    std::ofstream out(table_path);
    write_table(out, found);
    EXPECT_TRUE(out.flush()) << table_path;
  }
}

} // namespace
