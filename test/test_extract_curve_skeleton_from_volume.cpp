// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "support/Temporary_folder.h"
#include <CSCD/IO/read_volume.h>
#include <CSCD/IO/write_nrrd.h>
#include <CSCD/Options.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Surface/Surface_components.h>
#include <CSCD/extract_curve_skeleton_from_volume.h>

#include <CGAL/Simple_cartesian.h>

#include <boost/range/iterator_range_core.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

using Volume_skeleton = CSCD::Skeleton_graph<CGAL::Simple_cartesian<double>::Point_3, std::size_t>;

constexpr double ring_radius = 9; // in the unit of space
constexpr double tube_radius = 3;

/// A ring of label 1, and a second one of label 2 that is linked with it, in voxels that are twice as high as wide.
CSCD::Volume make_linked_rings()
{
  CSCD::Volume volume;
  volume.grid.size = {44, 30, 15};
  volume.grid.axes[2] = {0, 0, 2};
  volume.grid.origin = {-13, -14.5, -14};
  for (std::size_t i = 0; i < volume.grid.number_of_voxels(); ++i) {
    const CSCD::Vector3 p = volume.grid.point({double(i % 44), double(i / 44 % 30), double(i / 44 / 30)});
    const double from_first = std::hypot(std::hypot(p.x(), p.y()) - ring_radius, p.z());
    const double from_second = std::hypot(std::hypot(p.x() - ring_radius, p.z()) - ring_radius, p.y());
    volume.labels.push_back(from_first < tube_radius ? 1 : from_second < tube_radius ? 2 : 0);
  }
  return volume;
}

TEST(extract_curve_skeleton_from_volume, finds_rings_where_they_are)
{
  for (const CSCD::Voxel_surface& surface : make_voxel_surfaces(make_linked_rings())) {
    Volume_skeleton skeleton;
    const CSCD::Skeletonization_report report = CSCD::extract_curve_skeleton(surface, skeleton);
    EXPECT_EQ(report.number_of_skeleton_components, 1U);
    EXPECT_EQ(report.betti_number, 1U);
    EXPECT_EQ(report.number_of_input_vertices, surface.triangles.points.size());
    std::set<std::size_t> assigned;
    for (const auto node : boost::make_iterator_range(vertices(skeleton))) {
      const auto& [point, members, radius, is_opening] = skeleton[node];
      const double distance = surface.label == 1
                                  ? std::hypot(std::hypot(point.x(), point.y()) - ring_radius, point.z())
                                  : std::hypot(std::hypot(point.x() - ring_radius, point.z()) - ring_radius, point.y());
      EXPECT_LT(distance, 0.5); // half of the shortest side of a voxel
      EXPECT_NEAR(radius, tube_radius, 0.5);
      assigned.insert(members.begin(), members.end());
    }
    EXPECT_EQ(assigned.size(), surface.triangles.points.size());
  }
}

/// The report on the voxels where `is_inside(x, y, z)`, of `height` layers that are `size` voxels wide and long.
template <class Predicate>
CSCD::Skeletonization_report skeletonize_voxels(std::size_t size, std::size_t height, const Predicate& is_inside,
                                                Volume_skeleton& skeleton,
                                                std::size_t max_sources = CSCD::Options().maximum_number_of_sources)
{
  CSCD::Volume volume;
  volume.grid.size = {size, size, height};
  for (std::size_t i = 0; i < volume.grid.number_of_voxels(); ++i) {
    volume.labels.push_back(is_inside(i % size, i / size % size, i / size / size) ? 1 : 0);
  }
  CSCD::Voxel_surface surface = make_voxel_surfaces(volume).front();
  surface.turn_cavities();
  return CSCD::extract_curve_skeleton(surface, skeleton, CSCD::parameters::maximum_number_of_sources(max_sources));
}

TEST(extract_curve_skeleton_from_volume, keeps_bars_of_one_voxel)
{
  constexpr std::size_t size = 41;
  constexpr std::size_t cell = 10;
  CSCD::Volume grid; // five bars in either direction
  grid.grid.size = {size, size, 1};
  for (std::size_t i = 0; i < size * size; ++i) {
    grid.labels.push_back(i % size % cell == 0 || i / size % cell == 0 ? 1 : 0);
  }
  const CSCD::Voxel_surface surface = make_voxel_surfaces(grid).front();
  const double volume = CSCD::internal::Surface_components(surface.triangles).measures.front().volume;
  EXPECT_NEAR(volume, double(surface.number_of_voxels), 0.03 * double(surface.number_of_voxels));
  Volume_skeleton skeleton;
  const CSCD::Skeletonization_report report = CSCD::extract_curve_skeleton(surface, skeleton);
  EXPECT_EQ(report.betti_number, 16U);
  EXPECT_EQ(report.number_of_edges_outside, 0U);
  double length = 0;
  for (const auto edge : boost::make_iterator_range(edges(skeleton))) {
    length += std::sqrt(
        CGAL::squared_distance(skeleton[source(edge, skeleton)].point, skeleton[target(edge, skeleton)].point));
  }
  EXPECT_NEAR(length, 10 * (size - 1), 0.05 * 10 * (size - 1));
}

TEST(extract_curve_skeleton_from_volume, has_all_cycles_of_sponges)
{
  // Few sources leave handles of a voxel to the last stage. In the second sponge, separators cross an edge at the same
  // position; in the others, they cross all edges of a piece.
  for (const unsigned seed : {10U, 26U, 35U}) {
    std::mt19937 random(seed);
    const std::size_t size = 8 + seed % 4 * 2;
    const auto is_inside = [&](std::size_t x, std::size_t y, std::size_t z) {
      return x * y * z > 0 && std::max({x, y, z}) + 1 < size && random() % 5 < 2;
    };
    Volume_skeleton skeleton;
    const CSCD::Skeletonization_report report = skeletonize_voxels(size, size, is_inside, skeleton, 1 + seed % 2 * 20);
    EXPECT_GT(report.number_of_handle_cuts, 5U) << seed;
    EXPECT_EQ(report.betti_number, report.genus) << seed;
  }
}

TEST(extract_curve_skeleton_from_volume, has_a_branch_for_each_pin_of_a_plate)
{
  const auto is_inside = [](std::size_t x, std::size_t y, std::size_t z) { return z < 10 || (x % 8 < 4 && y % 8 < 4); };
  Volume_skeleton skeleton;
  const CSCD::Skeletonization_report report = skeletonize_voxels(160, 50, is_inside, skeleton);
  const auto is_top = [&](auto node) { return out_degree(node, skeleton) == 1 && skeleton[node].point.z() > 45; };
  EXPECT_EQ(std::count_if(vertices(skeleton).first, vertices(skeleton).second, is_top), 400);
  EXPECT_LE(report.number_of_tips, 404U); // the plate has four corners
  EXPECT_EQ(report.number_of_edges_outside, 0U);
}

TEST(extract_curve_skeleton_from_volume, leads_edges_between_many_tunnels)
{
  const auto is_in_tunnel = [](auto a, auto b) { return a % 20 / 4 == b / 20 % 5 && b % 20 / 4 == a / 20 % 5; };
  const auto is_inside = [&](auto x, auto y, auto z) {
    return !is_in_tunnel(x, y) && !is_in_tunnel(y, z) && !is_in_tunnel(z, x);
  };
  Volume_skeleton skeleton;
  const CSCD::Skeletonization_report report = skeletonize_voxels(100, 100, is_inside, skeleton);
  EXPECT_EQ(report.betti_number, report.genus);
  EXPECT_LE(report.number_of_edges_outside, report.number_of_edges / 500);
}

TEST(extract_curve_skeleton_from_volume, tells_the_node_of_each_voxel)
{
  const CSCD::Volume volume = make_linked_rings();
  const test_support::Temporary_folder folder;
  std::ostringstream in;
  CSCD::write_nrrd(in, volume);
  const std::string file = folder.write("rings.nrrd", in.str());

  const CSCD::Voxel_selection first_ring{std::nullopt, 1U, false};
  const std::vector<CSCD::Voxel_surface> surfaces = CSCD::read_voxel_surfaces(file, first_ring);
  ASSERT_EQ(surfaces.size(), 1U);
  Volume_skeleton skeleton;
  CSCD::extract_curve_skeleton(surfaces.front(), skeleton);
  std::vector<std::uint32_t> node_of_vertex(surfaces.front().triangles.points.size());
  for (const auto node : boost::make_iterator_range(vertices(skeleton))) {
    for (const std::size_t vertex : skeleton[node].vertices) {
      node_of_vertex[vertex] = std::uint32_t(node + 1);
    }
  }
  CSCD::Volume_reader reader(file, first_ring);
  std::ostringstream out;
  CSCD::write_node_volume(out, reader, surfaces, {node_of_vertex});

  const CSCD::Volume nodes =
      CSCD::read_volume(folder.write("nodes.nrrd", out.str()), {std::nullopt, std::nullopt, true});
  ASSERT_EQ(nodes.labels.size(), volume.labels.size());
  EXPECT_EQ(nodes.grid.axes, volume.grid.axes);
  for (std::size_t i = 0; i < nodes.labels.size(); ++i) {
    ASSERT_EQ(nodes.labels[i] != 0, volume.labels[i] == 1) << i;
    if (nodes.labels[i] == 0) {
      continue;
    }
    const CSCD::Vector3 p = volume.grid.point({double(i % 44), double(i / 44 % 30), double(i / 44 / 30)});
    const auto& node = skeleton[nodes.labels[i] - 1].point;
    // In the same part of the ring: not farther than a radius and the distance of nodes along it.
    EXPECT_LT(std::hypot(p.x() - node.x(), p.y() - node.y(), p.z() - node.z()), 2 * tube_radius) << i;
  }
}

} // namespace
